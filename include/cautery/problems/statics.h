// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/elasticity.h>
#include <cautery/physics/large_elasticity.h>
#include <cautery/problems/body.h>
#include <cautery/time/equilibrium.h>

#include <functional>

namespace Cautery
{
  /**
   * The balance of momentum that a scene asks for, of small or of large deformation, and what finds its
   * equilibrium.
   */
  template <int dim>
  struct Statics
  {
    Statics(const Scene &scene, const Body<dim> &body, const Field<dim> &displacement, Cost &cost);

    std::unique_ptr<Elasticity<dim>>      small; ///< one of the two, or none with dynamic relaxation
    std::unique_ptr<LargeElasticity<dim>> large;
    std::unique_ptr<Equilibrium>          equilibrium; ///< none with inertia
    const BorneLoad *last_borne() const { return equilibrium ? equilibrium->last_borne() : nullptr; }
    /// see Problem
    std::function<Vector(const State &)> unbalanced_forces;
  };
} // namespace Cautery
