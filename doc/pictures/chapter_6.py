# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of chapter 6: Fourier against non-Fourier, differences against elements, liver, microwaves."""
from runs import CENTRE, FIELDS, Run, axes_of, finish, maps, zones


def fourier_and_non_fourier():
    """Figures 34, 43; 44 and 45."""
    runs = {"Fourier": Run("ch6_cube_fourier", "Output/Interval=1"),
            "non-Fourier": Run("ch6_cube_non_fourier", "Output/Interval=1")}
    figure, axes = axes_of(2, 11)
    for (label, run), style in zip(runs.items(), ("-", "--")):
        for probe, colour in (("P1", "#b0471c"), ("P2", "#1c4f9c"), ("P3", "#2c7a3f")):
            axes[0].plot(*run.course(probe, "temperature_K"), style, color=colour, label=f"{probe}, {label}")
            axes[1].plot(*run.course(probe, "ln_damage"), style, color=colour, label=f"{probe}, {label}")
    axes[0].set(ylabel="temperature, K", ylim=(282, 372), title="Figure 34")  # room for the legend
    axes[1].set(ylabel="ln Ω", ylim=(-38, 35), title="Figure 43")
    finish(figure, axes, "fourier_and_non_fourier", xlabel="time, s")
    zones({"Fourier": Run("ch6_cube_fourier", *FIELDS), "non-Fourier": Run("ch6_cube_non_fourier", *FIELDS)},
          "non_fourier_zones")


def uniform():
    """Figures 54 and 55."""
    figure, axes = axes_of(2, 11)
    for label, style in (("differences", "-"), ("elements", "--")):
        run = Run(f"ch6_uniform_finite_{label}")
        axes[0].plot(*run.course("P1", "temperature_K"), style, label=f"finite {label}")
        axes[1].plot(*run.course("P3", "displacement_x_m", 1e6), style, label=f"finite {label}")
    axes[0].set(ylabel="temperature at the centre, K", title="Figure 54")
    axes[1].set(ylabel="displacement of P3 along x, µm", title="Figure 55")
    finish(figure, axes, "uniform", xlabel="time, s")


def microwave():
    """Figure 61."""
    figure, axes = axes_of()
    for model, colour, name in (("fourier", "#b0471c", "Fourier"), ("non_fourier", "#1c4f9c", "non-Fourier"),
                                ("temperature_dependent", "#2c7a3f", "non-Fourier, k(T) and C(T)")):
        run = Run(f"ch6_microwave_{model}")
        for probe, style, place in (("TC1", "-", "2 mm"), ("TC2", "--", "5 mm")):
            axes[0].plot(*run.course(probe, "temperature_K"), style, color=colour, label=f"{place}: {name}")
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


def fields():
    """Figures 35 to 42."""
    runs = {name: Run(f"ch6_cube_{scene}", *FIELDS)
            for name, scene in (("Fourier", "fourier"), ("non-Fourier", "non_fourier"))}
    columns = {"temperature, K": ("temperature_K", 1, 35), "strain energy, J/m³": ("strain_energy_J_per_m3", 1, 41),
               **{f"strain {pair}": (f"strain_{pair}", 1, 37) for pair in ("xx", "yy", "zz")},
               **{f"stress {pair}, kPa": (f"stress_{pair}_Pa", 1e-3, 39) for pair in ("xx", "yy", "zz")}}
    maps("fields", [(label, [(f"Figure {number + late}: {name}, {time} s", run.plane(time, column) * factor)
                             for late, time in enumerate((10, 120)) for name, run in runs.items()])
                    for label, (column, factor, number) in columns.items()])


def uniform_fields():
    """Figures 50 to 53."""
    runs = {f"finite {name}": Run(f"ch6_uniform_finite_{name}", *FIELDS) for name in ("elements", "differences")}
    rows = [("temperature, K", [(f"Figure 50: {name}", run.plane(120, "temperature_K")) for name, run in runs.items()])]
    for component, letter in enumerate("xyz"):
        at = 0.003 if letter == "y" else CENTRE  # the displacement along y is nothing in the plane of symmetry
        rows.append((f"displacement along {letter}, µm",
                     [(f"Figure {51 + component}: {name}",
                       run.plane(120, "displacement_m", at=at).along(component) * 1e6) for name, run in runs.items()]))
    maps("uniform_fields", rows)


def single_source():
    """Figures 56 to 59."""
    temperature, displacement = Run("ch6_single_source", *FIELDS).plane(120, "temperature_K", "displacement_m")
    maps("single_source", [("temperature, K", [("Figure 56", temperature)])] +
         [(f"displacement along {letter}, µm", [(f"Figure {57 + c}", displacement.along(c) * 1e6)])
          for c, letter in enumerate("xyz")])


def liver():
    """Figures 47 to 49: temperature and damage in the plane of the needle's middle, and the border of the dead."""
    run = Run("ch6_liver", "Output/Fields=on", "Output/Interval=0", "Output/Times=10, 120")
    x, y, z = run.summary["ablation"]["centre_m"]
    temperature, ln_damage = run.plane(120, "temperature_K", "ln_damage", at=y, window=(1e3 * x, 1e3 * z, 8))
    maps("liver", [("temperature, K", [("Figure 47", temperature)]),
                   ("ln Ω; white: Ω = 1", [("Figures 48 and 49", ln_damage)])])
