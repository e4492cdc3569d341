# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the thesis's scenes and draws the pictures of doc/thesis.md from what they leave.

Usage, from the project's root: /usr/bin/python3 doc/pictures/thesis.py [PICTURE ...]   (Debian's python3-matplotlib, python3-vtk9)
Runs are kept in output/thesis/ and not repeated; remove them to run anew.
"""
import csv
import hashlib
import json
import pathlib
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
RUNS, IMAGES = ROOT / "output" / "thesis", ROOT / "doc" / "images" / "thesis"
CENTRE = 0.005  # m


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

    def course(self, probe, column):
        rows = [row for row in self.rows if row["probe"] == probe]
        return [float(row["time_s"]) for row in rows], [float(row[column]) for row in rows]

    def along(self, time, column, abscissa="x_m"):
        rows = [row for row in self.rows if float(row["time_s"]) == time and row["probe"].startswith("P")]
        return [1e3 * (float(row[abscissa]) - CENTRE) for row in rows], [float(row[column]) for row in rows]

    def plane(self, time, field):
        """x and z (mm) and a field at the nodes of the plane y = 5 mm."""
        import vtk
        from vtk.util.numpy_support import vtk_to_numpy

        number = sorted({float(row["time_s"]) for row in self.rows}).index(time)
        reader = vtk.vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(sorted(self.folder.glob("solution_*.vtu"))[number]))
        cutter = vtk.vtkCutter()
        plane = vtk.vtkPlane()
        plane.SetOrigin(0, CENTRE + 1e-9, 0)
        plane.SetNormal(0, 1, 0)
        cutter.SetCutFunction(plane)
        cutter.SetInputConnection(reader.GetOutputPort())
        cutter.Update()
        points = vtk_to_numpy(cutter.GetOutput().GetPoints().GetData())
        return 1e3 * points[:, 0], 1e3 * points[:, 2], vtk_to_numpy(cutter.GetOutput().GetPointData().GetArray(field))


FIELDS = ("Output/Fields=on", "Output/Interval=0", "Output/Times=10, 120")


def axes_of(n=1, width=6):
    figure, axes = pyplot.subplots(1, n, figsize=(width, 4), dpi=110, squeeze=False)
    return figure, list(axes[0])


def finish(figure, axes, name, **labels):
    for one in axes:
        one.set(**labels)
        one.grid(alpha=0.3)
        if one.get_legend_handles_labels()[0]:
            one.legend(frameon=False, fontsize=8)
    figure.tight_layout()
    figure.savefig(IMAGES / f"{name}.png")
    pyplot.close(figure)


def cube_by_differences():
    """Figures 11, 12, 17, 18, 19."""
    run = Run("ch4_cube_fourier")
    figure, axes = axes_of(4, 18)
    for probe, name in (("H1", "y = 3 mm"), ("H2", "4 mm"), ("P1", "5 mm"), ("H4", "6 mm"), ("H5", "7 mm")):
        axes[0].plot(*run.course(probe, "temperature_K"), label=name)
    axes[0].set(xlabel="time, s", ylabel="temperature, K", title="Figure 11")
    for time in (10, 50, 120):
        axes[1].plot(*run.along(time, "temperature_K"), "o-", label=f"{time} s")
        x, u = run.along(time, "displacement_x_m")
        axes[2].plot(x, [1e6 * value for value in u], "o-", label=f"{time} s")
    axes[1].set(xlabel="distance from the centre, mm", ylabel="temperature, K", title="Figure 12")
    axes[2].set(xlabel="distance from the centre, mm", ylabel="displacement along x, µm", title="Figures 17 and 18")
    for probe in ("P1", "P2", "P3", "P4"):
        axes[3].plot(*run.course(probe, "strain_xx"), label=probe)
    axes[3].set(xlabel="time, s", ylabel="strain xx", title="Figure 19")
    finish(figure, axes, "cube_by_differences")


def zones(runs, name):
    """Where Omega = 1 in the plane y = 5 mm, at 10 s and 120 s."""
    figure, axes = axes_of(2, 9)
    for axis, time in zip(axes, (10, 120)):
        for (label, run), colour in zip(runs.items(), ("#1c4f9c", "#b0471c", "#2c7a3f", "#7a2c6f")):
            axis.tricontour(*run.plane(time, "ln_damage"), levels=[0], colors=colour)
            axis.plot([], [], color=colour, label=label)
        axis.set(title=f"{time} s", xlim=(0, 10), ylim=(0, 10), aspect="equal")
    finish(figure, axes, name, xlabel="x, mm", ylabel="z, mm")


def damage_zones():
    """Figures 24 to 27."""
    for number in (1, 2):
        scene = f"ch5_damage_type_{number}"
        zones({"without strain energy": Run(scene, *FIELDS, "Effects/Damage=Arrhenius"),
               "with strain energy": Run(scene, *FIELDS)}, f"damage_type_{number}")


def fourier_and_non_fourier():
    """Figures 34, 43; 44 and 45."""
    runs = {"Fourier": Run("ch6_cube_fourier", "Output/Interval=1"),
            "non-Fourier": Run("ch6_cube_non_fourier", "Output/Interval=1")}
    figure, axes = axes_of(2, 11)
    for (label, run), style in zip(runs.items(), ("-", "--")):
        for probe, colour in (("P1", "#b0471c"), ("P2", "#1c4f9c"), ("P3", "#2c7a3f")):
            axes[0].plot(*run.course(probe, "temperature_K"), style, color=colour, label=f"{probe}, {label}")
            axes[1].plot(*run.course(probe, "ln_damage"), style, color=colour, label=f"{probe}, {label}")
    axes[0].set(ylabel="temperature, K", title="Figure 34")
    axes[1].set(ylabel="ln Ω", ylim=(-40, 40), title="Figure 43")
    finish(figure, axes, "fourier_and_non_fourier", xlabel="time, s")
    zones({"Fourier": Run("ch6_cube_fourier", *FIELDS), "non-Fourier": Run("ch6_cube_non_fourier", *FIELDS)},
          "non_fourier_zones")


def uniform():
    """Figures 54 and 55."""
    figure, axes = axes_of(2, 11)
    for label, style in (("differences", "-"), ("elements", "--")):
        run = Run(f"ch6_uniform_finite_{label}")
        axes[0].plot(*run.course("P1", "temperature_K"), style, label=f"finite {label}")
        time, u = run.course("P3", "displacement_x_m")
        axes[1].plot(time, [1e6 * value for value in u], style, label=f"finite {label}")
    axes[0].set(ylabel="temperature at the centre, K", title="Figure 54")
    axes[1].set(ylabel="displacement of P3 along x, µm", title="Figure 55")
    finish(figure, axes, "uniform", xlabel="time, s")


def microwave():
    """Figure 61."""
    figure, axes = axes_of()
    for model, colour in (("fourier", "#b0471c"), ("non_fourier", "#1c4f9c"), ("temperature_dependent", "#2c7a3f")):
        for probe, style in (("TC1", "-"), ("TC2", "--")):
            run = Run(f"ch6_microwave_{model}")
            axes[0].plot(*run.course(probe, "temperature_K"), style, color=colour,
                         label=f"{probe}, {model.replace('_', ' ')}")
    finish(figure, axes, "microwave", xlabel="time, s", ylabel="temperature, K", title="Figure 61")


def relaxation_times():
    """What the non-Fourier term does, and when it does not matter."""
    figure, axes = axes_of(2, 12)
    for axis, jumps in zip(axes, ("consistent", "neglected")):
        for tau in (0, 1, 4, 16, 40, 100):
            run = Run("ch6_cube_non_fourier", f"Tissues/tissue/Relaxation time={tau}", "Output/Interval=1",
                      "Time/End=400", f"Effects/Heat source jumps={jumps}", "Effects/Damage=off",
                      "Effects/Deformation=off", "Effects/Coupling=off")
            axis.plot(*run.course("P2", "temperature_K"), label=f"τ = {tau} s")
        axis.set(title=f"jump of the source {jumps}", ylabel="temperature 1 mm from the needle, K")
    finish(figure, axes, "relaxation_times", xlabel="time, s")


MARGINS = ("1e-1", "1e-2", "1e-3", "1e-4", "1e-6", "1e-8", "1e-10")
METHODS = ("Gauss-Seidel", "CG + SSOR", "CG + AMG", "direct")
MODELS = {"finite differences (Figure 8)": "ch4_cube_fourier", "finite elements (Figure 31)": "ch6_cube_non_fourier"}


def with_margin(scene, method, margin):
    solvers = [f"Numerics/{what} solver/{entry}" for what in ("Heat", "Deformation") for entry in
               (f"Method={method}", f"Tolerance={margin}", "Remembered solutions=0")]
    run = Run(scene, *solvers, "Numerics/Displacement at=every step", "Output/Interval=120")
    statistics, cost = run.summary["statistics"], run.summary["cost"]
    set_up = sum(s for part, s in cost["seconds_by_part"].items() if part.endswith(": set-up"))
    steps = run.summary["time_steps"]
    iterations = [statistics.get(f"linear_iterations_{what}", 0) / steps for what in ("heat", "deformation")]
    return iterations, 1e3 * (cost["seconds_per_step"] - set_up / steps)


def margins():
    """Figures 8 and 31: iterations of a step, both fields, against the margin; the table is printed."""
    figure, axes = axes_of(2, 11)
    print("| model | margin | " + " | ".join(f"{m}: iterations heat + deformation, ms" for m in METHODS) + " |")
    print("|---|---|" + "---|" * len(METHODS))
    for axis, (model, scene) in zip(axes, MODELS.items()):
        found = {method: [with_margin(scene, method, margin) for margin in MARGINS] for method in METHODS}
        for method in METHODS[:3]:
            axis.loglog([float(m) for m in MARGINS], [max(sum(i), 0.1) for i, _ in found[method]], "o-", label=method)
        axis.set(title=model, xlabel="margin of error", ylabel="iterations of a step")
        for row, margin in enumerate(MARGINS):
            cells = [f"{i[0]:.1f} + {i[1]:.1f}, {ms:.2f}" for i, ms in (found[m][row] for m in METHODS)]
            print(f"| {model} | {margin} | " + " | ".join(cells) + " |")
    finish(figure, axes, "margins")


PICTURES = {function.__name__: function for function in (
    cube_by_differences, damage_zones, fourier_and_non_fourier, uniform, microwave, relaxation_times, margins)}

if __name__ == "__main__":
    IMAGES.mkdir(parents=True, exist_ok=True)
    for picture in sys.argv[1:] or PICTURES:
        PICTURES[picture]()
