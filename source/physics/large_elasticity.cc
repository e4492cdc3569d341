// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/large_elasticity.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <array>
#include <limits>

namespace Cautery
{
  Loading Loading::between(const Loading &from, const Loading &to, const double share)
  {
    if (share == 1.)
      return to;
    const auto mix = [share](Vector from, const Vector &to) {
      from.sadd(1. - share, share, to);
      return from;
    };
    return {mix(from.force, to.force),
            mix(from.prescribed, to.prescribed),
            to.temperature.size() > 0 ? mix(from.temperature, to.temperature) : Vector(),
            (1. - share) * from.heating + share * to.heating};
  }

  namespace
  {
    template <int dim>
    Quadrature<dim> rule(const Field<dim> &nodes)
    {
      if (nodes.mesh().simplices() && nodes.element().degree == 1)
        return QGaussSimplex<dim>(1);
      return nodes.cell_quadrature();
    }

    template <int dim>
    std::vector<TissueElasticity> all_elasticities(const TissueMap<dim> &tissues, const bool expands)
    {
      std::vector<TissueElasticity> result;
      for (unsigned int t = 0; t < tissues.size(); ++t)
        result.emplace_back(tissues.tissue(t), expands);
      return result;
    }

    /// dP/dH times @p weight: the column 3 k + l is how P changes with H_kl.
    using TangentColumns = std::array<Matrix3<double>, 9>;

    TangentColumns tangent_columns(const ElasticLaw             &law,
                                   const Matrix3<double>        &gradient,
                                   const ElasticLaw::Directions &directions,
                                   const double                  thermal_strain,
                                   const double                  weight)
    {
      TangentColumns columns;
      for (int k = 0; k < 9; ++k)
        {
          Matrix3<double> change = {};
          change.entries[k]      = weight;
          columns[k]             = law.stress_change(gradient, directions, thermal_strain, change);
        }
      return columns;
    }
  } // namespace

  template <int dim>
  LargeElasticity<dim>::LargeElasticity(const Scene             &scene,
                                        const Field<dim>        &displacement,
                                        const Field<dim>        &nodes,
                                        const TissueMap<dim>    &tissues,
                                        const BoundaryMap<dim>  &boundaries,
                                        const PointLocator<dim> &locator)
    : displacement(displacement)
    , nodes(nodes)
    , tissues(tissues)
    , expands(scene.effects.coupling != Effects::Coupling::off)
    , quadrature(rule(nodes))
    , elasticities(all_elasticities(tissues, expands))
    , held(scene, displacement, boundaries)
    , outer_load(scene, displacement, nodes, tissues, boundaries, locator)
  {
    held.check_held(scene);
    displacement.initialize_matrix(tangent, displacement, &held.constraints());
  }

  template <int dim>
  Loading LargeElasticity<dim>::loading(const State &state) const
  {
    Loading result{displacement.vector(), displacement.vector(), Vector()};
    outer_load.at(state.time, result.force);
    held.prescribe(state.time, result.prescribed);
    if (expands)
      result.temperature = state.temperature;
    return result;
  }

  template <int dim>
  Loading LargeElasticity<dim>::unloaded(const State &state) const
  {
    Loading result{displacement.vector(), displacement.vector(), Vector(), 0.};
    if (expands)
      result.temperature = state.temperature;
    return result;
  }

  /**
   * Calls work(cell, dofs, values, points) for each owned cell, the points of integration as @p x and
   * @p loading make them.
   */
  template <int dim>
  template <typename Work>
  void LargeElasticity<dim>::for_each_cell(const Vector &x, const Loading &loading, const Work &work) const
  {
    const auto                          &fe = displacement.element();
    FEValues<dim>                        values(nodes.mapping(),
                         nodes.element(),
                         quadrature,
                         update_values | update_gradients | update_JxW_values | update_quadrature_points);
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    std::vector<double>                  temperatures(quadrature.size());
    std::vector<MaterialPoint>           points(quadrature.size());
    const Vector                         ghosted = displacement.ghosted(x);
    const Vector temperature_field               = expands ? nodes.ghosted(loading.temperature) : Vector();
    const bool   at_centre                       = nodes.element().degree == 1;

    auto node_cell = nodes.dof_handler().begin_active();
    for (const auto &cell : displacement.dof_handler().active_cell_iterators())
      {
        if (cell->is_locally_owned())
          {
            const TissueElasticity &elasticity = elasticities[tissues.index(cell->material_id())];
            values.reinit(node_cell);
            cell->get_dof_indices(dofs);
            if (expands)
              values.get_function_values(temperature_field, temperatures);
            for (const unsigned int q : values.quadrature_point_indices())
              {
                Tensor<2, dim> gradient;
                for (unsigned int i = 0; i < dofs.size(); ++i)
                  {
                    const auto [component, node] = fe.system_to_component_index(i);
                    gradient[component] += ghosted(dofs[i]) * values.shape_grad(node, q);
                  }
                const double temperature = expands ? temperatures[q] : elasticity.reference_temperature();
                points[q].can_invert     = !elasticity.is_linear();
                points[q].law            = elasticity.law(temperature);
                points[q].directions     = elasticity.directions(
                  in_space<dim>(at_centre ? cell->center() : values.quadrature_point(q)));
                points[q].gradient = in_space(gradient);
                points[q].thermal_strain =
                  expands ? loading.heating * elasticity.thermal_strain(temperature) : 0.;
              }
            work(cell, dofs, values, points);
          }
        ++node_cell;
      }
  }

