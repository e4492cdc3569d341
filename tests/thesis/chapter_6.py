# SPDX-License-Identifier: LGPL-2.1-or-later
"""Statements on chapter 6's further cases.

Usage: chapter_6.py STATEMENT DIRECTORY, the directory holding uniform_finite_differences/, uniform_finite_elements/,
convective_CG/, convective_direct/, convective_whole/ and convective_condensed/ (solved to 1e-13), cube/, liver/,
microwave_fourier/ and microwave_non_fourier/.
"""
import math
import pathlib
import sys

from runs import Run

TIMES = range(1, 121)
PROBES = ("P1", "P2", "P3", "P4", "P5")


def uniform(folder):
    return Run(folder / "uniform_finite_differences"), Run(folder / "uniform_finite_elements")


def differences_and_elements_find_the_same_temperature(folder):
    """The thesis: within 2.4 %, of the temperature in K."""
    differences, elements = ([run.value(time, probe, "temperature_K") for time in TIMES for probe in PROBES]
                             for run in uniform(folder))
    found = max(abs(a - b) / a for a, b in zip(differences, elements))
    print(f"within {100 * found:.2f} %")
    assert found < 0.004


def differences_and_elements_find_the_same_displacement(folder):
    """The thesis: within 4.7 %; here of the largest."""
    differences, elements = ([run.value(time, probe, "displacement_x_m") for time in TIMES for probe in PROBES]
                             for run in uniform(folder))
    found = max(abs(a - b) for a, b in zip(differences, elements)) / max(differences)
    print(f"within {100 * found:.2f} %")
    assert found < 0.025


def a_body_that_nothing_holds_stays_where_it_is(folder):
    """Heat moves its corners by 0.02 mm; what solvers leave must not throw it about, whichever they are."""
    for solver in ("CG", "direct"):
        moved = Run(folder / f"convective_{solver}").summary["extremes"]["displacement_max_m"]
        assert 0.02e-3 < moved < 0.03e-3, (solver, moved)


def columns_apart(one, other, column, about=None):
    """The largest difference, of the column's largest value; about: the probe whose values are taken off both."""
    pairs = [[float(run.rows[key][column]) - (float(run.rows[key[0], about][column]) if about else 0)
              for run in (one, other)] for key in one.rows if math.isfinite(float(one.rows[key][column]))]
    return max(abs(a - b) for a, b in pairs) / max(abs(a) for a, _ in pairs)


def condensed_to_the_nodes_inside_all_is_the_same(folder):
    """6.3: kept nodes behave exactly as in the whole system. Only its inertia holds the body, so what solvers leave of forces
    lets it drift as a whole: displacements count from the centre, along the line of the probes."""
    whole, condensed = Run(folder / "convective_whole"), Run(folder / "convective_condensed")
    pairs = ("xx", "yy", "zz", "xy", "xz", "yz")
    for column in ("temperature_K", *(f"strain_{p}" for p in pairs), *(f"stress_{p}_Pa" for p in pairs),
                   "strain_energy_J_per_m3", "ln_damage"):
        found = columns_apart(whole, condensed, column)
        print(f"{column}: {found:.1e}")
        assert found < 1e-10, column
    found = columns_apart(whole, condensed, "displacement_x_m", "P1")
    drift = columns_apart(whole, condensed, "displacement_x_m")
    print(f"displacement from the centre: {found:.1e}; drift: {drift:.1e}")
    assert found < 1e-10 and drift < 1e-2


def liver_is_heated_less_than_the_cube(folder):
    """Figures 36 and 47: by the same needle."""
    peaks = [Run(folder / name).summary["extremes"]["temperature_max_K"] for name in ("liver", "cube")]
    print(f"peaks {peaks[0]:.1f} and {peaks[1]:.1f} K")
    assert 355 < peaks[0] < peaks[1] - 3


def microwaves_heat_by_their_law_at_first(folder):
    """Eq. 6-35 at 5 mm, before heat is conducted: by its power over rho C, and by what backward Euler makes of the delay of
    12 s, with steps of 1 s."""
    r, steps = 5.0, 4
    power = 40 * 0.00316e9 * (2 * 0.0413 * r + 0.2) * math.exp(-2 * 0.0413 * r) / r ** 2.2
    rate = power / (1050 * 3628)
    for model, wanted in (("fourier", rate * steps),
                          ("non_fourier", rate * sum(1 - (12 / 13) ** n for n in range(1, steps + 1)))):
        found = Run(folder / f"microwave_{model}").value(steps, "TC2", "temperature_K") - 293
        print(f"{model}: {found:.3f} K, by the law {wanted:.3f} K")
        assert abs(found - wanted) < 0.05 * wanted


def microwaves_by_both_models_draw_near(folder):
    """Figure 61: non-Fourier curves set out late, and in the end there is little between them."""
    fourier, delayed = (Run(folder / f"microwave_{model}") for model in ("fourier", "non_fourier"))
    for probe in ("TC1", "TC2"):
        early, late = (fourier.value(time, probe, "temperature_K") - delayed.value(time, probe, "temperature_K")
                       for time in (20, 120))
        print(f"{probe}: Fourier is ahead by {early:.1f} K at 20 s, {late:.1f} K at 120 s")
        assert early > 5 and 0 < late < 3


if __name__ == "__main__":
    globals()[sys.argv[1]](pathlib.Path(sys.argv[2]))
