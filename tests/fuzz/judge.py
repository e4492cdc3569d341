# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is wrong with how a case ended: a list of texts."""
import array
import base64
import csv
import json
import math
import re
import zlib

# What the standard library and others say, which names neither an entry nor a place
VAGUE = re.compile(r"std::|bad_alloc|vector::|basic_string|\bsto[a-z]+$|map::at|\[json\.|bad_variant|regex_|filesystem error|boost::|"
                   r"Dereferencing|not given any text|Internal error|parse error$")
# The logarithm of no damage; damage itself where that overflows. JSON writes null for both
NO_NUMBER = {"ln_damage": -math.inf, "damage": math.inf}
NULLS = {"ln_damage_max", "damage_max"}


def wrong_numbers(value, path):
    """Paths of what is not a finite number in a summary."""
    if isinstance(value, dict):
        return [text for key, part in value.items() for text in wrong_numbers(part, f"{path}/{key}")]
    if isinstance(value, list):
        return [text for n, part in enumerate(value) for text in wrong_numbers(part, f"{path}/{n}")]
    if value is None and path.rsplit("/", 1)[1] not in NULLS:
        return [path]
    return [path] if isinstance(value, float) and not math.isfinite(value) else []


def wrong_fields(file):
    """Arrays of a .vtu file that hold what is not a number (beyond single precision's range they may be infinite)."""
    found, n_arrays = [], 0
    pattern = r'<DataArray type="Float32"(?: Name="([^"]*)")?[^>]*format="binary">\s*([A-Za-z0-9+/=]+)'
    for name, text in re.findall(pattern, file.read_text(errors="replace")):
        # four words of a header (one block, its size, again, its size when compressed), then the block
        n_arrays += 1
        try:
            data = array.array("f", zlib.decompress(base64.b64decode(text[24:])))
        except (zlib.error, ValueError) as error:
            found.append(f"{file.name}: {name or 'places'} cannot be read: {error}")
            continue
        if any(map(math.isnan, data)):
            found.append(f"{file.name}: {name or 'a place'} is not a number")
    return found if n_arrays > 1 else [f"{file.name} has no arrays"]


def wrong_results(out, status):
    """Of the files of a run that ended with @p status."""
    if not (out / "summary.json").exists():
        return [] if status == 1 else ["there is no summary.json"]
    summary = json.loads((out / "summary.json").read_bytes())
    found = [f"summary.json: {path} is no number" for path in wrong_numbers(summary, "")]
    if summary["status"] != ("done" if status == 0 else "failed"):
        found.append(f"summary.json has status {summary['status']}")
    if (out / "probes.csv").exists():
        with open(out / "probes.csv", encoding="utf-8", errors="replace", newline="") as file:
            rows = list(csv.DictReader(file))
        for row in rows:
            for column, text in row.items():
                if column == "probe":
                    continue
                number = float(text)
                if not math.isfinite(number) and number != NO_NUMBER.get(column):
                    found.append(f"probes.csv: {column} = {text} at {row['time_s']} s")
    for file in out.glob("*.vtu"):
        found += wrong_fields(file)
    return found[:5]


def wrong_message(said, status, words):
    found = []
    if "Sanitizer" in said or "runtime error:" in said:
        found.append("a sanitizer complains")
    if not said.startswith("cautery: ") or len(said) < 20:
        found.append("no message")
    if VAGUE.search(said[:2000]):
        found.append("the message is another library's")
    if status == 2 and not any(word in said for word in ("scene.prm", "--set", *words)):
        found.append("the message names neither the scene nor the mesh")
    return found


def wrong(ended, said, folder, command, inputs):
    """Of a case that @p ended ("exit 0", "signal 11") in @p folder with the files @p inputs, and complained @p said."""
    kind, number = ended.split()
    if kind == "signal":
        return [f"{'hangs' if number in ('14', '24') else 'crashes'}: signal {number}"]
    status = int(number)
    if status not in (0, 1, 2):
        return [f"exit status {status}"] + wrong_message(said, status, [])
    left = sorted(entry.name for entry in folder.iterdir())
    beside = sorted(entry.name for entry in folder.parent.iterdir())
    found = []
    if status == 0:
        found += [f"it complains: {said[:300]}"] * bool(said)
    else:
        found += wrong_message(said, status, inputs)
    if (status == 2 or command == "check") and left != sorted(inputs) and command in ("run", "check"):
        found.append(f"something was left behind: {left}")
    if set(beside) - {"run", "run.stdout", "run.stderr", "tmp"} or set(left) - {*inputs, "out"}:
        found.append(f"files outside of the output directory: {beside}, {left}")
    if command == "run" and status != 2:
        found += wrong_results(folder / "out", status)
    return found
