// SPDX-License-Identifier: LGPL-2.1-or-later
// A body that is pulled and let go vibrates for ten periods: its energy stays within 1e-3 of what it was, its
// momentum within rounding. The program moves it; strain energy is that of the laws, summed over the cells by
// deal.II, velocities are what displacements change by in a step.
#include "large.h"

#include <cautery/physics/tled_body.h>
#include <cautery/problems/problem.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

namespace Verification
{
  namespace
  {
    class FreeBody
    {
    public:
      explicit FreeBody(const Scene &given)
        : scene(given)
        , body(scene, MPI_COMM_WORLD)
        , problem(make_problem(scene, body, cost))
        , nodes(body.nodes)
        , mass(nodes.sum(TledBody<double>(scene, body.nodes, body.tissues, nodes).masses()))
        , state(problem->start())
        , rates(dim * nodes.n_own(), 0.)
      {
      }

      double time() const { return state.time; }

      /** One step. Returns kinetic plus strain energy at its start, J. */
      double step()
      {
        const Cautery::Vector before = state.displacement;
        const double          from   = state.time;
        problem->step(state, scene.time.end);
        double kinetic = 0.;
        for (std::size_t i = 0; i < rates.size(); ++i)
          {
            const double last = rates[i];
            rates[i]          = (state.displacement.begin()[i] - before.begin()[i]) / (state.time - from);
            kinetic += 0.5 * mass[i / dim] * std::pow(0.5 * (last + rates[i]), 2);
          }
        return kinetic + strain_energy(before);
      }

      Tensor<1, 3> momentum() const
      {
        Tensor<1, 3> sum;
        for (std::size_t i = 0; i < rates.size(); ++i)
          sum[i % dim] += mass[i / dim] * rates[i];
        return sum;
      }

      /** The sum of the sizes of its parts. */
      double size_of_momentum() const
      {
        double sum = 0.;
        for (std::size_t i = 0; i < rates.size(); ++i)
          sum += mass[i / dim] * std::abs(rates[i]);
        return sum;
      }

    private:
      static constexpr unsigned int dim = 3;

      double strain_energy(const Cautery::Vector &displacement) const
      {
        const Field<3>     &field = body.nodes;
        const Quadrature<3> rule =
          field.mesh().simplices() ? Quadrature<3>(QGaussSimplex<3>(1)) : Quadrature<3>(QGauss<3>(2));
        FEValues<3> at(field.mapping(), field.element(), rule, update_gradients | update_JxW_values);
        std::vector<types::global_dof_index> dofs(field.element().n_dofs_per_cell());
        double                               energy = 0.;
        for (const auto &cell : field.dof_handler().active_cell_iterators())
          {
            const TissueElasticity elasticity(body.tissues[cell->material_id()], false);
            at.reinit(cell);
            cell->get_dof_indices(dofs);
            for (const unsigned int q : at.quadrature_point_indices())
              {
                Matrix3<double> gradient = {};
                for (unsigned int i = 0; i < dofs.size(); ++i)
                  for (unsigned int c = 0; c < dim; ++c)
                    for (unsigned int d = 0; d < dim; ++d)
                      gradient(c, d) +=
                        displacement.begin()[dim * nodes.local(dofs[i]) + c] * at.shape_grad(i, q)[d];
                energy += at.JxW(q) * elasticity.law(elasticity.reference_temperature())
                                        .energy(gradient, elasticity.directions(cell->center()), 0.);
              }
          }
        return energy;
      }

      const Scene                 scene;
      Cost                        cost;
      const Body<3>               body;
      std::unique_ptr<Problem<3>> problem;
      TledNodes<double>           nodes;
      std::vector<double>         mass;
      State                       state;
      std::vector<double>         rates; ///< in the middle of the last step, m/s
    };

    /// Two faces are pulled apart, and one is pushed sidewards more than the other, until t = 0.5 s.
    const std::vector<Override> let_go = {
      {"Boundaries/x0/Mechanical", "traction"},
      {"Boundaries/x0/Traction", "if(t < 0.5, -300*y, 0); 0; 0"},
      {"Boundaries/x1/Mechanical", "traction"},
      {"Boundaries/x1/Traction", "if(t < 0.5, 300*y, 0); if(t < 0.5, 20, 0); 0"},
      {"Boundaries/y0/Mechanical", "free"},
      {"Boundaries/z0/Mechanical", "free"}};
  } // namespace

  void vibration(Checks &checks)
  {
    // the slowest wave crosses the unit cube and comes back in 2 / sqrt(mu / rho) s
    const double period = 2. / std::sqrt(3000. / (2. * 1.35) / 1000.);
    const double end    = 0.5 + 10. * period;
    for (const auto &element : {elements[0], elements[2]})
      for (const auto &law : {laws[0], laws[1], laws[3]})
        {
          // short steps: the energy goes up and down with their square
          FreeBody body(read_scene(VERIFICATION_SCENES "/large.prm",
                                   joined({bent_cube(element),
                                           law.overrides,
                                           let_go,
                                           {{"Effects/Deformation", "explicit dynamics"},
                                            {"Time/End", to_text(end)},
                                            {"Time/Step", "0.0025"}}})));
          while (body.time() < 0.5025)
            body.step();
          const Tensor<1, 3> momentum = body.momentum();
          const double       size     = body.size_of_momentum();
          const double       start    = body.step();
          double             largest = 0., change = 0.;
          while (body.time() < end)
            {
              largest = std::max(largest, std::abs(body.step() / start - 1.));
              change  = std::max(change, (body.momentum() - momentum).norm() / size);
            }
          const std::string name = element.name + ", " + law.name;
          checks.holds(name + ": it vibrates", start > 1. && momentum.norm() > 0.01 * size);
          checks.below(name + ": change of energy", largest, 1e-3);
          checks.below(name + ": change of momentum", change, 1e-12);
        }
  }
} // namespace Verification
