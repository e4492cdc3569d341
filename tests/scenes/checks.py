# SPDX-License-Identifier: LGPL-2.1-or-later
"""What each scene must find, computed without the program: a function for each scene, named like it. See its head."""
import math

TISSUE = "Tissues/tissue/"
GAS_CONSTANT = 8.314


def near(found, exact, relative, floor=0.0):
    assert abs(found - exact) <= max(relative * abs(exact), floor), f"found {found}, exact {exact}"


def lame(outcome):
    """lambda, mu, bulk modulus in Pa."""
    young, nu = outcome[TISSUE + "Young's modulus"], outcome[TISSUE + "Poisson's ratio"]
    return young * nu / ((1 + nu) * (1 - 2 * nu)), young / (2 * (1 + nu)), young / (3 * (1 - 2 * nu))


def thermal_strain(outcome, row):
    return outcome[TISSUE + "Thermal expansion coefficient"] * (row["temperature_K"]
                                                                - outcome[TISSUE + "Reference temperature"])


def hookes_law(outcome):
    """sigma = lambda tr eps I + 2 mu eps - 3 K alpha (T - T_0) I at every probe: linear, so also of averages."""
    first, second, bulk = lame(outcome)
    for row in outcome.rows:
        volume = row["strain_xx"] + row["strain_yy"] + row["strain_zz"]
        hydrostatic = first * volume - 3 * bulk * thermal_strain(outcome, row)
        a_kelvin = outcome[TISSUE + "Thermal expansion coefficient"]
        scale = 1e-9 * 3 * bulk * max(abs(volume), abs(thermal_strain(outcome, row)), a_kelvin)
        for pair in ("xx", "yy", "zz", "xy", "xz", "yz"):
            exact = 2 * second * row["strain_" + pair] + (hydrostatic if pair[0] == pair[1] else 0)
            near(row[f"stress_{pair}_Pa"], exact, 1e-8, scale)


def same(outcome, one, other, swap="xyz", sign=1):
    """Two probes find the same; their components along swap[0], swap[1], swap[2] take the place of x, y, z."""
    for row in outcome.rows:
        if row["probe"] != one or row["time_s"] == 0:
            continue
        mirrored = outcome.at(row["time_s"], other)
        near(mirrored["temperature_K"], row["temperature_K"], 1e-9)
        if "displacement_x_m" in row:
            largest = max(abs(row[f"displacement_{axis}_m"]) for axis in "xyz")
            for axis, turned in zip("xyz", swap):
                near(mirrored[f"displacement_{turned}_m"], sign * row[f"displacement_{axis}_m"], 0, 1e-7 * largest)
        if "ln_damage" in row:
            near(mirrored["ln_damage"], row["ln_damage"], 0, 1e-6)


def share_within(half_width, radius):
    """Of a Gaussian about the middle of an interval, what lies within."""
    return math.erf(half_width / (radius * math.sqrt(2)))


def backward_euler_power(power, on_in_step, delay):
    """Heat from a source of the non-Fourier model whose jumps are neglected, in steps of 1 s: it acts as s with
    tau s' + s = a, where a is the share of the step that it is on."""
    acting = total = 0
    for share in on_in_step:
        acting = (delay * acting + share) / (delay + 1)
        total += acting
    return power * total


def switched(outcome, heat):
    near(outcome.summary["balance"]["sources_J"], heat, 1e-9)
    near(outcome.summary["balance"]["metabolism_J"], 33800 * 1e-6 * 20, 1e-9)
    same(outcome, "off", "opposite")


def switched_points(outcome):
    """On from 0 to 4 s and from 8.5 s to 16 s."""
    switched(outcome, 0.4 * 11.5)
    assert all(row["temperature_K"] >= 310 for row in outcome.rows if row["time_s"] <= 16)
    # the flux from the needle's node, 1 mm3 of tissue, dies out with tau = 16 s when its source is switched off
    fall = 0.2 * 16 * (1 - math.exp(-4 / 16)) / (4.192e6 * 1e-9)
    near(outcome.at(16, "needle")["temperature_K"] - outcome.at(20, "needle")["temperature_K"], fall, 0.1)


def neglected_jumps(outcome):
    switched(outcome, backward_euler_power(0.4, [1] * 4 + [0] * 4 + [0.5] + [1] * 7 + [0] * 4, 16))
    assert outcome.at(20, "off")["temperature_K"] > outcome.at(16, "off")["temperature_K"]


def limited_points(outcome):
    switched(outcome, 0.4 * 11.5)
    assert outcome.summary["extremes"]["temperature_min_K"] >= 310 - 1e-9


