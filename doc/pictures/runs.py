# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs of the thesis's scenes, kept in output/thesis/, and what their pictures share."""
import csv
import hashlib
import json
import pathlib
import subprocess

import matplotlib
import numpy

matplotlib.use("Agg")
from matplotlib import pyplot, tri  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
RUNS, IMAGES = ROOT / "output" / "thesis", ROOT / "doc" / "images" / "thesis"
CENTRE = 0.005  # m, of the cube of 10 mm
FIELDS = ("Output/Fields=on", "Output/Interval=0", "Output/Times=10, 120")


class Run:
    """Of prm/thesis/SCENE.prm, with further entries."""

    def __init__(self, scene, *entries):
        self.folder = RUNS / (scene + ("_" + hashlib.sha1("\n".join(entries).encode()).hexdigest()[:8] if entries else ""))
        if not (self.folder / "summary.json").exists():
            words = [word for entry in entries for word in ("--set", entry)]
            subprocess.run([ROOT / "build" / "cautery", ROOT / "prm" / "thesis" / f"{scene}.prm", *words, "--output",
                            self.folder], check=True, stdout=subprocess.DEVNULL)
        self.summary = json.loads((self.folder / "summary.json").read_text())
        with open(self.folder / "probes.csv", newline="", encoding="utf-8") as file:
            self.rows = list(csv.DictReader(file))

    def column(self, probe, column):
        return [float(row[column]) for row in self.rows if row["probe"] == probe]

    def course(self, probe, column, factor=1.0):
        return self.column(probe, "time_s"), [factor * value for value in self.column(probe, column)]

    def along(self, time, column, factor=1.0):
        """From the cube's centre (mm), at the probes P1, P2, ..."""
        rows = [row for row in self.rows if float(row["time_s"]) == time and row["probe"].startswith("P")]
        return [1e3 * (float(row["x_m"]) - CENTRE) for row in rows], [factor * float(row[column]) for row in rows]

    def plane(self, time, *fields, axis=1, at=CENTRE):
        """A section: its triangles (mm) and the values of fields at their corners."""
        import vtk
        from vtk.util.numpy_support import vtk_to_numpy

        number = sorted({float(row["time_s"]) for row in self.rows}).index(time)
        reader = vtk.vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(sorted(self.folder.glob("solution_*.vtu"))[number]))
        plane = vtk.vtkPlane()
        normal = [float(d == axis) for d in range(3)]
        plane.SetNormal(normal)
        plane.SetOrigin([at * n for n in normal])
        cutter = vtk.vtkCutter()
        cutter.SetCutFunction(plane)
        cutter.SetInputConnection(reader.GetOutputPort())
        triangles = vtk.vtkTriangleFilter()
        triangles.SetInputConnection(cutter.GetOutputPort())
        triangles.Update()
        section = triangles.GetOutput()
        points = 1e3 * vtk_to_numpy(section.GetPoints().GetData())
        corners = vtk_to_numpy(section.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        first, second = (d for d in range(3) if d != axis)
        data = section.GetPointData()
        return (tri.Triangulation(points[:, first], points[:, second], corners),
                *(vtk_to_numpy(data.GetArray(field)) for field in fields))


def axes_of(n=1, width=6.0, rows=1):
    figure, axes = pyplot.subplots(rows, n, figsize=(width, 4 * rows), dpi=110, squeeze=False)
    return figure, list(axes.flat)


def finish(figure, axes, name, **labels):
    for one in axes:
        one.set(**labels)
        one.grid(alpha=0.3)
        if one.get_legend_handles_labels()[0]:
            one.legend(frameon=False, fontsize=8)
    save(figure, name)


def save(figure, name):
    figure.tight_layout()
    figure.savefig(IMAGES / f"{name}.png")
    pyplot.close(figure)


def maps(name, rows, axis=1, about=None):
    """Fields on sections: rows of (label, [(title, (triangles, values)), ...]), one scale of colours in a row; mm.
    about: (first, second, half width) of what is shown."""
    columns = max(len(row) for _, row in rows)
    figure, axes = pyplot.subplots(len(rows), columns, figsize=(2.8 * columns + 1.6, 2.6 * len(rows)), dpi=100,
                                   squeeze=False, constrained_layout=True)
    first, second = (letter for d, letter in enumerate("xyz") if d != axis)
    for line, (label, row) in zip(axes, rows):
        low = min(values.min() for _, (_, values) in row)
        high = max(values.max() for _, (_, values) in row)
        levels = numpy.linspace(low, high, 33)
        for one, (title, (triangles, values)) in zip(line, row):
            filled = one.tricontourf(triangles, values, levels=levels, cmap="turbo")
            one.set(title=title, aspect="equal", xlabel=f"{first}, mm", ylabel=f"{second}, mm")
            one.title.set_fontsize(9)
            one.label_outer()
            if about:
                one.set(xlim=(about[0] - about[2], about[0] + about[2]), ylim=(about[1] - about[2], about[1] + about[2]))
        figure.colorbar(filled, ax=list(line), label=label, ticks=numpy.linspace(low, high, 5), format="%.3g")
    figure.savefig(IMAGES / f"{name}.png")
    pyplot.close(figure)


def zones(runs, name):
    """Where Omega = 1 in the plane y = 5 mm, at 10 s and 120 s."""
    figure, axes = axes_of(2, 9)
    for axis, time in zip(axes, (10, 120)):
        for (label, run), colour in zip(runs.items(), ("#1c4f9c", "#b0471c", "#2c7a3f", "#7a2c6f")):
            axis.tricontour(*run.plane(time, "ln_damage"), levels=[0], colors=colour)
            axis.plot([], [], color=colour, label=label)
        axis.set(title=f"{time} s", xlim=(0, 10), ylim=(0, 10), aspect="equal")
    finish(figure, axes, name, xlabel="x, mm", ylabel="z, mm")
