# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes with cells of extreme size and shape, in gmsh's format 2.2."""
import itertools
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "errors"))
import meshes  # noqa: E402


def grid(axes, simplices, region_of=lambda centre: 1):
    """Nodes and cells of the grid of three lists of coordinates; each cell one hexahedron, or six tetrahedra."""
    counts = [len(axis) for axis in axes]
    number = lambda i, j, k: i + counts[0] * (j + counts[1] * k)
    nodes = [(x, y, z) for z in axes[2] for y in axes[1] for x in axes[0]]
    cells = []
    for k, j, i in itertools.product(*(range(count - 1) for count in reversed(counts))):
        region = region_of([0.5 * (axis[n] + axis[n + 1]) for axis, n in zip(axes, (i, j, k))])
        if not simplices:
            square = [(0, 0), (1, 0), (1, 1), (0, 1)]
            cells.append((meshes.HEXAHEDRON, region, [number(i + a, j + b, k + c) for c in (0, 1) for a, b in square]))
            continue
        for order in itertools.permutations(range(3)):
            corner, path = [i, j, k], [number(i, j, k)]
            for direction in order:
                corner[direction] += 1
                path.append(number(*corner))
            cells.append((meshes.TETRAHEDRON, region, path))
    return nodes, cells


def text(nodes, cells):
    return meshes.text(nodes, [(kind, region, [1 + node for node in corners]) for kind, region, corners in cells])


def slivers(flatness, side=0.01, n=4):
    """A cube of tetrahedra in which every other inner node is moved towards the opposite face of one of its tetrahedra,
    so that this is left with `flatness` of its height. Returns the text and the moved nodes."""
    nodes, cells = grid([[side * i / n for i in range(n + 1)]] * 3, True)
    moved = []
    for k, j, i in itertools.product(range(1, n, 2), repeat=3):
        node = i + (n + 1) * (j + (n + 1) * k)
        opposite = [other for other in next(c for _, _, c in cells if node in c) if other != node]
        centre = [sum(nodes[other][d] for other in opposite) / 3 for d in range(3)]
        nodes[node] = tuple(c + flatness * (p - c) for c, p in zip(centre, nodes[node]))
        moved.append(nodes[node])
    return text(nodes, cells), moved


def graded(simplices, smallest=1e-6, n=5, across=0.01):
    """Cells from `smallest` at the plane x = 0 to 10^(n-1) times as long away from it, in regions 1 and 2."""
    lengths = [smallest * 10**i for i in range(n)]
    right = list(itertools.accumulate(lengths))
    nodes, cells = grid([[-x for x in reversed(right)] + [0] + right, [0, across / 2, across], [0, across / 2, across]],
                        simplices, lambda centre: 1 if centre[0] < 0 else 2)
    return text(nodes, cells)
