// SPDX-License-Identifier: LGPL-2.1-or-later
// A body that is let go vibrates for ten periods: its energy stays within 1e-3 of what it was, its momentum
// within rounding of nothing. The strain energy is that of the laws, summed over the cells by deal.II.
#include "large.h"

#include <cautery/physics/critical_step.h>
#include <cautery/physics/explicit_motion.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

namespace Verification
{
  namespace
  {
    class FreeBody
    {
    public:
      using Records = TledNodes<double>::Records;

      explicit FreeBody(const Scene &given)
        : scene(given)
        , body(scene, MPI_COMM_WORLD)
        , nodes(body.nodes)
        , cells(scene, body.nodes, body.tissues, nodes)
        , mass(nodes.sum(cells.masses()))
        , values(nodes.zero())
        , rates(nodes.zero())
        , forces(nodes.zero())
      {
        for (std::uint32_t node = 0; node < nodes.n_own(); ++node)
          {
            const Point<3> &place          = nodes.places()[node];
            values[node_record * node]     = 0.1 * place[0] + 0.03 * place[1];
            values[node_record * node + 1] = 0.02 * place[0] * place[2];
          }
      }

      /** Steps of @p duration (s); the half step from rest first. Returns kinetic plus strain energy, J. */
      double step(const double duration)
      {
        cells.add_forces(TledBody<double>::Part::motion, values, forces);
        const double impulse = started ? duration : 0.5 * duration;
        const double strain  = strain_energy();
        double       kinetic = 0.;
        for (std::size_t i = 0; i < rates.size(); ++i)
          {
            const double before = rates[i];
            rates[i] -= impulse * forces[i] / mass[i / node_record];
            const double now = started ? 0.5 * (before + rates[i]) : 0.;
            kinetic += 0.5 * mass[i / node_record] * now * now;
            values[i] += duration * rates[i];
            forces[i] = 0.;
          }
        started = true;
        return kinetic + strain;
      }

      /** The largest component of the momentum over the sum of its parts' sizes. */
      double momentum() const
      {
        Tensor<1, 3> sum;
        double       size = 0.;
        for (std::size_t i = 0; i < rates.size(); ++i)
          if (i % node_record < 3)
            {
              sum[i % node_record] += mass[i / node_record] * rates[i];
              size += mass[i / node_record] * std::abs(rates[i]);
            }
        return sum.norm() / size;
      }

      double stable_step()
      {
        CriticalStep<double> critical(cells, nodes, TledBody<double>::Part::motion, mass);
        return 2. / std::sqrt(critical.largest_eigenvalue(values));
      }

    private:
      double strain_energy() const
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
                  for (int c = 0; c < 3; ++c)
                    for (int d = 0; d < 3; ++d)
                      gradient(c, d) +=
                        values[node_record * nodes.local(dofs[i]) + c] * at.shape_grad(i, q)[d];
                energy += at.JxW(q) * elasticity.law(elasticity.reference_temperature())
                                        .energy(gradient, elasticity.directions(cell->center()), 0.);
              }
          }
        return energy;
      }

      const Scene         scene;
      Body<3>             body;
      TledNodes<double>   nodes;
      TledBody<double>    cells;
      std::vector<double> mass;
      Records             values, rates, forces;
      bool                started = false;
    };
  } // namespace

  void vibration(Checks &checks)
  {
    // the slowest wave crosses the unit cube and comes back in 2 / sqrt(mu / rho) s
    const double period = 2. / std::sqrt(3000. / (2. * 1.35) / 1000.);
    for (const auto &element : {elements[0], elements[2]})
      for (const auto &law : {laws[0], laws[1], laws[3]})
        {
          FreeBody     body(read_scene(
            VERIFICATION_SCENES "/large.prm",
            joined({bent_cube(element), law.overrides, {{"Effects/Deformation", "explicit dynamics"}}})));
          const double duration = 0.05 * body.stable_step(); // the energy goes up and down with its square
          const double start    = body.step(duration);
          double       largest  = 0.;
          for (double time = 0.; time < 10. * period; time += duration)
            largest = std::max(largest, std::abs(body.step(duration) / start - 1.));
          checks.below(element.name + ", " + law.name + ": change of energy", largest, 1e-3);
          checks.below(element.name + ", " + law.name + ": momentum", body.momentum(), 1e-13);
        }
  }
} // namespace Verification
