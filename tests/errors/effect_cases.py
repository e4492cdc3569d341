# SPDX-License-Identifier: LGPL-2.1-or-later
"""Effects, boundaries and times that contradict each other."""
from case import ALTERNATE, DEFORMATION, NEEDLE, TISSUE, Case, rollers, value

EFFECTS = [
    Case("nothing on",
         "scene.prm: Effects: neither Heat nor Deformation is on: there is nothing to simulate; turn one on",
         ["Effects/Heat=off"]),
    Case("gravity out of the plane",
         "scene.prm: Loads/Gravity has a component along z, out of the plane; in two dimensions it must be 0",
         [*DEFORMATION, "Dimension=2", "Heat sources/needle/Places=0.005, 0.005", "Output/Probe places=0.005, 0.005",
          "Effects/Gravity=on"], check_too=True),
    Case("traction out of the plane",
         "scene.prm: Boundaries/outside/Traction has a component along z, out of the plane; in two dimensions it must "
         "be 0",
         [*DEFORMATION, "Dimension=2", "Heat sources/needle/Places=0.005, 0.005", "Output/Probe places=0.005, 0.005",
          "Boundaries/outside/Traction=0; 0; t"]),
    Case("displacement at output times for a damage that needs it always",
         "scene.prm: Numerics/Displacement at = output times, but the damage law needs strain energy at every step; "
         "choose automatic",
         [*DEFORMATION, "Effects/Coupling=expansion", "Effects/Damage=thermal strain energy",
          "Numerics/Displacement at=output times"]),
    Case("non-Fourier Q10 metabolism with IDA",
         "scene.prm: Time/Integrator = IDA does not know the rate of a metabolism that grows with temperature in the "
         "non-Fourier model; choose backward Euler, or Metabolism = constant",
         ["Time/Integrator=IDA", "Effects/Heat=non-Fourier", "Effects/Metabolism=Q10"]),
    value("Boundaries/outside/Transfer coefficient", "5 + t", "it cannot depend on t"),
    Case("coupling without deformation",
         "scene.prm: Effects: Coupling needs both Heat and Deformation; turn it off or turn them on",
         ["Effects/Coupling=expansion"], check_too=True),
    Case("damage without heat",
         "scene.prm: Effects: Damage needs Heat; turn Damage off or Heat on",
         [*DEFORMATION, "Effects/Heat=off", "Effects/Damage=Arrhenius"]),
    Case("perfusion without heat",
         "scene.prm: Effects: Perfusion needs Heat; turn Perfusion off or Heat on",
         [*DEFORMATION, "Effects/Heat=off", "Effects/Perfusion=on"]),
    Case("metabolism without heat",
         "scene.prm: Effects: Metabolism needs Heat; turn Metabolism off or Heat on",
         [*DEFORMATION, "Effects/Heat=off", "Effects/Metabolism=Q10"]),
    Case("strain energy without deformation",
         "scene.prm: Effects: this Damage law needs strain energy; turn Deformation on or choose Arrhenius",
         ["Effects/Damage=thermal strain energy"]),
    Case("thermo-mechanical strain energy without deformation",
         "scene.prm: Effects: this Damage law needs strain energy; turn Deformation on or choose Arrhenius",
         ["Effects/Damage=thermo-mechanical strain energy"]),
    Case("perfusion that stops without damage",
         "scene.prm: Effects: `Perfusion stops in dead tissue` needs Perfusion and Damage; turn it off or turn "
         "them on",
         ["Effects/Perfusion=on", "Effects/Perfusion stops in dead tissue=on"]),
    Case("gravity without deformation",
         "scene.prm: Effects: Gravity needs Deformation; turn Gravity off or Deformation on",
         ["Effects/Gravity=on"]),
    Case("a table without its effect",
         "scene.prm: Tissues/tissue has a property that depends on temperature; set Effects/Temperature-dependent "
         "properties = on, or give a number",
         [f"{TISSUE}/Conductivity=300: 0.5, 310: 0.6"]),
    Case("no thermal condition",
         "scene.prm: Boundaries/outside has no thermal condition; set Thermal (e.g. insulated)",
         ["Boundaries/outside/Thermal=none"]),
    Case("no mechanical condition",
         "scene.prm: Boundaries/outside has no mechanical condition; set Mechanical (e.g. free)",
         [*DEFORMATION, "Boundaries/outside/Mechanical=none"]),
    Case("nothing holds the body",
         "scene.prm: Boundaries: nothing holds the body, so it has no equilibrium; set Mechanical = fixed, roller "
         "or displacement somewhere, or Effects/Deformation = inertia",
         [*DEFORMATION, "Boundaries/outside/Mechanical=free"]),
    Case("rollers on one side",
         "scene.prm: Boundaries: the rollers leave the body 3 shifts or turns as a whole, so it has no "
         "equilibrium; hold them with Mechanical = fixed, displacement or more rollers, or set Effects/Deformation "
         "= inertia", [*DEFORMATION, *rollers("x min")], check_too=True),
    Case("rollers on two sides",
         "scene.prm: Boundaries: the rollers leave the body 1 shifts or turns as a whole, so it has no "
         "equilibrium; hold them with Mechanical = fixed, displacement or more rollers, or set Effects/Deformation "
         "= inertia", [*DEFORMATION, *rollers("x min, z max")]),
    Case("lumped capacity of degree 2",
         "scene.prm: Numerics/Capacity matrix = lumped is for Element degree = 1 only; choose consistent",
         ["Numerics/Capacity matrix=lumped", "Numerics/Element degree=2"]),
    Case("a limiter of temperatures with IDA",
         "scene.prm: Numerics/Temperature limiter = on is for heat by backward Euler, elements of degree 1, without "
         "two-way coupling; turn it off",
         ["Numerics/Temperature limiter=on", "Time/Integrator=IDA"]),
    Case("mean dilatation of degree 2",
         "scene.prm: Numerics/Mean dilatation = on is for small deformation by finite elements of degree 1; turn it "
         "off, or set Element degree = 2",
         [*DEFORMATION, "Numerics/Mean dilatation=on", "Numerics/Element degree=2"]),
    Case("mean dilatation of tetrahedra",
         "scene.prm: Numerics/Mean dilatation = on is for hexahedra and quadrilaterals: a linear tetrahedron has one "
         "dilatation only; take hexahedra, or Element degree = 2",
         [*DEFORMATION, "Numerics/Mean dilatation=on", "Mesh/Cells=tetrahedra"], check_too=True),
    Case("IDA with two-way coupling",
         "scene.prm: Time/Integrator = IDA does not know two-way coupling; choose backward Euler or Coupling = "
         "expansion",
         [*DEFORMATION, "Effects/Coupling=two-way", "Time/Integrator=IDA"]),
    Case("IDA with inertia",
         "scene.prm: Time/Integrator = IDA does not know inertia; choose backward Euler or Deformation = "
         "equilibrium",
         ["Effects/Deformation=inertia", "Time/Integrator=IDA"]),
    Case("IDA without heat",
         "scene.prm: Time/Integrator = IDA integrates heat; turn Effects/Heat on",
         [*DEFORMATION, "Effects/Heat=off", "Time/Integrator=IDA"]),
    Case("two-way coupling with the exact stretch",
         "scene.prm: Effects/Coupling = two-way needs elastic properties that do not depend on temperature and "
         "`Thermal stretch = linearised`; choose Coupling = expansion or such properties",
         [*DEFORMATION, "Effects/Coupling=two-way", f"{TISSUE}/Thermal stretch=exact"]),
]

