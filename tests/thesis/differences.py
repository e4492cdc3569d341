# SPDX-License-Identifier: LGPL-2.1-or-later
"""Statements of the thesis on its cube by finite differences, chapters 4 and 5.

Usage: differences.py STATEMENT DIRECTORY, the directory holding ch4/, type_1/ and type_2/ with strain energy in the
damage, type_1_thermal/ and type_2_thermal/ without.
"""
import pathlib
import sys

from runs import Run, radius_of_death


def centre_reaches_367_K(folder):
    """Figures 11 and 12; to the digits of a prototype of 7-point differences."""
    assert abs(Run(folder / "ch4").value(120, "P1", "temperature_K") - 367.46) < 0.005


def p3_moves_further_than_p2_late_but_less_at_10_s(folder):
    """Figure 18."""
    run = Run(folder / "ch4")
    p2, p3 = ([run.value(time, p, "displacement_x_m") for time in (10, 120)] for p in ("P2", "P3"))
    assert p3[0] < p2[0] and p3[1] > p2[1]


def strain_is_positive_near_the_centre_and_negative_outside(folder):
    """Figure 19, at all times."""
    for probe, sign in (("P1", 1), ("P2", 1), ("P3", -1), ("P4", -1)):
        assert all(sign * strain > 0 for strain in Run(folder / "ch4").history(probe, "strain_xx")[1:]), probe


def strain_energy_of_type_1_is_as_printed(folder):
    run = Run(folder / "type_1")
    for time, printed in ((10, 1625.18), (120, 3091.80)):
        assert round(run.value(time, "P1", "strain_energy_J_per_m3"), 2) == printed


def strain_energy_of_type_2_is_as_printed(folder):
    """But for 1.7e-8 in the tenth digit, which the thesis's iterative solver left: ours is the direct solver's."""
    run = Run(folder / "type_2")
    for time, printed in ((10, 841464.90), (120, 1465832.67)):
        assert abs(run.value(time, "P1", "strain_energy_J_per_m3") / printed - 1) < 2e-8


def strain_energy_kills_little_more_of_type_1(folder):
    """Figures 24 and 25."""
    for time in (10, 120):
        more = radius_of_death(Run(folder / "type_1"), time) - radius_of_death(Run(folder / "type_1_thermal"), time)
        assert 0 <= more < 0.02, (time, more)


def strain_energy_kills_much_more_of_type_2_and_most_early(folder):
    """Figures 26 and 27, by the share that the radius grows."""
    growth = [radius_of_death(Run(folder / "type_2"), time) / radius_of_death(Run(folder / "type_2_thermal"), time) - 1
              for time in (10, 120)]
    assert growth[0] > growth[1] > 0.05, growth


if __name__ == "__main__":
    globals()[sys.argv[1]](pathlib.Path(sys.argv[2]))
