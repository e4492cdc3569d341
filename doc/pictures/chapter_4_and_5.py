# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of chapters 4 and 5: the cube by finite differences."""
from runs import FIELDS, Run, axes_of, finish, maps, zones


def cube_by_differences():
    """Figures 11, 12, 16 to 19."""
    run = Run("ch4_cube_fourier")
    figure, axes = axes_of(3, 14, rows=2)
    for probe, name in (("H1", "y = 3 mm"), ("H2", "4 mm"), ("P1", "5 mm"), ("H4", "6 mm"), ("H5", "7 mm")):
        axes[0].plot(*run.course(probe, "temperature_K"), "--" if probe in ("H4", "H5") else "-", label=name)
    axes[0].set(xlabel="time, s", ylabel="temperature, K", title="Figure 11")
    for time in (10, 50, 120):
        axes[1].plot(*run.along(time, "temperature_K"), "o-", label=f"{time} s")
        axes[4].plot(*run.along(time, "displacement_x_m", 1e6), "o-", label=f"{time} s")
    axes[1].set(xlabel="distance from the centre, mm", ylabel="temperature, K", title="Figures 12 and 18")
    axes[4].set(xlabel="distance from the centre, mm", ylabel="displacement along x, µm", title="Figure 18")
    for letter, style in zip("xyz", ("-", "-", "--")):
        axes[2].plot(run.column("P2", "temperature_K"), [1e6 * u for u in run.column("P2", f"displacement_{letter}_m")],
                     style, label=f"along {letter}")
    axes[2].set(xlabel="temperature at P2, K", ylabel="displacement of P2, µm", title="Figure 16")
    for probe in ("P1", "P2", "P3", "P4"):
        axes[3].plot(*run.course(probe, "displacement_x_m", 1e6), label=probe)
        axes[5].plot(*run.course(probe, "strain_xx"), label=probe)
    axes[3].set(xlabel="time, s", ylabel="displacement along x, µm", title="Figure 17")
    axes[5].set(xlabel="time, s", ylabel="strain xx", title="Figure 19")
    finish(figure, axes, "cube_by_differences")


def damage_zones():
    """Figures 24 to 27."""
    for number in (1, 2):
        scene = f"ch5_damage_type_{number}"
        zones({"without strain energy": Run(scene, *FIELDS, "Effects/Damage=Arrhenius"),
               "with strain energy": Run(scene, *FIELDS)}, f"damage_type_{number}")


def cube_displacements():
    """Figures 13 to 15."""
    run = Run("ch4_cube_fourier", *FIELDS)
    rows = []
    for axis, letter in enumerate("xyz"):
        planes = []
        for at in (0.001, 0.009):
            section = run.plane(120, "displacement_m", axis=axis, at=at)
            planes.append((f"Figure {13 + axis}: {letter} = {1e3 * at:g} mm", section.along(axis) * 1e6))
        rows.append((f"displacement along {letter}, µm", planes))
    maps("cube_displacements", rows)


def strain_energies():
    """Figures 22 and 23."""
    maps("strain_energies", [
        (f"strain energy, {unit}",
         [(f"Figure {21 + number}: type {'I' * number}, {time} s",
           Run(f"ch5_damage_type_{number}", *FIELDS).plane(time, "strain_energy_J_per_m3") * factor)
          for time in (10, 120)]) for number, unit, factor in ((1, "J/m³", 1), (2, "kJ/m³", 1e-3))])
