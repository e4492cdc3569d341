# SPDX-License-Identifier: LGPL-2.1-or-later
"""Times the explicit steps of Cautery, in single precision on one core, beside two public programs of the same method
on the same cube of 6 N^3 linear tetrahedra: FEDFEMBioheatExpan (github: jinaojakezhang; heat, thermal stretch, one
family of fibres) and NiftySim (github: eloygarcia/niftysim; neo-Hookean alone).

Usage: tled.py FEDFEM_SOURCE_FILE NIFTYSIM_PROGRAM [N [REPEAT]]
FEDFEM is compiled here with -O3 -march=native; its C library is Microsoft's, two functions of which are made up for.
"""
import csv
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

from kuhn_mesh import cube

ROOT = pathlib.Path(__file__).resolve().parents[2]
LENGTH, STEP, STEPS = 0.1, 1e-3, 1000
YOUNG, POISSON, CONDUCTIVITY, HEAT, DENSITY, EXPANSION = 2716.2, 0.35, 0.613, 4192, 1000, 3e-4
SHEAR, BULK = YOUNG / 2 / (1 + POISSON), YOUNG / 3 / (1 - 2 * POISSON)
POWER, DAMPING, TEMPERATURE = 10, 50, 310  # W, 1/s, K
MICROSOFT = """
#include <cstdio>
#include <cstring>
#include <cmath>
#include <string>
#include <algorithm>
inline int fopen_s(FILE **file, const char *name, const char *mode)
{ *file = std::fopen(name, mode); return *file == nullptr; }
template <typename... A> int fscanf_s(FILE *f, const char *format, char *text, unsigned int, A... rest)
{ return std::fscanf(f, format, text, rest...); }
template <typename T, typename... A> int fscanf_s(FILE *f, const char *format, T *first, A... rest)
{ return std::fscanf(f, format, first, rest...); }
"""


def run(*command, folder=None):
    return subprocess.run(["taskset", "-c", "0", *map(str, command)], cwd=folder, check=True, text=True,
                          stdout=subprocess.PIPE, env={**os.environ, "OMP_NUM_THREADS": "1"}).stdout


