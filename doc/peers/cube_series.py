# SPDX-License-Identifier: LGPL-2.1-or-later
"""The exact temperature of the chapter 6 cube with Gaussian sources (prm/accuracy/cube_*.prm), by a series of sines.

Fields are sums of a(t) sin(l pi x / L) sin(m pi y / L) sin(n pi z / L); of each mode, with
k = conductivity (l^2 + m^2 + n^2) pi^2 / L^2 and Eq. 6-8,
    tau rho C a'' + (rho C + tau w) a' + (w + k) a = q + q_m,    a(0) = 0, a'(0) = q / (rho C)
where the sources q are switched on at t = 0 (their impulse gives a'(0)) and the metabolic heat q_m was there before. Fourier's
model is tau = 0. Only odd modes count: all is symmetric about the middle. Coefficients of the Gaussians by Simpson's rule.

Usage: python3 doc/peers/cube_series.py; prints them as the scenes have them, and what modes 53 to 61 change.
"""
import cmath
import math

LENGTH = 0.01  # m
CAPACITY = 1000 * 4192.0  # J/(m3 K)
CONDUCTIVITY = 0.613  # W/(m K)
PERFUSION = 0.5 * 3600  # W/(m3 K)
METABOLIC_HEAT = 33800.0  # W/m3
POWER, RADIUS = 0.08, 0.0005  # W of each source, m
MIDDLE, CENTRES = 0.005, [0.003, 0.004, 0.005, 0.006, 0.007]  # m
START = 310.0  # K, of blood and surface too
TIMES = [10, 30, 60, 120]
PLACES = {"P1": 0.005, "P2": 0.006}  # x, m; y and z are the middle's


def sine(mode, x):
    return math.sin(mode * math.pi * x / LENGTH)


def coefficient(mode, centre, radius):
    """Of a Gaussian of integral 1 in one direction, cut off at the surface: 2/L int g(x) sin(mode pi x / L) dx."""
    points = 4000
    step = LENGTH / points
    total = 0.0
    for i in range(1, points):
        weight = 4 if i % 2 else 2
        total += weight * math.exp(-((i * step - centre) ** 2) / (2 * radius**2)) * sine(mode, i * step)
    return 2 / LENGTH * total * step / 3 / (radius * math.sqrt(2 * math.pi))


def amplitude(source, constant, decay, tau, time):
    """a(t) of a mode, for the coefficients of both heats (W/m3) and `decay` = w + k (W/(m3 K))."""
    steady = (source + constant) / decay
    if tau == 0:
        return steady * (1 - math.exp(-decay / CAPACITY * time))
    mean = -0.5 * (CAPACITY + tau * PERFUSION) / (tau * CAPACITY)
    root = cmath.sqrt(mean**2 - decay / (tau * CAPACITY))
    first, second = mean + root, mean - root
    # steady + c1 exp(first t) + c2 exp(second t), with the two conditions at the start
    c1 = (source / CAPACITY + second * steady) / (first - second)
    c2 = -steady - c1
    return (steady + c1 * cmath.exp(first * time) + c2 * cmath.exp(second * time)).real


def temperatures(tau, highest_mode=61, radius=RADIUS):
    """K, at the TIMES by place; tau in s."""
    modes = range(1, highest_mode + 1, 2)
    across = {mode: coefficient(mode, MIDDLE, radius) for mode in modes}
    along = {mode: POWER * sum(coefficient(mode, centre, radius) for centre in CENTRES) for mode in modes}
    even = {mode: 4 / (mode * math.pi) for mode in modes}  # of the constant 1
    result = {place: [START] * len(TIMES) for place in PLACES}
    for l in modes:
        for m in modes:
            for n in modes:
                source = across[l] * along[m] * across[n]
                constant = METABOLIC_HEAT * even[l] * even[m] * even[n]
                decay = PERFUSION + CONDUCTIVITY * (l * l + m * m + n * n) * (math.pi / LENGTH) ** 2
                shape = sine(m, MIDDLE) * sine(n, MIDDLE)
                values = [amplitude(source, constant, decay, tau, time) for time in TIMES]
                for place, x in PLACES.items():
                    for i, value in enumerate(values):
                        result[place][i] += value * shape * sine(l, x)
    return result


def expression(values):
    """In t, as `Exact values` of a study has it: the value of the output time that is nearest."""
    ends = [(first + second) / 2 for first, second in zip(TIMES, TIMES[1:])]
    parts = [f"if(t < {end:g}, {value:.6f}, " for end, value in zip(ends, values)]
    return f"if(t < 1, {START:g}, " + "".join(parts) + f"{values[-1]:.6f}" + ")" * (len(parts) + 1)


def main():
    for model, tau in (("Fourier", 0.0), ("non-Fourier", 16.0)):
        exact, fewer = temperatures(tau), temperatures(tau, 51)
        for place in PLACES:
            change = max(abs(a - b) for a, b in zip(exact[place], fewer[place]))
            print(f"{model} {place}, within {change:.1e} K: {expression(exact[place])}")


if __name__ == "__main__":
    main()
