// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/mechanical_fields.h>

namespace Cautery
{
  template <int dim>
  MechanicalRecovery<dim>::MechanicalRecovery(const Effects             &effects,
                                              const NodalGradients<dim> &gradients,
                                              const Field<dim>          &displacement,
                                              const TissueMap<dim>      &tissues)
    : expands(effects.coupling != Effects::Coupling::off)
    , gradients(gradients)
    , displacement(displacement)
    , tissues(tissues)
  {
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
        const auto             &piece  = pieces[p];
        const Tissue           &tissue = tissues.tissue(piece.tissue);
        SymmetricTensor<2, dim> strain;
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = c; d < dim; ++d)
            strain[c][d] = 0.5 * (values[(p * dim + c) * dim + d] + values[(p * dim + d) * dim + c]);

        const double temperature =
          expands ? state.temperature.begin()[piece.node] : tissue.expansion.reference_temperature;
        const Lame   lame   = tissue.elastic.lame(temperature);
        const double factor = expands ? tissue.expansion.stiffness_factor(temperature) : 1.;
        const double thermal =
          expands ? lame.bulk_modulus() * tissue.expansion.pressure_factor(temperature) : 0.;

        const SymmetricTensor<2, dim> elastic = factor * lame.stress(strain);
        const SymmetricTensor<2, dim> stress  = elastic - thermal * unit_symmetric_tensor<dim>();
        fields.strain[piece.node] += piece.share * strain;
        fields.stress[piece.node] += piece.share * stress;
        fields.strain_energy[piece.node] += piece.share * 0.5 * (elastic * strain);
        fields.thermal_strain_energy[piece.node] += piece.share * 0.5 * (stress * strain);
      }
    return fields;
  }

  template class MechanicalRecovery<2>;
  template class MechanicalRecovery<3>;
} // namespace Cautery
