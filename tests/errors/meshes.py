# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small gmsh meshes (format 2.2), good and bad."""

TRIANGLE, TETRAHEDRON, HEXAHEDRON, PRISM = 2, 4, 5, 6


def text(nodes, elements, names=()):
    """Of nodes: places, the first is 1; elements: type, physical group, nodes; names: dimension, group, name."""
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat"]
    if names:
        lines += ["$PhysicalNames", str(len(names)), *(f'{d} {group} "{name}"' for d, group, name in names),
                  "$EndPhysicalNames"]
    lines += ["$Nodes", str(len(nodes)), *(f"{n} {x} {y} {z}" for n, (x, y, z) in enumerate(nodes, 1)), "$EndNodes"]
    lines += ["$Elements", str(len(elements)),
              *(" ".join(map(str, (e, kind, 2, group, 10 * kind + group, *corners)))
                for e, (kind, group, corners) in enumerate(elements, 1)), "$EndElements"]
    return "\n".join(lines) + "\n"


CORNERS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
CUBE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]


def two_regions(negative=False):
    """Two tetrahedra, liver and tumour, on both sides of z = 0; one face is the surface `skin`."""
    nodes = [*CORNERS, (0, 0, -1)]
    upper, lower = ((1, 3, 2, 4), (1, 2, 3, 5)) if negative else ((1, 2, 3, 4), (1, 3, 2, 5))
    return text(nodes, [(TRIANGLE, 5, (1, 2, 4)), (TETRAHEDRON, 3, upper), (TETRAHEDRON, 7, lower)],
                [(2, 5, "skin"), (3, 3, "liver"), (3, 7, "tumour")])


def cube(negative=False):
    """One hexahedron."""
    return text(CUBE, [(HEXAHEDRON, 1, (5, 6, 7, 8, 1, 2, 3, 4) if negative else range(1, 9))])


def mixed():
    return text([*CUBE, (3, 0, 0), (4, 0, 0), (3, 1, 0), (3, 0, 1)],
                [(HEXAHEDRON, 1, range(1, 9)), (TETRAHEDRON, 1, (9, 10, 11, 12))])


def wedge():
    return text([*CORNERS, (1, 0, 1), (0, 1, 1)], [(PRISM, 1, (1, 2, 3, 4, 5, 6))])


def triangles():
    return text(CORNERS, [(TRIANGLE, 1, (1, 2, 3))])


def flat():
    return text([*CORNERS[:3], (1, 1, 0)], [(TETRAHEDRON, 1, (1, 2, 3, 4))])


def drawn_out():
    """Ten million times longer than wide."""
    return text([*CORNERS[:2], (0, 1e7, 0), (0, 0, 1)], [(TETRAHEDRON, 1, (1, 2, 3, 4))])


def twisted():
    return text(CUBE, [(HEXAHEDRON, 1, (1, 2, 3, 4, 6, 5, 7, 8))])


def missing_node():
    return text(CORNERS, [(TETRAHEDRON, 1, (1, 2, 3, 4)), (TETRAHEDRON, 1, (1, 2, 3, 9))])


def version_4(corner=1):
    """The two tetrahedra of two_regions, without the second region, in format 4.1."""
    return f"""$MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
2 5 "skin"
3 3 "liver"
$EndPhysicalNames
$Entities
0 0 1 1
1 0 0 0 1 1 1 1 5 0
1 0 0 -1 1 1 1 1 3 1 1
$EndEntities
$Nodes
1 5 1 5
3 1 0 5
1
2
3
4
5
0 0 0
1 0 0
0 1 0
0 0 1
0 0 -1
$EndNodes
$Elements
2 3 1 3
2 1 2 1
1 1 2 4
3 1 4 2
2 1 2 3 4
3 {corner} 3 2 5
$EndElements
"""
