# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes that are interrupted: a small one, and what is changed in it, so that together they turn on all that a run
remembers from step to step."""

SCENE = """
subsection Mesh
  set Cells        = hexahedra
  set Subdivisions = 6
end
subsection Heat sources
  set Names = needle, field
  subsection needle
    set Places        = 0.005, 0.005, 0.005
    set Power         = 0.3
    set Switch on at  = 0, 14
    set Switch off at = 6.3, 27
  end
  subsection field
    set Type   = Gaussian
    set Centre = 0.003, 0.004, 0.005
    set Radius = 0.002
    set Power  = 0.1 * (1 + 0.5 * sin(t))
  end
end
subsection Boundaries
  set Names = base, top, sides
  subsection base
    set Surfaces    = z min
    set Thermal     = temperature
    set Temperature = 310
    set Mechanical  = fixed
  end
  subsection top
    set Surfaces             = z max
    set Thermal              = convection
    set Transfer coefficient = 20
    set Ambient temperature  = 295
    set Mechanical           = traction
    set Traction             = 0; 0; 100
  end
  subsection sides
    set Surfaces   = remaining
    set Thermal    = insulated
    set Mechanical = free
  end
end
subsection Time
  set End  = 40
  set Step = 0.2
end
subsection Output
  set Interval     = 1
  set Every step   = on
  set Probe names  = tip, aside
  set Probe places = 0.005, 0.005, 0.005; 0.002, 0.006, 0.0041
