# SPDX-License-Identifier: LGPL-2.1-or-later
"""Case 9: properties with kinks and peaks, as where tissue dries at 373 K."""

TABLES = {
    "kinks": ["Tissues/tissue/Specific heat=310: 3600, 340: 4200, 372: 4300, 373: 2500, 400: 2000",
              "Tissues/tissue/Conductivity=310: 0.5, 345: 0.55, 372.9: 0.6, 373.1: 0.2, 450: 0.15"],
    "latent heat over 10 K": ["Tissues/tissue/Specific heat=310: 4200, 368: 4200, 373: 310000, 378: 4200",
                              "Tissues/tissue/Conductivity=310: 0.6, 368: 0.6, 378: 0.2"],
    "latent heat over 1 K": ["Tissues/tissue/Specific heat=310: 4200, 372.5: 4200, 373: 3100000, 373.5: 4200",
                             "Tissues/tissue/Conductivity=310: 0.6, 372.5: 0.6, 373.5: 0.2"],
}
ENTHALPY = 1000 * 4200.0  # of 1 m3 and 1 K outside of the peak, J
BASE = ["Effects/Temperature-dependent properties=on", "Effects/Heat sources=on", "Effects/Heat=Fourier",
        "Initial state/Temperature=310", "Heat sources/everywhere/Power=2e7", "Time/End=200", "Output/Interval=20"]


def adapted(lab):
    """A peak on a mesh that follows the heat: what is carried over to a new mesh is enthalpy, and its rate."""
    peak = ["Tissues/tissue/Specific heat=310: 4200, 312: 4200, 320: 60000, 330: 4200", "Tissues/tissue/Relaxation time=5",
            "Heat sources/everywhere/Power=if(x < 0.003, 1e7, 0)", "Heat sources/everywhere/Switch off at=20", "Time/End=100",
            "Mesh/Adaptive/Follow=temperature", "Mesh/Adaptive/Interval=4", "Numerics/Capacity matrix=consistent"]
    found = lab.run_all({heat: ("slab", *BASE, *peak, f"Effects/Heat={heat}") for heat in ("Fourier", "non-Fourier")})
    for heat, run in found.items():
        balance = run.summary["balance"]
        lab.above(f"a peak on an adaptive mesh, {heat}: times that the mesh was adapted", run.summary["adaption"]["times"], 1)
        lab.below(f"the same: books of heat open by", run.open_books(), 1e-8)
        lab.below(f"the same: heat made by adaption, of that put in", abs(balance["made_by_adaption_J"] / balance["sources_J"]), 1e-3)


def check(lab):
    adapted(lab)
    runs = {}
    for table, properties in TABLES.items():
        for step in (0.1, 1.0, 10.0):
            runs[table, step] = ("slab", *BASE, *properties, f"Time/Step={step}")
        runs[table, "IDA"] = ("slab", *BASE, *properties, "Time/Integrator=IDA")
        runs[table, "non-Fourier"] = ("slab", *BASE, *properties, "Effects/Heat=non-Fourier", "Tissues/tissue/Relaxation time=2")
    found = lab.run_all(runs)
    for table in TABLES:
        fixed = [found[table, step] for step in (0.1, 1.0, 10.0)]
        lab.above(f"{table}: hottest, K", min(run.hottest() for run in fixed), 373.5)
        lab.below(f"{table}, steps of 0.1, 1 and 10 s: books of heat open by", max(run.open_books() for run in fixed), 1e-8)
        rises = [run.end("middle", "temperature_K") - 310 for run in fixed]
        lab.below(f"{table}: end of steps of 1 s against 0.1 s, of the rise", abs(rises[1] / rises[0] - 1), 0.02)
        lab.below(f"{table}, IDA: books open by", found[table, "IDA"].open_books(), 1e-2)
        lagging = found[table, "non-Fourier"]
        lab.below(f"{table}, non-Fourier (lag of 2 s): books open by", lagging.open_books(), 1e-8)
        # the heating is even and lasts a hundred times longer than the lag
        lab.below(f"{table}, non-Fourier: end against Fourier's, of the rise",
                  abs((lagging.end("middle", "temperature_K") - 310) / rises[1] - 1), 0.02)
    run = lab.run("slab", *BASE, "Tissues/tissue/Conductivity=0.6 - 0.01 * (T - 310)", status=1)
    lab.says("an expression that falls below 0 on the way", run.complaint, "Conductivity = 0.6 - 0.01 * (T - 310) is -", "at T = ",
             "it must be > 0")
    lab.keep("the same: last good state on disk", "t > 0", f"t = {run.last_time():g} s", run.last_time() > 0)
