# SPDX-License-Identifier: LGPL-2.1-or-later
"""Values, entries and names that a scene may not have."""
from case import DEFORMATION, EXPRESSION, NEEDLE, PLACE, SCENE, TABLE, TISSUE, Case, value

DIFFERENCES = "Numerics/Method = finite differences"
KEPT = "Numerics/Kept nodes = inside"
STAYS = ("needs a matrix that stays, which IDA, properties that depend on temperature and perfusion that stops do not "
         "leave; leave it empty")
GRID = "set Mesh/Shape = box and Mesh/Cells = hexahedra, or choose finite elements"
SMALL = ("knows small deformation and implicit steps only; choose finite elements, or Effects/Deformation = equilibrium "
         "and Time/Integrator = backward Euler")

EMPTY = "a name is empty; write one between two commas"
BREAKS = "a name has a slash, backslash, quote or control character; leave it out"

VALUES = [
    value("Dimension", "4", "it must be >= 2 and <= 3"),
    value(f"{TISSUE}/Density", "-1000", "it must be > 0"),
    value(f"{TISSUE}/Density", "heavy", "this is not a number"),
    value(f"{TISSUE}/Conductivity", "0", "it must be > 0"),
    value(f"{TISSUE}/Specific heat", "-1", "it must be > 0"),
    value(f"{TISSUE}/Poisson's ratio", "0.5", "it must be > -1 and < 0.5"),
    value(f"{TISSUE}/Young's modulus", "-1e6", "it must be > 0"),
    value(f"{TISSUE}/Perfusion rate", "-1", "it must be >= 0"),
    value(f"{TISSUE}/Relaxation time", "-16", "it must be >= 0"),
    value(f"{TISSUE}/Conductivity", "300: 0.5, 290: 0.6", "the temperatures of a table must rise from entry to entry"),
    value(f"{TISSUE}/Conductivity", "300: 0.5, 310", TABLE),
    value(f"{TISSUE}/Arrhenius damage/Constants", "kidney", "choose one of: none, thesis, retina, skin, liver"),
    value("Initial state/Temperature", "-5", "it must be >= 0"),
    Case("negative initial temperature somewhere",
         "scene.prm: Initial state/Temperature = 1000*(0.005 - x): it falls to -5 K in the body; temperatures are "
         "absolute, from 0 K on",
         ["Initial state/Temperature=1000*(0.005 - x)"], check_too=True),
    Case("initial temperature in time",
         "scene.prm: Initial state/Temperature = 300 + t: it cannot depend on t; it is that at t = 0",
         ["Initial state/Temperature=300 + t"]),
    value(f"{NEEDLE}/Power", "0.1 * q", EXPRESSION + 'Unexpected token "q" found at position 6.'),
    value(f"{NEEDLE}/Power", "0,1", EXPRESSION + "a comma only separates arguments; decimals have a point"),
    value(f"{NEEDLE}/Power", "x = 1", EXPRESSION + "nothing can be assigned; compare with =="),
    value(f"{TISSUE}/Conductivity", "T=300", EXPRESSION.replace("x,y,z,t", "T") + "nothing can be assigned; compare with =="),
    value(f"{NEEDLE}/Power", "2 * (3", EXPRESSION + "Missing parenthesis"),
    value(f"{NEEDLE}/Places", "0.005", PLACE),
    value(f"{NEEDLE}/Places", "0.005, 0.005", PLACE),
    value(f"{NEEDLE}/Places", "", "a point source needs at least one place"),
    value("Mesh/Subdivisions", "2.5", "these are whole numbers"),
    value("Mesh/Subdivisions", "0", "it must be >= 1 and <= 10000"),
    value("Mesh/Refinements", "9", "it must be >= 0 and <= 8"),
    value("Mesh/Shape", "sphere", "choose one of: box, file"),
    value("Numerics/Element degree", "3", "it must be >= 1 and <= 2"),
    value("Numerics/Method", "volumes", "choose one of: finite elements, finite differences"),
    Case("condensed large deformation",
         f"scene.prm: {KEPT} condenses linear systems, which explicit steps and large deformation do not have; leave it "
         "empty", ["Numerics/Kept nodes=inside", "Effects/Deformation=large equilibrium"]),
    *[Case(f"condensed {what}", f"scene.prm: {KEPT} {STAYS}", ["Numerics/Kept nodes=inside", *entries])
      for what, entries in {
          "IDA": ["Time/Integrator=IDA"],
          "conductivity": ["Effects/Temperature-dependent properties=on", f"{TISSUE}/Conductivity=0.5 + 0.001*T"],
          "perfusion": ["Effects/Perfusion=on", "Effects/Perfusion stops in dead tissue=on",
                        "Effects/Damage=Arrhenius"]}.items()],
    Case("reactions of nothing",
         "scene.prm: Output/Reactions = on, but there is none without deformation; switch one of both",
         ["Output/Reactions=on"], check_too=True),
    Case("condensed to nothing",
         "scene.prm: Numerics/Kept nodes keeps 0 of 27 nodes, so that there is nothing to condense; name "
         "fewer or other nodes, or none for no condensation",
         ["Numerics/Kept nodes=probes", "Output/Probe names=", "Output/Probe places="], check_too=True),
    Case("condensed to all",
         "scene.prm: Numerics/Kept nodes keeps 27 of 27 nodes, so that there is nothing to condense; name "
         "fewer or other nodes, or none for no condensation", ["Numerics/Kept nodes=all"], check_too=True),
    Case("finite differences on tetrahedra", f"scene.prm: {DIFFERENCES} needs a grid along the axes; {GRID}",
         ["Numerics/Method=finite differences", "Mesh/Cells=tetrahedra"]),
    Case("finite differences on a file", f"scene.prm: {DIFFERENCES} needs a grid along the axes; {GRID}",
         ["Numerics/Method=finite differences", "Mesh/Shape=file", "Mesh/File name=grid.msh"]),
    Case("quadratic finite differences",
         f"scene.prm: {DIFFERENCES} knows the corners of cells only; set Numerics/Element degree = 1",
         ["Numerics/Method=finite differences", "Numerics/Element degree=2"]),
    Case("finite differences in large deformation", f"scene.prm: {DIFFERENCES} {SMALL}",
         ["Numerics/Method=finite differences", "Effects/Deformation=large equilibrium"]),
    Case("finite differences in explicit steps", f"scene.prm: {DIFFERENCES} {SMALL}",
         ["Numerics/Method=finite differences", "Time/Integrator=explicit"]),
    value("Numerics/Heat solver/Tolerance", "1", "it must be > 0 and < 1"),
    value("Output/Fields", "yes", "choose one of: off, on"),
    value(f"{TISSUE}/Density", "nan", "this is not a number"),
    value(f"{TISSUE}/Density", "inf", "this is not a number"),
    value(f"{TISSUE}/Thermal stretch", "large", "choose one of: linearised, exact"),
    value("Effects/Damage", "boiling", "choose one of: off, critical thermal load, Arrhenius, thermal strain energy, "
          "thermo-mechanical strain energy, CEM43"),
    value("Mesh/Length unit", "inch", "choose one of: m, cm, mm"),
    value("Mesh/Lower corner", "0", PLACE),
    value("Boundaries/outside/Thermal", "cold", "choose one of: none, temperature, flux, convection, insulated"),
    value("Boundaries/outside/Temperature", "-5", "it must be >= 0"),
    value("Boundaries/outside/Temperature", "310 + w", EXPRESSION + 'Unexpected token "w" found at position 6.'),
    value("Boundaries/outside/Transfer coefficient", "-5", "it must be >= 0"),
    value("Boundaries/outside/Displacement", "0",
          "a vector has two or three components, separated by semicolons"),
    value("Output/Probe places", "0.005", PLACE),
]