def error_control(outcome):
    near(outcome.summary["balance"]["sources_J"], 2 * share_within(5e-3, 2e-3) ** 3 * 12.3, 1e-3)
    same(outcome, "P3", "P3 across", "yxz", -1)
    hookes_law(outcome)
    at_centre = [outcome.at(time, "centre")["temperature_K"] for time in (0, 5, 12.3, 20)]
    assert max(at_centre) == at_centre[2]


def exact_stretch(outcome):
    # alpha = 3e-4 + 1e-5 (T - 310) from 312 to 320 K; E = 9e6 Pa at 320 K
    stretch = math.exp(8 * 3.6e-4)
    bulk = 9e6 / (3 * (1 - 2 * 0.35))
    for probe in ("centre", "off", "side"):
        for pair in ("xx", "yy", "zz"):
            near(outcome.at(0, probe)[f"stress_{pair}_Pa"], -1.5 * (stretch - 1 / stretch) * bulk, 1e-9)
    near(outcome.summary["balance"]["stored_J"], 100 * 6e-4 * 200, 1e-9)
    for time in (100, 200):
        centre, off, side = (outcome.at(time, probe)["temperature_K"] for probe in ("centre", "off", "side"))
        assert centre < off < side
        shear = [outcome.at(time, "centre")[f"stress_{pair}_Pa"] for pair in ("xy", "xz", "yz")]
        near(max(shear), min(shear), 1e-6, 1e-3)


def balances(outcome, time, load, tolerance=1e-9):
    """What all supports together bear is the load (N)."""
    sums = [sum(parts) for parts in zip(*(force for (at, _), force in outcome.reactions.items() if at == time))]
    for axis in range(3):
        near(sums[axis], -load[axis], 0, tolerance * max(map(abs, load)) or 1e-12)


def forces(outcome):
    for probe in ("middle", "top", "pulled", "end"):
        at = [outcome.at(time, probe) for time in (0, 2, 4)]
        for column in outcome.columns[5:]:
            if column.startswith(("displacement", "strain_x", "stress")):
                start, half, end = (row[column] for row in at)
                near(end - start, 2 * (half - start), 1e-6, 1e-13 if column.startswith("displacement") else 1e-4)
    # a load F in the middle: F L / (4 k G A) + F L^3 / (192 E I); spread evenly: F L / (8 k G A) + F L^3 / (384 E I)
    young, length, area, inertia_of_area = outcome[TISSUE + "Young's modulus"], 0.02, 1e-4, 1e-8 / 12
    shear, bending = 1.2 * length / (lame(outcome)[1] * area), length ** 3 / (young * inertia_of_area)
    start, end = outcome.at(0, "middle"), outcome.at(4, "middle")
    near(end["displacement_y_m"] - start["displacement_y_m"], 0.2 * (shear / 4 + bending / 192), 0.25)
    near(end["displacement_z_m"] - start["displacement_z_m"], -0.8 * (shear / 8 + bending / 384), 0.25)
    near(start["displacement_y_m"], -1000 * 9.81 * area * length * (shear / 8 + bending / 384), 0.25)
    assert 0 < outcome.at(4, "pulled")["displacement_y_m"] < end["displacement_y_m"]
    gravity = outcome.at(0, "middle")
    assert gravity["displacement_y_m"] < -10 * max(abs(gravity[f"displacement_{axis}_m"]) for axis in "xz")
    end = outcome.at(4, "end")
    assert (end["displacement_x_m"], end["displacement_y_m"], end["displacement_z_m"]) == (4e-5, 0, 0)
    assert outcome.at(4, "top")["displacement_z_m"] < outcome.at(4, "middle")["displacement_z_m"] < 0
    near(outcome.at(4, "middle")["strain_xx"], 4e-5 / 0.02, 0.1)
    for time in (0, 2, 4):  # the wall bears everything but what the end bears along x
        weight = 1000 * 9.81 * area * length
        balances(outcome, time, [0, 0.05 * time - weight, -1000 * time * length * 0.01])
    pull = outcome.reactions[4, "end"][0] - outcome.reactions[0, "end"][0]
    near(pull, young * area * 4e-5 / length, 0.1)


