# SPDX-License-Identifier: LGPL-2.1-or-later
"""What studies of a scene find, against what is known without the program. Usage: study.py STATEMENT CAUTERY FOLDER [PREFIX...]

FOLDER has the scenes; PREFIX are the words of a launcher, for several processes. Works in the present directory.
"""
import csv
import json
import math
import pathlib
import shutil
import subprocess
import sys

END, RATE = 20.0, 360000 / 4.192e6  # s; w / (rho C) of cooling.prm, 1/s


def exact(time):
    return 310 + 40 * math.exp(-RATE * time)


def backward_euler(time, step):
    return 310 + 40 / (1 + RATE * step) ** round(time / step)


class Study:
    def __init__(self, command, folder):
        self.command, self.folder = command, folder

    def run(self, *words):
        done = subprocess.run([*self.command, *map(str, words)], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    def accuracy(self, out, *settings, scene="cooling.prm"):
        """What it says, and its table by ladder, setting and quantity."""
        said = self.run("accuracy", self.folder / scene, "--output", out,
                        *(word for text in settings for word in ("--set", text)))
        with open(pathlib.Path(out) / "accuracy.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        return said, {(row["ladder"], row["setting"], row["quantity"]): row for row in rows}


def errors_are_those_of_the_recurrence(study):
    """Backward Euler's error is known in closed form; its observed order must be 1, and IDA's must follow its tolerance."""
    _, rows = study.accuracy("accuracy")
    for step in (2.0, 1.0, 0.5, 0.25):
        label = f"{step:g} s"
        expected = max(abs(backward_euler(t, step) - exact(t)) for t in (4, 12, 20))
        at_twelve = abs(backward_euler(12, step) - exact(12))
        found = float(rows["step", label, "inside temperature_K"]["error"])
        assert abs(found - expected) < 1e-8, (step, found, expected)
        assert abs(float(rows["step", label, "inside temperature_K at 12"]["error"]) - at_twelve) < 1e-8
    ida = [float(row["error"]) for (ladder, _, quantity), row in rows.items()
           if ladder == "IDA" and quantity == "inside temperature_K"]
    assert ida[0] > 30 * ida[-1] and ida[-1] < 1e-4, ida
    # the mesh does not matter here, so its ladder has the error of the step
    mesh = [float(row["error"]) for (ladder, _, quantity), row in rows.items()
            if ladder == "mesh" and quantity == "inside temperature_K"]
    assert max(mesh) - min(mesh) < 1e-8, mesh
    report = pathlib.Path("accuracy/accuracy.md").read_text()
    orders = [line for line in report.splitlines() if line.startswith("| 0.25 s")][0]
    assert abs(float(orders.split("|")[7]) - 1) < 0.05, orders


def cheapest_setting_is_a_scene_that_keeps_its_promise(study):
    said, rows = study.accuracy("accuracy")
    within = [(float(row["seconds"]), float(row["error"])) for (_, _, quantity), row in rows.items()
              if quantity == "inside temperature_K" and float(row["error"]) <= 0.01]
    assert f"inside temperature_K within 0.01 K: `" in said or "within 0.01 K: the scene" in said, said
    scene = pathlib.Path("accuracy/cheapest_0_1.prm")
    assert f"in {min(within)[0]:.6g} s" in scene.read_text().splitlines()[0]
    study.run(scene, "--output", "promised")
    with open("promised/probes.csv", newline="") as file:
        found = [abs(float(row["temperature_K"]) - exact(float(row["time_s"]))) for row in csv.DictReader(file)]
    assert max(found) <= 0.01, found
    # by Pareto's rule no other run is cheaper and more accurate
    quantity = [row for (_, _, name), row in rows.items() if name == "inside temperature_K"]
    for row in quantity:
        dominated = any(float(other["seconds"]) < float(row["seconds"]) and float(other["error"]) <= float(row["error"])
                        for other in quantity)
        assert dominated == (row["pareto"] == "0"), row


def richardson_knows_how_wrong_it_is(study):
    """Without the exact values: the reference errs by no more than it says, and it says little."""
    _, rows = study.accuracy("richardson", "Accuracy/Reference=Richardson", "Accuracy/Names=step, mesh")
    row = rows["scene", "as it is", "inside temperature_K at 12"]
    uncertainty = float(row["reference_uncertainty"])
    reference = float(row["last_value"]) - float(row["error"])  # backward Euler cools too slowly
    assert abs(reference - exact(12)) < uncertainty < 0.02, (reference - exact(12), uncertainty)
    _, rows = study.accuracy("finer", "Accuracy/Reference=finer run", "Accuracy/Finer run=Time/Step=0.03125",
                             "Accuracy/Names=step")
    row = rows["scene", "as it is", "inside temperature_K at 12"]
    uncertainty = float(row["reference_uncertainty"])
    reference = float(row["last_value"]) - float(row["error"])
    assert 0.5 * uncertainty < abs(reference - exact(12)) < 2 * uncertainty, (reference - exact(12), uncertainty)


def finished_runs_are_not_repeated(study):
    study.accuracy("again", "Accuracy/Names=step")
    first = {path: path.stat().st_mtime_ns for path in pathlib.Path("again/runs").glob("*/probes.csv")}
    assert len(first) == 4, first
    pathlib.Path("again/runs/step_1/outcome.json").unlink()  # as if it had been interrupted there
    said, _ = study.accuracy("again", "Accuracy/Names=step")
    second = {path: path.stat().st_mtime_ns for path in first}
    repeated = [path.parent.name for path in first if first[path] != second[path]]
    assert repeated == ["step_1"], repeated
    assert said.count("(kept)") == 4, said
    # other settings of the scene are other runs
    said, _ = study.accuracy("again", "Accuracy/Names=step", "Time/End=12", "Output/Times=4")
    assert said.count("(kept)") == 1, said  # the scene as it is, which the ladder has as a rung


def standard_ladders_fit_the_scene(study):
    said, rows = study.accuracy("standard", "Accuracy/Names=", "Accuracy/Quantities=", "Accuracy/Reference=Richardson",
                                "Accuracy/Tolerances=", "Time/Step=2")
    ladders = {ladder for ladder, _, _ in rows}
    assert ladders == {"scene", "mesh", "step", "IDA", "solver", "degree", "cells", "method", "condensation"}, ladders
    assert {quantity for _, _, quantity in rows} == {"inside temperature_K", "/extremes/temperature_max_K"}
    assert (pathlib.Path("standard") / "accuracy.png").exists() or "accuracy_0.png" in (
        pathlib.Path("standard/accuracy.md").read_text())
    if shutil.which("gnuplot"):
        assert pathlib.Path("standard/accuracy_0.png").read_bytes()[:4] == b"\x89PNG"


def products_of_ladders_have_every_combination(study):
    _, rows = study.accuracy("product", "Accuracy/Names=both, cells", "Accuracy/both/Entries=Time/Step",
                             "Accuracy/both/Rungs=4 | 2", "Accuracy/both/Times=cells")
    settings = {setting for ladder, setting, _ in rows if ladder == "both"}
    assert settings == {"4, tetrahedra", "4, hexahedra", "2, tetrahedra", "2, hexahedra"}, settings


def effects_tell_what_the_scene_calls_for(study):
    """Perfusion cools by 30 K; metabolism, switched on for this, warms by 0.16 K; free expansion changes no temperature."""
    study.run("effects", study.folder / "cooling.prm", "--output", "effects", "--set", "Effects/Metabolism=constant",
              "--set", "Effects/Deformation=equilibrium", "--set", "Effects/Damage=CEM43", "--set",
              "Boundaries/outside/Mechanical=fixed")
    with open("effects/effects.csv", newline="") as file:
        rows = {(row["left_out"], row["quantity"]): row for row in csv.DictReader(file)}

    def change(effect, quantity="inside temperature_K"):
        row = rows[effect, quantity]
        return float(row["without"]) - float(row["with"])

    # backward Euler: dT = (Q / (rho C) - RATE (T - 310)) dt, so metabolism adds Q/w (1 - the decay)
    decay = (1 + RATE * 0.5) ** -round(END / 0.5)
    warmed = 33800 / 360000 * (1 - decay)
    assert abs(change("metabolism") + warmed) < 1e-6, (change("metabolism"), warmed)
    assert abs(change("perfusion") - (350 + 33800 / 4.192e6 * END - (310 + 40 * decay + warmed))) < 1e-6
    assert change("deformation") == 0
    table = {line.split("|")[1].strip(): line.split("|")[-2].strip()
             for line in pathlib.Path("effects/effects.md").read_text().splitlines() if line.startswith("| ")}
    assert table["perfusion"] == "yes" and table["deformation"] == "no", table
    assert table["metabolism"] == ("yes" if warmed > 0.1 else "no"), (table, warmed)


DEPTH = math.sqrt(0.613 / 360000)  # m, of slab.prm


def steady(x):
    return 310 + 10 * math.cosh((0.01 - x) / DEPTH) / math.cosh(0.01 / DEPTH)


def meshes_converge_to_the_steady_slab(study):
    """Against a finer run; order 2; the finer run itself is where the closed form says; steps and margins do not matter."""
    _, rows = study.accuracy("slab", scene="slab.prm")

    def cells(ladder, quantity):
        return [row for (name, _, text), row in rows.items() if name == ladder and text.startswith(quantity)]

    for probe, x in (("near", 0.001), ("far", 0.005)):
        found = cells("cells", probe)
        errors = [float(row["error"]) for row in found]
        orders = [math.log2(a / b) for a, b in zip(errors, errors[1:])]
        assert abs(orders[-1] - 2) < 0.15, (probe, errors, orders)
        assert float(found[0]["reference_uncertainty"]) < 1e-5
        for row, error in zip(found, errors):
            assert abs(abs(float(row["last_value"]) - steady(x)) - error) < 2e-5, (row, steady(x))
        spread = [float(row["last_value"]) for row in cells("steps", probe)]
        assert len(spread) == 3 and max(spread) - min(spread) < 1e-6 and errors[0] > 1e-3, spread
        quadratic = [float(row["error"]) for row in cells("both", probe) if row["setting"].startswith("2,")]
        linear = [float(row["error"]) for row in cells("both", probe) if row["setting"].startswith("1,")]
        assert len(quadratic) == len(linear) == 4 and all(
            q < 0.2 * p for q, p in zip(quadratic[1:], linear[1:]))
    outcome = json.loads(pathlib.Path("slab/runs/cells_1/outcome.json").read_text())
    assert len(outcome["seconds"]) == 2, outcome


def goal_needs_a_finer_mesh(study):
    said = study.run(study.folder / "slab.prm", "--output", "slab_goal")
    with open("slab_goal/probes.csv", newline="") as file:
        found = {row["probe"]: float(row["temperature_K"]) for row in csv.DictReader(file)}
    wrong = max(abs(found["near"] - steady(0.001)), abs(found["far"] - steady(0.005)))
    assert wrong <= 0.02, (wrong, said)
    # not by a mesh far too fine: its estimate is of the size of its error
    estimate = float(pathlib.Path("slab_goal/choice.txt").read_text().split("errors: ")[1].split(" K")[0])
    assert estimate <= 0.01 and wrong > 0.02 * estimate, (wrong, estimate)


def goal_is_reached(study):
    for goal in (1.0, 0.05):
        out = f"goal_{goal:g}"
        said = study.run(study.folder / "cooling.prm", "--output", out, "--set", f"Accuracy/Temperature within={goal}")
        assert f"Temperature within {goal:g} K: chose" in said, said
        with open(f"{out}/probes.csv", newline="") as file:
            found = [abs(float(row["temperature_K"]) - exact(float(row["time_s"]))) for row in csv.DictReader(file)]
        assert max(found) <= goal, found
        assert "estimated errors" in pathlib.Path(f"{out}/choice.txt").read_text()


def forecast_and_ledger_add_up(study):
    """The ledger's parts make up the wall time but for 5 %; a forecast stands in the summary, and `check` makes one too."""
    said = study.run("check", study.folder / "cooling.prm", "--set", "Mesh/Subdivisions=6", "--set", "Time/Step=0.05")
    line = next(line for line in said.splitlines() if line.startswith("Forecast"))
    assert " s and " in line and "trial of the first 30 steps" in line, line
    shares = []
    for _ in range(5):  # on a busy machine a run may be interrupted where no part counts
        study.run(study.folder / "cooling.prm", "--output", "ledger", "--set", "Mesh/Subdivisions=14", "--set",
                  "Time/Step=0.05", "--set", "Effects/Deformation=equilibrium", "--set", "Effects/Damage=CEM43", "--set",
                  "Boundaries/outside/Mechanical=fixed")
        summary = json.loads(pathlib.Path("ledger/summary.json").read_text())
        ledger = summary["cost"]["ledger"]
        assert {"heat", "deformation", "damage", "set-up", "output", "rest"} <= set(ledger), ledger
        assert abs(sum(part["seconds"] for part in ledger.values()) - summary["cost"]["wall_s"]) < 1e-6
        shares.append(ledger["rest"]["share"])
        if shares[-1] < 0.05:
            break
    assert -0.001 < min(shares) < 0.05, (shares, ledger)
    nodes = 15 ** 3
    assert ledger["heat"]["unknowns"] == nodes and ledger["deformation"]["unknowns"] == 3 * nodes
    # what is built holds at least its matrix: 15 entries a row on average of these tetrahedra, 12 bytes each
    assert ledger["heat"]["bytes"] > 12 * 12 * nodes and ledger["deformation"]["bytes"] > 9 * 12 * 12 * nodes
    forecast = summary["forecast"]
    assert forecast["after_steps"] == 30 and 0.1 < forecast["wall_over_actual"] < 10, forecast
    assert 0.7 < forecast["memory_over_actual"] <= 1, forecast


if __name__ == "__main__":
    statement, program, folder, *prefix = sys.argv[1:]
    globals()[statement](Study([*prefix, program], pathlib.Path(folder)))
