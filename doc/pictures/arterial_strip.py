# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws Figure 63 of the thesis: Cauchy stress of the arterial strip against its stretch, as the program finds it and as
the closed form has it.

Usage: /usr/bin/python3 doc/pictures/arterial_strip.py output/ch7_arterial_strip doc/images/arterial_strip.png
(Debian's python3-matplotlib)
"""
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests" / "thesis"))
from arterial_strip import curve  # noqa: E402


def main(directory, picture):
    with open(pathlib.Path(directory) / "probes.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    found = [(1 + float(row["displacement_x_m"]) / float(row["x_m"]), float(row["stress_xx_Pa"]) / 1e3) for row in rows]
    stretches = [1 + i * (found[-1][0] - 1) / 100 for i in range(101)]
    figure, axes = pyplot.subplots(figsize=(6, 4), dpi=120)
    axes.plot(stretches, [curve(stretch)[1] / 1e3 for stretch in stretches], color="#b0471c", label="closed form")
    axes.plot(*zip(*found), "o", color="#1c4f9c", markersize=4, label="prm/thesis/ch7_arterial_strip.prm")
    axes.set(xlabel="stretch", ylabel="Cauchy stress, kPa", title="Arterial strip, two families of fibres at 43.39°")
    axes.legend(frameon=False)
    axes.grid(alpha=0.3)
    figure.tight_layout()
    figure.savefig(picture)


if __name__ == "__main__":
    main(*sys.argv[1:])
