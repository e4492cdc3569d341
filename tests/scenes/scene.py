# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a scene, compares what it finds with SCENE.output, and checks it: exactly what is on is there, the heat is
all accounted for, and numbers are what is known without the program (checks.py). Working directory: where the run
may write.

Usage: scene.py NUMDIFF SCENE COMMAND..., SCENE without .prm
"""
import math
import pathlib
import shutil
import subprocess
import sys

import checks
import digest
import presence
from outcome import Outcome

CLOSED = 1e-8       # backward Euler conserves heat to the tolerance of its solver
CLOSED_IDA = 5e-5   # IDA's steps are booked by the trapezoidal rule
ROUNDING = 1e-12    # J; all there is where no heat moves


def check_all(outcome, name):
    presence.check(outcome)
    if "balance" in outcome.summary:
        balance = outcome.summary["balance"]
        limit = CLOSED_IDA if outcome["Time/Integrator"] == "IDA" else CLOSED
        assert balance["relative_error"] < limit or abs(balance["error_J"]) < ROUNDING, balance
    for row in outcome.rows:
        assert not any(value != value for value in row.values()), f"no number: {row}"
        if "damage" in row:
            assert math.isclose(row["damage"], math.exp(row["ln_damage"]), rel_tol=1e-9), row
    getattr(checks, name)(outcome)


def main(numdiff, scene, command):
    shutil.rmtree("out", ignore_errors=True)
    run = subprocess.run([*command, scene + ".prm", "--set", "Output/Directory=out"], stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT, text=True, check=False)
    if run.returncode != 0:
        print(run.stdout, f"exit status {run.returncode}")
        return 1
    outcome = Outcome("out")
    pathlib.Path("output").write_text(digest.text(outcome))
    check_all(outcome, pathlib.Path(scene).name)
    compared = subprocess.run([numdiff, *digest.tolerances(outcome), scene + ".output", "output"],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    print(compared.stdout)
    return compared.returncode


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], sys.argv[3:]))
