# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a program and compares what it prints with a file. Usage: compare.py NUMDIFF EXPECTED COMMAND..."""
import pathlib
import subprocess
import sys

numdiff, expected, command = sys.argv[1], sys.argv[2], sys.argv[3:]
run = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False)
pathlib.Path("output").write_text(run.stdout)
compared = subprocess.run([numdiff, "--absolute-tolerance=1e-9", "--relative-tolerance=1e-6", expected, "output"],
                          stdout=subprocess.PIPE, text=True, check=False)
if run.returncode != 0 or compared.returncode != 0:
    print(f"exit status {run.returncode}", compared.stdout, sep="\n")
    sys.exit(1)
