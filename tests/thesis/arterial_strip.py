# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arterial strip of Figure 63: every output of the run is on the closed form's curve, to 1e-8.

Usage: arterial_strip.py DIRECTORY of the run
"""
import csv
import math
import sys

MU, BULK, STIFFNESS, STIFFENING, ANGLE = 12710.0, 101680.0, 2363.2, 0.8393, 0.757298


def nominal(stretches):
    """Eqs. 7-6 to 7-12 for a diagonal F: P of the three directions, Pa."""
    lame = BULK - 2 / 3 * MU
    volume = math.log(math.prod(stretches))
    cosine, sine = math.cos(ANGLE) ** 2, math.sin(ANGLE) ** 2
    excess = max(0.0, cosine * stretches[0] ** 2 + sine * stretches[1] ** 2 - 1)
    tension = 2 * 2 * STIFFNESS * excess * math.exp(STIFFENING * excess ** 2)  # of both families
    return [MU * (s - 1 / s) + lame * volume / s + tension * part * s
            for s, part in zip(stretches, (cosine, sine, 0.0))]


def solved(function, low, high):
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (middle, high) if function(middle) < 0 else (low, middle)
    return (low + high) / 2


def curve(along):
    """Stretches across that leave the sides free, for a stretch along; and the Cauchy stress along, Pa."""
    def thick(wide):
        return solved(lambda s: nominal((along, wide, s))[2], 0.3, 2)

    wide = solved(lambda s: nominal((along, s, thick(s)))[1], 0.3, 2)
    stretches = (along, wide, thick(wide))
    return stretches, nominal(stretches)[0] * along / math.prod(stretches)


def main(directory):
    with open(directory + "/probes.csv", encoding="utf-8") as file:
        rows = [{key: float(value) for key, value in row.items() if key != "probe"} for row in csv.DictReader(file)]
    for row in rows[1:]:
        along = 1 + row["displacement_x_m"] / row["x_m"]
        stretches, stress = curve(along)
        print(f"stretch {along:.4f}: {row['stress_xx_Pa']:.3f} Pa, closed form {stress:.3f} Pa")
        assert abs(row["stress_xx_Pa"] - stress) < 1e-8 * stress
        assert abs(row["displacement_y_m"] - (stretches[1] - 1) * row["y_m"]) < 1e-10 * row["y_m"]
    assert along > 1.5


if __name__ == "__main__":
    main(sys.argv[1])
