# SPDX-License-Identifier: LGPL-2.1-or-later
"""Independent codes on the same mesh, compared with Cautery node by node. Usage: judge.py CASE CAUTERY, in a folder of
its own. Exit status 77 where the other code is not installed."""
import csv
import os
import pathlib
import shutil
import subprocess
import sys

import calculix

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "doc" / "peers"))
import kuhn_mesh  # noqa: E402

SAME = 1e-6
LENGTH, CELLS = 0.01, 8
CENTRE = "0.005, 0.005, 0.005"
NEEDLE = f"""
subsection Heat sources
  set Names = needle
  subsection needle
    set Places = {CENTRE}
    set Power  = 0.08
  end
end
subsection Boundaries
  subsection outside
    set Thermal     = temperature
    set Temperature = 310
    set Mechanical  = fixed
  end
end
"""
ALL_DIGITS = """
subsection Numerics
  subsection Heat solver
    set Tolerance = 1e-13
  end
  subsection Deformation solver
    set Tolerance = 1e-13
  end
end
"""


class Cube:
    """The cube of 10 mm (or another length), its nodes in the order of the files for the other codes."""

    def __init__(self, length=LENGTH, cells=CELLS):
        self.length, self.cells = length, cells
        self.nodes, self.tetrahedra = kuhn_mesh.cube(cells)
        self.places = [tuple(length * c / cells for c in node) for node in self.nodes]
        self.surface = [i for i, node in enumerate(self.nodes) if 0 in node or cells in node]
        self.centre = self.nodes.index((cells // 2,) * 3)
        kuhn_mesh.write_medit(cells, "cube.mesh", length)

    def hexahedra(self):
        """Corners in CalculiX's order."""
        number = {node: i for i, node in enumerate(self.nodes)}
        square = ((0, 0), (1, 0), (1, 1), (0, 1))
        return [[number[i + di, j + dj, k + dk] for dk in (0, 1) for di, dj in square]
                for k in range(self.cells) for j in range(self.cells) for i in range(self.cells)]

    def cautery(self, program, text, columns, reactions="off"):
        """Values of these columns at every node at the end of a run of the scene on the box of the same mesh."""
        pathlib.Path("scene.prm").write_text(text, encoding="utf-8")
        entries = {"Mesh/Upper corner": ", ".join([str(self.length)] * 3), "Mesh/Subdivisions": self.cells,
                   "Output/Fields": "off", "Output/Reactions": reactions,
                   "Output/Probe names": ", ".join(f"n{i}" for i in range(len(self.places))),
                   "Output/Probe places": "; ".join(", ".join(f"{c:.17g}" for c in place) for place in self.places)}
        words = [word for path, value in entries.items() for word in ("--set", f"{path}={value}")]
        subprocess.run([program, "scene.prm", *words, "--output", "out"], check=True, stdout=subprocess.DEVNULL)
        with open("out/probes.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))[-len(self.places):]
        return [[float(row[column]) for column in columns] for row in rows]


def freefem(script, *arguments):
    """The lines of numbers that a script writes."""
    subprocess.run(["FreeFem++", "-nw", "-v", "0", HERE / script, "cube.mesh", *map(str, arguments), "freefem.txt"],
                   check=True, env={**os.environ, "FF_LOADPATH": "/usr/lib/freefem++/;;"})
    return [[float(word) for word in line.split()] for line in pathlib.Path("freefem.txt").read_text().splitlines()]


def compare(what, ours, theirs):
    largest = max(abs(value) for row in theirs for value in row)
    apart = max(abs(a - b) for mine, other in zip(ours, theirs) for a, b in zip(mine, other)) / largest
    assert len(ours) == len(theirs)
    print(f"{what}: {len(ours)} values, largest value {largest:.6g}, largest difference {apart:.2g} of it")
    assert apart < SAME


def rises(rows):
    return [[value - 310 for value in row] for row in rows]


def heat_scene(cells, effects="", steps=20):
    return f"""subsection Mesh
  set Cells = {cells}
end
subsection Effects
{effects}
end
subsection Time
  set End  = {steps}
  set Step = 1
end
""" + NEEDLE + ALL_DIGITS


def calculix_heats_one_point(program):
    """On hexahedra: CalculiX integrates the capacity of its tetrahedra in one point."""
    cube = Cube()
    lines = calculix.mesh(cube.places, "C3D8", cube.hexahedra()) + calculix.node_set("SURFACE", cube.surface)
    lines += calculix.material(DENSITY="1000.", CONDUCTIVITY="0.613", SPECIFIC_HEAT="4192.")
    lines += ["*INITIAL CONDITIONS, TYPE=TEMPERATURE", "ALL, 0.", "*STEP, INC=1000", "*HEAT TRANSFER, DIRECT", "1., 20.",
              "*BOUNDARY", "SURFACE, 11, 11, 0.", "*CFLUX", f"{cube.centre + 1}, 11, 0.08",
              "*NODE PRINT, NSET=ALL, FREQUENCY=20", "NT", "*END STEP"]
    compare("rise", rises(cube.cautery(program, heat_scene("hexahedra"), ["temperature_K"])),
            calculix.run("heat", lines, 1))


def freefem_heats_one_point(program):
    cube = Cube()
    compare("rise", rises(cube.cautery(program, heat_scene("tetrahedra"), ["temperature_K"])),
            freefem("heat.edp", 20, 0, 0))


def freefem_repeats_the_single_source(program):
    """The thesis's own comparison (6.5.4), with its scene as it is: heat first, then the displacement from our heat."""
    cube = Cube(cells=10)
    scene = HERE.parents[1] / "prm" / "thesis" / "ch6_single_source.prm"
    rows = cube.cautery(program, scene.read_text(encoding="utf-8") + ALL_DIGITS,
                        ["temperature_K", "displacement_x_m", "displacement_y_m", "displacement_z_m"])
    heat = rises([row[:1] for row in rows])
    compare("rise", heat, freefem("heat.edp", 120, 0, 0))
    pathlib.Path("rises.txt").write_text("\n".join(f"{rise:.15g}" for (rise,) in heat) + "\n", encoding="utf-8")
    compare("displacement", [row[1:] for row in rows], freefem("expansion.edp", "rises.txt"))


def freefem_heats_with_blood(program):
    cube = Cube()
    effects = "  set Perfusion  = on\n  set Metabolism = constant"
    compare("rise", rises(cube.cautery(program, heat_scene("tetrahedra", effects), ["temperature_K"])),
            freefem("heat.edp", 20, 1800, 33800))


def expanded(program):
    """Our rises and displacements with all terms of the balance of heat on."""
    cube = Cube()
    effects = """  set Heat        = non-Fourier
  set Perfusion   = on
  set Metabolism  = constant
  set Deformation = equilibrium
  set Coupling    = expansion"""
    rows = cube.cautery(program, heat_scene("tetrahedra", effects),
                        ["temperature_K", "displacement_x_m", "displacement_y_m", "displacement_z_m"])
    return cube, [row[0] - 310 for row in rows], [row[1:] for row in rows]


def freefem_expands_by_the_same_heat(program):
    _, heat, displacements = expanded(program)
    pathlib.Path("rises.txt").write_text("\n".join(f"{rise:.15g}" for rise in heat) + "\n")
    compare("displacement", displacements, freefem("expansion.edp", "rises.txt"))


def calculix_expands_by_the_same_heat(program):
    cube, heat, displacements = expanded(program)
    lines = calculix.mesh(cube.places, "C3D4", cube.tetrahedra) + calculix.node_set("SURFACE", cube.surface)
    lines += calculix.material(ELASTIC="10.2e6, 0.35", EXPANSION="3e-4,")
    lines += ["*INITIAL CONDITIONS, TYPE=TEMPERATURE", "ALL, 0.", "*STEP", "*STATIC", "*BOUNDARY", "SURFACE, 1, 3, 0.",
              "*TEMPERATURE", *(f"{i}, {rise:.15g}" for i, rise in enumerate(heat, 1)), "*NODE PRINT, NSET=ALL", "U",
              "*END STEP"]
    compare("displacement", displacements, calculix.run("expansion", lines, 3))


COLLAGEN = """
    set Fibre families  = collagen
    subsection collagen
      set Fibre direction        = 1; 1; 0
      set Fibres in tension only = off
    end"""


def stretched(program, stiffness, fibres=""):
    """A block of 0.1 m, drawn by 20 %."""
    cube = Cube(0.1)
    scene = f"""subsection Effects
  set Heat        = off
  set Deformation = large equilibrium
end
subsection Tissues
  subsection tissue
    set Young's modulus = 2716.2
    set Poisson's ratio = 0.35
    set Elastic law     = neo-Hookean{fibres}
  end
end
subsection Boundaries
  set Names = held, drawn, rest
  subsection held
    set Surfaces   = x min
    set Mechanical = fixed
  end
  subsection drawn
    set Surfaces     = x max
    set Mechanical   = displacement
    set Displacement = 0.02; 0; 0
  end
  subsection rest
    set Surfaces   = remaining
    set Mechanical = free
  end
end
subsection Numerics
  subsection Newton
    set Tolerance = 1e-12
  end
end
subsection Time
  set End  = 1
  set Step = 1
end
"""
    ours = cube.cautery(program, scene, ["displacement_x_m", "displacement_y_m", "displacement_z_m"], "on")
    (force, *theirs) = freefem("stretch.edp", stiffness)
    compare("displacement", ours, theirs)
    with open("out/reactions.csv", newline="", encoding="utf-8") as file:
        drawn = [row for row in csv.DictReader(file) if row["support"] == "drawn"][-1]
    compare("reaction force", [[float(drawn["force_x_N"])]], [force])


def freefem_stretches_tissue(program):
    stretched(program, 0)


def freefem_stretches_fibres(program):
    stretched(program, 2363.2, COLLAGEN)


if __name__ == "__main__":
    case, cautery = sys.argv[1:]
    judge = {"calculix": "ccx", "freefem": "FreeFem++"}[case.split("_", maxsplit=1)[0]]
    if shutil.which(judge) is None:
        print(f"SKIPPED: {judge} is not installed")
        sys.exit(77)
    globals()[case](cautery)
