# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is on has its unknowns, columns, fields, books and costs; what is off has none of them."""

AXES = "xyz"


def tensor(name, unit, dimension):
    pairs = [(c, c) for c in range(dimension)]
    pairs += [(c, d) for c in range(dimension) for d in range(c + 1, dimension)]
    return [f"{name}_{AXES[c]}{AXES[d]}{unit}" for c, d in pairs]


def expected_unknowns(outcome):
    heat, deformation = outcome["Effects/Heat"], outcome["Effects/Deformation"]
    non_fourier = heat == "non-Fourier"
    two_way = outcome["Effects/Coupling"] == "two-way"
    present = {"temperature": heat != "off", "temperature_rate": non_fourier, "displacement": deformation != "off",
               "displacement_rate": deformation in ("inertia", "explicit dynamics") or (non_fourier and two_way)}
    return {name for name, is_there in present.items() if is_there}


def expected_columns(outcome):
    dimension = int(outcome["Dimension"])
    columns = ["time_s", "probe", "x_m", "y_m", "z_m"]
    if outcome.is_on("Heat"):
        columns.append("temperature_K")
    if outcome.is_on("Deformation"):
        columns += [f"displacement_{axis}_m" for axis in AXES[:dimension]]
        columns += tensor("strain", "", dimension) + tensor("stress", "_Pa", dimension) + ["strain_energy_J_per_m3"]
    if outcome.is_on("Damage"):
        columns += ["ln_damage", "damage"]
    return columns


def expected_arrays(outcome):
    arrays = {"displacement_m" if column.startswith("displacement") else column
              for column in expected_columns(outcome)[5:]} - {"damage"}
    if outcome.is_on("Heat"):
        arrays.add("temperature_error_indicator_K_per_m")
    if outcome.is_on("Deformation"):
        arrays.add("displacement_error_indicator")
    return arrays | {"region"}


def expected_errors(outcome):
    """Of steps: nothing is told by explicit ones, nor by an equilibrium."""
    heat, deformation = outcome["Effects/Heat"] != "off", outcome["Effects/Deformation"]
    stepped = {"heat": heat and outcome["Time/Integrator"] != "explicit", "deformation": deformation == "inertia"}
    present = {"time": {name for name, is_there in stepped.items() if is_there},
               "space": {name for name, is_there in {"temperature_gradient": heat, "displacement_gradient": deformation != "off"}.items() if is_there}}
    return {name: entries for name, entries in present.items() if entries}


def check(outcome):
    summary = outcome.summary
    assert set(summary["unknowns"]) == expected_unknowns(outcome), summary["unknowns"]
    assert outcome.columns == expected_columns(outcome), outcome.columns
    times = {row["time_s"] for row in outcome.rows}
    assert len(outcome.arrays) == (len(times) if outcome["Output/Fields"] == "on" else 0), outcome.arrays
    for arrays in outcome.arrays:
        assert arrays == expected_arrays(outcome), arrays
    errors = {name: set(entries) for name, entries in summary["errors"].items() if name in ("time", "space")}
    assert errors == expected_errors(outcome), errors
    assert ("balance" in summary) == outcome.is_on("Heat")
    assert ("ablation" in summary) == outcome.is_on("Damage")
    extremes = {name.split("_")[0] for name in summary["extremes"]} - {"ln"}
    names = {"temperature": "Heat", "displacement": "Deformation", "damage": "Damage"}
    assert extremes == {name for name, effect in names.items() if outcome.is_on(effect)}, extremes
    for effect in names.values():
        cost = summary["cost"]["seconds_by_effect"]
        assert (effect.lower() in cost) == outcome.is_on(effect), cost
