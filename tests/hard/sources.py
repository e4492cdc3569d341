# SPDX-License-Identifier: LGPL-2.1-or-later
"""Case 7: spikes, switches inside steps, a thousand of them; heat and deformation that feed back, in short and long steps."""
RHO_C, VOLUME = 1000 * 4192.0, 1e-5  # J/(m3 K), m3 per metre of depth
SPIKE = ["Heat sources/everywhere/Power=1e9", "Heat sources/everywhere/Switch on at=0.3000001",
         "Heat sources/everywhere/Switch off at=0.3000011"]
PULSES = 500
ON, OFF = 0.0131, 0.0577  # s, in each tenth of a second
INTEGRATORS = ("backward Euler", "IDA")
BASE = ["Effects/Heat sources=on", "Boundaries/ends/Thermal=insulated", "Initial state/Temperature=310",
        "Tissues/tissue/Relaxation time=0.5"]


def switched(power):
    times = lambda offset: ", ".join(f"{i / 10 + offset:.10g}" for i in range(PULSES))
    return [f"Heat sources/everywhere/Power={power}", f"Heat sources/everywhere/Switch on at={times(ON)}",
            f"Heat sources/everywhere/Switch off at={times(OFF)}"]


def pulses(lab):
    runs = {}
    for heat in ("Fourier", "non-Fourier"):
        for integrator in INTEGRATORS:
            common = ("slab", *BASE, f"Effects/Heat={heat}", f"Time/Integrator={integrator}")
            runs["spike", heat, integrator] = (*common, *SPIKE, "Time/End=10")
            runs["pulses", heat, integrator] = (*common, *switched(1e6), "Time/End=50", "Time/Step=0.7")
        runs["spike", heat, "explicit"] = ("slab", *BASE, f"Effects/Heat={heat}", "Time/Integrator=explicit", *SPIKE,
                                           "Time/End=10", "Dimension=3", "Mesh/Upper corner=0.01, 0.001, 0.001")
    runs["by itself"] = ("slab", *BASE, "Time/Integrator=IDA", "Heat sources/everywhere/Power=if(t > 3, 1e6, 0)", "Time/End=5")
    found = lab.run_all(runs)

    def worst(kind, integrator, energy, of):
        """Relative errors of the energy put in, and of the rise."""
        mine = [run for key, run in found.items() if key[0] == kind and key[2] == integrator]
        return max(of(run, energy) for run in mine)

    put_in = lambda run, energy: abs(run.summary["balance"]["sources_J"] / energy - 1)
    rise = lambda run, energy: abs((run.end("middle", "temperature_K") - 310) * RHO_C * VOLUME / energy - 1)
    spike, train = 1e9 * 1e-6 * VOLUME, 1e6 * PULSES * (OFF - ON) * VOLUME
    for integrator, bound in (("backward Euler", 1e-6), ("IDA", 1e-3)):
        lab.below(f"1e9 W/m3 for 1 us inside a step of 1 s, {integrator}, both models: energy put in, relative error",
                  worst("spike", integrator, spike, put_in), 1e-9)
        lab.below("the same: rise of temperature, relative error", worst("spike", integrator, spike, rise), bound)
        lab.below(f"{2 * PULSES} switches, {integrator}: energy put in, relative error",
                  worst("pulses", integrator, train, put_in), 1e-12)
        lab.below("the same: rise, relative error", worst("pulses", integrator, train, rise), bound)
    lab.below("the spike by explicit steps: energy put in, relative error", worst("spike", "explicit", spike * 1e-3, put_in), 1e-9)
    lab.keep("a power that jumps by itself, IDA, non-Fourier: books open, and the run says so", "a warning",
             f"{found['by itself'].open_books():.2g} open", "WARNING: heat is lost or made" in found["by itself"].log)


def feedback(lab):
    """Stiff tissue: the thesis's type II, and with ten times its expansion."""
    stiff = ["Tissues/tissue/Preset=thesis type II", "Effects/Deformation=equilibrium", "Boundaries/outside/Mechanical=fixed",
             "Mesh/Subdivisions=6", "Heat sources/needle/Switch off at="]
    runs = {}
    for heat in ("Fourier", "non-Fourier"):
        for step in (1e-3, 1.0, 1e3):
            for alpha, name in (("3e-4", "type II"), ("3e-3", "10 alpha")):
                runs[heat, step, name] = ("cube", *stiff, f"Effects/Heat={heat}", "Effects/Coupling=two-way",
                                          f"Tissues/tissue/Thermal expansion coefficient={alpha}",
                                          f"Time/Step={step}", f"Time/End={20 * step}")
        runs[heat, 1e3, "one way"] = ("cube", *stiff, f"Effects/Heat={heat}", "Effects/Coupling=expansion",
                                      "Time/Step=1000", "Time/End=20000")
    found = lab.run_all(runs)
    coupled = {key: run for key, run in found.items() if key[2] != "one way"}
    lab.below(f"two-way, type II and 10 times its expansion, steps of 1e-3, 1 and 1e3 s ({len(coupled)} runs): books open by",
              max(run.open_books() for run in coupled.values()), 1e-8)
    lab.below("the same: iterations of the coupled system a step",
              max(run.summary["statistics"]["linear_iterations_coupled"] / run.summary["time_steps"]
                  for run in coupled.values()), 100)
    lab.below("the same, 20 steps of 1000 s: rise near the source against one-way coupling, relative",
              max(abs((run.end("near", "temperature_K") - 310) /
                      (found[key[0], 1e3, "one way"].end("near", "temperature_K") - 310) - 1)
                  for key, run in coupled.items() if key[1] == 1e3), 1e-6)
    lab.below("the same: hottest over the steady state of the node heated", max(
        (run.hottest() - 310) / (found[key[0], 1e3, "one way"].hottest() - 310) for key, run in coupled.items()), 3)


def check(lab):
    pulses(lab)
    feedback(lab)
