# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the cases of *_cases.py: each must end with its exit status and say exactly what is expected of it. Where the
input is wrong nothing may be written, where a run fails its last good state must be, and `cautery check` must judge
as a run does.

Usage: errors.py CAUTERY GROUP
"""
import csv
import json
import pathlib
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

import adaptive_cases
import effect_cases
import large_cases
import mesh_cases
import run_cases
import scene_cases
import study_cases
from case import write_files

GROUPS = {"values": scene_cases.VALUES, "names": scene_cases.NAMES, "mesh": mesh_cases.MESH,
          "effects": effect_cases.EFFECTS, "time": effect_cases.TIME, "large": large_cases.LARGE,
          "adaptive": adaptive_cases.ADAPTIVE, "command_line": run_cases.COMMAND_LINE,
          "accepted": run_cases.ACCEPTED, "study": study_cases.STUDY, "numerical": run_cases.NUMERICAL}


def run(program, words, folder):
    """Exit status, what was said, and the complaint with the folder's path left out."""
    answer = subprocess.run([program, *words], cwd=folder, capture_output=True, text=True, errors="replace", timeout=120,
                            check=False)
    return answer.returncode, answer.stdout, answer.stderr.strip().replace(f"{folder}/", "")


def wrong_answer(case, status, answer, message):
    """What is wrong with an answer to a case, which should complain with the message: a list of texts."""
    returned, said, complaint = answer
    found = [] if returned == status else [f"exit status {returned} instead of {status}"]
    if status == 0:
        found += [f"no `{text}` in:\n{said}" for text in case.says if text not in said]
        return found + [f"it complains: {complaint}"] * bool(complaint)
    pattern = ".*".join(re.escape(text) for text in f"cautery: {message}".split("<any>"))
    if not re.fullmatch(pattern, complaint, re.DOTALL):
        found.append(f"it says\n    {complaint}\ninstead of\n    cautery: {message}")
    return found


def wrong_failure(case, out):
    """What a run that failed left behind: a summary that says so, and the probes until the last good step."""
    summary = json.loads((out / "summary.json").read_text())
    with open(out / "probes.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    found = []
    if summary["status"] != "failed" or not summary["message"]:
        found.append(f"summary.json has status {summary['status']} and message `{summary['message']}`")
    if summary["end_time_s"] != case.last_good:
        found.append(f"summary.json ends at {summary['end_time_s']} s instead of {case.last_good} s")
    times = [float(row["time_s"]) for row in rows]
    if times[-1:] != [case.last_good] or len(set(times)) != len(times):
        found.append(f"probes.csv has the times {times}")
    if any(not abs(float(row["temperature_K"])) < 1e300 for row in rows):
        found.append("probes.csv has a temperature that is not finite")
    return found


def wrong(program, case, folder):
    """All that is wrong with a case: a list of texts."""
    folder.mkdir()
    write_files(folder, case)
    fails_later = case.last_good is not None
    found = []
    if case.check_too:
        found += wrong_answer(case, case.status, run(program, ["check", *case.words()], folder), case.message)
        if (folder / "out").exists():
            found.append("`check` wrote an output directory")
    message = case.message + (f"; the last good state is that of t = {case.last_good:g} s" if fails_later else "")
    found += wrong_answer(case, case.status, run(program, case.words(), folder), message)
    if fails_later:
        found += wrong_failure(case, folder / "out")
    elif case.status != 0 and sorted(entry.name for entry in folder.iterdir()) != sorted(["scene.prm", *case.files]):
        found.append("something was left behind")
    return [f"{case.name}: {text}" for text in found]


def main(program, group):
    chosen = GROUPS[group]
    names = [case.name for case in chosen]
    assert len(set(names)) == len(names), "names must differ"
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(2) as pool:
        folder = pathlib.Path(folder).resolve()
        answers = pool.map(lambda item: wrong(program, item[1], folder / str(item[0])), enumerate(chosen))
        found = [text for answer in answers for text in answer]
    print(f"{len(chosen)} cases", *found, sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(str(pathlib.Path(sys.argv[1]).resolve()), sys.argv[2]))
