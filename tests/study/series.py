# SPDX-License-Identifier: LGPL-2.1-or-later
"""The exact series of the chapter 6 cube: the studies' scenes have its values, and the program comes near it, in both
models. Usage: series.py CAUTERY ROOT"""
import csv
import pathlib
import subprocess
import sys

program, root = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path.insert(0, str(root / "doc/peers"))
import cube_series  # noqa: E402

RADIUS = 0.001  # m: twice the scenes', so that a coarse mesh will do
MESH = ["Mesh/Cells=hexahedra", "Mesh/Subdivisions=10", "Numerics/Element degree=2", "Time/Integrator=IDA"]
CASES = {"cube_fourier": (0.0, 0.015), "cube_non_fourier": (16.0, 0.06)}  # tau, s; bound, K, of a rise of 30 K


def values_in(scene):
    text = scene.read_text().split("set Exact values = ")[1].replace("\\\n", " ")
    return [part.strip() for part in text.split("\n")[0].split(";")]


for name, (tau, bound) in CASES.items():
    scene = root / f"prm/accuracy/{name}.prm"
    series = cube_series.temperatures(tau)
    assert values_in(scene) == [cube_series.expression(series[place]) for place in ("P1", "P2")], name
    wider = cube_series.temperatures(tau, radius=RADIUS)
    changes = [*MESH, *(f"Heat sources/{source}/Radius={RADIUS}" for source in ("y3", "y4", "y5", "y6", "y7"))]
    subprocess.run([program, scene, "--output", name, *(word for change in changes for word in ("--set", change))],
                   check=True, stdout=subprocess.DEVNULL)
    with open(f"{name}/probes.csv", newline="") as file:
        found = {(row["probe"], float(row["time_s"])): float(row["temperature_K"]) for row in csv.DictReader(file)}
    worst = max(abs(found[place, time] - value) for place, values in wider.items()
                for time, value in zip(cube_series.TIMES, values))
    print(f"{name}: within {worst:.4f} K of the series")
    assert worst < bound, (name, worst)