def free_expansion(outcome, factor, energy_factor):
    """u = factor alpha (T - T_0) x without stress; W = energy_factor K (alpha (T - T_0))^2."""
    bulk = lame(outcome)[2]
    for row in outcome.rows:
        stretch = thermal_strain(outcome, row)
        for axis in "xyz"[:int(outcome["Dimension"])]:
            near(row[f"displacement_{axis}_m"], factor * stretch * row[f"{axis}_m"], 1e-8, 1e-14)
            near(row[f"strain_{axis}{axis}"], factor * stretch, 1e-8, 1e-13)
            near(row[f"stress_{axis}{axis}_Pa"], 0, 0, 1e-8 * 3 * bulk * abs(stretch))
        near(row["strain_energy_J_per_m3"], energy_factor * bulk * stretch * stretch, 1e-8, 1e-9)


def inclined(outcome):
    free_expansion(outcome, 1, 4.5)
    bulk = lame(outcome)[2]
    ln_frequency, energy = math.log(1.98e106), 667000

    def ln_rate(rise):
        return ln_frequency - (energy - 0.285 * 4.5 * bulk * (3e-4 * rise) ** 2) / (GAS_CONSTANT * (310 + rise))

    # the integral over each step of a rate whose logarithm runs straight
    damage = sum((math.exp(ln_rate(n + 1)) - math.exp(ln_rate(n))) / (ln_rate(n + 1) - ln_rate(n)) for n in range(10))
    for probe in ("origin", "middle"):
        near(outcome.at(10, probe)["temperature_K"], 320, 1e-10)
        near(outcome.at(10, probe)["ln_damage"], math.log(damage), 0, 1e-8)


def plane_strain(outcome):
    nu = outcome[TISSUE + "Poisson's ratio"]
    assert (nu, outcome[TISSUE + "Young's modulus"]) == (0.49, 120e6), "thesis type II"
    near(outcome.at(10, "inside")["temperature_K"], 320, 1e-10)
    free_expansion(outcome, 1 + nu, 3 * (1 + nu))


def mean_dilatation(outcome):
    nu = outcome[TISSUE + "Poisson's ratio"]
    near(outcome.at(10, "inside")["temperature_K"], 320, 1e-10)
    free_expansion(outcome, 1 + nu, 3 * (1 + nu))


def inertia(outcome):
    first, second, bulk = lame(outcome)
    modulus, length, area = first + 2 * second, 0.02, 2.5e-5
    speed = math.sqrt(modulus / 1000)
    transit = length / speed
    warming = 1000 / (1000 * 4192 * area)  # of the bar's section, K m/s

    def ramp(time):
        return max(0.0, time)

    for time in (1e-4, 2e-4, 3e-4):
        pull = 1000 / (1000 * speed) * time
        expansion = 3 * bulk * 3e-4 / modulus * warming * (ramp(time - 0.5 * transit) + ramp(time - 1.5 * transit))
        near(outcome.at(time, "end")["displacement_x_m"], pull + expansion, 0.03)
    middle = outcome.at(4e-4, "middle")
    assert middle["stress_yy_Pa"] < middle["stress_xx_Pa"] < 0
    near(outcome.summary["balance"]["sources_J"], 0.4, 1e-9)
    hookes_law(outcome)


def antenna_heat():
    """W of Eq. 6-35 in the box, 8 mm x 8 mm x 12 mm, by midpoints; the axis is the line x = 4 mm, z = 6 mm."""
    scale, attenuation, exponent, axial, inner, power = 0.004, 0.06, 2.4, 12.0, 2.0, 10
    n, across = (40, 40, 60), 0.0
    for i in range(n[0]):
        for k in range(n[2]):
            r = max(inner, math.hypot(8 * (i + 0.5) / n[0] - 4, 12 * (k + 0.5) / n[2] - 6))
            across += (2 * attenuation * r + exponent - 2) * math.exp(-2 * attenuation * r) / r ** exponent
    along = sum(math.exp(-(8 * (j + 0.5) / n[1] / axial) ** 2) for j in range(n[1]))
    return scale * power * across * along * 8 * 8 * 12 / (n[0] * n[1] * n[2])


def layers(outcome):
    balance, extremes = outcome.summary["balance"], outcome.summary["extremes"]
    near(balance["sources_J"], 60 * (antenna_heat() + 2e5 * 256e-9), 0.01)
    same(outcome, "mirror left", "mirror right")
    rises = [extremes[name] for name in ("temperature_min_K", "temperature_max_K")]

    def metabolism(temperature):
        muscle, fat = 2 ** ((temperature - 310) / 10), 2.5 ** ((temperature - 308) / 10)
        return 60 * (33800 * 512e-9 * muscle + 20000 * 256e-9 * fat)

    def blood(temperature):
        return 60 * (20 * 3600 * 512e-9 * (temperature - 310) + 1.5 * 3700 * 256e-9 * (temperature - 309))

    assert metabolism(rises[0]) < balance["metabolism_J"] < metabolism(rises[1])
    assert blood(rises[0]) < balance["lost_to_blood_J"] < blood(rises[1])
    for time in (30, 60):
        assert outcome.at(time, "antenna")["ln_damage"] < outcome.at(time, "mirror left")["ln_damage"]
    assert outcome.summary["title"] == "Two layers"


