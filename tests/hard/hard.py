# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks one hard case of doc/stability.md, and prints its rows. Usage: hard.py CASE CAUTERY"""
import importlib
import pathlib
import sys

from lab import Lab

if __name__ == "__main__":
    lab = Lab(pathlib.Path(sys.argv[2]).resolve(), pathlib.Path.cwd())
    importlib.import_module(sys.argv[1]).check(lab)
    print(f"{len(lab.rows)} statements, {lab.wrong()} wrong, {lab.n_runs} runs")
    sys.exit(lab.wrong() > 0 or not lab.rows)
