# SPDX-License-Identifier: LGPL-2.1-or-later
"""Case 3: Poisson's ratio near 0.5. How stiff meshes are against converged quadratic elements, and what the solver needs."""

RATIOS = (0.3, 0.45, 0.49, 0.499, 0.4999)
TETRAHEDRA = "Mesh/Cells=tetrahedra"
QUADRATIC = "Numerics/Element degree=2"
CURED = "Numerics/Mean dilatation=on"
BLOCK = ["Dimension=3", "Mesh/Subdivisions=12, 4, 4", "Output/Probe places=0.04, 0.01, 0.005"]
MESHES = {"quadrilaterals, degree 1": [], "the same with mean dilatation": [CURED],
          "quadrilaterals, degree 2": [QUADRATIC], "triangles, degree 1": [TETRAHEDRA],
          "triangles, degree 2": [TETRAHEDRA, QUADRATIC]}
BLOCKS = {"hexahedra, degree 1": BLOCK, "hexahedra with mean dilatation": [*BLOCK, CURED],
          "tetrahedra, degree 1": [*BLOCK, TETRAHEDRA], "hexahedra, degree 2": [*BLOCK, QUADRATIC]}
GOOD = {"the same with mean dilatation": 0.015, "quadrilaterals, degree 2": 0.04, "triangles, degree 2": 0.04}


def check(lab):
    runs = {}
    for ratio in RATIOS:
        poisson = f"Tissues/tissue/Poisson's ratio={ratio}"
        runs[ratio, "reference"] = ("beam", poisson, QUADRATIC, "Mesh/Subdivisions=64, 16, 1",
                                    "Numerics/Deformation solver/Method=direct")
        for name, choice in MESHES.items():
            runs[ratio, name] = ("beam", poisson, *choice)
        if ratio in (0.3, 0.4999):
            for name, choice in BLOCKS.items():
                runs[ratio, name] = ("beam", poisson, *choice)
    found = lab.run_all(runs)
    tip = lambda ratio, name: found[ratio, name].end("tip", "displacement_y_m")
    for name in MESHES:
        errors = [tip(ratio, name) / tip(ratio, "reference") - 1 for ratio in RATIOS]
        what = f"{name}, nu = {', '.join(map(str, RATIOS))}: displacement too small by, %"
        shown = ", ".join(f"{-100 * error:.2g}" for error in errors)
        bound = GOOD.get(name)
        if bound:
            lab.keep(what, f"within {100 * bound:.2g}", shown, all(abs(error) < bound for error in errors))
        else:
            lab.keep(what, "locks: more than 30 at 0.4999", shown, errors[-1] < -0.3)
    for name in BLOCKS:
        few, many = (found[ratio, name].iterations("deformation") for ratio in (0.3, 0.4999))
        limit = 5000 if QUADRATIC in BLOCKS[name] else 2000
        lab.keep(f"block of 12 x 4 x 4 {name}: iterations of the solver at nu = 0.3 and 0.4999", f"at most {limit}",
                 f"{few:.0f}, {many:.0f}", 0 < few <= many <= limit)
