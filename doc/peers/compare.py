# SPDX-License-Identifier: LGPL-2.1-or-later
"""Times Cautery on the benchmark cube and writes tables into doc/performance.md.

Usage: compare.py [--repeat R] peers [N ...]     beside FreeFEM (Debian's freefem++ and libfreefem++)
       compare.py [--repeat R] growth [N ...]    how time and memory grow with the mesh
All run by turns on one core; medians of R runs (default 5) are quoted. Default sizes: 10 and 20.
"""
import argparse
import csv
import json
import math
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
CASES = ((False, "heat", ()),
         (True, "heat and displacement at every step", ()),
         (True, "heat, displacement at outputs", ("Numerics/Displacement at=output times",)))


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
    scene = ROOT / "prm" / "benchmarks" / f"cube_heat{'_deformation' if deformation else ''}_10.prm"
    arguments = [word for setting in (f"Mesh/Subdivisions={n}", *settings) for word in ("--set", setting)]
    wall, memory, _ = measured([ROOT / "build" / "cautery", scene, "--output", folder / "out", *arguments])
    summary = json.loads((folder / "out" / "summary.json").read_text())
    cost = summary["cost"]
    with open(folder / "out" / "probes.csv", newline="") as file:
        probes = {(int(float(r["time_s"])), r["probe"]): (float(r["temperature_K"]),
                                                         float(r.get("displacement_x_m") or 0))
                  for r in csv.DictReader(file)}
    # what is set up once, at the first step, is booked by itself
    set_up = sum(s for part, s in cost["seconds_by_part"].items() if part.endswith(": set-up"))
    return {"loop": 120 * cost["seconds_per_step"] - set_up, "wall": wall, "memory": memory, "probes": probes,
            "unknowns": sum(summary["unknowns"].values())}


def disagreement(ours, theirs):
    """The largest difference of temperature rise and of displacement, relative to the largest of each."""
    worst = 0.
    for which, zero in ((0, 310.), (1, 0.)):
        largest = max(abs(v[which] - zero) for v in theirs.values()) or 1.
        worst = max(worst, max(abs(ours[key][which] - value[which]) for key, value in theirs.items()) / largest)
    return worst


def median(runs, key):
    return statistics.median(run[key] for run in runs)


def beside_freefem(sizes, repeat, folder):
    yield ("| n | case | Cautery, loop s | FreeFEM, loop s | ratio | Cautery, process s | FreeFEM, process s | "
           "Cautery, MB | FreeFEM, MB | disagreement |")
    yield "|" + "---|" * 10
    for n in sizes:
        subprocess.run([sys.executable, HERE / "kuhn_mesh.py", str(n), folder / f"{n}.mesh"], check=True)
        for deformation, case, settings in CASES:
            us, them = zip(*((cautery(n, deformation, folder, *settings), freefem(n, deformation, folder))
                             for _ in range(repeat)))
            yield (f"| {n} | {case} | {median(us, 'loop'):.4f} | {median(them, 'loop'):.4f} | "
                   f"{median(us, 'loop') / median(them, 'loop'):.2f} | {median(us, 'wall'):.2f} | "
                   f"{median(them, 'wall'):.2f} | {median(us, 'memory'):.0f} | {median(them, 'memory'):.0f} | "
                   f"{disagreement(us[0]['probes'], them[0]['probes']):.0e} |")


def growth(sizes, repeat, folder):
    yield ("| n | case | unknowns N | loop s | loop, ns per step and N log2 N | process s | "
           "process, us per N log2 N | MB |")
    yield "|" + "---|" * 8
    for deformation, case, settings in CASES:
        for n in sizes:
            runs = [cautery(n, deformation, folder, *settings) for _ in range(repeat)]
            unknowns = runs[0]["unknowns"]
            size = unknowns * math.log2(unknowns)
            yield (f"| {n} | {case} | {unknowns} | {median(runs, 'loop'):.4f} | "
                   f"{median(runs, 'loop') / 120 / size * 1e9:.2f} | {median(runs, 'wall'):.2f} | "
                   f"{median(runs, 'wall') / size * 1e6:.2f} | {median(runs, 'memory'):.0f} |")


TABLES = {"peers": beside_freefem, "growth": growth}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--repeat", type=int, default=5)
    parser.add_argument("table", choices=TABLES)
    parser.add_argument("sizes", type=int, nargs="*", default=[10, 20])
    arguments = parser.parse_args()
    lines = []
    with tempfile.TemporaryDirectory() as name:
        for line in TABLES[arguments.table](arguments.sizes, arguments.repeat, pathlib.Path(name)):
            lines.append(line)
            print(line, flush=True)
    page = ROOT / "doc" / "performance.md"
    begin, end = (f"<!-- {arguments.table}: {word} -->" for word in ("begin", "end"))
    before, rest = page.read_text().split(begin)
    page.write_text(before + begin + "\n" + "\n".join(lines) + "\n" + end + rest.split(end)[1])


if __name__ == "__main__":
    main()
