# SPDX-License-Identifier: LGPL-2.1-or-later
"""Case 2: a steep thermal wave on coarse meshes, and how far it falls below the coldest data, 310 K."""

LUMPED = "Numerics/Capacity matrix=lumped"
LIMITED = "Numerics/Temperature limiter=on"
NEGLECTED = "Effects/Heat source jumps=neglected"
ON_THE_WAY = "Time/End=9.75"  # before the source is switched off
FOURIER = "Effects/Heat=Fourier"
SPOT = [FOURIER, "Effects/Heat sources=off", "Boundaries/outside/Thermal=insulated",
        "Initial state/Temperature=310 + if(abs(x - 0.005) + abs(y - 0.005) + abs(z - 0.005) < 1e-6, 50, 0)"]
HEXAHEDRA, DIFFERENCES = ["Mesh/Cells=hexahedra"], ["Mesh/Cells=hexahedra", "Numerics/Method=finite differences"]
FLAT = "Mesh/Subdivisions=10, 10, 2"
BOUND = 1e-8


def fall(run):
    """Below the coldest data, as a share of the range of temperatures."""
    return max(0.0, 310 - run.coldest()) / (run.hottest() - 310)


def waves(lab):
    fine = "Mesh/Subdivisions=16"
    runs = {
        "1 mm, consistent, on": ("cube", ON_THE_WAY),
        "1 mm, lumped, on": ("cube", ON_THE_WAY, LUMPED),
        "0.6 mm, consistent, on": ("cube", ON_THE_WAY, fine),
        "0.6 mm, lumped, on": ("cube", ON_THE_WAY, fine, LUMPED),
        "1 mm, lumped, switched off": ("cube", LUMPED),
        "0.6 mm, lumped, switched off": ("cube", LUMPED, fine),
        "1 mm hexahedra, lumped, switched off": ("cube", LUMPED, *HEXAHEDRA),
        "finite differences, switched off": ("cube", *DIFFERENCES),
        "1 mm, jumps neglected, lumped": ("cube", NEGLECTED, LUMPED),
        "1 mm, jumps neglected, consistent": ("cube", NEGLECTED),
    }
    limited = {name: (*arguments, LIMITED) for name, arguments in runs.items() if "on" not in name.split(", ")}
    limited["1 mm, consistent, switched off"] = ("cube", LIMITED)
    limited["blood and convection"] = ("cube", LIMITED, "Effects/Perfusion=on", "Boundaries/outside/Thermal=convection",
                                       "Boundaries/outside/Ambient temperature=310",
                                       "Boundaries/outside/Transfer coefficient=500")
    free, lifted = lab.run_all(runs), lab.run_all(limited)
    for name, run in free.items():
        needed = 1e-3 if "consistent" in name or "switched off" in name else -1
        lab.keep(f"{name}: fall below the coldest data, of the range", "needs the limiter" if needed > 0 else "none",
                 f"{fall(run):.2g}", fall(run) > needed if needed > 0 else fall(run) < BOUND)
    lab.below(f"with the limiter, {len(limited)} runs: fall", max(map(fall, lifted.values())), BOUND)
    lab.below("with the limiter: books of heat open by", max(run.open_books() for run in lifted.values()), 1e-8)
    rise = lambda run: run.end("far", "temperature_K") - 310
    lab.below("1 mm, lumped, 3 mm from the source at 20 s: change of the rise by the limiter, relative",
              abs(rise(lifted["1 mm, lumped, switched off"]) / rise(free["1 mm, lumped, switched off"]) - 1), 0.1)
    together = lab.run("cube", LIMITED, processes=2)
    alone = lifted["1 mm, consistent, switched off"]
    lab.below("with the limiter: 2 processes against 1, K",
              max(abs(a["temperature_K"] - b["temperature_K"]) for a, b in zip(together.rows, alone.rows)), 1e-7)


def fourier(lab):
    """Without sources temperatures stay between the coldest and the hottest start."""
    proved = {"tetrahedra of cubes": [], "flat tetrahedra": [FLAT], "cubes": HEXAHEDRA,
              "finite differences": DIFFERENCES, "flat finite differences": [*DIFFERENCES, FLAT]}
    runs = {}
    for step in (1e-3, 1.0, 1e3):
        for name, choice in proved.items():
            runs[name, step] = ("cube", *SPOT, LUMPED, *choice, f"Time/Step={step}", f"Time/End={20 * step}")
    runs["consistent"] = ("cube", *SPOT, "Time/Step=1e-3", "Time/End=0.02")
    runs["flat hexahedra"] = ("cube", *SPOT, LUMPED, *HEXAHEDRA, FLAT, "Time/End=2")
    runs["flat hexahedra, limited"] = (*runs["flat hexahedra"], LIMITED)
    runs["consistent, limited"] = (*runs["consistent"], LIMITED)
    found = lab.run_all(runs)
    beyond = lambda run: max(310 - run.coldest(), run.hottest() - 360, 0) / 50
    lab.below(f"Fourier, lumped, {' and '.join(proved)}, steps of 1e-3, 1 and 1e3 s: beyond the first temperatures",
              max(beyond(found[key]) for key in runs if key[0] in proved), BOUND)
    lab.above("Fourier, consistent, step 1e-3 s: fall", fall(found["consistent"]), 1e-3)
    lab.above("Fourier, lumped, flat hexahedra, which have no such principle: fall", fall(found["flat hexahedra"]), 1e-6)
    both = [found["flat hexahedra, limited"], found["consistent, limited"]]
    lab.below("both with the limiter: fall", max(map(fall, both)), BOUND)
    lab.below("both with the limiter: books of heat open by", max(run.open_books() for run in both), 1e-8)


def check(lab):
    waves(lab)
    fourier(lab)
