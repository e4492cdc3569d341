# SPDX-License-Identifier: LGPL-2.1-or-later
"""A long run takes hardly more memory at its end than after its first quarter. Usage: memory.py CAUTERY CASE STEPS"""
import os
import pathlib
import re
import sys
import tempfile

import cases
from faults import Program

# Share by which the memory may grow.
GROWTH = 0.01


def resident(pid):
    """Bytes."""
    return int(pathlib.Path(f"/proc/{pid}/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def main(cautery, name, steps):
    with tempfile.TemporaryDirectory() as folder:
        program = Program(folder, cautery)
        step = float(next((text.split("=")[1] for text in cases.CASES[name] if text.startswith("Time/Step=")), 0.2))
        process = program.start([*cases.words(name), "--set", "Mesh/Subdivisions=3", "--set", f"Time/End={steps * step}",
                                 "--set", f"Output/Interval={steps * step / 20}", "--set",
                                 f"Output/Checkpoints/Steps={steps // 10}"], "out")
        early = late = None
        for line in process.stdout:
            if found := re.match(r"t = .* step \d+  (\d+) %", line):
                if early is None and int(found[1]) >= 25:  # after some checkpoints
                    early = resident(process.pid)
                if late is None and int(found[1]) >= 98:
                    late = resident(process.pid)
        process.communicate()
        assert process.returncode == 0
    print(f"{name}, {steps} steps: {early / 1e6:.2f} MB after a quarter, {late / 1e6:.2f} MB at the end, "
          f"{100 * (late / early - 1):+.2f} %")
    assert late < (1 + GROWTH) * early


if __name__ == "__main__":
    main(str(pathlib.Path(sys.argv[1]).resolve()), sys.argv[2], int(sys.argv[3]))
