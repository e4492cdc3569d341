# SPDX-License-Identifier: LGPL-2.1-or-later
"""Statements on chapter 6's further cases.

Usage: chapter_6.py STATEMENT DIRECTORY, the directory holding uniform_finite_differences/, uniform_finite_elements/ and
convective_CG/ and convective_direct/.
"""
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


if __name__ == "__main__":
    globals()[sys.argv[1]](pathlib.Path(sys.argv[2]))
