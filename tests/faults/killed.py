# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs that write checkpoints and fields at every step are killed (SIGKILL) at random times, again and again: nothing
that stands under its name is half a file, and what is resumed leaves what a run that was never killed does.
Usage: killed.py CAUTERY KILLS PROCESSES [SEED]"""
import os
import pathlib
import random
import re
import shutil
import signal
import sys
import tempfile
import time

import cases
from faults import Program, assert_identical, children

NAMES = ["heat_that_lags_damages_and_stops_perfusion", "strain_energy", "error_control", "explicit",
         "adaptive_heat"]
BUSY = ["--set", "Output/Checkpoints/Steps=1", "--set", "Mesh/Subdivisions=4"]


def words(name):
    # IDA starts anew at every checkpoint: at every step that would get it nowhere
    return [*cases.words(name), *(BUSY if name != "error_control" else [])]


def kill_after(process, seconds):
    """Returns whether the run was still there."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if process.poll() is not None:
            return False
        time.sleep(0.001)
    for pid in [*children(process.pid), process.pid]:
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
    return process.wait() != 0


def assert_whole(out):
    for file in out.glob("*.vtu"):
        assert file.read_bytes().rstrip().endswith(b"</VTKFile>"), f"{file} is half a file"
    index = out / "solution.pvd"
    if index.exists():
        text = index.read_text()
        assert text.rstrip().endswith("</VTKFile>"), "solution.pvd is half a file"
        for name in re.findall(r'file="([^"]*)"', text):
            assert (out / name).exists(), f"solution.pvd lists {name}, which is missing"


def main(cautery, kills, processes, seed):
    print("seed", seed)
    choose = random.Random(seed)
    resumed = anew = 0
    with tempfile.TemporaryDirectory() as folder:
        program = Program(folder, cautery, processes)
        started, duration = set(), {}
        while kills > 0:
            name = choose.choice(NAMES)
            if name not in started:
                started.add(name)
                begin = time.monotonic()
                program.run(words(name), name + "_whole")
                duration[name] = time.monotonic() - begin
            out = program.out(name)
            shutil.rmtree(out, ignore_errors=True)
            more = []
            while kills > 0:
                with open(program.folder / "said", "w") as said:
                    process = program.start(words(name), name, *more, to=said)
                    died = kill_after(process, choose.uniform(0.2, 1.) * duration[name])
                if not died:
                    assert process.returncode == 0, f"{name}: " + (program.folder / "said").read_text()
                    break
                kills -= 1
                assert_whole(out)
                more = ["--resume"] if (out / "checkpoint.h5").exists() else []
                resumed += bool(more)
                anew += not more
            else:
                program.run(words(name), name, *more)
            assert_identical(out, program.out(name + "_whole"))
    print(f"resumed after {resumed} kills; {anew} came before the first checkpoint")
    assert resumed > 0


if __name__ == "__main__":
    main(str(pathlib.Path(sys.argv[1]).resolve()), int(sys.argv[2]), int(sys.argv[3]),
         int(sys.argv[4]) if len(sys.argv) > 4 else time.time_ns())
