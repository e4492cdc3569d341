# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line; scenes that look odd but are right; runs that fail."""
import meshes
from case import DEFORMATION, NEEDLE, SCENE, TISSUE, Case, mesh, rollers

COMMAND_LINE = [
    Case("no scene",
         "give a scene to run; see cautery --help", command=[]),
    Case("two scenes",
         "give a scene, or a command and a scene, not `scene.prm scene.prm`; see cautery --help",
         command=["scene.prm", "scene.prm"]),
    Case("check without a scene",
         "`check` takes one scene; see cautery --help", command=["check"]),
    Case("parameters of something",
         "`parameters` takes nothing more, not `scene.prm`; see cautery --help",
         command=["parameters", "scene.prm"]),
    Case("an unknown option",
         "unrecognised option '--verbose'; see cautery --help", command=["scene.prm", "--verbose"]),
    Case("an option without value",
         "the required argument for option '--output' is missing; see cautery --help",
         command=["scene.prm", "--output"]),
    Case("an override without a value",
         '--set "Time/End": write "Section/Entry=value"', ["Time/End"], check_too=True),
    Case("an override without an entry",
         '--set "=3": write "Section/Entry=value"', ["=3"]),
    Case("an override of a section",
         '--set "Time=3": Line <1> of file <--set "Time=3">: No entry with name <Time> was declared in the current '
         "subsection. (`cautery parameters` lists every section and entry)", ["Time=3"]),
    Case("an unknown command",
         "give a scene, or a command and a scene, not `chekc scene.prm`; see cautery --help",
         command=["chekc", "scene.prm"]),
    Case("missing scene",
         "the scene `none.prm` cannot be read; give the path of a .prm file",
         command=["none.prm"], check_too=True),
    Case("a folder as a scene",
         "the scene `.` cannot be read; give the path of a .prm file", command=["."], check_too=True),
    Case("an empty scene",
         "scene.prm: Boundaries/outside has no thermal condition; set Thermal (e.g. insulated)", text=""),
    Case("a file that is no scene",
         "scene.prm: Line <1> of file <scene.prm>: The line\n\n        <$MeshFormat>\n\ncould not be parsed: "
         "please check to make sure that the file is not missing a 'set', 'include', 'subsection', or 'end' "
         "statement. (`cautery parameters` lists every section and entry)", text=meshes.two_regions()),
    Case("an output directory that cannot be made",
         "scene.prm: the output directory `scene.prm/out` cannot be written; give another one with --output",
         command=["scene.prm", "--output", "scene.prm/out"]),
    Case("an output directory that is a file",
         "scene.prm: the output directory `scene.prm` cannot be written; give another one with --output",
         command=["scene.prm", "--output", "scene.prm"]),
]

# What looks odd but is right: these run.
ACCEPTED = [
    mesh("negative tetrahedra are turned round", "", meshes.two_regions(True),
         [f"{NEEDLE}/Places=0.1, 0.1, 0.1", "Output/Probe places=0.1, 0.1, 0.1"], status=0,
         says=["2 tetrahedra, 5 nodes, 0.333333 m3", "note: 2 inverted cells turned round"]),
    mesh("a negative hexahedron is turned round", "", meshes.cube(True),
         [f"{NEEDLE}/Places=0.1, 0.1, 0.1", "Output/Probe places=0.1, 0.1, 0.1"], status=0,
         says=["1 hexahedra, 8 nodes, 1 m3", "note: 1 inverted cells turned round"]),
    Case("a title in another encoding than UTF-8", "", ["Title=caf\udce9"], status=0, says=["Results"]),
    Case("rollers on three sides hold a body", "",
         [*DEFORMATION, *rollers("x min, y min, z min")], status=0, says=["Results"]),
    Case("rollers on one side do with inertia", "",
         ["Effects/Deformation=inertia", *rollers("x min")], status=0, says=["Results"]),
    Case("fields are written without a word", "", ["Output/Fields=on"], status=0, says=["Results"]),
    Case("lines that end as on Windows", "",
         text=SCENE.replace("\n", "\r\n"), status=0, says=["Results"]),
    Case("the last of two overrides counts", "", ["Time/Step=7", "Time/Step=0.5"], status=0,
         says=["4 steps of 0.5 s"]),
    Case("a step longer than the run", "", ["Time/Step=50"], status=0, says=["Results"]),
]

# The input is well-formed, but the numbers fail: status 1.
NUMERICAL = [
    Case("a source that becomes infinite",
         "the expression `1/(1 - t)` has no finite value at (0, 0, 0) m, 1 s; change the expression or its range",
         [f"{NEEDLE}/Power=1/(1 - t)"], check_too=True, last_good=0.0, status=1),
    Case("a source that is infinite from the start",
         "the expression `log(-1 - x)` has no finite value at (0, 0, 0) m, 0 s; change the expression or its range",
         ["Initial state/Temperature=log(-1 - x)"], status=1, check_too=True),
    Case("a solver without iterations",
         "CG + SSOR did not converge in 1 iterations; choose Method = direct or CG + AMG, or a larger Tolerance in the "
         "solver's section of Numerics",
         ["Numerics/Heat solver/Method=CG + SSOR", "Numerics/Heat solver/Largest number of iterations=1",
          "Numerics/Heat solver/Tolerance=1e-14"], last_good=0.0, status=1),
    Case("IDA without steps",
         "The largest number of steps, 2, is used up at t = 0.004 s (last step <any> s). Allow more steps or raise "
         "the tolerances.",
         ["Time/Integrator=IDA", "Time/Largest number of steps=2"], last_good=0.004, status=1),
    Case("a sink under a limiter of temperatures",
         "Numerics/Temperature limiter = on, but a source or a flux takes heat away in the step to t = 2 s, so that no "
         "datum tells how cold the body may get; turn it off",
         ["Numerics/Temperature limiter=on", f"{NEEDLE}/Power=1.5 - t"], last_good=1.0, status=1),
    Case("a conductivity that falls below 0",
         f"{TISSUE}/Conductivity = 0.6 - 0.1 * (T - 310) is <any> at T = <any> K, where it must be > 0; give an "
         "expression that holds at all temperatures of the run",
         ["Effects/Temperature-dependent properties=on", f"{TISSUE}/Conductivity=0.6 - 0.1 * (T - 310)",
          f"{NEEDLE}/Power=if(t > 1, 50, 0)"], last_good=1.0, status=1),
    Case("a temperature beyond all numbers",
         "a right-hand side is not finite: the solution has blown up; take a smaller Time/Step",
         [f"{NEEDLE}/Power=if(t > 1, 1e307, 1)"], last_good=1.0, status=1),
    Case("properties that never settle",
         "the iteration for heat did not converge in 3 rounds in the step to t = 1 s (last change <any>); take a "
         "smaller Time/Step",
         ["Effects/Temperature-dependent properties=on", f"{TISSUE}/Conductivity=0.6 + 0.5 * sin(50 * T)",
          "Numerics/Largest number of nonlinear iterations=3"], last_good=0.0, status=1),
]
