# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures 8, 31 and 62: iterations and time against the margin of error of the linear solvers."""
from runs import Run, axes_of, finish

MARGINS = ("1e-1", "1e-2", "1e-3", "1e-4", "1e-6", "1e-8", "1e-10")
METHODS = ("Gauss-Seidel", "CG + SSOR", "CG + AMG", "direct")


def linear_model(scene, method, margin):
    """Iterations of a step for heat and deformation, and its milliseconds."""
    solvers = [f"Numerics/{what} solver/{entry}" for what in ("Heat", "Deformation") for entry in
               (f"Method={method}", f"Tolerance={margin}", "Remembered solutions=0")]
    run = Run(scene, *solvers, "Numerics/Displacement at=every step", "Output/Interval=120")
    statistics, cost = run.summary["statistics"], run.summary["cost"]
    set_up = sum(s for part, s in cost["seconds_by_part"].items() if part.endswith(": set-up"))
    steps = run.summary["time_steps"]
    iterations = [statistics.get(f"linear_iterations_{what}", 0) / steps for what in ("heat", "deformation")]
    return iterations, 1e3 * (cost["seconds_per_step"] - set_up / steps)


def nonlinear_model(scene, method, margin):
    """Newton's iterations and the linear ones of an equilibrium, and its milliseconds; the margin is Newton's."""
    run = Run(scene, "Effects/Deformation=large equilibrium", f"Numerics/Deformation solver/Method={method}",
              f"Numerics/Newton/Tolerance={margin}", "Output/Interval=0")
    parts = run.summary["cost"]["seconds_by_part"]
    seconds = sum(parts["deformation: " + part] for part in ("tangent", "residual", "solve"))
    statistics = run.summary["statistics"]
    return [statistics["newton_iterations"], statistics["linear_iterations_deformation"]], 1e3 * seconds


MODELS = {"finite differences (Figure 8)": (linear_model, "ch4_cube_fourier"),
          "finite elements (Figure 31)": (linear_model, "ch6_cube_non_fourier"),
          "large deformation (Figure 62)": (nonlinear_model, "ch7_mechanical_fibres")}


def margins():
    """Figures 8, 31 and 62: iterations of a step against the margin; the table is printed."""
    figure, axes = axes_of(3, 15)
    print("| model | margin | " + " | ".join(METHODS) + " |")
    print("|---|---|" + "---|" * len(METHODS))
    for axis, (model, (measured, scene)) in zip(axes, MODELS.items()):
        found = {method: [measured(scene, method, margin) for margin in MARGINS] for method in METHODS}
        for method in METHODS[:3]:
            linear = [i[1] + (i[0] if measured is linear_model else 0) for i, _ in found[method]]
            axis.loglog([float(m) for m in MARGINS], linear, "o-", label=method)
        axis.set(title=model, xlabel="margin of error", ylabel="linear iterations of a step")
        for row, margin in enumerate(MARGINS):
            cells = [f"{i[0]:.1f} + {i[1]:.1f}, {ms:.2f}" for i, ms in (found[m][row] for m in METHODS)]
            print(f"| {model} | {margin} | " + " | ".join(cells) + " |")
    finish(figure, axes, "margins")
