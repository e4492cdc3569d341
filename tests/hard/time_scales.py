# SPDX-License-Identifier: LGPL-2.1-or-later
"""Case 1: delays of the flux and steps that differ by seventeen and seven orders of magnitude."""
import math

RHO_C, K, LENGTH, CELLS, AMPLITUDE = 1000 * 4192.0, 0.613, 0.01, 20, 5.0
DELAYS = (1e-14, 1e-6, 1.0, 1e3)  # s
STEPS = (1e-4, 1.0, 1e3)          # s
NUMBER = 50                       # of steps
# of the first sine on the nodes, lumped: exactly a mode of the matrices (1/s)
DECAY = K / RHO_C * (2 * CELLS / LENGTH * math.sin(math.pi / (2 * CELLS)))**2


def backward_euler(delay, step):
    """The amplitude after NUMBER steps, by the scheme's own recurrence."""
    value, rate = AMPLITUDE, 0.0
    for _ in range(NUMBER):
        rate = (delay / step * rate - DECAY * value) / (delay / step + 1 + step * DECAY)
        value += step * rate
    return value


def exact(delay, time):
    """Of tau a'' + a' + lambda a = 0 from rest."""
    root = 1 - 4 * delay * DECAY
    if root < 0:
        turn = math.sqrt(-root) / (2 * delay)
        return AMPLITUDE * math.exp(-time / (2 * delay)) * (
            math.cos(turn * time) + math.sin(turn * time) / (2 * delay * turn))
    slow = 2 * DECAY / (1 + math.sqrt(root))
    fast = (1 + math.sqrt(root)) / (2 * delay)
    return AMPLITUDE * (fast * math.exp(-slow * time) - slow * math.exp(-min(fast * time, 700))) / (fast - slow)


def check(lab):
    runs = {}
    for integrator in ("backward Euler", "IDA"):
        for step in STEPS:
            common = [f"Time/Integrator={integrator}", f"Time/Step={step}", f"Time/End={NUMBER * step}"]
            for delay in DELAYS:
                runs[integrator, step, delay] = ("slab", *common, f"Tissues/tissue/Relaxation time={delay}")
            runs[integrator, step, "Fourier"] = ("slab", *common, "Effects/Heat=Fourier")
    runs["steady"] = ("slab", "Time/Step=1000", "Time/End=50000", "Effects/Heat sources=on",
                      "Tissues/tissue/Relaxation time=1000")
    found = lab.run_all(runs)
    amplitude = lambda key: found[key].end("middle", "temperature_K") - 310
    waves = [key for key in runs if isinstance(key[2], float)]
    for integrator, reference, bound in (("backward Euler", lambda d, s: backward_euler(d, s), 1e-9),
                                         ("IDA", lambda d, s: exact(d, NUMBER * s), 1e-2)):
        mine = [key for key in waves if key[0] == integrator]
        what = "its recurrence" if integrator == "backward Euler" else "the closed form"
        lab.below(f"{integrator}, tau 1e-14 to 1e3 s, {NUMBER} steps of 1e-4 to 1e3 s: first mode (5 K) against {what}, K",
                  max(abs(amplitude(key) - reference(key[2], key[1])) for key in mine), bound)
        lab.below(f"{integrator}: hottest ever above the hottest start, K",
                  max(found[key].hottest() - 310 - AMPLITUDE for key in mine), bound)
        lab.below(f"{integrator}, tau = 1e-14 s against Fourier's model, K",
                  max(abs(amplitude((integrator, step, 1e-14)) - amplitude((integrator, step, "Fourier")))
                      for step in STEPS), bound)
    lab.below("50 steps of 1000 s, tau = 1000 s, heated: against the steady parabola, relative",
              abs(amplitude("steady") / (1e5 * LENGTH**2 / (8 * K)) - 1), 1e-6)
