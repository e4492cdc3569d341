// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/cost.h>
#include <cautery/physics/balance.h>
#include <cautery/solve/linear_solver.h>

namespace Cautery
{
  /**
   * K x = F: a balance without rates, solved for the time of the state.
   */
  class Equilibrium
  {
  public:
    Equilibrium(Balance &balance, Cost &cost);

    /** Errors: ExcRun where the linear solver fails. */
    void solve(State &state);

    unsigned int iterations() const { return n_iterations; }

  private:
    Balance     &equation;
    Cost        &cost;
    LinearSolver solver;
    Vector       force, solution, product;
    bool         ready        = false;
    unsigned int n_iterations = 0;
  };
} // namespace Cautery
