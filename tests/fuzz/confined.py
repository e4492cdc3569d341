# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nothing that a scene says reaches further than it should: expressions know arithmetic alone, words stay words, and
all that is written lies below the output directory. Works in the present directory.

Usage: confined.py STATEMENT CAUTERY
"""
import pathlib
import shutil
import subprocess
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "errors"))
from case import NEEDLE, SCENE, TISSUE  # noqa: E402

# What would leave a file `reached`, if a shell, gnuplot or a file system took it at its word
WORDS = ["`touch reached`", "$(touch reached)", "; touch reached", "' ; system('touch reached') #", "\"; system \"touch reached", "|touch reached",
         "../reached", "/tmp/../reached", "..", "@reached", "%s%n", "{/Symbol a}_^", "\u00e4 \u4e2d"]
EXPRESSIONS = ["system(\"touch reached\")", "`touch reached`", "touch(1)", "exec(1)", "open(\"reached\")", "read(\"scene.prm\")", "fopen(1)",
               "\"reached\"", "import(1)", "getenv(\"HOME\")", "_a = 1", "x = 1", "x := 1", "#include", "&x", "*x", "x[0]", "x; t", "x -> t"]
PLACES_OF_EXPRESSIONS = ["Initial state/Temperature", f"{NEEDLE}/Power", f"{TISSUE}/Conductivity"]


def run(cautery, folder, *settings, command=()):
    """Exit status and complaint; nothing may be beside the scene and its output directory afterwards."""
    shutil.rmtree(folder, ignore_errors=True)
    inner = pathlib.Path(folder, "a", "b")
    inner.mkdir(parents=True)
    (inner / "scene.prm").write_text(SCENE)
    words = [*command, "scene.prm", "--output", "out"] + [word for text in settings for word in ("--set", text)]
    done = subprocess.run([cautery, *words], cwd=inner, capture_output=True, text=True, errors="replace", check=False)
    made = {str(path.relative_to(inner)) for path in inner.rglob("*")} - {"scene.prm", "out"}
    assert all(path.startswith("out/") for path in made), made
    assert not [path for path in pathlib.Path(folder).rglob("*") if path.name.startswith("reached")], settings
    assert {path.name for path in pathlib.Path(folder).rglob("*") if inner not in path.parents} == {"a", "b"}, settings
    return done.returncode, done.stderr


def expressions_reach_arithmetic_alone(cautery):
    for number, text in enumerate(EXPRESSIONS):
        entry = PLACES_OF_EXPRESSIONS[number % len(PLACES_OF_EXPRESSIONS)]
        status, said = run(cautery, "expression", f"{entry}={text}", "Effects/Temperature-dependent properties=on")
        assert status == 2 and f"scene.prm: {entry} = {text.split('#')[0].strip()}" in said, (entry, text, status, said)


def names_stay_names(cautery):
    """Of probes, boundaries, tissues and ladders: refused, or a word in a column."""
    for text in WORDS:
        text = text.replace(",", "").split("#")[0].strip()
        for settings in ([f"Output/Probe names={text}"], [f"Accuracy/Names={text}"], ["Effects/Deformation=equilibrium", "Output/Reactions=on",
                         f"Boundaries/Names={text}", f"Boundaries/{text}/Thermal=insulated", f"Boundaries/{text}/Mechanical=fixed"]):
            status, said = run(cautery, "names", *settings)
            assert status in (0, 2), (settings, status, said)


def titles_stay_titles(cautery):
    """A study hands titles, quantities and the names of ladders to gnuplot, and makes folders of the latter."""
    for text in WORDS:
        text = text.split("#")[0].strip()
        ladder = text if not set("/\\\"`;") & set(text) else "steps"
        status, said = run(cautery, "titles", f"Title={text}", f"Accuracy/Names={ladder}", f"Accuracy/{ladder}/Entries=Time/Step",
                           f"Accuracy/{ladder}/Rungs=2 | 1", "Accuracy/Quantities=tip temperature_K", command=["accuracy"])
        assert status == 0, (text, status, said)
        pictures = list(pathlib.Path("titles").rglob("*.png"))
        assert not shutil.which("gnuplot") or (len(pictures) == 1 and pictures[0].stat().st_size > 1000), (text, pictures)


if __name__ == "__main__":
    globals()[sys.argv[1]](str(pathlib.Path(sys.argv[2]).resolve()))
