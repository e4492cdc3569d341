// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/nodal_gradients.h>
#include <cautery/scene/effects.h>
#include <cautery/space/state.h>

#include <deal.II/base/symmetric_tensor.h>

#include <vector>

namespace Cautery
{
  /**
   * Strain, stress and strain energy density at the owned nodes: strain and stress averaged over the node's
   * cells by volume, energies from the averaged strain, tissue by tissue.
   */
  template <int dim>
  struct MechanicalFields
  {
    std::vector<SymmetricTensor<2, dim>> strain;
    std::vector<SymmetricTensor<2, dim>> stress; ///< Pa
    std::vector<double> strain_energy; ///< 1/2 sigma':eps without the thermal part of the stress, J/m3
    std::vector<double> thermal_strain_energy; ///< 1/2 sigma:eps with it (thesis Eq. 2-4), J/m3
  };

  template <int dim>
  class MechanicalRecovery
  {
  public:
    MechanicalRecovery(const Effects             &effects,
                       const NodalGradients<dim> &gradients,
                       const Field<dim>          &displacement,
                       const TissueMap<dim>      &tissues);

    MechanicalFields<dim> evaluate(const State &state) const;

  private:
    const bool                 expands;
    const NodalGradients<dim> &gradients;
    const Field<dim>          &displacement;
    const TissueMap<dim>      &tissues;
  };
} // namespace Cautery
