# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mutates meshes: knows the lines and numbers of gmsh's formats and of the others that are read."""

NUMBERS = ["0", "-1", "1", "2", "3", "4", "7", "99", "999", "nan", "NaN", "inf", "-inf", "1e300", "-1e300", "1e-300", "1e999", "0.5", "x",
           "", "4294967295", "4294967296", "18446744073709551615", "-2147483648", "2147483647", "1000000000", "1e9", "--1", "1 1"]
# Types of gmsh's elements: lines, triangles, ..., of second order, points, polygons, unknown ones
ELEMENT_TYPES = [str(kind) for kind in (*range(1, 32), 34, 92, 93, 140, 200, 0, -1)]
HEADS = ["$MeshFormat\n2.2 0 8\n$EndMeshFormat", "$MeshFormat\n4.1 0 8\n$EndMeshFormat", "$MeshFormat\n4 0 8\n$EndMeshFormat",
         "$MeshFormat\n2.2 1 8\n$EndMeshFormat", "$MeshFormat\n4.1 1 8\n$EndMeshFormat", "$MeshFormat\n1 0 8\n$EndMeshFormat",
         "$MeshFormat\n9.9 0 8\n$EndMeshFormat", "$MeshFormat\n$EndMeshFormat", "$NOD", "$MeshFormat"]
JUNK = ["$Nodes", "$EndNodes", "$Elements", "$EndElements", "$PhysicalNames\n1\n3 1 \"x\"\n$EndPhysicalNames",
        "$PhysicalNames\n1\n3 1 \"\xff\"\n$EndPhysicalNames", "$PhysicalNames\n99\n$EndPhysicalNames", "$Periodic\n1\n0 1 1\n$EndPeriodic",
        "$Entities\n0 0 0 0\n$EndEntities", "$Entities\n1 1 1 1\n$EndEntities", "$NodeData\n1\n\"x\"\n$EndNodeData", "$Comments",
        "$PartitionedEntities\n1\n0\n$EndPartitionedEntities", "$ElementData\n$EndElementData", "", "$", "Merge \"/etc/passwd\";",
        "a" * 100000, "\x00"]


class Mesh:
    """A mesh file's lines."""

    def __init__(self, data):
        self.lines = data.decode("latin-1").split("\n")

    def line(self, random, long_enough=1):
        """A line with that many words, or None; the first lines more often, as counts stand there."""
        numbers = [n for n, line in enumerate(self.lines) if len(line.split()) >= long_enough]
        if not numbers:
            return None
        return random.choice(numbers[:12]) if random.random() < 0.2 else random.choice(numbers)

    def change_word(self, random, make, long_enough=1):
        number = self.line(random, long_enough)
        if number is not None:
            words = self.lines[number].split(" ")
            place = random.randrange(len(words))
            words[place] = make(words[place])
            self.lines[number] = " ".join(words)

    def change_number(self, random):
        self.change_word(random, lambda _: random.choice(NUMBERS))

    def shift_number(self, random):
        def shifted(word):
            try:
                return str(int(word) + random.choice([-1, 1, 100]))
            except ValueError:
                return word
        self.change_word(random, shifted)

    def move_node(self, random):
        def moved(word):
            try:
                return repr(float(word) * random.choice([-1, 0, 10, 1e-12, 1e12]))
            except ValueError:
                return word
        self.change_word(random, moved, 4)

    def other_type(self, random):
        number = self.line(random, 6)
        if number is not None:
            words = self.lines[number].split(" ")
            words[1 if len(words) > 1 else 0] = random.choice(ELEMENT_TYPES)
            self.lines[number] = " ".join(words)

    def shuffle_corners(self, random):
        """Inverts a cell, or twists it."""
        number = self.line(random, 6)
        if number is not None:
            words = self.lines[number].split()
            tail = words[5:]
            random.shuffle(tail)
            self.lines[number] = " ".join(words[:5] + tail)

    def same_corner(self, random):
        number = self.line(random, 6)
        if number is not None:
            words = self.lines[number].split()
            words[-1] = words[-2]
            self.lines[number] = " ".join(words)

    def drop_line(self, random):
        number = self.line(random)
        if number is not None:
            del self.lines[number]

    def double_line(self, random):
        number = self.line(random)
        if number is not None:
            self.lines.insert(number, self.lines[number])

    def copy_line(self, random):
        number, other = self.line(random), self.line(random)
        if number is not None:
            self.lines[other] = self.lines[number]

    def drop_block(self, random):
        number = self.line(random)
        if number is not None:
            del self.lines[number:number + random.choice([2, 5, 50])]

    def cut_file(self, random):
        data = "\n".join(self.lines)
        self.lines = data[:random.randrange(len(data) + 1)].split("\n")

    def other_head(self, random):
        self.lines[:3] = random.choice(HEADS).split("\n")

    def insert_junk(self, random):
        self.lines.insert(random.randrange(len(self.lines) + 1), random.choice(JUNK))

    def random_bytes(self, random):
        data = bytearray("\n".join(self.lines).encode("latin-1"))
        for _ in range(random.choice([1, 5, 50])):
            if data:
                place = random.randrange(len(data))
                data[place:place + random.choice([0, 1, 1, 8])] = bytes(random.randrange(256) for _ in range(random.choice([0, 1, 1, 4])))
        self.lines = data.decode("latin-1").split("\n")


MUTATIONS = [(Mesh.change_number, 25), (Mesh.shift_number, 15), (Mesh.move_node, 15), (Mesh.other_type, 8), (Mesh.shuffle_corners, 6),
             (Mesh.same_corner, 3), (Mesh.drop_line, 8), (Mesh.double_line, 4), (Mesh.copy_line, 4), (Mesh.drop_block, 3),
             (Mesh.cut_file, 3), (Mesh.other_head, 3), (Mesh.insert_junk, 4), (Mesh.random_bytes, 6)]


def mutated(random, data):
    mesh = Mesh(data)
    kinds, weights = zip(*MUTATIONS)
    for mutate in random.choices(kinds, weights, k=random.choice([1, 1, 1, 2, 3, 5])):
        mutate(mesh, random)
    return "\n".join(mesh.lines).encode("latin-1")
