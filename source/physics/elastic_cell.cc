// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/elastic_cell.h>

#include <algorithm>

namespace Cautery
{
  template <int dim>
  ElasticCellTerms<dim>::ElasticCellTerms(const Field<dim> &displacement,
                                          const Field<dim> &nodes,
                                          const bool        mean_dilatation)
    : dofs(displacement.element().n_dofs_per_cell())
    , stiffness(dofs.size(), dofs.size())
    , mass(dofs.size(), dofs.size())
    , thermal_load(dofs.size())
    , element(displacement.element())
    , nodes(nodes)
    , values(nodes.mapping(),
             nodes.element(),
             nodes.cell_quadrature(),
             update_values | update_gradients | update_JxW_values)
    , dilatation(mean_dilatation)
    , temperatures(values.n_quadrature_points)
  {
  }

  template <int dim>
  void ElasticCellTerms<dim>::reinit(const typename DoFHandler<dim>::active_cell_iterator &cell,
                                     const Tissue                                         &tissue,
                                     const Vector                                         *temperature)
  {
    values.reinit(nodes.cell(cell));
    dilatation.reinit(values);
    cell->get_dof_indices(dofs);
    if (temperature != nullptr)
      values.get_function_values(*temperature, temperatures);
    else
      std::fill(temperatures.begin(), temperatures.end(), tissue.expansion.reference_temperature);
    stiffness    = 0.;
    mass         = 0.;
    thermal_load = 0.;
  }

  template <int dim>
  void ElasticCellTerms<dim>::add_stiffness(const Tissue &tissue)
  {
    for (const unsigned int q : values.quadrature_point_indices())
      {
        Lame         lame     = tissue.elastic.lame(temperatures[q]);
        const double pressure = lame.bulk_modulus() * tissue.expansion.pressure_factor(temperatures[q]);
        const double weight   = tissue.expansion.stiffness_factor(temperatures[q]) * values.JxW(q);
        lame.lambda *= weight;
        lame.mu *= weight;
        for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            const auto [ci, ni]       = element.system_to_component_index(i);
            const Tensor<1, dim> &g_i = values.shape_grad(ni, q);
            const double          d_i = dilatation.gradient(values, ni, q)[ci];
            thermal_load(i) += pressure * d_i * values.JxW(q);
            for (unsigned int j = 0; j < dofs.size(); ++j)
              {
                const auto [cj, nj]       = element.system_to_component_index(j);
                const Tensor<1, dim> &g_j = values.shape_grad(nj, q);
                stiffness(i, j) +=
                  lame.lambda * d_i * dilatation.gradient(values, nj, q)[cj] + lame.mu * g_i[cj] * g_j[ci];
                if (ci == cj)
                  stiffness(i, j) += lame.mu * (g_i * g_j);
              }
          }
      }
  }

  template <int dim>
  void ElasticCellTerms<dim>::add_mass(const Tissue &tissue)
  {
    for (const unsigned int q : values.quadrature_point_indices())
      for (unsigned int i = 0; i < dofs.size(); ++i)
        {
          const auto [ci, ni] = element.system_to_component_index(i);
          const double weight = tissue.thermal.density * values.shape_value(ni, q) * values.JxW(q);
          for (unsigned int j = 0; j < dofs.size(); ++j)
            if (const auto [cj, nj] = element.system_to_component_index(j); ci == cj)
              mass(i, j) += weight * values.shape_value(nj, q);
        }
  }

  template class ElasticCellTerms<2>;
  template class ElasticCellTerms<3>;
} // namespace Cautery
