# SPDX-License-Identifier: LGPL-2.1-or-later
"""A block of neo-Hookean tissue with fibres along x that is stretched along the axes (theory.md, Large deformation)."""
import math

E, NU = 3000.0, 0.4  # of block.prm
MU, LAMBDA = E / (2 * (1 + NU)), E * NU / ((1 + NU) * (1 - 2 * NU))


def nominal(along, volume, fibres=(0.0, 1.0)):
    """P along an axis whose stretch is `along`, in Pa; fibres: k_1 in Pa and k_2, in tension only."""
    stiffness, stiffening = fibres
    excess = max(0.0, along * along - 1)
    return (MU * along + (LAMBDA * math.log(volume) - MU) / along
            + 2 * stiffness * excess * math.exp(stiffening * excess**2) * along)


def free_sides(along):
    """The stretch across at which the sides bear no traction."""
    low, high = 0.05, 5.0
    for _ in range(200):
        middle = 0.5 * (low + high)
        if nominal(middle, along * middle**2) > 0:
            high = middle
        else:
            low = middle
    return 0.5 * (low + high)


def cauchy(along, across, fibres=(0.0, 1.0)):
    volume = along * across**2
    return nominal(along, volume, fibres) * along / volume