class Fedfem:
    name, physics = "FEDFEMBioheatExpan", "heat, thermal stretch, fibres"

    def __init__(self, source, n, folder):
        self.folder = folder
        (folder / "microsoft.h").write_text(MICROSOFT)
        run("g++", "-O3", "-march=native", "-fopenmp", "-w", "-include", folder / "microsoft.h", source, "-o",
            folder / "fedfem")
        nodes, tetrahedra = cube(n)
        held = [i for i, p in enumerate(nodes) if p[0] == 0 or any(c in (0, n) for c in p[1:])]
        self.middle = nodes.index((n // 2,) * 3)
        with open(folder / "cube.txt", "w") as file:
            for i, place in enumerate(nodes):
                print(i, *(LENGTH * c / n for c in place), file=file)
            print(f"TI {SHEAR} {BULK} 2000 1 1 0\nT_ISO {HEAT} {CONDUCTIVITY}\nT_EXPAN_ISO {EXPANSION}\n"
                  f"Density {DENSITY}\nT4", file=file)
            for i, corners in enumerate(tetrahedra):
                print(i, *corners, file=file)
            print("<FixP>\nall", *held, f"\n<HFlux>\n{POWER}", self.middle, f"\n<FixT>\n{TEMPERATURE}", *held,
                  f"\n</BC>\nDamping {DAMPING}\nT0 {TEMPERATURE}\nTimeStep {STEP}\nTotalTime {STEP * STEPS}",
                  file=file)

    def seconds(self):
        output = run(self.folder / "fedfem", "cube.txt", folder=self.folder)
        values = (self.folder / "T.vtk").read_text().split("LOOKUP_TABLE default\n")[1].split()
        self.heating = float(values[self.middle]) - TEMPERATURE
        return float(re.search(r"Computation time:\s+(\d+) ms", output)[1]) / 1e3


class Niftysim:
    name, physics = "NiftySim", "neo-Hookean alone"

    def __init__(self, program, n, folder):
        self.program, self.scene = program, folder / "cube.xml"
        nodes, tetrahedra = cube(n)
        held = [i for i, p in enumerate(nodes) if p[0] == 0 or any(c in (0, n) for c in p[1:])]
        with open(self.scene, "w") as file:
            print(f'<?xml version="1.0"?>\n<Model>\n<Nodes DOF="3" NumNodes="{len(nodes)}">', file=file)
            for place in nodes:
                print(*(LENGTH * c / n for c in place), file=file)
            print(f'</Nodes>\n<Elements NumEls="{len(tetrahedra)}" Type="T4">', file=file)
            for corners in tetrahedra:
                print(*corners, file=file)
            print(f'</Elements>\n<ElementSet Size="all"><Material Type="NH"><ElasticParams NumParams="2">{SHEAR} '
                  f'{BULK}</ElasticParams></Material>0</ElementSet>', file=file)
            for axis in range(3):
                print(f'<Constraint DOF="{axis}" NumNodes="{len(held)}" Type="Fix"><Nodes>', *held,
                      "</Nodes></Constraint>", file=file)
            print(f"<SystemParams><TimeStep>{STEP}</TimeStep><TotalTime>{STEP * STEPS}</TotalTime><DampingCoeff>"
                  f"{DAMPING}</DampingCoeff><HGKappa>0.075</HGKappa><Density>{DENSITY}</Density></SystemParams>\n"
                  "</Model>", file=file)

    def seconds(self):
        output = run(self.program, "-x", self.scene, "-t")
        return float(re.search(r"Execution time: (\S+) ms", output)[1]) / 1e3


class Cautery:
    name = "Cautery"

    def __init__(self, scene, n, folder, physics, *settings):
        self.scene, self.folder, self.physics = ROOT / "prm" / "benchmarks" / scene, folder / "out", physics
        self.settings = ("Mesh/Subdivisions=" + str(n), f"Time/End={STEP * STEPS}", f"Time/Step={STEP * STEPS}",
                         "Boundaries/top/Traction=0; 0; 0", *settings)

    def seconds(self):
        arguments = [word for setting in self.settings for word in ("--set", setting)]
        run(ROOT / "build" / "cautery", self.scene, "--output", self.folder, *arguments)
        with open(self.folder / "probes.csv", newline="") as file:
            self.heating = float(list(csv.DictReader(file))[-1].get("temperature_K") or TEMPERATURE) - TEMPERATURE
        cost = json.loads((self.folder / "summary.json").read_text())["cost"]
        return cost["seconds_by_part"]["deformation: explicit steps"]


def main(fedfem_source, niftysim_program, n=20, repeat=3):
    n, cells = int(n), 6 * int(n)**3
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        pairs = ((Fedfem(fedfem_source, n, folder),
                  Cautery("tled_cache_single.prm", n, folder, Fedfem.physics, "Effects/Conduction in=deformed body",
                          f"Heat sources/needle/Power={POWER}")),
                 (Niftysim(niftysim_program, n, folder),
                  Cautery("tled_cache_neo_hookean.prm", n, folder, Niftysim.physics)))
        print("| program | physics | tetrahedra | million tetrahedra a second | ratio |")
        print("|" + "---|" * 5)
        for them, us in pairs:
            times = [(us.seconds(), them.seconds()) for _ in range(int(repeat))]
            ours, theirs = (STEPS * cells / 1e6 / statistics.median(column) for column in zip(*times))
            print(f"| {them.name} | {them.physics} | {cells} | {theirs:.1f} | |")
            print(f"| {us.name} | {us.physics} | {cells} | {ours:.1f} | {ours / theirs:.1f} |", flush=True)
        them, us = pairs[0]
        print(f"heating of the middle node, K: {them.name} {them.heating:.5f}, {us.name} {us.heating:.5f}")


if __name__ == "__main__":
    main(*sys.argv[1:])
