// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/problems/statics.h>
#include <cautery/time/dynamic_relaxation.h>
#include <cautery/time/newton_equilibrium.h>

namespace Cautery
{
  namespace
  {
    /** Dynamic relaxation and all that it works on. */
    class RelaxedBody : public Equilibrium
    {
    public:
      RelaxedBody(const Scene &scene, const Body<3> &body, const Field<3> &displacement, Cost &cost)
        : field(displacement)
        , nodes(body.nodes)
        , cells(scene, body.nodes, body.tissues, nodes)
        , supports(scene, displacement, body.boundaries)
        , load(scene, displacement, body.nodes, body.tissues, body.boundaries, body.locator)
        , relaxation(scene, cells, nodes, supports, load, cost)
      {
        supports.check_held(scene);
      }

      void solve(State &state) override { relaxation.solve(state); }
      void archive(Archive &archive, const State &state) override { relaxation.archive(archive, state); }
      std::map<std::string, double> statistics() const override { return relaxation.statistics(); }
      Vector                        unbalanced_forces(const State &state)
      {
        return Cautery::unbalanced_forces(cells, nodes, load, field, state);
      }

    private:
      const Field<3>   &field;
      TledNodes<double> nodes;
      TledBody<double>  cells;
      Supports<3>       supports;
      OuterLoad<3>      load;
      DynamicRelaxation relaxation;
    };
  } // namespace

  template <int dim>
  Statics<dim>::Statics(const Scene &scene, const Body<dim> &body, const Field<dim> &displacement, Cost &cost)
  {
    if (scene.effects.deformation == Effects::Deformation::large_equilibrium)
      {
        if constexpr (dim == 3)
          if (scene.numerics.large_equilibrium == Numerics::LargeEquilibrium::relaxation)
            {
              auto relaxed      = std::make_unique<RelaxedBody>(scene, body, displacement, cost);
              unbalanced_forces = [&relaxed = *relaxed](const State &state) {
                return relaxed.unbalanced_forces(state);
              };
              equilibrium = std::move(relaxed);
              return;
            }
        large = std::make_unique<LargeElasticity<dim>>(
          scene, displacement, body.nodes, body.tissues, body.boundaries, body.locator);
        equilibrium = std::make_unique<NewtonEquilibrium<dim>>(
          *large, scene.numerics.newton, scene.numerics.deformation_solver, cost);
        unbalanced_forces = [&large = *large](const State &state) {
          return large.unbalanced_forces(state.displacement, large.loading(state));
        };
        return;
      }
    small = std::make_unique<Elasticity<dim>>(
      scene, displacement, body.nodes, body.tissues, body.boundaries, body.locator);
    if (scene.effects.deformation == Effects::Deformation::equilibrium)
      equilibrium = std::make_unique<LinearEquilibrium>(*small, cost);
    unbalanced_forces = [&small = *small](const State &state) { return small.unbalanced_forces(state); };
  }

  template struct Statics<2>;
  template struct Statics<3>;
} // namespace Cautery
