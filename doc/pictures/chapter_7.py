# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of chapter 7: the cube that is pulled and heated."""
import pathlib
import sys

from runs import Run, axes_of, finish, maps

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "tests" / "thesis"))
from arterial_strip import curve  # noqa: E402
from inner_force import PULL, inner_force  # noqa: E402

MECHANICAL = {"linear": "mechanical_linear", "neo-Hookean": "mechanical_neo_hookean", "with fibres": "mechanical_fibres"}
HEATED = {"Fourier": "fourier", "non-Fourier": "non_fourier"}
END = 0.1  # s
FACE = 0.1  # m, where the free face x max lies
DISPLACEMENT, STRAIN, STRESS = ("displacement_x_m", 1e3), ("strain_xx", 1), ("stress_xx_Pa", 1)
LABELS = ("displacement, mm", "strain xx", "stress S xx, Pa")


def courses(axes, runs, *columns):
    for one, (column, factor) in zip(axes, columns):
        for label, run in runs.items():
            one.plot(*run.course("pulled", column, factor), label=label)
        one.set(xlabel="time, s")


def arterial_strip():
    """Figure 63: as the program finds it, and as the closed form has it."""
    found = [(1 + float(row["displacement_x_m"]) / float(row["x_m"]), float(row["stress_xx_Pa"]) / 1e3)
             for row in Run("ch7_arterial_strip").rows]
    stretches = [1 + i * (found[-1][0] - 1) / 100 for i in range(101)]
    figure, axes = axes_of()
    axes[0].plot(stretches, [curve(stretch)[1] / 1e3 for stretch in stretches], color="#b0471c", label="closed form")
    axes[0].plot(*zip(*found), "o", color="#1c4f9c", markersize=4, label="prm/thesis/ch7_arterial_strip.prm")
    finish(figure, axes, "arterial_strip", xlabel="stretch", ylabel="Cauchy stress, kPa",
           title="Figure 63: two families of fibres at 43.39°")


def pulled():
    """Figures 65 to 69."""
    runs = {label: Run(f"ch7_{scene}") for label, scene in MECHANICAL.items()}
    figure, axes = axes_of(3, 14, rows=2)
    for label, run in runs.items():
        axes[0].plot(run.column("pulled", "strain_xx"), run.column("pulled", "stress_xx_Pa"), label=label)
        axes[4].plot(*inner_force(*run.course("pulled", "displacement_x_m")), label=label)
    axes[0].set(xlabel="strain xx", ylabel=LABELS[2], title="Figure 65")
    courses(axes[1:], runs, DISPLACEMENT, STRAIN, STRESS)
    for one, label, number in zip(axes[1:], (*LABELS, "inner force at the pulled node, N"), (66, 67, 68, 69)):
        one.set(ylabel=label, title=f"Figure {number}")
    axes[4].set(xlabel="time, s")
    axes[4].axhline(PULL, color="grey", linewidth=0.8, linestyle="--", label="pull")
    axes[5].axis("off")
    finish(figure, axes[:5], "pulled")


def pulled_faces():
    """Figures 70 to 72."""
    entries = ("Output/Fields=on", "Output/Interval=0")
    row = []
    for (label, scene), number in zip(MECHANICAL.items(), (70, 71, 72)):
        section = Run(f"ch7_{scene}", *entries).plane(END, "displacement_m", axis=0, at=FACE)
        row.append((f"Figure {number}: {label}", section.along(0) * 1e3))
    maps("pulled_faces", [("displacement along x, mm", row)])


def heated():
    """Figures 74 to 77."""
    runs = {label: Run(f"ch7_thermal_{scene}") for label, scene in HEATED.items()}
    figure, axes = axes_of(4, 18)
    courses(axes, runs, ("temperature_K", 1), DISPLACEMENT, STRAIN, STRESS)
    for one, label, number in zip(axes, ("temperature, K", *LABELS), (74, 75, 76, 77)):
        one.set(ylabel=label, title=f"Figure {number}")
    finish(figure, axes, "heated")


def heated_faces():
    """Figures 73 and 82."""
    entries = ("Output/Fields=on", "Output/Interval=0")
    thermal, both = ({label: Run(f"ch7_{load}_{scene}", *entries) for label, scene in HEATED.items()}
                     for load in ("thermal", "combined"))
    maps("heated_faces", [
        ("temperature, K", [(f"Figure 73: {label}", run.plane(END, "temperature_K", axis=0, at=FACE))
                            for label, run in thermal.items()]),
        ("ln Ω", [(f"Figure 82: {label}", run.plane(END, "ln_damage", axis=0, at=FACE))
                  for label, run in both.items()])])


def pulled_and_heated():
    """Figures 78 to 81, 83 and 84."""
    runs = {label: Run(f"ch7_combined_{scene}") for label, scene in HEATED.items()}
    figure, axes = axes_of(3, 14, rows=2)
    courses(axes, {"pulled alone": Run("ch7_mechanical_fibres"), **runs}, DISPLACEMENT, STRAIN, STRESS)
    for one, label, number in zip(axes, LABELS, (78, 79, 80)):
        one.set(ylabel=label, title=f"Figure {number}")
    for (label, run), one, number in zip(runs.items(), axes[4:], (83, 84)):
        axes[3].plot(run.column("pulled", "strain_xx"), run.column("pulled", "stress_xx_Pa"), label=label)
        thermal = Run(f"ch7_combined_{HEATED[label]}", "Effects/Damage=Arrhenius")
        for name, style, damage in (("with strain energy", "-", run), ("without", "--", thermal)):
            one.plot(damage.column("pulled", "strain_xx"), damage.column("pulled", "ln_damage"), style, label=name)
        one.set(xlabel="strain xx", ylabel="ln Ω", title=f"Figure {number}: {label}")
    axes[3].set(xlabel="strain xx", ylabel=LABELS[2], title="Figure 81")
    finish(figure, axes, "pulled_and_heated")
