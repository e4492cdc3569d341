# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes from which effects are taken: nothing of them is left (presence.py), their heat is nothing, and what does not
depend on them stays as it was. Working directory: where runs may write. Usage: off.py CAUTERY"""
import pathlib
import re
import statistics
import subprocess
import sys

import presence
from outcome import Outcome

SCENES = pathlib.Path(__file__).parent
NO_DEFORMATION = {"Deformation": "off", "Coupling": "off"}


def run(cautery, scene, effects):
    folder = pathlib.Path("_".join([scene, *effects]).replace(" ", "_"))
    overrides = [part for effect, value in effects.items() for part in ("--set", f"Effects/{effect}={value}")]
    subprocess.run([cautery, SCENES / f"{scene}.prm", "--output", folder, *overrides], stdout=subprocess.DEVNULL,
                   check=True)
    outcome = Outcome(folder)
    presence.check(outcome)
    return outcome


def check_same(one, other):
    """In the columns that both have: to the digits that are written."""
    columns = [column for column in one.columns if column in other.columns]
    assert len(columns) > 5 and len(one.rows) == len(other.rows)
    for row, twin in zip(one.rows, other.rows):
        for column in columns:
            near = row[column] == twin[column] or abs(row[column] - twin[column]) <= 1e-9 * abs(row[column])
            assert near, (column, row, twin)


def damage(cautery):
    check_same(run(cautery, "quadratic", {"Damage": "off"}), run(cautery, "quadratic", {}))


def deformation(cautery):
    """Heat does not feel it in one-way coupling, with both integrators."""
    check_same(run(cautery, "quadratic", {"Damage": "off", **NO_DEFORMATION}), run(cautery, "quadratic", {}))
    check_same(run(cautery, "error_control", NO_DEFORMATION), run(cautery, "error_control", {}))


def relaxation(cautery):
    assert run(cautery, "switched_points", {"Heat": "Fourier"}).summary["balance"]["relative_error"] < 1e-8


def coupling(cautery):
    """An even deformation that feels no heat, and heat that feels no deformation."""
    outcome = run(cautery, "two_way", {"Coupling": "off"})
    assert all(row["temperature_K"] == 310 for row in outcome.rows)


def sources_of_heat(cautery):
    """Left out by their switches, although the scene describes them."""
    off = {"Heat sources": "off", "Perfusion": "off", "Metabolism": "off"}
    balance = run(cautery, "switched_points", off).summary["balance"]
    assert balance["sources_J"] == balance["metabolism_J"] == balance["lost_to_blood_J"] == 0
    assert abs(balance["stored_J"]) < 1e-10


def gravity(cautery):
    outcome = run(cautery, "forces", {"Gravity": "off"})
    assert all(row["displacement_y_m"] == 0 for row in outcome.rows if row["time_s"] == 0)


def memory(cautery):
    """Of heat alone on 14^3 cells: less than a third of what heat with deformation takes, beyond a mesh of 2^3."""
    def megabytes(cells, effects):
        solvers = [f"Numerics/{solver} solver/Method=CG + AMG" for solver in ("Heat", "Deformation")]
        overrides = [part for entry in [f"Mesh/Subdivisions={cells}", "Numerics/Element degree=1", *solvers, *effects]
                     for part in ("--set", entry)]
        reports = [subprocess.run([cautery, "check", SCENES / "quadratic.prm", *overrides], stdout=subprocess.PIPE,
                                  text=True, check=True).stdout for _ in range(3)]
        # what the system gives a process differs by some MB from run to run
        return statistics.median(float(re.search(r"^Memory\s+(\S+) MB", report, re.M).group(1)) for report in reports)

    alone = [f"Effects/{effect}={value}" for effect, value in {"Damage": "off", **NO_DEFORMATION}.items()]
    heat, both = (megabytes(14, effects) - megabytes(2, effects) for effects in (alone, []))
    print(f"heat {heat} MB, with deformation {both} MB")
    assert 3 * heat < both


if __name__ == "__main__":
    for check in (damage, deformation, relaxation, coupling, sources_of_heat, gravity, memory):
        print(check.__name__, flush=True)
        check(sys.argv[1])
