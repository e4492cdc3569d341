# SPDX-License-Identifier: LGPL-2.1-or-later
"""A run is stopped by SIGTERM three times, first as it begins, and resumed: what it leaves is what it would have left, bit for bit, and on another
number of processes but for 1e-9. Usage: resume.py CAUTERY CASE PROCESSES [OTHER_PROCESSES]"""
import pathlib
import sys
import tempfile

import cases
from faults import Program, assert_close, assert_identical, interrupt


# On another number of processes answers differ by what linear solvers leave: that must be less than what is asserted.
TIGHT = ["--set", "Numerics/Heat solver/Tolerance=1e-13", "--set", "Numerics/Deformation solver/Tolerance=1e-13"]


def count_steps(out):
    return (out / "log.txt").read_text().count("  step ")


def stop(program, words, out, after, *more):
    process = program.start(words, out, *more)
    said, complaint = interrupt(process, after)
    assert process.returncode != 0, f"the run was done before it could be stopped:\n{said}"
    assert "stopped by a signal" in complaint and "--resume" in complaint, complaint
    assert (program.out(out) / "checkpoint.h5").exists()


def main(cautery, name, processes, others):
    words = [*cases.words(name), *(TIGHT if others else [])]
    with tempfile.TemporaryDirectory() as folder:
        program = Program(folder, cautery, processes)
        program.run(words, "whole")
        steps = count_steps(program.out("whole"))
        stop(program, words, "broken", 0)
        stop(program, words, "broken", steps // 5, "--resume")
        stop(program, words, "broken", steps // 4, "--resume")
        if others is None:
            said = program.run(words, "broken", "--resume")
            assert "Resumed at t = " in said
            assert_identical(program.out("broken"), program.out("whole"))
        else:
            Program(folder, cautery, others).run(words, "broken", "--resume")
            print("largest difference", assert_close(program.out("broken"), program.out("whole"), 1e-9))
        print(steps, "steps")


if __name__ == "__main__":
    main(str(pathlib.Path(sys.argv[1]).resolve()), sys.argv[2], int(sys.argv[3]),
         int(sys.argv[4]) if len(sys.argv) > 4 else None)
