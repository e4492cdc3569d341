// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/mechanical_fields.h>

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
  PointMechanics<dim> MechanicalRecovery<dim>::at_piece(const unsigned int    p,
                                                        const Tensor<2, dim> &gradient,
                                                        const State          &state) const
  {
    const auto  &piece  = gradients.pieces()[p];
    const auto  &tissue = tissues.tissue(piece.tissue);
    const double temperature =
      expands ? state.temperature.begin()[piece.node] : tissue.expansion.reference_temperature;
    if (elasticities.empty() || elasticities[piece.tissue].is_linear())
      return small_deformation(tissue, gradient, temperature, expands);
    return large_deformation<dim>(elasticities[piece.tissue].law(temperature),
                                  in_space(gradient),
                                  directions[p],
                                  elasticities[piece.tissue].thermal_strain(temperature),
                                  measure);
  }

  template <int dim>
  MechanicalFields<dim> MechanicalRecovery<dim>::evaluate(const State &state) const
  {
    const auto            values  = gradients.evaluate(displacement, state.displacement);
    const auto           &pieces  = gradients.pieces();
    const unsigned int    n_nodes = displacement.owned().n_elements() / dim;
    MechanicalFields<dim> fields;
    fields.strain.resize(n_nodes);
    fields.stress.resize(n_nodes);
    fields.strain_energy.assign(n_nodes, 0.);
    fields.thermal_strain_energy.assign(n_nodes, 0.);

    for (unsigned int p = 0; p < pieces.size(); ++p)
      {
        Tensor<2, dim> gradient;
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            gradient[c][d] = values[(p * dim + c) * dim + d];
        const auto   point = at_piece(p, gradient, state);
        const auto   node  = pieces[p].node;
        const double share = pieces[p].share;
        fields.strain[node] += share * point.strain;
        fields.stress[node] += share * point.stress;
        fields.strain_energy[node] += share * point.strain_energy;
        fields.thermal_strain_energy[node] += share * point.thermal_strain_energy;
      }
    return fields;
  }

  template class MechanicalRecovery<2>;
  template class MechanicalRecovery<3>;
} // namespace Cautery
