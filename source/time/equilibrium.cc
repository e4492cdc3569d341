// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/time/balance_solver.h>
#include <cautery/time/equilibrium.h>

namespace Cautery
{
  LinearEquilibrium::LinearEquilibrium(Balance &balance, Cost &cost)
    : equation(balance), cost(cost), solver(solver_of(balance))
  {
  }

  void LinearEquilibrium::solve(State &state)
  {
    Vector &x = state.*equation.unknown();
    if (!ready || equation.changes())
      {
        if (equation.changes())
          {
            const auto scope = cost.measure(equation.name() + ": assembly");
            equation.refresh(state, x);
          }
        set_matrix(x);
      }

    const bool moved = equation.stiffness().full.m() > 0; // else all prescribed values are zero
    {
      const auto scope = cost.measure(equation.name() + ": load");
      equation.load({state.time, state.time}, state, force);
      if (moved)
        {
          x = 0.;
          equation.prescribe(state.time, x);
          equation.stiffness().full.vmult(product, x);
          force -= product;
        }
      equation.elimination().condense(force);
    }
    const auto scope = cost.measure(equation.name() + ": solve");
    n_iterations += solver.solve(solution, force);
    equation.elimination().distribute(solution);
    if (moved)
      x += solution;
    else
      x = solution;
  }

  void LinearEquilibrium::set_matrix(const Vector &x)
  {
    cost.build(equation.name() + ": set-up", [&]() {
      solver.set_matrix(equation.stiffness().reduced);
      for (auto *vector : {&force, &solution, &product})
        vector->reinit(x);
    });
    ready = true;
  }

  void LinearEquilibrium::archive(Archive &archive, const State &state)
  {
    archive.shared("linear iterations", n_iterations);
    archive.shared("ready", ready);
    if (archive.restores() && ready && !equation.changes())
      set_matrix(state.*equation.unknown());
    solver.archive(archive);
  }

  std::map<std::string, double> LinearEquilibrium::statistics() const
  {
    return {{"linear_iterations_deformation", n_iterations}};
  }
} // namespace Cautery
