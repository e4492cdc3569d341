# SPDX-License-Identifier: LGPL-2.1-or-later
"""Input of CalculiX, and the nodal values that it prints (seven digits)."""
import re
import subprocess


def numbered(lists):
    return [f"{i}, " + ", ".join(map(str, entries)) for i, entries in enumerate(lists, 1)]


def mesh(places, kind, cells):
    """Places in m, cells as lists of nodes from 0 on; `kind` is CalculiX's name of the element."""
    return ["*NODE, NSET=ALL", *numbered([f"{c:.15g}" for c in place] for place in places),
            f"*ELEMENT, TYPE={kind}, ELSET=BODY", *numbered([n + 1 for n in cell] for cell in cells)]


def node_set(name, nodes):
    return [f"*NSET, NSET={name}", *(f"{node + 1}," for node in nodes)]


def material(**cards):
    return ["*MATERIAL, NAME=TISSUE", *(line for card, value in cards.items()
                                       for line in ("*" + card.replace("_", " "), value)),
            "*SOLID SECTION, ELSET=BODY, MATERIAL=TISSUE"]


def run(name, lines, components):
    """The last printed values: a list of `components` numbers for each node."""
    with open(name + ".inp", "w", encoding="utf-8") as file:
        print(*lines, sep="\n", file=file)
    answer = subprocess.run(["ccx", name], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    assert "Job finished" in answer.stdout, answer.stdout[-2000:]
    values = {}
    with open(name + ".dat", encoding="utf-8") as file:
        for line in file:
            words = line.split()
            if len(words) == components + 1 and re.fullmatch(r"\d+", words[0]):
                values[int(words[0]) - 1] = [float(word) for word in words[1:]]
    return [values[node] for node in range(len(values))]
