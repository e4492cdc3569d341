# SPDX-License-Identifier: LGPL-2.1-or-later
"""A disk that is full: the run ends with exit status 1 and names the file, all that was written before is whole, and
once there is room again the run resumes. The disk is full for files beyond a length (RLIMIT_FSIZE), and where this
may be mounted, a small tmpfs. Usage: full_disk.py CAUTERY"""
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import tempfile

import cases
from faults import Program, assert_identical, rows
from killed import assert_whole

WORDS = [*cases.words("strain_energy"), "--set", "Output/Checkpoints/Steps=20", "--set", "Mesh/Subdivisions=4"]
NO_FIELDS = [*WORDS, "--set", "Output/Fields=off"]
# the command line, bytes for which there is room, and the file that is the first to have none
CASES = [(WORDS, 15000, "solution_0000.vtu"), (NO_FIELDS, 100000, "checkpoint.h5"),
         ([*NO_FIELDS, "--set", "Output/Checkpoints/Steps=0"], 9000, "probes.csv")]


def limited(length):
    def prepare():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)  # write() then says that the file is too large
        resource.setrlimit(resource.RLIMIT_FSIZE, (length, length))
    return prepare


def run_without_room(program, words, out, prepare=None, processes=()):
    answer = subprocess.run([*processes, *program.command, *words, "--output", out], cwd=program.folder, text=True,
                            capture_output=True, timeout=120, preexec_fn=prepare, restore_signals=False, check=False)
    assert answer.returncode == 1, f"exit status {answer.returncode}\n{answer.stdout}\n{answer.stderr}"
    return answer.stderr.strip()


def assert_good(out):
    assert_whole(out)
    for table in ("probes.csv", "reactions.csv"):
        if (out / table).exists():
            text = (out / table).read_text()
            assert not text or text.endswith("\n"), f"{table} ends in half a row"
            assert all(None not in row.values() for row in rows(out / table)), f"{table} has half a row"
    assert not list(out.glob("*.h5.part")) and not list(out.glob("*.pvd.part")), "half a file is left"


def check(program, words, length, file):
    """Beyond `length` there is no room for `file`."""
    out = program.out("out")
    shutil.rmtree(out, ignore_errors=True)
    complaint = run_without_room(program, words, "out", limited(length))
    assert f"cannot write out/{file}: File too large" in complaint, complaint
    print(complaint)
    assert_good(out)


def on_a_small_disk(program):
    disk = program.folder / "disk"
    disk.mkdir()
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=1m", "tmpfs", disk], capture_output=True, check=False).returncode:
        print("no small disk can be mounted here")
        return
    try:
        complaint = run_without_room(program, WORDS, "disk/out")
        print(complaint)
        assert "cannot write disk/out/" in complaint and "No space left on device" in complaint, complaint
        assert_good(disk / "out")
        subprocess.run(["mount", "-o", "remount,size=50m", disk], check=True)
        program.run(WORDS, "disk/out", "--resume")
        program.run(WORDS, "whole")
        assert_identical(disk / "out", program.out("whole"))
    finally:
        subprocess.run(["umount", disk], check=True)


def main(cautery):
    with tempfile.TemporaryDirectory() as folder:
        program = Program(folder, cautery)
        for words, length, file in CASES:
            check(program, words, length, file)
        on_a_small_disk(program)


if __name__ == "__main__":
    os.environ.setdefault("LC_ALL", "C")
    main(str(pathlib.Path(sys.argv[1]).resolve()))
