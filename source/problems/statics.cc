// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/problems/statics.h>
#include <cautery/time/newton_equilibrium.h>

namespace Cautery
{
  template <int dim>
  Statics<dim>::Statics(const Scene &scene, const Body<dim> &body, const Field<dim> &displacement, Cost &cost)
  {
    if (scene.effects.deformation == Effects::Deformation::large_equilibrium)
      {
        large = std::make_unique<LargeElasticity<dim>>(
          scene, displacement, body.nodes, body.tissues, body.boundaries, body.locator);
        equilibrium = std::make_unique<NewtonEquilibrium<dim>>(
          *large, scene.numerics.newton, scene.numerics.deformation_solver, cost);
        return;
      }
    small = std::make_unique<Elasticity<dim>>(
      scene, displacement, body.nodes, body.tissues, body.boundaries, body.locator);
    if (scene.effects.deformation == Effects::Deformation::equilibrium)
      equilibrium = std::make_unique<LinearEquilibrium>(*small, cost);
  }

  template struct Statics<2>;
  template struct Statics<3>;
} // namespace Cautery
