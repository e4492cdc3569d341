# SPDX-License-Identifier: LGPL-2.1-or-later
"""Case 5: damage with constants, temperatures and strain energies beyond all that tissue knows."""
import math

R = 8.314  # J/(mol K)
CONSTANTS = ((1e300, 1e7), (1e300, 1.0), (1e-300, 1e7), (1e-300, 1.0), (1.98e106, 667000.0))  # 1/s, J/mol
TISSUE = "Tissues/tissue/Arrhenius damage"
WITH_ENERGY = ["Effects/Deformation=equilibrium", "Effects/Coupling=expansion", "Tissues/tissue/Young's modulus=1e12",
               "Tissues/tissue/Thermal expansion coefficient=1e-6"]
NOTHING = -math.inf


def add(a, b):
    larger, smaller = max(a, b), min(a, b)
    return larger + math.log1p(math.exp(smaller - larger)) if larger > NOTHING else NOTHING


def straight(start, end):
    """ln of the integral over 1 s of a rate whose logarithm runs straight."""
    fall = abs(end - start)
    if math.isinf(fall) or math.isnan(fall):
        return NOTHING
    return max(start, end) + (math.log(-math.expm1(-fall) / fall) if fall > 1e-12 else 0.0)


def expected(factor, energy, history):
    rates = [math.log(factor) - energy / (R * T) if T > 0 else NOTHING for T in history]
    values = [NOTHING]
    for start, end in zip(rates, rates[1:]):
        values.append(add(values[-1], straight(start, end)))
    return values


def is_monotone(values):
    """And a number, or no damage at all."""
    return all(b >= a for a, b in zip(values, values[1:])) and not any(map(math.isnan, values))


def check(lab):
    runs = {}
    for factor, energy in CONSTANTS:
        constants = [f"{TISSUE}/Frequency factor={factor}", f"{TISSUE}/Activation energy={energy}"]
        for quadrature in ("exponential", "end of step"):
            runs["Arrhenius", factor, energy, quadrature] = ("dose", *constants, f"Damage/Quadrature={quadrature}")
        for law in ("thermal", "thermo-mechanical"):
            runs[law, factor, energy] = ("dose", *constants, f"Effects/Damage={law} strain energy", *WITH_ENERGY)
    for law in ("CEM43", "critical thermal load"):
        runs[law] = ("dose", f"Effects/Damage={law}")
    runs["cold"] = ("dose", "Boundaries/outside/Temperature=1e-308", "Initial state/Temperature=1e-308",
                    "Effects/Damage=thermal strain energy", *WITH_ENERGY, "Time/End=5")
    found = lab.run_all(runs)
    history = {key: run.history("corner", "ln_damage") for key, run in found.items()}
    lab.keep(f"all {len(runs)} runs, A 1e-300 to 1e300 1/s, Delta E 1 to 1e7 J/mol, 0 to 2000 K: ln(Omega) is a number and grows",
             "in all", f"in {sum(map(is_monotone, history.values()))}", all(map(is_monotone, history.values())))
    worst = 0.0
    for factor, energy in CONSTANTS:
        run = found["Arrhenius", factor, energy, "exponential"]
        for got, should in zip(run.history("corner", "ln_damage"),
                               expected(factor, energy, run.history("corner", "temperature_K"))):
            worst = max(worst, abs(got - should) / max(1, abs(should)) if should > NOTHING else float(got > NOTHING))
    lab.below("Arrhenius: ln(Omega) against its integral by hand, relative", worst, 1e-9)
    energies = found["thermal", 1e300, 1e7].history("corner", "strain_energy_J_per_m3")
    lab.above("strain energy: V_mol W over an activation energy of 1e7 J/mol", 0.285 * max(energies) / 1e7, 1.0)
    lab.above("the same: ln(Omega), finite", max(h[-1] for key, h in history.items() if key[0] == "thermal"), 1000)
    lab.above("strain energy at 1e-308 K: ln(Omega), beyond all numbers but none",
              history["cold"][-1], 1e300)
    texts = [(run.folder / name).read_text().lower() for run in found.values() for name in ("probes.csv", "summary.json")]
    lab.keep("`nan` in any output", "none", f"{sum('nan' in text for text in texts)}", not any("nan" in text for text in texts))