TIME = [
    value("Time/End", "0", "it must be > 0"),
    value("Time/Step", "0", "it must be > 0"),
    value("Time/Step", "-1", "it must be > 0"),
    value("Time/Integrator", "Runge-Kutta", "choose one of: backward Euler, IDA, explicit"),
    value("Time/Relative tolerance", "0", "it must be > 0 and < 1"),
    value("Output/Interval", "-1", "it must be >= 0"),
    Case("more outputs than steps",
         "scene.prm: Output/Interval = 1e-07 s makes 2e+07 outputs, more than Time/Largest number of steps = "
         "1000000; take a larger interval", ["Output/Interval=1e-7"]),
    value(f"{NEEDLE}/Switch on at", "-1", "it must be >= 0"),
    value(f"{NEEDLE}/Switch on at", "later", "this is not a number"),
    Case("more steps than allowed",
         "scene.prm: Time/Step = 1e-07 s makes 2e+07 steps to Time/End, more than Largest number of steps = "
         "1000000; take a larger step or allow more", ["Time/Step=1e-7"]),
    Case("output after the end",
         "scene.prm: Output/Times: 3 s is after Time/End = 2 s; take it out or run longer", ["Output/Times=1, 3"]),
    value("Output/Times", "0", "it must be > 0"),
    value(f"{NEEDLE}/Switch off at", "0", ALTERNATE),
    Case("more switching off than on",
         "scene.prm: Heat sources/needle/Switch off at = 2 times: there must be as many as in `Switch on at`, or "
         "one fewer",
         [f"{NEEDLE}/Switch off at=1, 2"]),
    Case("on again before off",
         "scene.prm: Heat sources/needle/Switch off at = 3: the times must alternate: on, off, on, off, ...",
         [f"{NEEDLE}/Switch on at=0, 2", f"{NEEDLE}/Switch off at=3, 4"]),
]
