# SPDX-License-Identifier: LGPL-2.1-or-later
"""The inner force at the node of chapter 7's cube that is pulled (Figure 69), from the motion of that node."""

PULL = 0.325  # N
DAMPING = 2500.0  # 1/s
MASS = 1000.0 * 0.0125 ** 3 / 2  # kg; half a cell's: of the 24 tetrahedra around a node 12 lie within the body


def inner_force(times, displacements):
    """What Eq. 7-50 leaves of the pull at each time but the first and the last: m u'' + m zeta u' = pull - inner force, N."""
    forces = []
    for before, now, after, start, end in zip(displacements, displacements[1:], displacements[2:], times, times[2:]):
        step = (end - start) / 2
        acceleration, velocity = (after - 2 * now + before) / step ** 2, (after - before) / (2 * step)
        forces.append(PULL - MASS * (acceleration + DAMPING * velocity))
    return times[1:-1], forces
