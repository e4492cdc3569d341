# SPDX-License-Identifier: LGPL-2.1-or-later
"""Times Cautery beside FreeFEM on the benchmark cube and writes the table into doc/performance.md.

Usage: compare.py [--repeat R] [N ...]         (default: 5 repeats of N = 10 and 20)
Needs Debian's freefem++ and libfreefem++. Both run by turns on one core; medians are quoted.
"""
import argparse
import csv
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
ENVIRONMENT = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "DEAL_II_NUM_THREADS": "1",
               "FF_LOADPATH": "/usr/lib/freefem++/;;"}
BEGIN, END = "<!-- peers: begin -->", "<!-- peers: end -->"


def measured(command):
    """Wall seconds, peak memory in MB, and standard output of a command pinned to one core."""
    start = time.perf_counter()
    process = subprocess.Popen(["taskset", "-c", "0", *map(str, command)], stdout=subprocess.PIPE, text=True,
                               env=ENVIRONMENT)
    output = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"failed: {' '.join(map(str, command))}\n{output}")
    return time.perf_counter() - start, usage.ru_maxrss / 1024, output


def freefem(n, deformation, folder):
    wall, memory, output = measured(["FreeFem++", "-nw", "-v", "0", HERE / "cube.edp", folder / f"{n}.mesh",
                                     int(deformation)])
    probes = {}
    for line in output.splitlines():
        words = line.split()
        if words[:1] == ["probe"]:
            probes[(int(words[1]), words[2])] = (float(words[3]), float(words[4]))
        elif words[:1] == ["set-up"]:
            loop = float(words[3])
    return {"loop": loop, "wall": wall, "memory": memory, "probes": probes}


def cautery(n, deformation, folder, *settings):
    scene = ROOT / "prm" / "benchmarks" / f"cube_heat{'_deformation' if deformation else ''}_{n}.prm"
    arguments = [word for setting in settings for word in ("--set", setting)]
    wall, memory, _ = measured([ROOT / "build" / "cautery", scene, "--output", folder / "out", *arguments])
    cost = json.loads((folder / "out" / "summary.json").read_text())["cost"]
    with open(folder / "out" / "probes.csv", newline="") as file:
        probes = {(int(float(r["time_s"])), r["probe"]): (float(r["temperature_K"]),
                                                         float(r.get("displacement_x_m") or 0))
                  for r in csv.DictReader(file)}
    set_up = sum(s for part, s in cost["seconds_by_part"].items() if "set-up" in part)
    loop = 120 * cost["seconds_per_step"] - sum(s for part, s in cost["seconds_by_part"].items()
                                                if part.endswith(": set-up"))
    return {"loop": loop, "wall": wall, "memory": memory, "set-up": set_up, "probes": probes}


def disagreement(ours, theirs):
    """The largest difference of temperature rise and of displacement, relative to the largest of each."""
    worst = 0.
    for which, zero in ((0, 310.), (1, 0.)):
        largest = max(abs(v[which] - zero) for v in theirs.values()) or 1.
        worst = max(worst, max(abs(ours[key][which] - value[which]) for key, value in theirs.items()) / largest)
    return worst


def median(runs, key):
    return statistics.median(run[key] for run in runs)


def row(n, name, ours, theirs, folder, repeat):
    pairs = [(ours(), theirs()) for _ in range(repeat)]
    us, them = zip(*pairs)
    apart = disagreement(us[0]["probes"], them[0]["probes"])
    return (f"| {n} | {name} | {median(us, 'loop'):.4f} | {median(them, 'loop'):.4f} | "
            f"{median(us, 'loop') / median(them, 'loop'):.2f} | {median(us, 'wall'):.2f} | {median(them, 'wall'):.2f} | "
            f"{median(us, 'memory'):.0f} | {median(them, 'memory'):.0f} | {apart:.0e} |")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--repeat", type=int, default=5)
    parser.add_argument("sizes", type=int, nargs="*", default=[10, 20])
    arguments = parser.parse_args()
    lines = ["| n | case | Cautery, loop s | FreeFEM, loop s | ratio | Cautery, process s | FreeFEM, process s | "
             "Cautery, MB | FreeFEM, MB | disagreement |", "|" + "---|" * 10]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for n in arguments.sizes:
            subprocess.run([sys.executable, HERE / "kuhn_mesh.py", str(n), folder / f"{n}.mesh"], check=True)
            for deformation, case, settings in (
                    (False, "heat", ()),
                    (True, "heat and displacement at every step", ()),
                    (True, "heat, displacement at outputs", ("Numerics/Displacement at=output times",))):
                lines.append(row(n, case, lambda: cautery(n, deformation, folder, *settings),
                                 lambda: freefem(n, deformation, folder), folder, arguments.repeat))
                print(lines[-1], flush=True)
    page = ROOT / "doc" / "performance.md"
    text = page.read_text()
    before, rest = text.split(BEGIN)
    page.write_text(before + BEGIN + "\n" + "\n".join(lines) + "\n" + END + rest.split(END)[1])


if __name__ == "__main__":
    main()