def plane(outcome):
    ends = [1, 2, 3, 4, 5, 6, 7, 7.5]
    impulse = sum((1 + 0.1 * end) * (end - start) for start, end in zip([0, *ends], ends))
    width, half = math.sqrt(2) * 1e-3, 0.5
    share = (half + half * math.erf(4 / (width * 1e3 * math.sqrt(2)))) * math.erf(10 / (width * 1e3 * math.sqrt(2)))
    near(outcome.summary["balance"]["sources_J"], 2e6 * math.pi * 4e-6 * share * impulse, 2e-3)
    for time in (5, 7.5, 10):
        held, centre, side, corner = (outcome.at(time, probe)["temperature_K"]
                                      for probe in ("held", "centre", "side", "corner"))
        near(held, 310 + 0.2 * time, 1e-12)
        assert side < corner < 310 < held and centre > 310
    steps = [line for line in outcome.log.splitlines() if line.startswith("t = ")]
    assert len(steps) == outcome.summary["time_steps"], "a line for every step"


def quadratic(outcome):
    share = share_within(5e-3, 3e-3) * share_within(10e-3, 3e-3) ** 2
    near(outcome.summary["balance"]["sources_J"], 8 / 4 * share * 20, 1e-3)
    same(outcome, "x", "y", "yxz")
    hookes_law(outcome)
    assert outcome.at(20, "top")["displacement_z_m"] > outcome.at(20, "centre")["displacement_z_m"] > 0


def two_way(outcome):
    bulk = lame(outcome)[2]
    for time in (2, 4):
        for probe in ("centre", "corner"):
            row = outcome.at(time, probe)
            rise = 3 * bulk * 3e-4 * 310 * 1e-3 * time / 4 / 4.192e6
            near(row["temperature_K"] - 310, rise, 1e-6, 1e-10)
            near(row["displacement_x_m"], -1e-3 * time / 4 * row["x_m"], 1e-8)
    hookes_law(outcome)


def differences(outcome):
    conductivity, nu = outcome[TISSUE + "Conductivity"], outcome[TISSUE + "Poisson's ratio"]
    for row in outcome.rows:
        if row["time_s"] > 3e6:
            rise = 500 * row["x_m"] / conductivity
            near(row["temperature_K"] - 310, rise, 1e-9)
            stretch = (1 + nu) / (1 - nu) * outcome[TISSUE + "Thermal expansion coefficient"]
            near(row["displacement_x_m"], stretch * rise * row["x_m"] / 2, 1e-8)
            for axis in "yz":
                near(row[f"displacement_{axis}_m"], 0, 0, 1e-15)
    hookes_law(outcome)


def damage_constants(outcome):
    constants = {"thesis": (1.98e106, 667000), "retina": (1e44, 2.9e5), "skin": (3.1e98, 6.3e5), "liver": (1e70, 4e5),
                 "own": (1e90, 5.5e5)}
    for name, (frequency, energy) in constants.items():
        for time in (4, 8):
            exact = math.log(frequency) + math.log(time) - energy / (GAS_CONSTANT * 330)
            near(outcome.at(time, name)["ln_damage"], exact, 1e-10)
    # each strip is two cells high, and its lowest nodes belong to the strip below: ln Omega runs straight from there
    ln = {name: outcome.at(8, name)["ln_damage"] for name in constants}
    dead = {region["name"]: region["fraction"] for region in outcome.summary["ablation"]["regions"].values()}
    exact = {"thesis": 1, "retina": 0.5 * ln["thesis"] / (ln["thesis"] - ln["retina"]), "skin": 0,
             "liver": 0.5 + 0.5 * ln["liver"] / (ln["liver"] - ln["skin"]), "own": 1}
    for name, fraction in exact.items():
        near(dead[name], fraction, 1e-9)


def solved(function, low, high):
    """Where a rising function is zero."""
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if function(middle) < 0 else (low, middle)
    return (low + high) / 2


