// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/parameters.h>
#include <cautery/physics/cell_derivatives.h>
#include <cautery/physics/mechanical_fields.h>

#include <deal.II/base/mpi.h>

#include <deal.II/fe/fe_values.h>

#include <cmath>
#include <optional>

namespace Cautery
{
  namespace
  {
    /// Of the owned nodes, m.
    template <int dim>
    std::vector<Point<3>> node_places(const Field<dim> &displacement)
    {
      const auto                          &fe = displacement.element();
      std::vector<Point<3>>                places(displacement.owned().n_elements() / dim);
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
      for (const auto &cell : displacement.dof_handler().active_cell_iterators())
        {
          if (cell->is_artificial())
            continue;
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            if (fe.system_to_component_index(i).first == 0 && displacement.owned().is_element(dofs[i]))
              places[displacement.owned().index_within_set(dofs[i]) / dim] = in_space<dim>(
                displacement.mapping().transform_unit_to_real_cell(cell, fe.unit_support_point(i)));
        }
      return places;
    }

    template <int dim>
    PointMechanics<dim> small_deformation(const Tissue         &tissue,
                                          const Tensor<2, dim> &gradient,
                                          const double          temperature,
                                          const bool            expands)
    {
      const SymmetricTensor<2, dim> strain = symmetrize(gradient);
      const Lame                    lame   = tissue.elastic.lame(temperature);
      const double                  factor = expands ? tissue.expansion.stiffness_factor(temperature) : 1.;
      const double                  thermal =
        expands ? lame.bulk_modulus() * tissue.expansion.pressure_factor(temperature) : 0.;
      const SymmetricTensor<2, dim> elastic = factor * lame.stress(strain);
      const SymmetricTensor<2, dim> stress  = elastic - thermal * unit_symmetric_tensor<dim>();
      return {strain, stress, 0.5 * (elastic * strain), 0.5 * (stress * strain)};
    }

    template <int dim>
    SymmetricTensor<2, dim> in_plane(const Matrix3<double> &matrix)
    {
      SymmetricTensor<2, dim> result;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = i; j < dim; ++j)
          result[i][j] = matrix(i, j);
      return result;
    }

    Matrix3<double> green_strain(const Matrix3<double> &h)
    {
      Matrix3<double> result;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          result(i, j) =
            0.5 * (h(i, j) + h(j, i) + h(0, i) * h(0, j) + h(1, i) * h(1, j) + h(2, i) * h(2, j));
      return result;
    }

    template <int dim>
    PointMechanics<dim> large_deformation(ElasticLaw                    law,
                                          const Matrix3<double>        &gradient,
                                          const ElasticLaw::Directions &directions,
                                          const double                  thermal_strain,
                                          const OutputSettings::Stress  measure)
    {
      const Deformation<double> deformation(gradient);
      const Matrix3<double>     strain = green_strain(gradient);
      const Matrix3<double>     first  = law.stress(gradient, directions, thermal_strain);
      const Matrix3<double>     hot    = second_piola_kirchhoff_stress(deformation, first);
      law.stretch                      = StretchForm::none;
      const Matrix3<double> cold       = law.stress(gradient, directions, 0.);
      return {
        in_plane<dim>(strain),
        in_plane<dim>(measure == OutputSettings::Stress::cauchy ? cauchy_stress(deformation, first) : hot),
        0.5 * double_dot(second_piola_kirchhoff_stress(deformation, cold), strain),
        0.5 * double_dot(hot, strain)};
    }

