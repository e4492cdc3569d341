# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is mutated: the project's scenes, made so small that a run takes a fraction of a second, and meshes."""
import pathlib
import sys

PROJECT = pathlib.Path(__file__).resolve().parents[2]
sys.path += [str(PROJECT / "tests" / "scenes"), str(PROJECT / "tests" / "errors")]
import meshes  # noqa: E402
import prm  # noqa: E402

FOLDERS = ["prm", "tests/scenes", "tests/study", "tests/verification/scenes", "tests/errors", "tests/hard"]
CELLS = 3       # at most, along each axis of a box
STEPS = 4       # at most
EXPLICIT = 1e-3 # s; of a step where sound limits those within it
MOST = 300      # steps, whatever the mutation

FORMATS = {
    "body.vtk": """# vtk DataFile Version 3.0
tetrahedra
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 5 double
0 0 0
1 0 0
0 1 0
0 0 1
0 0 -1
CELLS 2 10
4 0 1 2 3
4 0 2 1 4
CELL_TYPES 2
10
10
""",
    "body.mesh": """MeshVersionFormatted 2
Dimension 3
Vertices
5
0 0 0 1
1 0 0 1
0 1 0 1
0 0 1 1
0 0 -1 1
Tetrahedra
2
1 2 3 4 1
1 3 2 5 2
End
""",
    "body.bdf": """GRID,1,0,0.0,0.0,0.0
GRID,2,0,1.0,0.0,0.0
GRID,3,0,0.0,1.0,0.0
GRID,4,0,0.0,0.0,1.0
GRID,5,0,0.0,0.0,-1.0
CTETRA,1,1,1,2,3,4
CTETRA,2,2,1,3,2,5
ENDDATA
"""}

MESH_SCENE = """subsection Mesh
  set Shape = file
  set File name = {name}
end
subsection Effects
  set Deformation = equilibrium
  set Coupling = expansion
end
subsection Boundaries
  subsection outside
    set Thermal = insulated
    set Mechanical = fixed
  end
end
subsection Time
  set End = 2
  set Step = 1
end
subsection Output
  set Fields = {fields}
end
"""


def scenes():
    """Of each: the path in the project and the text, without what only tests fill in."""
    return [(str(path.relative_to(PROJECT)), path.read_text())
            for folder in FOLDERS for path in sorted((PROJECT / folder).rglob("*.prm"))]


def small(path, text, mutated):
    """The entries, by path, that make a scene small, also as it has been mutated (bytes), and keep its mesh where it is."""
    values = prm.values(text)
    changes = {"Mesh/Refinements": "0", "Time/Largest number of steps": str(MOST), "Accuracy/Temperature within": "0",
               "Numerics/Relaxation/Largest number of steps": "2000", "Output/Fields": "off", "Output/Times": ""}
    if "Mesh/File name" in values:
        changes["Mesh/File name"] = str((PROJECT / path).parent / values["Mesh/File name"])
    if "Mesh/Subdivisions" in values:
        numbers = [min(CELLS, int(number)) for number in values["Mesh/Subdivisions"].split(",")]
        changes["Mesh/Subdivisions"] = ", ".join(map(str, numbers))
    step, end = (float(values.get("Time/" + name, default)) for name, default in (("Step", "1"), ("End", "120")))
    if values.get("Effects/Deformation") == "explicit dynamics" or b"explicit dynamics" in mutated:
        step = min(step, EXPLICIT)
        changes["Time/Step"] = repr(step)
    changes["Time/End"] = repr(min(end, STEPS * step))
    changes["Output/Interval"] = repr(2 * step)
    return changes


def mesh_files():
    """Of each: the name and the bytes. Small ones stand here several times, as they are read at once."""
    names = ("two_regions", "cube", "mixed", "wedge", "triangles", "flat", "twisted", "missing_node", "version_4")
    files = [("body.msh", getattr(meshes, name)().encode()) for name in names if hasattr(meshes, name)]
    files += [(name, text.encode()) for name, text in FORMATS.items()] * 2
    files += [(path.name, path.read_bytes()) for path in sorted((PROJECT / "tests" / "scenes").glob("*.msh"))] * 4
    return files + [(path.name, path.read_bytes()) for path in sorted((PROJECT / "meshes").glob("*.msh"))]
