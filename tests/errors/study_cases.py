# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a study may not be asked."""
from case import Case, value

STANDARD = "mesh, step, IDA, solver, degree, cells, method, precision, condensation"


def study(name, message, *overrides, command="accuracy"):
    """A study that is refused before anything runs."""
    words = [command, "scene.prm", "--output", "out"] + [word for text in overrides for word in ("--set", text)]
    return Case(name, message, command=words)


OWN = ["Accuracy/Names=steps", "Accuracy/steps/Entries=Time/Step, Time/End"]
TAKES = "write `Section/Entry = value; ...`"

STUDY = [
    value("Accuracy/Repeats", "0", "it must be >= 1 and <= 1000"),
    value("Accuracy/Temperature within", "-1", "it must be >= 0"),
    value("Accuracy/Tolerances", "0", "it must be > 0"),
    value("Accuracy/Reference", "guess", "choose one of: Richardson, finer run, exact"),
    Case("finer run without settings", "scene.prm: Accuracy/Finer run = : give its settings, or choose another Reference",
         ["Accuracy/Reference=finer run"]),
    Case("exact without values", "scene.prm: Accuracy/Exact values = : give one for each quantity, or choose another Reference",
         ["Accuracy/Reference=exact"]),
    Case("rungs without entries", "scene.prm: Accuracy/mesh/Rungs = 1 | 2: Entries and Rungs go together; give both, or none of "
         "a standard ladder", ["Accuracy/Names=mesh", "Accuracy/mesh/Rungs=1 | 2"]),
    study("no such ladder", f"scene.prm: Accuracy/Names: `stairs` is no standard ladder ({STANDARD}); give "
          "Accuracy/stairs/Entries and Rungs, or take one of these", "Accuracy/Names=stairs"),
    study("a rung of too few values", "scene.prm: Accuracy/steps/Rungs = 1; 2 | 1: `1` has 1 values for 2 Entries; separate the "
          "values of a rung by `;`", *OWN, "Accuracy/steps/Rungs=1; 2 | 1"),
    study("a rung that the scene refuses", "scene.prm: the ladder `steps`, rung `-1; 2`: scene.prm: Time/Step = -1: it must be "
          "> 0", *OWN, "Accuracy/steps/Rungs=1; 2 | -1; 2"),
    study("a ladder that does not fit", "scene.prm: the ladder `precision`, rung `half`: scene.prm: "
          "Numerics/Explicit/Precision = half: choose one of: double, single", "Accuracy/Names=precision",
          "Accuracy/precision/Entries=Numerics/Explicit/Precision", "Accuracy/precision/Rungs=half | double"),
    study("changes without a value", f"scene.prm: Accuracy/step/With = Time/End: {TAKES}", "Accuracy/Names=step",
          "Accuracy/step/With=Time/End"),
    study("a quantity of one word", "scene.prm: Accuracy/Quantities: `temperature` is neither `PROBE COLUMN`, as `P1 "
          "temperature_K`, nor a path in summary.json, as `/ablation/volume_m3`", "Accuracy/Quantities=temperature"),
    *[study(f"a quantity {text}", f"scene.prm: Accuracy/Quantities: `{text}` is neither `PROBE COLUMN`, as `P1 temperature_K`, nor "
            "a path in summary.json, as `/ablation/volume_m3`", f"Accuracy/Quantities={text}")
      for text in ("tip temperature_K at noon", "/a~2")],
    study("a study of no scene", "`accuracy` takes one scene, not `scene.prm again.prm`; see cautery --help",
          command="accuracy"),
    Case("a goal without heat", "scene.prm: Accuracy/Temperature within: there is no temperature; turn Effects/Heat on or set 0",
         ["Accuracy/Temperature within=0.1", "Effects/Heat=off", "Effects/Deformation=equilibrium"]),
]
STUDY[-2].command.insert(2, "again.prm")
