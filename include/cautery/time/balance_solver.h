// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/balance.h>
#include <cautery/solve/linear_solver.h>

namespace Cautery
{
  /** Solves with matrices of @p balance, which must live as long, in the way that it asks for. */
  inline LinearSolver solver_of(const Balance &balance)
  {
    return LinearSolver(
      balance.solver_settings(),
      balance.n_components(),
      [&balance]() { return balance.near_null_space(); },
      balance.kept_unknowns());
  }
} // namespace Cautery
