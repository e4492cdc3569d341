# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes, and regions and surfaces that do not fit to them."""
import meshes
from case import NEEDLE, TISSUE, Case, mesh

TWO = meshes.two_regions()

MESH = [
    mesh("no mesh file named",
         "scene.prm: Mesh/File name = : name the mesh file, or set Shape = box", None,
         ["Mesh/File name="]),
    mesh("missing mesh",
         "scene.prm: Mesh file `body.msh` is missing, empty or not readable; give Mesh/File name relative to the "
         "scene's folder",
         None),
    mesh("empty mesh",
         "scene.prm: Mesh file `body.msh` is missing, empty or not readable; give Mesh/File name relative to the "
         "scene's folder", ""),
    mesh("truncated mesh",
         "scene.prm: Mesh file `body.msh` cannot be read (Error: Error loading 'body.msh'): it may be cut off or "
         "of another format; open it in gmsh and export it again as .msh", TWO[:len(TWO) // 2]),
    mesh("mesh of another format",
         "scene.prm: Mesh file `body.msh` does not begin as a gmsh mesh does, with $MeshFormat; export it again",
         "solid body\nendsolid body\n"),
    mesh("unknown ending",
         "scene.prm: Mesh file `body.stp`: the ending must be .msh, .vtk, .unv, .bdf or .mesh; convert other "
         "formats with gmsh or meshio", TWO, ["Mesh/File name=body.stp"]),
    mesh("cells of two kinds",
         "scene.prm: Mesh file `body.msh` has 1 hexahedra, 1 tetrahedra; all cells must be tetrahedra or hexahedra",
         meshes.mixed()),
    mesh("wedges",
         "scene.prm: Mesh file `body.msh` has 1 prisms; all cells must be tetrahedra or hexahedra", meshes.wedge()),
    mesh("triangles in a scene of three dimensions",
         "scene.prm: Mesh file `body.msh` has no cells of dimension 3, only 1 triangles; export its tetrahedra or "
         "hexahedra",
         meshes.triangles()),
    mesh("tetrahedra in a scene of two",
         "scene.prm: Mesh file `body.msh` has volume cells (2 tetrahedra), but the scene is two-dimensional; set "
         "Dimension = 3", TWO,
         ["Dimension=2"]),
    mesh("a flat cell",
         "scene.prm: Mesh file `body.msh`: cell 1 at (0.5, 0.5, 0) m has no volume; remesh there or remove the cell",
         meshes.flat()),
    mesh("a cell that is drawn out",
         "scene.prm: Mesh file `body.msh`: cell 1 at (0.25, 2500000, 0.25) m has no volume; remesh there or remove the cell",
         meshes.drawn_out()),
    mesh("a twisted hexahedron",
         "scene.prm: Mesh file `body.msh`: cell 1 at (0.5, 0.5, 0.5) m is inverted or flat at some of its corners; "
         "remesh there",
         meshes.twisted()),
    mesh("a cell that refers to a missing node",
         "scene.prm: Mesh file `body.msh` cannot be read (Error: Wrong node index 9): it may be cut off or of "
         "another format; open it in gmsh and export it again as .msh", meshes.missing_node()),
    mesh("a mesh that breaks gmsh: a corner of number -1 in version 4",
         "scene.prm: Mesh file `body.msh` cannot be read (it breaks gmsh: a count, number or type in it is impossible): it may be "
         "cut off or of another format; open it in gmsh and export it again as .msh", meshes.version_4(corner=-1)),
    mesh("a region without tissue",
         "scene.prm: Tissues: nothing is said of region 7 `tumour` of the mesh; name it, or use `remaining`", TWO,
         [f"{TISSUE}/Regions=liver"]),
    mesh("a region with two tissues",
         "scene.prm: Tissues: region 7 `tumour` belongs to both a and b; name it once (`remaining` means what no "
         "other names)", TWO,
         ["Tissues/Names=a, b", "Tissues/b/Regions=tumour"]),
    mesh("a region that does not exist",
         "scene.prm: Tissues/tissue/Regions: there is no region `kidney` in the mesh `body.msh`; give a name or "
         "number of: 3 `liver`, 7 `tumour`; or all", TWO, [f"{TISSUE}/Regions=liver, kidney"]),
    mesh("a surface that does not exist",
         "scene.prm: Boundaries/outside/Surfaces: there is no surface `top` in the mesh `body.msh`; give a name or "
         "number of: 0, 5 `skin`; or all", TWO,
         ["Boundaries/outside/Surfaces=top"]),
    mesh("a surface without boundary",
         "scene.prm: Boundaries: nothing is said of surface 0 of the mesh; name it, or use `remaining`", TWO,
         ["Boundaries/outside/Surfaces=skin"]),
    mesh("a tissue without region",
         "scene.prm: Tissues/b/Regions = : no region of the mesh is left for it; name one, or take b out of "
         "Tissues/Names", TWO,
         ["Tissues/Names=a, b", "Tissues/b/Regions="]),
    mesh("a tissue for which nothing remains",
         "scene.prm: Tissues/b/Regions = remaining: no region of the mesh is left for it; name one, or take b out "
         "of Tissues/Names", TWO,
         ["Tissues/Names=a, b", "Tissues/b/Regions=remaining"]),
    mesh("two tissues for what remains",
         "scene.prm: Tissues: region 3 `liver` belongs to both a and b; name it once (`remaining` means what no "
         "other names)", TWO,
         ["Tissues/Names=a, b", "Tissues/a/Regions=remaining", "Tissues/b/Regions=remaining"]),
    mesh("a mesh in millimetres read as metres",
         "scene.prm: Output/Probe places, `tip`: (0.1, 0.1, 0.1) m lies outside the mesh `body.msh`; its nearest "
         "node is (0.001, 0, 0) m, 0.1726296614142541 m away", TWO,
         ["Mesh/Length unit=mm", f"{NEEDLE}/Places=1e-4, 1e-4, 1e-4", "Output/Probe places=0.1, 0.1, 0.1"]),
    Case("a surface with two boundaries",
         "scene.prm: Boundaries: surface 6 `z max` belongs to both outside and top; name it once (`remaining` "
         "means what no other names)",
         ["Boundaries/Names=outside, top", "Boundaries/top/Surfaces=z max", "Boundaries/top/Thermal=insulated"],
         check_too=True),
    Case("a box without height",
         "scene.prm: Mesh/Upper corner: the box reaches from 0.02 to 0.01 m in direction z; the second must be "
         "larger", ["Mesh/Lower corner=0, 0, 0.02"], check_too=True),
    Case("two subdivisions for three directions",
         "scene.prm: Mesh/Subdivisions: a box needs 1 or 3 numbers, not 2",
         ["Mesh/Subdivisions=2, 2"], check_too=True),
    Case("too many cells",
         "scene.prm: Mesh/Subdivisions: the box would have 1e+12 vertices; fewer than 100 million are possible",
         ["Mesh/Subdivisions=9999"], check_too=True),
    Case("rods instead of cells",
         "scene.prm: Mesh/Subdivisions: cells of 5e-10 by 5e-10 by 0.005 m are drawn out too far to have a volume; "
         "subdivide the long sides more", ["Mesh/Upper corner=1e-9, 1e-9, 0.01"], check_too=True),
]
