// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/heat_cell.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Cautery
{
  template <int dim>
  HeatCellTerms<dim>::HeatCellTerms(const Scene &scene, const Field<dim> &field)
    : dofs(field.element().n_dofs_per_cell())
    , capacity(dofs.size(), dofs.size())
    , capacity_excess(dofs.size(), dofs.size())
    , exchange(dofs.size(), dofs.size())
    , conduction(dofs.size(), dofs.size())
    , blood_weights(dofs.size())
    , blood_source(dofs.size())
    , surface_weights(dofs.size())
    , metabolism(dofs.size())
    , metabolism_growth(dofs.size())
    , effects(scene.effects)
    , values(field.mapping(),
             field.element(),
             field.cell_quadrature(),
             update_values | update_gradients | update_JxW_values)
    , face_values(field.mapping(),
                  field.element(),
                  field.face_quadrature(),
                  update_values | update_quadrature_points | update_JxW_values)
    , temperature_before(values.n_quadrature_points)
    , temperature_now(values.n_quadrature_points)
    , ln_damage(dofs.size())
  {
  }

  template <int dim>
  void HeatCellTerms<dim>::reinit(const typename DoFHandler<dim>::active_cell_iterator &cell,
                                  const Vector                                         *before,
                                  const Vector                                         *now,
                                  const Vector                                         *damage)
  {
    values.reinit(cell);
    cell->get_dof_indices(dofs);
    if (before != nullptr)
      {
        values.get_function_values(*before, temperature_before);
        values.get_function_values(*now, temperature_now);
      }
    if (damage != nullptr)
      cell->get_dof_values(*damage, ln_damage.begin(), ln_damage.end());
    for (auto *matrix : {&capacity, &capacity_excess, &exchange, &conduction})
      *matrix = 0.;
    for (auto *vector : {&blood_weights, &blood_source, &surface_weights, &metabolism, &metabolism_growth})
      *vector = 0.;
  }

  template <int dim>
  double HeatCellTerms<dim>::living_share(const unsigned int q) const
  {
    if (!effects.perfusion_stops_in_dead_tissue)
      return 1.;
    double share = 0.;
    for (const unsigned int i : values.dof_indices())
      share += ln_damage[i] < 0. ? values.shape_value(i, q) : 0.;
    return std::clamp(share, 0., 1.); // quadratic shape functions are negative in places
  }

  template <int dim>
  void HeatCellTerms<dim>::add_volume(const Tissue &tissue)
  {
    const double w = effects.perfusion ? tissue.perfusion.coefficient() : 0.;
    for (const unsigned int q : values.quadrature_point_indices())
      {
        const double before = temperature_before[q];
        const double now    = temperature_now[q];
        // the mean heat capacity between both temperatures stores exactly the difference of enthalpy; a
        // constant one must not depend on them by rounding
        const double heat_capacity =
          tissue.thermal.specific_heat.is_constant() || std::abs(now - before) < 1e-6 ?
            tissue.thermal.heat_capacity(now) :
            tissue.thermal.density * tissue.thermal.specific_heat.integral(before, now) / (now - before);
        const double excess =
          tissue.thermal.specific_heat.is_constant() ? 0. : tissue.thermal.heat_capacity(now) - heat_capacity;
        const double k         = tissue.thermal.conductivity.value(now);
        const double perfusion = w * living_share(q);
        for (const unsigned int i : values.dof_indices())
          {
            const double weight = values.shape_value(i, q) * values.JxW(q);
            blood_weights(i) += perfusion * weight;
            for (const unsigned int j : values.dof_indices())
              {
                const double product = weight * values.shape_value(j, q);
                capacity(i, j) += heat_capacity * product;
                capacity_excess(i, j) += excess * product;
                exchange(i, j) += perfusion * product;
                conduction(i, j) += k * (values.shape_grad(i, q) * values.shape_grad(j, q)) * values.JxW(q);
              }
          }
      }
    blood_source.add(tissue.perfusion.temperature, blood_weights);
  }

  template <int dim>
  void HeatCellTerms<dim>::add_metabolism(const Tissue &tissue)
  {
    if (effects.metabolism == Effects::Metabolism::off)
      return;
    const bool grows = effects.metabolism == Effects::Metabolism::q10;
    for (const unsigned int q : values.quadrature_point_indices())
      {
        const double heat   = grows ? tissue.metabolism.q10_heat(temperature_now[q]) : tissue.metabolism.heat;
        const double growth = grows ? heat - tissue.metabolism.q10_heat(temperature_before[q]) : 0.;
        for (const unsigned int i : values.dof_indices())
          {
            const double weight = values.shape_value(i, q) * values.JxW(q);
            metabolism(i) += heat * weight;
            metabolism_growth(i) += growth * weight;
          }
      }
  }

  template <int dim>
  void HeatCellTerms<dim>::add_surfaces(const typename DoFHandler<dim>::active_cell_iterator &cell,
                                        const BoundaryMap<dim>                               &boundaries)
  {
    for (const unsigned int face : cell->face_indices())
      {
        if (!cell->face(face)->at_boundary())
          continue;
        const Boundary &boundary = boundaries[cell->face(face)->boundary_id()];
        if (boundary.thermal != Boundary::Thermal::convection)
          continue;
        face_values.reinit(cell, face);
        for (const unsigned int q : face_values.quadrature_point_indices())
          {
            const double transfer =
              boundary.transfer_coefficient.value(in_space<dim>(face_values.quadrature_point(q)), 0.);
            for (const unsigned int i : face_values.dof_indices())
              {
                const double weight = transfer * face_values.shape_value(i, q) * face_values.JxW(q);
                surface_weights(i) += weight;
                for (const unsigned int j : face_values.dof_indices())
                  exchange(i, j) += weight * face_values.shape_value(j, q);
              }
          }
      }
  }

  template <int dim>
  void HeatCellTerms<dim>::lump()
  {
    for (auto *matrix : {&capacity, &capacity_excess, &exchange})
      for (unsigned int i = 0; i < dofs.size(); ++i)
        {
          double sum = 0.;
          for (unsigned int j = 0; j < dofs.size(); ++j)
            sum += std::exchange((*matrix)(i, j), 0.);
          (*matrix)(i, i) = sum;
        }
  }

  template class HeatCellTerms<2>;
  template class HeatCellTerms<3>;
} // namespace Cautery
