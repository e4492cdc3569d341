# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every entry of the parameter reference has a value other than its default in some scene, every choice is taken in
one. Prints which scene does it. Usage: options.py CAUTERY"""
import pathlib
import re
import subprocess
import sys

import prm

# scene.py sets it for every run.
ELSEWHERE = {"Output/Directory"}
# Its last digits depend on the processor: tests/thesis.
INEXACT = {("Numerics/Explicit/Precision", "single")}
# A boundary without a condition is refused where the condition counts: tests/errors.
NOTHING_TO_RUN = {("Boundaries/*/Thermal", "none"), ("Boundaries/*/Mechanical", "none")}


def wanted(reference):
    """For each entry {default}, or the set of its choices; True where it has choices."""
    found = {}
    for path, value, comment in prm.entries(reference):
        choices = re.search(r"\[([^][]* \| [^][]*)\]", comment)
        if choices:
            found[prm.general(path)] = (True, {choice.strip() for choice in choices.group(1).split("|")})
        else:
            found.setdefault(prm.general(path), (False, set()))[1].add(value)
    return found


def main(cautery):
    reference = subprocess.run([cautery, "parameters"], stdout=subprocess.PIPE, text=True, check=True).stdout
    users = {}
    defaults = {}
    for path, value, _ in prm.entries(reference):
        defaults.setdefault(prm.general(path), value)
    scenes = pathlib.Path(__file__).parent
    for file in sorted([*scenes.glob("*.prm"), *(scenes.parent / "study").glob("*.prm")]):
        for path, value, _ in prm.entries(file.read_text()):
            users.setdefault((prm.general(path), value), set()).add(file.stem)
    missing = []
    for path, (is_choice, values) in wanted(reference).items():
        if is_choice:
            # what nobody states is the default
            lines = {value: users.get((path, value), set()) for value in values if value != defaults[path]}
            missing += [f"{path} = {value}" for value, scenes in lines.items()
                        if not scenes and (path, value) not in NOTHING_TO_RUN | INEXACT]
        else:
            lines = {value: scenes for (entry, value), scenes in users.items() if entry == path and value not in values}
            missing += [] if lines or path in ELSEWHERE else [path]
        for value, scenes in sorted(lines.items()):
            print(f"{path} = {value}: {', '.join(sorted(scenes))}")
    for line in missing:
        print("NO SCENE TOUCHES", line)
    return bool(missing)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
