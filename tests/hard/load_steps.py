# SPDX-License-Identifier: LGPL-2.1-or-later
"""Case 8: loads that Newton's method cannot take at once, and loads that nothing can bear."""
import re

import closed_forms

PULLED = ["Boundaries/moved/Mechanical=traction", "Mesh/Subdivisions=3", "Numerics/Newton/Tolerance=1e-10"]
FIBRES = ["Tissues/tissue/Fibre families=collagen", "Tissues/tissue/collagen/Fibre stiffness=1000",
          "Tissues/tissue/collagen/Fibre stiffening=1", "Tissues/tissue/collagen/Fibre direction=1; 0; 0"]
ONCE = ["Time/Step=1", "Output/Interval=1"]


def stepping(lab):
    """The whole load at once, in one output time."""
    cases = {"pulled to I4 = 4, fibres with exp(9)": (2.0, FIBRES, (1000.0, 1.0)), "pressed to 20 %": (0.2, [], (0.0, 1.0)),
             "pulled to five times its length": (5.0, [], (0.0, 1.0))}
    runs = {}
    for name, (along, choice, fibres) in cases.items():
        across = closed_forms.free_sides(along)
        load = closed_forms.nominal(along, along * across**2, fibres)
        runs[name] = ("block", *PULLED, *ONCE, *choice, f"Boundaries/moved/Traction={load:.15g} * t; 0; 0",
                      "Numerics/Newton/Smallest load step=1e-8")
    found = lab.run_all(runs)
    for name, (along, _, _) in cases.items():
        run, statistics = found[name], found[name].summary["statistics"]
        lab.below(f"{name} at once, in {statistics['load_steps']:.0f} load steps and {statistics['newton_iterations']:.0f} "
                  "iterations of Newton's method: stretch against the closed form, relative",
                  abs((1 + run.end("end", "displacement_x_m") / 0.01) / along - 1), 1e-8)
        lab.above(f"the same: load steps", statistics["load_steps"], 1)


def no_equilibrium(lab):
    """A tool pushed through a body that is held; a body drawn on all sides beyond what its volume bears."""
    cases = {"a tool pushed through a block that is held": (
        "Tools/Names=forceps", "Tools/forceps/Centre=0.005, 0.005, 0.005", "Tools/forceps/Displacement=0.02 * t; 0; 0",
        *(f"Boundaries/{side}/Mechanical=fixed" for side in ("moved", "held", "rest"))),
             "tissue of nu = 0.49 drawn on all sides": (
                 *PULLED, "Tissues/tissue/Poisson's ratio=0.49", "Boundaries/moved/Traction=4000 * t; 0; 0",
                 "Boundaries/rest/Mechanical=traction",
                 "Boundaries/rest/Traction=0; if(y > 0.00999, 4000 * t, 0); if(z > 0.00999, 4000 * t, 0)")}
    for name, changes in cases.items():
        run = lab.run("block", *changes, status=1)
        lab.says(name, run.complaint, "no equilibrium found at t = ", " % of the load's change", "the body may give way under this load")
        *_, before, borne = sorted({row["time_s"] for row in run.rows})
        failed, share = (float(number) for number in re.search("at t = (.*) s beyond (.*) % of", run.complaint).groups())
        lab.below("the same: time of the last output, against that of the last load borne, relative",
                  abs(borne / (before + 0.01 * share * (failed - before)) - 1), 1e-12)
        again = lab.run("block", *changes, f"Time/End={borne:.17g}")
        lab.below("the same: last output against a run that ends there, relative",
                  abs(run.end("middle", "displacement_x_m") / again.end("middle", "displacement_x_m") - 1), 1e-8)


def jump(lab):
    """A traction that jumps to more than the body bears: what it bore is a share of the jump."""
    low, high, area = 1.0, 4000.0, 1e-4  # Pa, Pa, m2
    drawn = [*PULLED, "Tissues/tissue/Poisson's ratio=0.49", "Boundaries/rest/Mechanical=traction", "Output/Reactions=on"]
    load = f"if(t > 0.35, {high}, {low})"
    run = lab.run("block", *drawn, f"Boundaries/moved/Traction={load}; 0; 0",
                  f"Boundaries/rest/Traction=0; if(y > 0.00999, {load}, 0); if(z > 0.00999, {load}, 0)", status=1)
    share = 0.01 * float(re.search("beyond (.*) % of", run.complaint).group(1))
    force = run.reactions[run.last_time(), "held"][0]
    lab.below("a traction that jumps: force at the support against the load that was borne, relative",
              abs(force / (-area * (low + share * (high - low))) - 1), 1e-6)
    lab.says("the same", run.complaint, "the last load that was borne is written as t = 0.35")


def at_once(lab):
    """No equilibrium in the first step, with heat and damage; and none at the start."""
    grip = ["Tools/Names=forceps", "Tools/forceps/Centre=0.005, 0.005, 0.005", "Tools/forceps/Displacement=if(t < 0.01, 0, 0.01); 0; 0",
            *(f"Boundaries/{side}/Mechanical=fixed" for side in ("moved", "held", "rest"))]
    warm = [*(f"Boundaries/{side}/Thermal=insulated" for side in ("moved", "held", "rest")),
            "Effects/Heat=Fourier", "Effects/Coupling=expansion", "Effects/Damage=Arrhenius", "Numerics/Displacement at=every step"]
    run = lab.run("block", *grip, *warm, status=1)
    lab.says("a tool that jumps through warm tissue in the first step", run.complaint, "no equilibrium found at t = 0.05 s beyond ")
    run = lab.run("block", *grip, "Tools/forceps/Displacement=0.01; 0; 0", status=1)
    share = 0.01 * float(re.search("at t = 0 s beyond (.*) % of", run.complaint).group(1))
    lab.below("a tool that is there at the start: its way in the output, against the share that was borne, relative",
              abs(run.end("middle", "displacement_x_m") / (0.01 * share) - 1), 1e-9)


def check(lab):
    stepping(lab)
    no_equilibrium(lab)
    jump(lab)
    at_once(lab)
