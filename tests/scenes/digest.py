# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results of a run as text, and how exactly two of them must agree.

Temperatures of the probes are written as rises since the start, of which far more digits count.
"""
import re

# Measured between solvers and numbers of processes: up to 2e-9 (IDA), 1e-9 (displacement at tolerance 1e-9).
RELATIVE = 1e-6
# Of the largest value of its kind in the table: a shear that only the mesh makes need not have six digits.
OF_LARGEST = 1e-6
# What is rounding where a kind is nothing at all. Stress: that of a modulus of 1e9 Pa and the strain here.
ROUNDING = {"temperature": 1e-9, "displacement": 1e-14, "strain_energy": 1e-8, "strain": 1e-12, "stress": 1e-3}
FIRST_RESULT = 6  # field of a row, after time, probe and place


def kind(column):
    return next((name for name in ROUNDING if column.startswith(name)), column)


def results(outcome):
    """The columns to compare and their rows, temperatures as rises. damage is exp(ln_damage): scene.py checks that."""
    columns = [column for column in outcome.columns if column != "damage"]
    start = {row["probe"]: row["temperature_K"] for row in reversed(outcome.rows) if "temperature_K" in row}
    rows = [{column: row[column] - start[row["probe"]] if column == "temperature_K" else row[column]
             for column in columns} for row in outcome.rows]
    return columns, rows


def floors(columns, rows):
    """By column: differences that do not count."""
    largest = {}
    for row in rows:
        for column in columns[FIRST_RESULT - 1:]:
            if abs(row[column]) < float("inf"):
                largest[kind(column)] = max(largest.get(kind(column), 0), abs(row[column]))
    return {column: max(OF_LARGEST * largest.get(kind(column), 0), ROUNDING.get(kind(column), 0))
            for column in columns[FIRST_RESULT - 1:]}


def table(outcome):
    """Values far below their floors are written as 0."""
    columns, rows = results(outcome)
    floor = floors(columns, rows)

    def field(column, value):
        if column == "probe":
            return value.replace(" ", "_")
        return "0" if abs(value) < 0.1 * floor.get(column, 0) else f"{value:.9g}"

    yield " ".join(column.replace("temperature", "rise") for column in columns)
    for row in rows:
        yield " ".join(field(column, row[column]) for column in columns)


def flat(name, value):
    if isinstance(value, dict):
        return [line for key, inner in value.items() for line in flat(f"{name}/{key}", inner)]
    if isinstance(value, list):
        return [f"{name} = " + ", ".join(map(str, value))]
    return [f"{name} = {value:.9g}" if isinstance(value, float) else f"{name} = {value}"]


def balance(accounts):
    """Without the errors; what is rounding (of the largest, or of nothing) is 0."""
    accounts = {name: heat for name, heat in accounts.items() if "error" not in name}
    largest = max(map(abs, accounts.values()))
    return {name: heat if abs(heat) > max(1e-9 * largest, 1e-12) else 0 for name, heat in accounts.items()}


def text(outcome):
    summary = dict(outcome.summary)
    if "balance" in summary:
        summary["balance"] = balance(summary["balance"])
    if outcome["Time/Integrator"] == "IDA":
        del summary["time_steps"]
    lines = [line for key in ("title", "status", "effects", "unknowns", "time_steps", "extremes", "ablation", "adaption", "balance")
             if key in summary for line in flat(key, summary[key])]
    if outcome["Output/Every step"] == "on":
        lines += re.findall(r"^t = .*", re.sub(r"  \d+:\d\d left", "", outcome.log), re.M)
    return "\n".join([*lines, *table(outcome)]) + "\n"


def tolerances(outcome):
    """For numdiff, which accepts what is within either; each column of the table has a floor of its own."""
    absolute = [f"--absolute-tolerance={floor:.3g}:{field}"
                for field, floor in enumerate(floors(*results(outcome)).values(), FIRST_RESULT)]
    return [f"--relative-tolerance={RELATIVE}", *absolute]
