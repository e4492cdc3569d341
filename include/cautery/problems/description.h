// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/problems/problem.h>

#include <string>

namespace Cautery
{
  /** What a run is going to do: effects, mesh, unknowns, memory, steps. Collective. */
  template <int dim>
  std::string description(const Scene &scene, const Body<dim> &body, const Problem<dim> &problem);
} // namespace Cautery