  template <int dim>
  std::optional<InvertedCell>
  LargeElasticity<dim>::add_inner_forces(const Vector &x, const Loading &loading, Vector &forces) const
  {
    const auto                 &fe = displacement.element();
    dealii::Vector<double>      local(fe.n_dofs_per_cell());
    std::optional<InvertedCell> inverted;
    for_each_cell(
      x, loading, [&](const auto &cell, const auto &dofs, const auto &values, const auto &points) {
        local = 0.;
        for (const unsigned int q : values.quadrature_point_indices())
          {
            const MaterialPoint &at       = points[q];
            const double         jacobian = Deformation<double>(at.gradient).jacobian;
            if (at.can_invert && !(jacobian > 0.) && !(inverted && jacobian >= inverted->jacobian))
              inverted = {cell_number<dim>(cell), in_space<dim>(cell->center()), jacobian};
            const auto stress = at.law.stress(at.gradient, at.directions, at.thermal_strain);
            for (unsigned int i = 0; i < local.size(); ++i)
              {
                const auto [component, node] = fe.system_to_component_index(i);
                for (unsigned int d = 0; d < dim; ++d)
                  local(i) += stress(component, d) * values.shape_grad(node, q)[d] * values.JxW(q);
              }
          }
        forces.add(dofs, local);
      });
    forces.compress(VectorOperation::add);
    return inverted;
  }

  template <int dim>
  std::optional<InvertedCell>
  LargeElasticity<dim>::find_residual(const Vector &x, const Loading &loading, Vector &residual) const
  {
    residual            = 0.;
    const auto inverted = add_inner_forces(x, loading, residual);
    inner_force_norm    = residual.l2_norm();
    residual -= loading.force;
    held.elimination().condense(residual);
    return worst_of_all(inverted, nodes.communicator());
  }

  template <int dim>
  Vector LargeElasticity<dim>::unbalanced_forces(const Vector &x, const Loading &loading) const
  {
    Vector result = displacement.vector();
    add_inner_forces(x, loading, result);
    result -= loading.force;
    displacement.hanging().condense(result);
    return result;
  }

  template <int dim>
  const SparseMatrix &LargeElasticity<dim>::find_tangent(const Vector  &x,
                                                         const Loading &loading,
                                                         const Vector  &moves,
                                                         Vector        &forces)
  {
    const auto            &fe = displacement.element();
    const unsigned int     n  = fe.n_dofs_per_cell();
    FullMatrix<double>     local(n, n);
    dealii::Vector<double> local_moves(n), local_forces(n);
    const bool             moving    = moves.size() > 0;
    const Vector           all_moves = moving ? displacement.ghosted(moves) : Vector();
    tangent                          = 0.;
    forces                           = 0.;
    for_each_cell(x, loading, [&](const auto &, const auto &dofs, const auto &values, const auto &points) {
      local = 0.;
      for (const unsigned int q : values.quadrature_point_indices())
        {
          const MaterialPoint &at = points[q];
          const auto           columns =
            tangent_columns(at.law, at.gradient, at.directions, at.thermal_strain, values.JxW(q));
          for (unsigned int j = 0; j < n; ++j)
            {
              const auto [cj, nj] = fe.system_to_component_index(j);
              const auto    &g_j  = values.shape_grad(nj, q);
              Tensor<2, dim> change; // of P with unknown j
              for (unsigned int l = 0; l < dim; ++l)
                for (unsigned int c = 0; c < dim; ++c)
                  for (unsigned int d = 0; d < dim; ++d)
                    change[c][d] += columns[3 * cj + l](c, d) * g_j[l];
              for (unsigned int i = 0; i < n; ++i)
                {
                  const auto [ci, ni] = fe.system_to_component_index(i);
                  local(i, j) += change[ci] * values.shape_grad(ni, q);
                }
            }
        }
      held.constraints().distribute_local_to_global(local, dofs, tangent);
      if (!moving)
        return;
      for (unsigned int i = 0; i < n; ++i)
        local_moves(i) = all_moves(dofs[i]);
      local.vmult(local_forces, local_moves);
      forces.add(dofs, local_forces);
    });
    tangent.compress(VectorOperation::add);
    forces.compress(VectorOperation::add);
    held.elimination().condense(forces);
    return tangent;
  }

  template class LargeElasticity<2>;
  template class LargeElasticity<3>;
} // namespace Cautery
