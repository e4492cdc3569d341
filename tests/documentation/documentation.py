# SPDX-License-Identifier: LGPL-2.1-or-later
"""Usage: documentation.py STATEMENT CAUTERY PROJECT; STATEMENT `write_parameter_reference` renews doc/parameters.md."""
import csv
import pathlib
import re
import subprocess
import sys
import tempfile

HEAD = ("# Parameters\n\nWhat `./cautery parameters` prints: every section and entry of a scene, with defaults, units and "
        "bounds.\n\n```prm\n")


def reference(cautery):
    run = subprocess.run([cautery, "parameters"], stdout=subprocess.PIPE, text=True, check=True)
    return HEAD + run.stdout + "```\n"


def parameter_reference_is_current(cautery, project):
    assert (project / "doc" / "parameters.md").read_text() == reference(cautery), \
        "renew doc/parameters.md: documentation.py write_parameter_reference build/cautery ."


def write_parameter_reference(cautery, project):
    (project / "doc" / "parameters.md").write_text(reference(cautery))


def scene_of_the_readme_runs(cautery, project):
    scene = re.search(r"```prm\n(.*?)```", (project / "README.md").read_text(), re.DOTALL).group(1)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "readme.prm").write_text(scene)
        subprocess.run([cautery, folder / "readme.prm", "--output", folder / "out", "--set",
                        "Output/Probe names=tip", "--set", "Output/Probe places=0.005, 0.005, 0.005"], check=True)
        with open(folder / "out" / "probes.csv", newline="") as file:
            last = list(csv.DictReader(file))[-1]
        assert float(last["time_s"]) == 120 and 380 < float(last["temperature_K"]) < 500


def complete_scene_gives_the_same_answer(cautery, project):
    """scene.prm, which a run leaves behind, holds everything: also what came from the command line."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        settings = ("--set", "Time/End=20", "--set", "Effects/Heat=non-Fourier", "--set", "Output/Interval=5")
        subprocess.run([cautery, project / "prm" / "liver_ablation.prm", "--output", folder / "first", *settings], check=True)
        subprocess.run([cautery, folder / "first" / "scene.prm", "--output", folder / "second"], check=True)
        for file in ("scene.prm", "probes.csv"):
            assert (folder / "first" / file).read_bytes() == (folder / "second" / file).read_bytes(), file


def numbers_of(word, cells):
    """Of `Figures 8, 31 and 62`, `13 to 15` or `Table 7` in a table's first column."""
    found = set()
    for cell in cells:
        tables = re.findall(r"Tables? (\d+)", cell)
        text = re.sub(r"Tables? \d+", "", cell)
        for first, last in re.findall(r"\b(\d+)(?: to (\d+))?", text if word == "Figure" else ""):
            found.update(range(int(first), int(last or first) + 1))
        found.update(int(table) for table in tables if word == "Table")
    return found


def gallery_has_every_figure_and_table(_, project):
    """Of chapters 4 to 7: Figures 7 to 84, Tables 2 to 10."""
    lines = (project / "doc" / "thesis.md").read_text(encoding="utf-8").splitlines()
    cells = [line.split("|")[1].strip() for line in lines if re.match(r"\| (\d|Table|Figure)", line)]
    for word, last, first in (("Figure", 84, 7), ("Table", 10, 2)):
        missing = set(range(first, last + 1)) - numbers_of(word, cells)
        assert not missing, f"{word} {sorted(missing)}"


def gallery_names_every_scene_and_picture(_, project):
    text = (project / "doc" / "thesis.md").read_text(encoding="utf-8")
    scenes = [name.replace("*", ".*") for name in re.findall(r"`(ch\d_[a-z0-9_*]+)`", text)]
    for scene in (project / "prm" / "thesis").glob("*.prm"):
        assert any(re.fullmatch(name, scene.stem) for name in scenes), scene
    for name in scenes:
        assert any(re.fullmatch(name, scene.stem) for scene in (project / "prm" / "thesis").glob("*.prm")), name
    shown = set(re.findall(r"\(images/thesis/(\w+\.png)\)", text))
    assert shown == {picture.name for picture in (project / "doc" / "images" / "thesis").iterdir()}


if __name__ == "__main__":
    globals()[sys.argv[1]](sys.argv[2], pathlib.Path(sys.argv[3]))
