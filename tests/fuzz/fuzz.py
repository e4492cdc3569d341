# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mutates the project's scenes and meshes and runs the program on them: every case must end in a result, or with exit
status 1 or 2 and a message that says where the fault is. Cases are numbered and always the same; the files of those that
fail stay in WORK/KIND_NUMBER/run, with what was said beside them.

Usage: fuzz.py DRIVER WORK [--scenes 5000] [--meshes 1000] [--first 0] [--messages FILE]
       fuzz.py DRIVER WORK --only scene:17      one case again, its files kept
"""
import argparse
import collections
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from random import Random

import judge
import mesh_mutations
import scene_mutations
import seeds

SECONDS = 30      # of computing, for a case; sanitizers and busy machines included
WORKERS = 2
COMMANDS = {"run": 80, "check": 16, "effects": 2, "accuracy": 2}
ENVIRONMENT = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "DEAL_II_NUM_THREADS": "1", "LD_BIND_NOW": "1",
               "ASAN_OPTIONS": "detect_leaks=0:exitcode=99:allocator_may_return_null=0:max_allocation_size_mb=4000:"
                               "detect_stack_use_after_return=0",
               "UBSAN_OPTIONS": "print_stacktrace=1:exitcode=99"}


class Driver:
    """A process that runs the program again and again, see driver.cc."""

    def __init__(self, program, temporary):
        self.process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                                        env={**os.environ, **ENVIRONMENT, "TMPDIR": str(temporary)})

    def run(self, folder, words):
        self.process.stdin.write(json.dumps({"folder": str(folder), "seconds": SECONDS, "words": words}) + "\n")
        self.process.stdin.flush()
        return self.process.stdout.readline().strip() or "signal 0"

    def close(self):
        self.process.stdin.close()
        self.process.wait()


class Fuzzer:
    def __init__(self, program, work):
        self.program, self.work, self.own = program, work, threading.local()
        self.drivers, self.scenes, self.meshes = [], seeds.scenes(), seeds.mesh_files()
        self.choices = None

    def driver(self):
        if not hasattr(self.own, "driver"):
            temporary = self.work / f"tmp_{len(self.drivers)}"
            temporary.mkdir(exist_ok=True)
            self.own.driver = Driver(self.program, temporary)
            self.drivers.append(self.own.driver)
        return self.own.driver

    def reference(self):
        """What `cautery parameters` prints."""
        folder = self.work / "parameters" / "run"
        folder.mkdir(parents=True)
        assert self.driver().run(folder, ["parameters"]) == "exit 0", "the driver does not work"
        return folder.with_suffix(".stdout").read_text()

    def scene_case(self, random, folder):
        path, text = random.choice(self.scenes)
        data, changed = scene_mutations.mutated(random, text, self.choices)
        (folder / "scene.prm").write_bytes(data)
        changes = {name: value for name, value in seeds.small(path, text, data).items() if name not in changed}
        if random.random() < 0.1:
            changes["Output/Fields"] = "on"
        return path, {"scene.prm"}, changes

    def mesh_case(self, random, folder):
        name, data = random.choice(self.meshes)
        (folder / name).write_bytes(mesh_mutations.mutated(random, data))
        (folder / "scene.prm").write_text(seeds.MESH_SCENE.format(name=name, fields=random.choice(["off", "off", "off", "on"])))
        flat = {"Dimension": "2"} if name == "strips.msh" else {}
        return name, {"scene.prm", name}, flat

    def case(self, label):
        """The label, its seed, how it ended, what was said, and what is wrong with it."""
        random = Random(label)
        kind, number = label.split(":")
        folder = self.work / f"{kind}_{number}" / "run"
        shutil.rmtree(folder.parent, ignore_errors=True)
        folder.mkdir(parents=True)
        make = {"scene": self.scene_case, "mesh": self.mesh_case}[kind]
        origin, inputs, changes = make(random, folder)
        command = random.choices(*zip(*COMMANDS.items()))[0] if kind == "scene" else "run"
        if command == "accuracy" and b"subsection Accuracy" in (folder / "scene.prm").read_bytes():
            command = "check" # the ladders of its own are not small
        words = [command] * (command != "run") + ["scene.prm", "--output", "out"]
        words += [word for name, value in changes.items() for word in ("--set", f"{name}={value}")]
        ended = self.driver().run(folder, words)
        said = folder.with_suffix(".stderr").read_text(errors="replace")
        found = judge.wrong(ended, said, folder, command, inputs)
        if not found and not self.keep:
            shutil.rmtree(folder.parent)
        else:
            (folder.parent / "command.json").write_text(json.dumps(words))
        return label, origin, ended, said, found

    def run(self, labels, keep=False):
        self.keep = keep
        self.choices = scene_mutations.choices_of(self.reference())
        with ThreadPoolExecutor(WORKERS) as pool:
            yield from pool.map(self.case, labels)
        for driver in self.drivers:
            driver.close()


def without_numbers(said):
    return re.sub(r"[-+]?\d+(\.\d+)?(e[-+]?\d+)?", "N", said.strip()[:400])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("driver", type=pathlib.Path)
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--scenes", type=int, default=0)
    parser.add_argument("--meshes", type=int, default=0)
    parser.add_argument("--first", type=int, default=0, help="number of the first case")
    parser.add_argument("--only", action="append", help="these cases alone, as scene:17; their files are kept")
    parser.add_argument("--messages", type=pathlib.Path, help="a file for what was said, each kind of message once")
    options = parser.parse_args()
    shutil.rmtree(options.work, ignore_errors=True)
    options.work.mkdir(parents=True)
    labels = options.only or [f"{kind}:{options.first + n}" for kind, count in
                              (("scene", options.scenes), ("mesh", options.meshes)) for n in range(count)]
    ends, messages, failed, start = collections.Counter(), {}, 0, time.time()
    fuzzer = Fuzzer(str(options.driver.resolve()), options.work.resolve())
    for label, origin, ended, said, found in fuzzer.run(labels, keep=bool(options.only)):
        ends[ended] += 1
        messages.setdefault((ended, without_numbers(said)), label)
        if found:
            failed += 1
            print(f"{label} ({origin}) {ended}: {'; '.join(found)}\n    {said.strip()[:600]}", flush=True)
    if options.messages:
        options.messages.write_text("".join(f"{label} {ended}: {said}\n" for (ended, said), label in sorted(messages.items())))
    counts = ", ".join(f"{number} {ended}" for ended, number in sorted(ends.items()))
    print(f"{len(labels)} cases in {time.time() - start:.0f} s: {counts}; {failed} wrong")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