NAMES = [
    Case("unknown entry",
         "scene.prm: Line <20> of file <scene.prm>: No entry with name <Stop> was declared in the current "
         "subsection. (`cautery parameters` lists every section and entry)",
         text=SCENE.replace("set End ", "set Stop"), check_too=True),
    Case("unknown section",
         "scene.prm: Line <19> of file <scene.prm: There is no such subsection to be entered: Duration (`cautery "
         "parameters` lists every section and entry)",
         text=SCENE.replace("subsection Time", "subsection Duration")),
    Case("unknown entry in an override",
         '--set "Time/Stop=3": Line <2> of file <--set "Time/Stop=3">: No entry with name <Stop> was declared in '
         "the current subsection. (`cautery parameters` lists every section and entry)", ["Time/Stop=3"]),
    Case("a section that is not named",
         "scene.prm: Line <29> of file <scene.prm: There is no such subsection to be entered: Tissues.tumour "
         "(`cautery parameters` lists every section and entry)",
         text=SCENE + "subsection Tissues\n  subsection tumour\n  end\nend\n"),
    Case("section without an end",
         "scene.prm: There are unequal numbers of 'subsection' and 'end' statements in the parameter file "
         "<scene.prm>. (`cautery parameters` lists every section and entry)", text=SCENE.rstrip()[:-3]),
    Case("a line that is no entry",
         "scene.prm: Line <2> of file <scene.prm>: The line\n\n        <End = 3>\n\ncould not be parsed: please "
         "check to make sure that the file is not missing a 'set', 'include', 'subsection', or 'end' statement. "
         "(`cautery parameters` lists every section and entry)", text="\nEnd = 3\n" + SCENE),
    Case("an entry twice",
         "scene.prm, line 29: Time/End stands in line 20 already; keep one",
         text=SCENE.rstrip() + "\nsubsection Time\n  set  End=3\nend\n", check_too=True),
    Case("two tissues of one name",
         "scene.prm: Tissues/Names = a, a: a name stands twice; names must differ",
         ["Tissues/Names=a, a"]),
    Case("two boundaries of one name",
         "scene.prm: Boundaries/Names = a, a: a name stands twice; names must differ",
         ["Boundaries/Names=a, a"]),
    Case("two probes of one name",
         "scene.prm: Output/Probe names = a, a: a name stands twice; names must differ",
         ["Output/Probe names=a, a", "Output/Probe places=0,0,0; 0.01,0,0"]),
    Case("an entry twice in capitals",
         "scene.prm, line 29: Time/End stands in line 20 already; keep one",
         text=SCENE.rstrip() + "\nSUBSECTION Time\n  SET End=3\nEND\n", check_too=True),
    Case("a scene that includes itself",
         "scene.prm, line 28: a scene is one file; write here what `scene.prm` has, in place of `include`",
         text=SCENE.rstrip() + "\ninclude scene.prm\n", check_too=True),
    *[Case(f"{entry} {text}", f"scene.prm: {entry} = {text}: {reason}", [f"{entry}={text}", *more])
      for text, reason in (("a, , b", EMPTY), ("a/b", BREAKS), ('a"b', BREAKS), ("`id`", BREAKS), ("..\\b", BREAKS))
      for entry, more in ((("Tissues/Names", []), (f"{TISSUE}/Fibre families", []), ("Accuracy/Names", []),
                           ("Output/Probe names", ["Output/Probe places=" + "; ".join(["0, 0, 0"] * (text.count(",") + 1))])))],
    Case("more probes than places",
         "scene.prm: Output/Probe names = a, b: there are 2 names for 1 places; give each probe one of both",
         ["Output/Probe names=a, b"]),
    Case("no tissue",
         "scene.prm: Tissues/Names is empty; name at least one tissue", ["Tissues/Names="]),
    Case("unknown tissue preset",
         "scene.prm: Tissues/tissue/Preset = kidney: there is no tissue preset `kidney`; choose one of: thesis "
         "type I, thesis type II, porcine liver",
         ["Tissues/tissue/Preset=kidney"]),
    Case("unknown type of source",
         "scene.prm: Heat sources/needle/Type = laser: there is no heat source of type `laser`; choose one of: "
         "points, uniform, Gaussian, microwave antenna, expression",
         ["Heat sources/needle/Type=laser"]),
    Case("an entry of another type of source",
         "scene.prm: Line <9> of file <scene.prm>: No entry with name <Places> was declared in the current "
         "subsection. (`cautery parameters` lists every section and entry)",
         ["Heat sources/needle/Type=uniform"]),
    Case("probe outside",
         "scene.prm: Output/Probe places, `far`: (0.005, 0.005, 0.02) m lies outside the mesh box; its nearest "
         "node is (0.005, 0.005, 0.01) m, 0.01 m away",
         ["Output/Probe names=tip, far", "Output/Probe places=0.005,0.005,0.005; 0.005,0.005,0.02"], check_too=True),
    Case("point source outside",
         "scene.prm: Heat sources/needle/Places: (-0.001, 0, 0) m lies outside the mesh box; its nearest node is "
         "(0, 0, 0) m, 0.001 m away",
         ["Heat sources/needle/Places=-0.001, 0, 0"], check_too=True),
    Case("Gaussian source outside",
         "scene.prm: Heat sources/needle: of 1 W only 0 W falls on the body; its Centre lies outside, or it is far "
         "narrower than the cells",
         ["Heat sources/needle/Centre=0.1, 0, 0"],
         text=SCENE.replace("set Places = 0.005, 0.005, 0.005", "set Type = Gaussian", 1), check_too=True),
    Case("source narrower than the cells",
         "scene.prm: Heat sources/needle: of 1 W <any> W would fall on the body: it is narrower than the cells; refine "
         "the mesh, or take a wider source or one of type points",
         ["Heat sources/needle/Centre=0.0010566, 0.0010566, 0.0010566", "Heat sources/needle/Radius=5e-4"],
         text=SCENE.replace("set Places = 0.005, 0.005, 0.005", "set Type = Gaussian", 1)),
    Case("load outside",
         "scene.prm: Loads/pull/Place: (1, 0, 0) m lies outside the mesh box; its nearest node is (0.01, 0, 0) m, "
         "0.99 m away",
         [*DEFORMATION, "Loads/Names=pull", "Loads/pull/Place=1, 0, 0"], check_too=True),
    Case("source in a region that does not exist",
         "scene.prm: Heat sources/needle/Regions: there is no region `liver` in the mesh box; give a name or "
         "number of: 1 `box`; or all",
         ["Heat sources/needle/Regions=liver"],
         text=SCENE.replace("set Places = 0.005, 0.005, 0.005", "set Type = uniform", 1), check_too=True),
]
