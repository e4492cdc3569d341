# SPDX-License-Identifier: LGPL-2.1-or-later
"""The benchmark's cube: n^3 cells, each cut into six tetrahedra around its main diagonal, the cut that Cautery
makes. As a program it writes the cube of 10 mm in medit's format, which FreeFEM reads. Usage: kuhn_mesh.py N FILE"""
import itertools
import sys


def cube(n):
    """Nodes as triples of 0 to n, tetrahedra as lists of four numbers of nodes."""
    def node(i, j, k):
        return i + (n + 1) * (j + (n + 1) * k)

    nodes = [(i, j, k) for k in range(n + 1) for j in range(n + 1) for i in range(n + 1)]
    tetrahedra = []
    for corner in itertools.product(range(n), repeat=3):
        for order in itertools.permutations(range(3)):
            path = [list(corner)]
            for axis in order:
                path.append(path[-1].copy())
                path[-1][axis] += 1
            corners = [node(*p) for p in path]
            even = order in ((0, 1, 2), (1, 2, 0), (2, 0, 1))
            tetrahedra.append(corners if even else [corners[0], corners[2], corners[1], corners[3]])
    return nodes, tetrahedra


def outer_faces(n, nodes, tetrahedra):
    """Triangles with the number of their surface, 1 to 6: x min, x max, y min, ..."""
    for corners in tetrahedra:
        for left_out in range(4):
            face = [corner for m, corner in enumerate(corners) if m != left_out]
            for axis in range(3):
                heights = {nodes[p][axis] for p in face}
                if heights in ({0}, {n}):
                    yield face, 2 * axis + (1 if heights == {0} else 2)


def write_medit(n, file_name, length=0.01):
    nodes, tetrahedra = cube(n)
    cells = {"Tetrahedra": [(corners, 1) for corners in tetrahedra], "Triangles": list(outer_faces(n, nodes, tetrahedra))}
    with open(file_name, "w") as file:
        print("MeshVersionFormatted 2\nDimension 3\nVertices\n", len(nodes), sep="", file=file)
        for place in nodes:
            print(*(f"{length * c / n:.17g}" for c in place), 0, file=file)
        for title, labelled in cells.items():
            print(title, len(labelled), sep="\n", file=file)
            for corners, label in labelled:
                print(*(corner + 1 for corner in corners), label, file=file)
        print("End", file=file)


if __name__ == "__main__":
    write_medit(int(sys.argv[1]), sys.argv[2])
