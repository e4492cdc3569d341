# SPDX-License-Identifier: LGPL-2.1-or-later
"""A run in which tissue dies is stopped by SIGTERM after each step and resumed: what it leaves is what it would have left, bit for bit.
Usage: stopped_often.py CAUTERY CASE"""
import itertools
import json
import pathlib
import sys
import tempfile

import cases
from faults import Program, assert_identical, interrupt


def stop_often(program, words, out):
    """After each step that it tells of, till it is done. Returns how many runs that took."""
    more = []
    for runs in itertools.count(1):
        process = program.start(words, out, *more)
        _, complaint = interrupt(process, 1)
        if process.returncode == 0:
            return runs
        assert "stopped by a signal" in complaint, complaint
        more = ["--resume"]


def main(cautery, name):
    words = cases.words(name)
    with tempfile.TemporaryDirectory() as folder:
        program = Program(folder, cautery, 1)
        program.run(words, "whole")
        runs = stop_often(program, words, "broken")
        dead = json.loads((program.out("whole") / "summary.json").read_text())["extremes"]["ln_damage_max"]
        assert runs > 5 and dead > 0, (runs, dead)
        assert_identical(program.out("broken"), program.out("whole"))
        print(runs, "runs")


if __name__ == "__main__":
    main(str(pathlib.Path(sys.argv[1]).resolve()), sys.argv[2])
