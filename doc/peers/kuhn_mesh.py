# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the benchmark's cube of 10 mm in medit's format, which FreeFEM reads: n^3 cells, each cut into six
tetrahedra around its main diagonal, the cut that Cautery makes. Usage: kuhn_mesh.py N FILE"""
import itertools
import sys

n, file_name = int(sys.argv[1]), sys.argv[2]
length = 0.01


def node(i, j, k):
    return 1 + i + (n + 1) * (j + (n + 1) * k)


nodes = [(i, j, k) for k in range(n + 1) for j in range(n + 1) for i in range(n + 1)]
tetrahedra, triangles = [], []
for corner in itertools.product(range(n), repeat=3):
    for order in itertools.permutations(range(3)):
        path = [list(corner)]
        for axis in order:
            path.append(path[-1].copy())
            path[-1][axis] += 1
        corners = [node(*p) for p in path]
        even = order in ((0, 1, 2), (1, 2, 0), (2, 0, 1))
        tetrahedra.append(corners if even else [corners[0], corners[2], corners[1], corners[3]])
        for left_out in range(4):
            face = [p for m, p in enumerate(path) if m != left_out]
            if any(len({p[axis] for p in face}) == 1 and face[0][axis] in (0, n) for axis in range(3)):
                triangles.append([node(*p) for p in face])

with open(file_name, "w") as file:
    print("MeshVersionFormatted 2\nDimension 3\nVertices\n", len(nodes), sep="", file=file)
    for place in nodes:
        print(*(f"{length * c / n:.17g}" for c in place), 0, file=file)
    print("Tetrahedra", len(tetrahedra), sep="\n", file=file)
    for corners in tetrahedra:
        print(*corners, 1, file=file)
    print("Triangles", len(triangles), sep="\n", file=file)
    for corners in triangles:
        print(*corners, 1, file=file)
    print("End", file=file)