    template <int dim>
    void require_stress(const std::optional<unsigned int> &without,
                        const Field<dim>                  &displacement,
                        const double                       time)
    {
      const auto found = Utilities::MPI::min_max_avg(without ? 1. : 0., displacement.communicator());
      if (found.max == 0.)
        return;
      const Point<3> place =
        Utilities::MPI::broadcast(displacement.communicator(),
                                  without ? node_places(displacement)[*without] : Point<3>(),
                                  found.max_index);
      AssertThrow(false,
                  ExcRun("stress and strain energy have no value at t = " + to_short_text(time) +
                         " s at the node " + to_short_text(place) +
                         " m, around which the deformation is turned inside out; "
                         "refine the mesh there, or load the body less or in smaller steps"));
    }
  } // namespace

  template <int dim>
  MechanicalRecovery<dim>::MechanicalRecovery(const Scene               &scene,
                                              const NodalGradients<dim> &gradients,
                                              const Field<dim>          &displacement,
                                              const TissueMap<dim>      &tissues)
    : expands(scene.effects.coupling != Effects::Coupling::off)
    , measure(scene.output.stress)
    , gradients(gradients)
    , displacement(displacement)
    , tissues(tissues)
  {
    if (!scene.effects.has_large_deformation())
      return;
    for (unsigned int t = 0; t < tissues.size(); ++t)
      elasticities.emplace_back(tissues.tissue(t), expands);
    const auto places = node_places(displacement);
    for (const auto &piece : gradients.pieces())
      directions.push_back(elasticities[piece.tissue].directions(places[piece.node]));
  }

  template <int dim>
  PointMechanics<dim> MechanicalRecovery<dim>::mechanics(const unsigned int            t,
                                                         const unsigned int            node,
                                                         const Tensor<2, dim>         &gradient,
                                                         const ElasticLaw::Directions &along,
                                                         const State                  &state) const
  {
    const auto  &tissue = tissues.tissue(t);
    const double temperature =
      expands ? state.temperature.begin()[node] : tissue.expansion.reference_temperature;
    if (elasticities.empty() || elasticities[t].is_linear())
      return small_deformation(tissue, gradient, temperature, expands);
    return large_deformation<dim>(elasticities[t].law(temperature),
                                  in_space(gradient),
                                  along,
                                  elasticities[t].thermal_strain(temperature),
                                  measure);
  }

  template <int dim>
  MechanicalFields<dim> MechanicalRecovery<dim>::evaluate(const State &state) const
  {
    const auto                   values = gradients.evaluate(displacement, state.displacement);
    const auto                  &pieces = gradients.pieces();
    MechanicalFields<dim>        fields(displacement.owned().n_elements() / dim);
    const ElasticLaw::Directions none{};
    for (unsigned int p = 0; p < pieces.size(); ++p)
      {
        Tensor<2, dim> gradient;
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            gradient[c][d] = values[(p * dim + c) * dim + d];
        fields.add(
          pieces[p].node,
          pieces[p].share,
          mechanics(
            pieces[p].tissue, pieces[p].node, gradient, directions.empty() ? none : directions[p], state));
      }
    if (!elasticities.empty())
      mend(state, fields);
    return fields;
  }

  /**
   * Where the gradient, averaged over the cells around a node, is turned inside out although each of them is
   * well, no law knows a stress: there stress and energies are averages of those at the cells' centres.
   */
  template <int dim>
  void MechanicalRecovery<dim>::mend(const State &state, MechanicalFields<dim> &fields) const
  {
    std::map<unsigned int, double> volumes; // around the nodes without stress, m^dim
    for (unsigned int node = 0; node < fields.strain_energy.size(); ++node)
      if (!std::isfinite(fields.strain_energy[node]))
        volumes[node] = 0.;
    if (Utilities::MPI::max(volumes.size(), displacement.communicator()) == 0)
      return;
    const auto parts = in_cells(state, volumes);
    for (const auto &[node, volume] : volumes)
      {
        fields.stress[node]                = 0.;
        fields.strain_energy[node]         = 0.;
        fields.thermal_strain_energy[node] = 0.;
      }
    for (const auto &part : parts)
      fields.add_stress(part.node, part.volume / volumes.at(part.node), part.point);
    std::optional<unsigned int> without;
    for (const auto &[node, volume] : volumes)
      if (!std::isfinite(fields.strain_energy[node]))
        without = node;
    require_stress(without, displacement, state.time);
  }

  /// At the centres of all cells around the nodes that @p volumes has, whose volumes are added there.
  template <int dim>
  std::vector<typename MechanicalRecovery<dim>::CellPart>
  MechanicalRecovery<dim>::in_cells(const State &state, std::map<unsigned int, double> &volumes) const
  {
    const Vector  ghosted = displacement.ghosted(state.displacement);
    const auto   &fe      = displacement.element();
    FEValues<dim> at(displacement.mapping(), fe, cell_centre(displacement.mesh()), update_gradients);
    std::vector<Tensor<2, dim>>          gradient(1);
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    std::vector<CellPart>                parts;
    for (const auto &cell : displacement.dof_handler().active_cell_iterators())
      {
        if (cell->is_artificial())
          continue;
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            if (fe.system_to_component_index(i).first != 0 || !displacement.owned().is_element(dofs[i]))
              continue;
            const unsigned int node   = displacement.owned().index_within_set(dofs[i]) / dim;
            const auto         around = volumes.find(node);
            if (around == volumes.end())
              continue;
            at.reinit(cell);
            at[FEValuesExtractors::Vector(0)].get_function_gradients(ghosted, gradient);
            const unsigned int t     = tissues.index(cell->material_id());
            const auto         along = elasticities[t].directions(in_space<dim>(cell->center()));
            parts.push_back({node, cell->measure(), mechanics(t, node, gradient[0], along, state)});
            around->second += cell->measure();
          }
      }
    return parts;
  }

  template class MechanicalRecovery<2>;
  template class MechanicalRecovery<3>;
} // namespace Cautery
