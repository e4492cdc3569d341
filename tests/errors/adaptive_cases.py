# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes whose mesh cannot be adapted."""
import meshes
from case import DEFORMATION, Case, mesh, value

ON = "Mesh/Adaptive/Follow=temperature"
FOLLOW = "scene.prm: Mesh/Adaptive/Follow"

ADAPTIVE = [
    value("Mesh/Adaptive/Target error", "1", "it must be > 0 and < 1"),
    value("Mesh/Adaptive/Largest number of divisions", "7", "it must be >= 1 and <= 6"),
    Case("tetrahedra",
         f"{FOLLOW} needs cells that can be divided beside others that are not, as tetrahedra cannot here; set "
         "Mesh/Cells = hexahedra, or choose nothing",
         [ON, "Mesh/Cells=tetrahedra"], check_too=True),
    mesh("tetrahedra from a file",
         f"{FOLLOW} needs hexahedra (in two dimensions quadrilaterals), but the mesh `body.msh` has simplices; choose "
         "nothing", meshes.two_regions(), [ON]),
    Case("finite differences",
         f"{FOLLOW}: finite differences know one grid only; choose nothing, or Method = finite elements",
         [ON, "Numerics/Method=finite differences"]),
    Case("explicit steps",
         f"{FOLLOW}: explicit steps and dynamic relaxation do not know nodes that follow others; choose nothing",
         [ON, "Time/Integrator=explicit"]),
    Case("kept nodes",
         f"{FOLLOW}: Numerics/Kept nodes needs a mesh that stays; choose nothing, or leave it empty",
         [ON, "Numerics/Kept nodes=inside"]),
    Case("displacement without deformation",
         f"{FOLLOW} = displacement, but deformation is off; choose temperature, or turn Effects/Deformation on",
         ["Mesh/Adaptive/Follow=displacement"]),
    Case("temperature without heat",
         f"{FOLLOW} = temperature, but heat is off; choose displacement, or turn Effects/Heat on",
         [ON, *DEFORMATION, "Effects/Heat=off", "Effects/Heat sources=off"]),
    Case("too many divisions",
         "scene.prm: Mesh/Refinements = 8 and Adaptive/Largest number of divisions = 3 are more than 10 together; take "
         "fewer",
         [ON, "Mesh/Refinements=8"]),
]