end
"""

DAMAGE = ["Effects/Damage=Arrhenius", "Effects/Perfusion=on", "Effects/Perfusion stops in dead tissue=on"]
NON_FOURIER = ["Effects/Heat=non-Fourier", "Tissues/tissue/Relaxation time=3"]
STRAIN = ["Effects/Deformation=equilibrium", "Effects/Coupling=expansion"]
SOFT = ["Tissues/tissue/Young's modulus=3000", "Tissues/tissue/Poisson's ratio=0.45"]
IDA = ["Time/Integrator=IDA", "Time/Relative tolerance=1e-6", "Output/Checkpoints/Steps=17"]
EXPLICIT = ["Time/Integrator=explicit", "Effects/Deformation=explicit dynamics", "Effects/Coupling=expansion", *SOFT,
            "Time/End=1", "Time/Step=0.005", "Output/Interval=0.05", "Heat sources/needle/Switch on at=0, 0.3",
            "Heat sources/needle/Switch off at=0.2, 0.5", "Numerics/Explicit/Damping=50", "Output/Reactions=on"]
# nodes die on the way from here to there, so that much depends on when the run is stopped
DYING = [*NON_FOURIER, *DAMAGE, "Heat sources/needle/Power=0.8", "Tissues/tissue/Perfusion rate=30", "Mesh/Subdivisions=8",
         "Time/End=12"]

ADAPTIVE = ["Mesh/Subdivisions=3", "Mesh/Adaptive/Follow=temperature", "Mesh/Adaptive/Target error=0.2",
            "Mesh/Adaptive/Interval=3", "Mesh/Adaptive/Largest number of divisions=2", "Time/Step=0.4"]

CASES = {
    "heat": [],
    "heat_that_lags_damages_and_stops_perfusion": [*NON_FOURIER, *DAMAGE],
    "dying": DYING,
    "dying_in_explicit_steps": [*DYING, "Time/Integrator=explicit"],
    "neglected_jumps": [*NON_FOURIER, "Effects/Heat source jumps=neglected"],
    "metabolism_that_grows": ["Effects/Metabolism=Q10", *DAMAGE],
    "properties_of_temperature": ["Effects/Temperature-dependent properties=on",
                                  "Tissues/tissue/Conductivity=300: 0.5, 350: 0.7",
                                  "Tissues/tissue/Young's modulus=300: 1e5, 400: 5e4", *STRAIN, *DAMAGE],
    "strain_energy": [*STRAIN, *DAMAGE[1:], "Effects/Damage=thermo-mechanical strain energy",
                      "Output/Reactions=on"],
    "two_way": [*NON_FOURIER, *STRAIN, "Effects/Coupling=two-way", *DAMAGE],
    "inertia": ["Effects/Deformation=inertia", "Effects/Coupling=expansion", "Time/End=0.02", "Time/Step=1e-4",
                "Output/Interval=5e-4", "Heat sources/needle/Switch on at=0", "Heat sources/needle/Switch off at=0.01"],
    "newton": ["Effects/Deformation=large equilibrium", "Effects/Coupling=expansion", *SOFT, "Output/Reactions=on",
               "Boundaries/top/Traction=0; 0; 20*t", "Time/End=30", "Time/Step=0.5"],
    "newton_and_damage": ["Effects/Deformation=large equilibrium", "Effects/Coupling=expansion", *SOFT, *DAMAGE,
                          "Numerics/Displacement at=every step", "Time/End=10", "Time/Step=0.5", "Mesh/Subdivisions=4"],
    "peak_of_lagging_heat": [*NON_FOURIER, "Effects/Temperature-dependent properties=on", "Mesh/Subdivisions=4",
                             "Tissues/tissue/Specific heat=310: 4200, 311: 4200, 314: 40000, 318: 4200",
                             "Tissues/tissue/Conductivity=310: 0.5, 330: 0.7"],
    "dynamic_relaxation": ["Effects/Deformation=large equilibrium", "Effects/Coupling=expansion", *SOFT,
                           "Numerics/Large equilibrium=dynamic relaxation", "Boundaries/top/Traction=0; 0; 20*t",
                           "Time/End=20", "Time/Step=0.5", "Mesh/Subdivisions=4"],
    "motion_alone": ["Effects/Heat=off", "Effects/Heat sources=off", "Effects/Deformation=large equilibrium", *SOFT,
                     "Boundaries/top/Traction=0; 0; 20*t", "Output/Reactions=on", "Time/End=30"],
    "condensed": [*STRAIN, "Numerics/Kept nodes=probes", "Mesh/Subdivisions=5"],
    "quadratic_tetrahedra": [*STRAIN, "Numerics/Element degree=2", "Mesh/Cells=tetrahedra", "Mesh/Subdivisions=3"],
    "multigrid": [*STRAIN, "Numerics/Deformation solver/Method=CG + AMG", "Numerics/Heat solver/Method=CG + AMG"],
    "factorisation": [*STRAIN, "Numerics/Deformation solver/Method=direct", "Numerics/Heat solver/Method=direct"],
    "error_control": [*IDA, *STRAIN, *DAMAGE],
    "error_control_of_lagging_heat": [*IDA, *NON_FOURIER, "Effects/Temperature-dependent properties=on",
                                      "Tissues/tissue/Conductivity=300: 0.5, 350: 0.7", "Time/End=20",
                                      "Mesh/Subdivisions=3"],
    "adaptive_heat": [*ADAPTIVE, *NON_FOURIER, *DAMAGE, "Effects/Temperature-dependent properties=on",
                      "Tissues/tissue/Conductivity=310: 0.5, 330: 0.7"],
    "adaptive_two_way": [*ADAPTIVE, *STRAIN, "Effects/Coupling=two-way", "Effects/Damage=thermo-mechanical strain energy",
                         "Mesh/Adaptive/Follow=both", "Output/Reactions=on", "Time/End=20"],
    "adaptive_displacement_at_outputs": [*ADAPTIVE, *STRAIN, "Time/End=20"],
    "adaptive_load_that_ends": [*ADAPTIVE, "Effects/Deformation=equilibrium", "Numerics/Displacement at=every step",
                                "Boundaries/top/Traction=0; 0; 100*(t<1)", "Time/End=20"],
    "adaptive_error_control": [*ADAPTIVE, *IDA, *STRAIN, *DAMAGE],
    "explicit": [*EXPLICIT, *NON_FOURIER, *DAMAGE, "Heat sources/needle/Power=30",
                 "Numerics/Explicit/Averaged pressure=on", "Mesh/Cells=tetrahedra"],
    "explicit_single": [*EXPLICIT, "Numerics/Explicit/Precision=single", "Effects/Metabolism=Q10"],
    "explicit_beside_implicit_heat": [*EXPLICIT, "Time/Integrator=backward Euler", "Mesh/Cells=tetrahedra"],
    "explicit_beside_error_control": [*EXPLICIT, *IDA],
}


def words(name):
    """Of the command line, after the program."""
    return ["scene.prm", *(word for text in CASES[name] for word in ("--set", text))]
