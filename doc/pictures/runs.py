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
from matplotlib import pyplot, ticker  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
RUNS, IMAGES = ROOT / "output" / "thesis", ROOT / "doc" / "images" / "thesis"
CENTRE = 0.005  # m, of the cube of 10 mm
POINTS = 161  # along a side of a section
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

    def plane(self, time, *fields, axis=1, at=CENTRE, window=None):
        """Sections of fields across an axis, one for each field, as VTK interpolates them within cells; window: where, as
        (first, second, half width) in mm, for all of the body."""
        import vtk
        from vtk.util.numpy_support import vtk_to_numpy

        number = sorted({float(row["time_s"]) for row in self.rows}).index(time)
        reader = vtk.vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(sorted(self.folder.glob("solution_*.vtu"))[number]))
        reader.Update()
        bounds = numpy.reshape(reader.GetOutput().GetBounds(), (3, 2))
        bounds += 1e-6 * (bounds[:, 1:] - bounds[:, :1]) * (1, -1)  # of rounding, corners may lie outside of all cells
        first, second = (d for d in range(3) if d != axis)
        if window:
            for d, middle in ((first, window[0]), (second, window[1])):
                bounds[d] = 1e-3 * (middle - window[2]), 1e-3 * (middle + window[2])
        bounds[axis] = numpy.clip(at, *bounds[axis])
        numbers = [1 if d == axis else POINTS for d in range(3)]
        places = [numpy.linspace(*bounds[d], numbers[d]) for d in range(3)]
        lattice = vtk.vtkImageData()
        lattice.SetDimensions(numbers)
        lattice.SetOrigin(bounds[:, 0])
        lattice.SetSpacing([1 if n == 1 else (high - low) / (n - 1) for n, (low, high) in zip(numbers, bounds)])
        probe = vtk.vtkProbeFilter()
        probe.SetInputData(lattice)
        probe.SetSourceConnection(reader.GetOutputPort())
        probe.SetCellLocatorPrototype(vtk.vtkStaticCellLocator())
        probe.Update()
        data = probe.GetOutput().GetPointData()
        outside = vtk_to_numpy(data.GetArray("vtkValidPointMask")) == 0
        sections = []
        for field in fields:
            values = vtk_to_numpy(data.GetArray(field)).astype(float)
            values[outside] = numpy.nan
            sections.append(Section(["xyz"[d] for d in (first, second)], 1e3 * places[first], 1e3 * places[second],
                                    values.reshape(POINTS, POINTS, *values.shape[1:])))
        return sections if len(sections) > 1 else sections[0]


class Section:
    """Values (second, first[, component]) at places (mm) along two axes; NaN outside the body."""

    def __init__(self, axes, first, second, values):
        self.axes, self.first, self.second, self.values = axes, first, second, values

    def __mul__(self, factor):
        return Section(self.axes, self.first, self.second, factor * self.values)

    def along(self, component):
        return Section(self.axes, self.first, self.second, self.values[..., component])


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


def maps(name, rows):
    """Fields on sections: rows of (label, [(title, section), ...]), one scale of colours in a row. In those of ln Omega a
    white line is the border of the dead tissue."""
    columns = max(len(row) for _, row in rows)
    figure, axes = pyplot.subplots(len(rows), columns, figsize=(2.8 * columns + 1.6, 2.8 * len(rows)), dpi=100,
                                   squeeze=False, constrained_layout=True)
    for line, (label, row) in zip(axes, rows):
        low = min(numpy.nanmin(section.values) for _, section in row)
        high = max(numpy.nanmax(section.values) for _, section in row)
        levels = numpy.linspace(low, high + 1e-9 * (high - low), 33)
        for one, (title, section) in zip(line, row):
            filled = one.contourf(section.first, section.second, section.values, levels=levels, cmap="turbo")
            if label.startswith("ln Ω") and low < 0 < high:
                one.contour(section.first, section.second, section.values, levels=[0], colors="white")
            one.set(title=title, aspect="equal", xlabel=section.axes[0] + ", mm",
                    ylabel=section.axes[1] + ", mm" if one is line[0] else "")
            one.title.set_fontsize(9)
            one.locator_params(nbins=4)
        figure.colorbar(filled, ax=list(line), label=label, ticks=ticker.MaxNLocator(5))
    figure.savefig(IMAGES / f"{name}.png")
    pyplot.close(figure)


def radius_of_death(run, time):
    """Along the cube's axis, from its centre to where Omega = 1, mm."""
    distances, ln_damage = run.along(time, "ln_damage")
    return numpy.interp(0, ln_damage[::-1], distances[::-1])


def zones(runs, name):
    """Where Omega = 1 in the plane y = 5 mm, at 10 s and 120 s."""
    figure, axes = axes_of(2, 9)
    styles = (("#1c4f9c", "solid", 2.5), ("#e0701c", "dashed", 1.5))
    for axis, time in zip(axes, (10, 120)):
        for (label, run), (colour, style, width) in zip(runs.items(), styles):
            section = run.plane(time, "ln_damage")
            axis.contour(section.first, section.second, section.values, levels=[0], colors=colour, linestyles=style,
                         linewidths=width)
            axis.plot([], [], color=colour, linestyle=style, linewidth=width,
                      label=f"{label}: {radius_of_death(run, time):.2f} mm along x")
        axis.set(title=f"{time} s", xlim=(1.5, 8.5), ylim=(1.5, 8.5), aspect="equal")
    finish(figure, axes, name, xlabel="x, mm", ylabel="z, mm")
