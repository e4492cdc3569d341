// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/scene/numerics.h>

namespace Cautery
{
  void LinearSolverSettings::parameters(Parameters &p)
  {
    p.entry(
      "Method",
      method,
      Choices<Method>{{"automatic", Method::automatic},
                      {"direct", Method::direct},
                      {"CG + SSOR", Method::cg_ssor},
                      {"CG + AMG", Method::cg_amg},
                      {"Gauss-Seidel", Method::gauss_seidel}},
      "How the linear systems are solved; automatic: by size. Gauss-Seidel is the thesis's, its margin of "
      "error is Tolerance: next to always the slowest");
    p.entry(
      "Tolerance",
      tolerance,
      "",
      "Euclidean norm of the residual, relative to that of the largest right-hand side of the run so far; "
      "1e-8 keeps temperature rises and displacements within 1e-7",
      Bounds::between_open(0., 1.));
    p.entry("Largest number of iterations",
            max_iterations,
            "After which the run fails",
            Bounds{1., 1e9, false, false});
    p.entry("Remembered solutions",
            guesses,
            "Earlier solutions that the initial guess is combined from",
            Bounds::between(0, 200));
  }

  void Numerics::parameters(Parameters &p)
  {
    p.entry("Method",
            method,
            Choices<Method>{{"finite elements", Method::finite_elements},
                            {"finite differences", Method::finite_differences}},
            "Finite differences, on the grid of a box of hexahedra, couple fewer nodes");
    p.entry("Element degree", degree, "Polynomial degree of the finite elements", Bounds::between(1, 2));
    p.entry(
      "Capacity matrix",
      capacity_matrix,
      Choices<CapacityMatrix>{{"consistent", CapacityMatrix::consistent}, {"lumped", CapacityMatrix::lumped}},
      "Lumped (degree 1 only) keeps temperatures from undershooting near point sources");
    p.entry(
      "Temperature limiter",
      temperature_limiter,
      "After each step of backward Euler, lift nodes that are colder than all data (initial, prescribed, "
      "ambient, blood) by heat from warmer ones; degree 1 only");
    p.entry(
      "Mean dilatation",
      mean_dilatation,
      "Against locking where Poisson's ratio is near 0.5: hexahedra and quadrilaterals of degree 1 resist "
      "only the mean change of their volume; small deformation");
    p.entry("Displacement at",
            displacement_at,
            Choices<DisplacementAt>{{"automatic", DisplacementAt::automatic},
                                    {"every step", DisplacementAt::every_step},
                                    {"output times", DisplacementAt::output_times}},
            "When a displacement in equilibrium is solved for; automatic: at every step only if an effect "
            "needs it");
    p.entry("Iteration tolerance",
            iteration_tolerance,
            "K",
            "Change of temperature at which the iteration for temperature-dependent terms ends",
            Bounds::positive());
    p.entry("Largest number of nonlinear iterations",
            max_iterations,
            "Per step, after which the run fails",
            Bounds{1., 1e6, false, false});
    p.entry(
      "Kept nodes",
      kept_nodes,
      "Nodes that the linear systems are condensed to: `inside` (all but the body's surface), `probes` (of "
      "the cells around them), regions; empty: all. The answer is the same; see doc/performance.md for what "
      "it costs");
    p.section("Heat solver", [&]() { heat_solver.parameters(p); });
    p.section("Deformation solver", [&]() { deformation_solver.parameters(p); });
    p.entry(
      "Large equilibrium",
      large_equilibrium,
      Choices<LargeEquilibrium>{{"Newton", LargeEquilibrium::newton},
                                {"dynamic relaxation", LargeEquilibrium::relaxation}},
      "How equilibrium in large deformation is found: with matrices, or by a damped motion without any");
    p.section("Newton", [&]() { newton.parameters(p); });
    p.section("Relaxation", [&]() { relaxation.parameters(p); });
    p.section("Explicit", [&]() { explicit_steps.parameters(p); });
  }

  void TimeSettings::parameters(Parameters &p)
  {
    p.entry("End", end, "s", "Duration of the run", Bounds::positive());
    p.entry("Integrator",
            integrator,
            Choices<Integrator>{{"backward Euler", Integrator::backward_euler},
                                {"IDA", Integrator::ida},
                                {"explicit", Integrator::explicit_steps}},
            "Of heat: fixed steps, SUNDIALS IDA with variable order and step, or explicit steps without any "
            "matrix");
    p.entry("Step",
            step,
            "s",
            "Step of backward Euler, and of what looks at the state: damage, the balance of heat, a source's "
            "schedule; explicit steps divide it; shortened to meet an output time",
            Bounds::positive());
    p.entry(
      "Relative tolerance", relative_tolerance, "", "Of IDA's local error", Bounds::between_open(0., 1.));
    p.entry("Absolute tolerance", absolute_tolerance, "K", "Of IDA's local error", Bounds::positive());
    p.entry("Largest number of steps", max_steps, "After which the run fails", Bounds{1., 4e9, false, false});
  }
} // namespace Cautery
