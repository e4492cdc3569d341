# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the meshes beside it (gmsh format 2.2, hexahedra). Usage: make_meshes.py FOLDER"""
import math
import pathlib
import sys

QUADRILATERAL, HEXAHEDRON = 3, 5


def box(counts, sides, region_of, surface_of, names, place=lambda p: p):
    """A box of cells; region_of(k): group of layer k; surface_of(direction, end): group of a side, 0 for none."""
    number = lambda i, j, k: 1 + i + (counts[0] + 1) * (j + (counts[1] + 1) * k)
    nodes = [place([sides[d] * (i, j, k)[d] / counts[d] for d in range(3)])
             for k in range(counts[2] + 1) for j in range(counts[1] + 1) for i in range(counts[0] + 1)]
    square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    elements = [(HEXAHEDRON, region_of(k), [number(i + a, j + b, k + c) for c in (0, 1) for a, b in square])
                for k in range(counts[2]) for j in range(counts[1]) for i in range(counts[0])]
    for d in range(3):
        e, f = (x for x in range(3) if x != d)
        for end in (0, 1):
            for i in range(counts[e] if surface_of(d, end) else 0):
                for j in range(counts[f]):
                    corners = []
                    for a, b in square:
                        index = {d: end * counts[d], e: i + a, f: j + b}
                        corners.append(number(index[0], index[1], index[2]))
                    elements.append((QUADRILATERAL, surface_of(d, end), corners))
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(names)),
             *(f'{d} {group} "{name}"' for d, group, name in names), "$EndPhysicalNames",
             "$Nodes", str(len(nodes)), *(f"{n} {x:.15g} {y:.15g} {z:.15g}" for n, (x, y, z) in enumerate(nodes, 1)),
             "$EndNodes", "$Elements", str(len(elements)),
             *(" ".join(map(str, (e, kind, 2, group, 10 * kind + group, *corners)))
               for e, (kind, group, corners) in enumerate(elements, 1)), "$EndElements"]
    return "\n".join(lines) + "\n"


def turned(place):
    """By 30 degrees about z, then by 20 degrees about x."""
    x, y, z = place
    c, s = math.cos(math.pi / 6), math.sin(math.pi / 6)
    x, y = c * x - s * y, s * x + c * y
    c, s = math.cos(math.pi / 9), math.sin(math.pi / 9)
    return x, c * y - s * z, s * y + c * z


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1])
    (folder / "layers.msh").write_text(
        box((4, 4, 6), (8, 8, 12), lambda k: 1 if k < 4 else 2, lambda d, end: 10 + end if d == 2 else 0,
            [(3, 1, "muscle"), (3, 2, "fat"), (2, 10, "deep"), (2, 11, "skin")]))
    (folder / "inclined.msh").write_text(
        box((3, 2, 2), (0.6, 0.4, 0.4), lambda k: 1, lambda d, end: d + 1 if end == 0 else 0,
            [(3, 1, "block"), (2, 1, "side"), (2, 2, "back"), (2, 3, "slope")], turned))
    (folder / "strips.msh").write_text(
        box((1, 1, 10), (2, 2, 10), lambda k: 1 + k // 2, lambda d, end: 0,
            [(3, 1, "thesis"), (3, 2, "retina"), (3, 3, "skin"), (3, 4, "liver"), (3, 5, "own")]))
