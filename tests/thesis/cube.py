# SPDX-License-Identifier: LGPL-2.1-or-later
"""Statements of the thesis on its cube, checked on the output of prm/thesis/ch6_cube_*.prm.

Usage: cube.py STATEMENT DIRECTORY, the directory holding fourier/ and non_fourier/.
"""
import math
import pathlib
import sys

from runs import Run, radius_of_death


def centre_reaches_367_K(fourier, non_fourier):
    """Figure 12; finite elements on these tetrahedra give what finite differences do."""
    assert abs(fourier.value(120, "P1", "temperature_K") - 367.46) < 0.5


def p3_moves_further_than_p2_late_but_less_at_10_s(fourier, non_fourier):
    """Figure 18."""
    p2, p3 = ([fourier.value(time, p, "displacement_x_m") for time in (10, 120)] for p in ("P2", "P3"))
    assert p3[0] < p2[0] and p3[1] > p2[1]


def strain_is_positive_near_the_centre_and_negative_outside(fourier, non_fourier):
    """Figure 19, at all times."""
    for probe, sign in (("P1", 1), ("P2", 1), ("P3", -1), ("P4", -1)):
        assert all(sign * strain > 0 for strain in fourier.history(probe, "strain_xx")[1:]), probe


def both_models_merge_at_the_end(fourier, non_fourier):
    """Figure 34."""
    for probe in ("P1", "P2", "P3"):
        difference = non_fourier.value(120, probe, "temperature_K") - fourier.value(120, probe, "temperature_K")
        rise = fourier.value(120, probe, "temperature_K") - 310
        assert abs(difference) < 0.02 * rise, (probe, difference)


def non_fourier_rises_late_and_overshoots(fourier, non_fourier):
    """Figure 34: smaller at first, oscillating about the steady state then."""
    for probe in ("P1", "P2", "P3"):
        assert non_fourier.value(10, probe, "temperature_K") < fourier.value(10, probe, "temperature_K")
        history = non_fourier.history(probe, "temperature_K")
        assert max(history) > history[-1] + 0.1
        assert all(a <= b for a, b in zip(fourier.history(probe, "temperature_K"),
                                          fourier.history(probe, "temperature_K")[1:]))


def non_fourier_kills_less_at_10_s_and_more_at_120_s(fourier, non_fourier):
    """Figures 44 and 45."""
    assert radius_of_death(non_fourier, 10) < radius_of_death(fourier, 10)
    assert radius_of_death(non_fourier, 120) > radius_of_death(fourier, 120)
    assert non_fourier.summary["ablation"]["volume_m3"] > fourier.summary["ablation"]["volume_m3"]


def ablation_radius_is_about_2_2_mm(fourier, non_fourier):
    """Figure 45, right: in the plane y = 5 mm at 120 s."""
    assert abs(radius_of_death(non_fourier, 120) - 2.2) < 0.15


def displacement_is_along_x_only_on_the_axis(fourier, non_fourier):
    """Figure 16. The tetrahedra are not symmetric, so the other components only come close to zero."""
    across = max(abs(fourier.value(120, "P3", f"displacement_{c}_m")) for c in "yz")
    assert across < 0.1 * fourier.value(120, "P3", "displacement_x_m")


def books_of_heat_close(fourier, non_fourier):
    for run in (fourier, non_fourier):
        assert run.summary["balance"]["relative_error"] < 1e-8
    assert math.isclose(fourier.summary["balance"]["sources_J"], 5 * 0.08 * 120, rel_tol=1e-12)


if __name__ == "__main__":
    statement, directory = sys.argv[1], pathlib.Path(sys.argv[2])
    globals()[statement](Run(directory / "fourier"), Run(directory / "non_fourier"))
