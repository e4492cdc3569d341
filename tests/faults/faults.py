# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the tests of faults share: runs that are interrupted, and whether what they leave is the same."""
import csv
import json
import os
import pathlib
import re
import signal
import subprocess

import cases


# Processes that wait for each other on cores which they share must not spin.
ENVIRONMENT = {**os.environ, "OMPI_MCA_mpi_yield_when_idle": "1"}


class Program:
    def __init__(self, folder, cautery, processes=1):
        """Runs `cautery` on some processes, in a folder with the scene."""
        self.folder = pathlib.Path(folder)
        self.command = [cautery] if processes == 1 else ["mpirun", "--oversubscribe", "-np", str(processes), cautery]
        (self.folder / "scene.prm").write_text(cases.SCENE)

    def start(self, words, out, *more, to=subprocess.PIPE):
        return subprocess.Popen([*self.command, *words, "--output", out, *more], cwd=self.folder, text=True,
                                env=ENVIRONMENT, stdout=to, stderr=subprocess.STDOUT if to != subprocess.PIPE else to, start_new_session=True)

    def run(self, words, out, *more, status=0):
        """What it says."""
        process = self.start(words, out, *more)
        said, complaint = process.communicate(timeout=300)
        assert process.returncode == status, f"exit status {process.returncode}\n{said}\n{complaint}"
        return said + complaint

    def out(self, name):
        return self.folder / name


def children(pid):
    """All processes below `pid`."""
    found = []
    for task in pathlib.Path(f"/proc/{pid}/task").glob("*/children"):
        for child in task.read_text().split():
            found += [int(child), *children(child)]
    return found


def computing(process):
    """Those of a run: itself, or what mpirun has started."""
    return children(process.pid) or [process.pid]


def interrupt(process, after_steps, what=signal.SIGTERM):
    """Sends a signal once the run has told of so many steps, if it is not done by then. Returns the end of what it says."""
    for line in process.stdout:
        if re.match(r"t = .* step ", line):
            after_steps -= 1
        if after_steps == 0:
            for pid in computing(process):
                try:
                    os.kill(pid, what)
                except ProcessLookupError:
                    pass
            break
    return process.communicate(timeout=120)


def files(folder):
    """The results by name, without the date that deal.II writes."""
    return {file.name: re.sub(rb"<!--.*?-->", b"", file.read_bytes(), count=1, flags=re.DOTALL)
            for pattern in ("*.csv", "*.vtu", "*.pvd") for file in sorted(folder.glob(pattern))}


def assert_identical(folder, expected):
    found, wanted = files(folder), files(expected)
    assert found.keys() == wanted.keys(), f"files {found.keys() ^ wanted.keys()} are in one folder only"
    different = [name for name in wanted if found[name] != wanted[name]]
    assert not different, f"{different} differ from {expected}"
    one, other = (json.loads((place / "summary.json").read_text()) for place in (folder, expected))
    for part in ("statistics", "errors", "adaption", "balance"):
        assert one.get(part) == other.get(part), f"{part} in summary.json: {one.get(part)} in the place of {other.get(part)}"
    assert not list(folder.glob("*.part")), "a file is left half written"
    assert not (folder / "checkpoint.h5").exists(), "the checkpoint is left though the run is done"


def rows(file):
    with open(file, newline="", encoding="utf-8") as text:
        return list(csv.DictReader(text))


def assert_close(folder, expected, tolerance):
    """All columns of all tables, relative to their largest value, forces to the largest of all components, as some balance
    to nothing. Returns the largest difference."""
    worst = 0.
    for table in ("probes.csv", "reactions.csv"):
        if not (expected / table).exists():
            continue
        found, wanted = rows(folder / table), rows(expected / table)
        assert len(found) == len(wanted) > 1, f"{table} has {len(found)} rows in the place of {len(wanted)}"
        for column in wanted[0]:
            if column in ("probe", "support"):
                assert [row[column] for row in found] == [row[column] for row in wanted]
                continue
            one, other = [[float(row[column]) for row in table] for table in (found, wanted)]
            alike = [name for name in wanted[0] if name.startswith("force")] if column.startswith("force") else [column]
            size = max((abs(float(row[name])) for row in wanted for name in alike if abs(float(row[name])) < 1e300), default=0.)
            for x, y in zip(one, other):
                if x != y:
                    worst = max(worst, abs(x - y) / size)
                assert x == y or abs(x - y) <= tolerance * size, f"{table}, {column}: {x} in the place of {y}"
    return worst