def pulled_stretches(outcome, traction, thermal_stretch, fibre):
    """Along and across, of a neo-Hookean block that is pulled; fibre(I_4 - 1) is S along the fibres, which run along."""
    first, second, _ = lame(outcome)

    def nominal(stretch, along, across):
        """P = s^2 P_e of the direction with this stretch."""
        volume = along * across**2 / thermal_stretch**3
        elastic = stretch / thermal_stretch
        tension = second * (elastic - 1 / elastic) + first * math.log(volume) / elastic
        return thermal_stretch**2 * (tension + (elastic * fibre(elastic**2 - 1) if stretch == along else 0))

    def across(along):
        return solved(lambda stretch: nominal(stretch * (1 + 1e-15), along, stretch), 0.2, 3)

    along = solved(lambda stretch: nominal(stretch, stretch, across(stretch)) - traction, 0.5, 5)
    return along, across(along)


def large_fibres(outcome):
    family = TISSUE + "collagen/Fibre "
    stiffness, stiffening = outcome[family + "stiffness"], outcome[family + "stiffening"]
    heated = math.exp(outcome[TISSUE + "Thermal expansion coefficient"] * 20)
    along, across = pulled_stretches(outcome, 3000, heated,
                                     lambda x: 2 * stiffness * x * math.exp(stiffening * x * x))
    assert along > 1.15, along
    for row in outcome.rows:
        near(row["temperature_K"], 330, 1e-12)
        if row["time_s"] == 1:
            near(row["displacement_x_m"], (along - 1) * row["x_m"], 1e-9)
            near(row["displacement_y_m"], (across - 1) * row["y_m"], 1e-9)
            near(row["strain_xx"], (along**2 - 1) / 2, 1e-9)
            near(row["stress_xx_Pa"], 3000 / along, 1e-9)
            near(row["stress_yy_Pa"], 0, 0, 1e-5)
    balances(outcome, 1, [3000 * 1e-4, 0, 0])


def relaxed_fibres(outcome):
    large_fibres(outcome)


def explicit_block(outcome):
    along, across = pulled_stretches(outcome, 1000, 1, lambda x: 0)
    assert along > 1.3, along
    length, flux, conductivity = 0.01, 1e6, outcome[TISSUE + "Conductivity"]
    slope = flux / (conductivity * across**2 / along)  # of the temperature along the undeformed body
    for row in outcome.rows:
        if row["time_s"] > 0:
            near(row["displacement_x_m"], (along - 1) * row["x_m"], 1e-9)
            near(row["displacement_z_m"], (across - 1) * row["z_m"], 1e-9)
            near(row["stress_xx_Pa"], 1000 / across**2, 1e-8)
            near(row["temperature_K"] - 310, slope * row["x_m"], 1e-6)
    near(outcome.summary["balance"]["lost_through_boundary_J"], -stored_in_slope(slope, length), 1e-6)
    balances(outcome, 1.2, [1000 * 1e-4, 0, 0], 1e-8)


def stored_in_slope(slope, length):
    return 1000 * 4192 * length**2 * slope * length**2 / 2


def explicit_bricks(outcome):
    for row in outcome.rows:
        near(row["displacement_z_m"], -9.81 * row["time_s"]**2 / 2, 0, 3e-7)
    heat = outcome.summary["balance"]
    near(heat["sources_J"], 2e6 * 1e-6 * 0.0075, 1e-9)
    assert heat["stored_J"] > 0


def adaptive_heat(outcome):
    adaption = outcome.summary["adaption"]
    assert adaption["times"] > 0 and adaption["last_number_of_cells"] < adaption["largest_number_of_cells"] <= 440, adaption
    near(outcome.summary["balance"]["sources_J"], 2e7 * math.pi * 1e-6 * 20, 2e-3)
    near(outcome.summary["balance"]["metabolism_J"], 33800 * 2e-4 * 100, 1e-9)
    same(outcome, "above", "below")
    assert outcome.at(20, "end")["temperature_K"] > outcome.at(20, "above")["temperature_K"] + 5


def adaptive_displacement(outcome):
    assert 27 < outcome.summary["adaption"]["last_number_of_cells"] <= 300
    balances(outcome, 1, [0.1, 0, 0])
    # push and support are symmetric about y = 5 mm
    for axis, sign in zip("xyz", (1, -1, 1)):
        name = f"displacement_{axis}_m"
        near(outcome.at(1, "right")[name], sign * outcome.at(1, "left")[name], 1e-7, 1e-13)


def adaptive_both(outcome):
    adaption = outcome.summary["adaption"]
    assert adaption["times"] > 0 and 27 < adaption["last_number_of_cells"] < 27 * 64, adaption
    near(outcome.summary["balance"]["sources_J"], 0.5 * 10 * share_within(5e-3, 2e-3) ** 3, 1e-2)
    same(outcome, "one", "other", "xyz", -1)
    hookes_law(outcome)
