# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables 7 and 8 of the thesis: milliseconds of a step, with our solvers and with Gauss-Seidel at a margin of error of 0.001; and
what condensation costs on cubes of other sizes.

Usage, from the project's root: python3 doc/peers/thesis_steps.py [REPETITIONS], on a quiet machine; medians.
"""
import json
import statistics
import subprocess
import sys
import tempfile

SOLVERS = {
    "ours": [],
    "direct": [f"Numerics/{what} solver/Method=direct" for what in ("Heat", "Deformation")],
    "Gauss-Seidel": [f"Numerics/{what} solver/{entry}" for what in ("Heat", "Deformation") for entry in
                     ("Method=Gauss-Seidel", "Tolerance=1e-3", "Remembered solutions=0",
                      "Largest number of iterations=100000")]}
EVERY_STEP = ["Numerics/Displacement at=every step", "Output/Interval=120"]
WITHOUT_DAMAGE = [*EVERY_STEP, "Effects/Damage=off"]
CLOSE = [f"Numerics/{what} solver/Tolerance=1e-8" for what in ("Heat", "Deformation")]
SCENES = {"non-Fourier, coupled, held, 1331 nodes": ("ch6_cube_non_fourier", WITHOUT_DAMAGE),
          "the same, margin 1e-8 of ours": ("ch6_cube_non_fourier", [*WITHOUT_DAMAGE, *CLOSE]),
          "Fourier, coupled, held": ("ch6_cube_fourier", WITHOUT_DAMAGE),
          "convective and free, all 1331 nodes (Table 7)": ("ch6_convective_full", WITHOUT_DAMAGE),
          "condensed to 729 nodes (Table 7)": ("ch6_convective_condensed", WITHOUT_DAMAGE),
          "uniform, finite differences (Table 8)": ("ch6_uniform_finite_differences", EVERY_STEP),
          "uniform, finite elements (Table 8)": ("ch6_uniform_finite_elements", EVERY_STEP)}


def measured(scene, entries, repetitions):
    """Milliseconds of a step, seconds of setting solvers up, MB."""
    steps = []
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(repetitions):
            words = [word for entry in entries for word in ("--set", entry)]
            subprocess.run(["build/cautery", f"prm/thesis/{scene}.prm", *words, "--output", folder], check=True,
                           stdout=subprocess.DEVNULL)
            with open(f"{folder}/summary.json", encoding="utf-8") as file:
                summary = json.load(file)
            cost = summary["cost"]
            set_up = sum(s for part, s in cost["seconds_by_part"].items() if part.endswith(": set-up"))
            steps.append(1e3 * (cost["seconds_per_step"] - set_up / summary["time_steps"]))
    return statistics.median(steps), set_up, cost["peak_memory_bytes"] / 1e6


def tables(repetitions):
    print("| case | ours, ms | Gauss-Seidel 0.001, ms |\n|---|---|---|")
    for name, (scene, entries) in SCENES.items():
        ours, thesis = (measured(scene, entries + SOLVERS[solver], repetitions)[0] for solver in ("ours", "Gauss-Seidel"))
        print(f"| {name} | {ours:.2f} | {thesis:.1f} |", flush=True)


def condensation(repetitions):
    print("\n| cells a side | nodes | kept | ms a step | set-up, s | MB |\n|---|---|---|---|---|---|")
    for n in (4, 6, 8, 10):
        entries = [*WITHOUT_DAMAGE, f"Mesh/Subdivisions={n}"]
        probe = ["Output/Probe names=P1", "Output/Probe places=0.005, 0.005, 0.005"]
        for kept, scene, more in (("all, ours", "full", []), ("all, factorised", "full", SOLVERS["direct"]),
                                  ("inside", "condensed", ["Numerics/Kept nodes=inside"]),
                                  ("1", "condensed", ["Numerics/Kept nodes=probes", *probe])):
            step, set_up, memory = measured(f"ch6_convective_{scene}", entries + more, repetitions)
            print(f"| {n} | {(n + 1) ** 3} | {kept} | {step:.3f} | {set_up:.2f} | {memory:.0f} |", flush=True)


if __name__ == "__main__":
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 5
    tables(count)
    condensation(count)
