# SPDX-License-Identifier: LGPL-2.1-or-later
"""Large deformation and explicit steps: what does not go together, and runs that fail."""
from case import DEFORMATION, TISSUE, Case, value

DYNAMICS = ["Effects/Deformation=explicit dynamics"]
PLANE = ["Dimension=2", "Heat sources/needle/Places=0.005, 0.005", "Output/Probe places=0.005, 0.005"]
RELAXATION = ["Effects/Deformation=large equilibrium", "Numerics/Large equilibrium=dynamic relaxation"]
FIBRES = [f"{TISSUE}/Fibre families=collagen"]
FAMILY = f"{TISSUE}/collagen"


def for_three_dimensions(overrides, name):
    return Case(name + " in the plane",
                f"scene.prm: {name} is for three dimensions only; set Dimension = 3", [*overrides, *PLANE])


LARGE = [
    value(f"{TISSUE}/Elastic law", "Ogden", "choose one of: linear, neo-Hookean"),
    value("Numerics/Explicit/Precision", "half", "choose one of: double, single"),
    value("Numerics/Explicit/Points of hexahedra", "4", "it must be 8 or 1"),
    value("Numerics/Explicit/Safety factor", "0", "it must be > 0 and <= 1"),
    value("Numerics/Explicit/Motion step", "-1", "it must be >= 0"),
    value("Numerics/Newton/Smallest load step", "2", "it must be >= 1e-12 and <= 1"),
    value("Numerics/Large equilibrium", "Broyden", "choose one of: Newton, dynamic relaxation"),
    value("Effects/Conduction in", "space", "choose one of: reference body, deformed body"),
    value("Output/Stress", "Biot", "choose one of: Cauchy, second Piola-Kirchhoff"),
    for_three_dimensions(DYNAMICS, "Effects/Deformation = explicit dynamics"),
    for_three_dimensions(["Time/Integrator=explicit"], "Time/Integrator = explicit"),
    for_three_dimensions(RELAXATION, "Numerics/Large equilibrium = dynamic relaxation"),
    Case("explicit dynamics of degree 2",
         "scene.prm: Effects/Deformation = explicit dynamics is for Numerics/Element degree = 1 only",
         [*DYNAMICS, "Numerics/Element degree=2"]),
    Case("explicit dynamics that feel heat two-way",
         "scene.prm: Effects/Deformation = explicit dynamics does not know Effects/Coupling = two-way; choose "
         "expansion", [*DYNAMICS, "Effects/Coupling=two-way"]),
    Case("large equilibrium that feels heat two-way",
         "scene.prm: Effects/Coupling = two-way is for small deformation; choose Coupling = expansion or Deformation "
         "= equilibrium", ["Effects/Deformation=large equilibrium", "Effects/Coupling=two-way"]),
    Case("explicit heat with an equilibrium",
         "scene.prm: Time/Integrator = explicit goes with Effects/Deformation = explicit dynamics or off; choose one "
         "of these, or backward Euler", [*DEFORMATION, "Time/Integrator=explicit"]),
    Case("conduction in a body that does not move",
         "scene.prm: Effects/Conduction in = deformed body needs Deformation = explicit dynamics and Time/Integrator "
         "= explicit; choose these, or reference body", ["Effects/Conduction in=deformed body"]),
    Case("fibres in linear tissue",
         f"scene.prm: {TISSUE}/Elastic law = linear has no fibres; take out Fibre families, or choose neo-Hookean",
         [*DYNAMICS, *FIBRES, f"{TISSUE}/Elastic law=linear"], check_too=True),
    Case("fibres without a direction",
         "scene.prm: Fibre direction = 0; 0; 0: it has no length at <any>",
         [*DYNAMICS, *FIBRES, f"{FAMILY}/Fibre direction=0; 0; 0"]),
    Case("fibres that turn",
         f"scene.prm: {FAMILY}/Fibre direction = t; 0; 1: it must not depend on t",
        [*DYNAMICS, *FIBRES, f"{FAMILY}/Fibre direction=t; 0; 1"]),
    Case("properties of temperature in explicit loops",
         f"scene.prm: {TISSUE} has a property that depends on temperature, which explicit loops do not know; give a "
         "number, or choose Effects/Deformation = large equilibrium and Time/Integrator = backward Euler",
         [*DYNAMICS, "Effects/Temperature-dependent properties=on", f"{TISSUE}/Young's modulus=310: 1e6, 320: 2e6"]),
    Case("averaged pressure of hexahedra",
         "scene.prm: Numerics/Explicit/Averaged pressure = on is for tetrahedra of neo-Hookean tissue, which tissue is "
         "not; turn it off", [*DYNAMICS, "Numerics/Explicit/Averaged pressure=on"]),
    Case("a motion step that is not stable",
         "scene.prm: Numerics/Explicit/Motion step = 1 s is longer than the <any> s that are known to be stable at t "
         "= 0 s; take at most that, or 0 for the program's choice, or set Unstable steps = on",
         [*DYNAMICS, "Numerics/Explicit/Motion step=1"]),
    Case("a heat step that is not stable",
         "scene.prm: Numerics/Explicit/Heat step = 1000 s is longer than the <any> s that are known to be stable at t "
         "= 0 s; take at most that, or 0 for the program's choice, or set Unstable steps = on",
         ["Time/Integrator=explicit", "Numerics/Explicit/Heat step=1000"]),
    Case("a tool beside the body",
         "scene.prm: Tools/forceps: no node of the body lies within 0.001 m of its Centre; move it, or take a larger "
         "Radius", [*DYNAMICS, "Tools/Names=forceps", "Tools/forceps/Centre=1, 1, 1"]),
    Case("a body that a tool turns inside out",
         "at t = <any> s cell <any> m is turned inside out (J = <any>); load the body more slowly or less, refine the "
         "mesh there, or lower Numerics/Explicit/Safety factor",
         [*DYNAMICS, f"{TISSUE}/Young's modulus=3000", "Tools/Names=forceps",
          "Tools/forceps/Centre=0.005, 0.005, 0.005", "Tools/forceps/Displacement=if(t > 1, 0.02*(t - 1), 0); 0; 0"],
         status=1, last_good=1),
    Case("a motion step that becomes unstable as fibres stiffen",
         "Numerics/Explicit/Motion step = 0.001 s is longer than the <any> s that are known to be stable at t = <any> s; "
         "take at most that, or 0 for the program's choice, or set Unstable steps = on",
         [*DYNAMICS, *FIBRES, f"{TISSUE}/Young's modulus=3000", f"{FAMILY}/Fibre direction=1; 0; 0",
          f"{FAMILY}/Fibres in tension only=off", "Boundaries/Names=outside, far, rest",
          "Boundaries/outside/Surfaces=x min", "Boundaries/far/Surfaces=x max", "Boundaries/far/Thermal=insulated",
          "Boundaries/far/Mechanical=displacement", "Boundaries/far/Displacement=0.003*t; 0; 0",
          "Boundaries/rest/Surfaces=remaining", "Boundaries/rest/Thermal=insulated", "Boundaries/rest/Mechanical=free",
          "Numerics/Explicit/Damping=20", "Numerics/Explicit/Motion step=0.001", "Time/Step=0.1"],
         status=1, last_good=0.6),
    Case("linear tissue in steps that are not stable",
         "the motion grows without bounds at t = <any> s at the node <any> m; take Numerics/Explicit/Motion step = 0, a "
         "lower Safety factor, or damping",
         [*DYNAMICS, "Effects/Coupling=expansion", f"{TISSUE}/Young's modulus=3000", f"{TISSUE}/Elastic law=linear",
          "Numerics/Explicit/Motion step=0.01", "Numerics/Explicit/Unstable steps=on", "Time/Step=10", "Time/End=20"],
         status=1, last_good=0),
    Case("heat in steps that are not stable",
         "the temperature grows without bounds at t = <any> s at the node <any> m; take Numerics/Explicit/Heat step = 0, "
         "or a lower Safety factor",
         ["Time/Integrator=explicit", "Numerics/Explicit/Heat step=160", "Numerics/Explicit/Unstable steps=on",
          "Time/Step=160", "Time/End=32000"],
         status=1, last_good=1600),
    Case("a load that no equilibrium bears",
         "no equilibrium found at t = 2 s: <any>; load the body less or in more output times, refine the mesh there, "
         "or choose Numerics/Large equilibrium = Newton",
         [*RELAXATION, "Tools/Names=forceps", "Tools/forceps/Centre=0.005, 0.005, 0.005",
          "Tools/forceps/Displacement=if(t > 1, 0.012, 0); 0; 0", "Numerics/Displacement at=every step",
          "Numerics/Relaxation/Largest number of steps=3000"],
         status=1, last_good=1),
]
