# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far `cautery check` is off: its forecast of seconds and memory, made from a short trial, beside a run of the same scene.

Of scenes that run in less than a second both are medians of five. Usage, from the project's root, on a quiet machine:
    python3 doc/peers/forecasts.py [SCENE...]
without scenes: all in prm/ but the given liver.
"""
import json
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile


def forecast(scene):
    said = subprocess.run(["build/cautery", "check", scene], check=True, capture_output=True, text=True).stdout
    seconds, memory = re.search(r"Forecast +about (\S+) s and (\S+) MB", said).groups()
    return float(seconds), float(memory)


def actual(scene):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["build/cautery", scene, "--output", folder], check=True, stdout=subprocess.DEVNULL)
        cost = json.loads((pathlib.Path(folder) / "summary.json").read_text())["cost"]
    return cost["wall_s"], cost["peak_memory_bytes"] / 1e6


def main():
    scenes = [pathlib.Path(name) for name in sys.argv[1:]] or sorted(
        path for path in pathlib.Path("prm").rglob("*.prm") if path.stem != "real_liver_ablation")
    print("| scene | forecast, s | run, s | ratio | forecast, MB | run, MB |\n|---|---|---|---|---|---|")
    for scene in scenes:
        pairs = [(*forecast(scene), *actual(scene))]
        if pairs[0][2] < 1.0:
            pairs += [(*forecast(scene), *actual(scene)) for _ in range(4)]
        foretold, memory, seconds, peak = (statistics.median(column) for column in zip(*pairs))
        print(f"| `{scene}` | {foretold:.2f} | {seconds:.2f} | {foretold / seconds:.2f} | {memory:.0f} | {peak:.0f} |", flush=True)


if __name__ == "__main__":
    main()
