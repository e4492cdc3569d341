// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/nodal_gradients.h>
#include <cautery/physics/tissue_elasticity.h>
#include <cautery/scene/scene.h>
#include <cautery/space/state.h>

#include <deal.II/base/symmetric_tensor.h>

#include <vector>

namespace Cautery
{
  /** Strain, stress and strain energy density at a point. */
  template <int dim>
  struct PointMechanics
  {
    SymmetricTensor<2, dim> strain; ///< small; in large deformation Green's, E = (F'F - I) / 2
    SymmetricTensor<2, dim> stress; ///< in large deformation Cauchy's or S, as the scene says; Pa
    double strain_energy; ///< 1/2 sigma':eps without the thermal part of the stress, or 1/2 S':E (Eq. 7-49),
                          ///< J/m3
    double thermal_strain_energy; ///< 1/2 sigma:eps with it (thesis Eq. 2-4), or 1/2 S:E, J/m3
  };

  /**
   * The same at the owned nodes: strain and stress averaged over the node's cells by volume, energies from
   * the averaged strain, tissue by tissue; in large deformation all of it from the averaged gradient.
   */
  template <int dim>
  struct MechanicalFields
  {
    std::vector<SymmetricTensor<2, dim>> strain;
    std::vector<SymmetricTensor<2, dim>> stress;
    std::vector<double>                  strain_energy;
    std::vector<double>                  thermal_strain_energy;
  };

  template <int dim>
  class MechanicalRecovery
  {
  public:
    MechanicalRecovery(const Scene               &scene,
                       const NodalGradients<dim> &gradients,
                       const Field<dim>          &displacement,
                       const TissueMap<dim>      &tissues);

    MechanicalFields<dim> evaluate(const State &state) const;

  private:
    PointMechanics<dim>
    at_piece(const unsigned int piece, const Tensor<2, dim> &gradient, const State &state) const;

    const bool                          expands;
    const OutputSettings::Stress        measure;
    const NodalGradients<dim>          &gradients;
    const Field<dim>                   &displacement;
    const TissueMap<dim>               &tissues;
    std::vector<TissueElasticity>       elasticities; ///< by tissue, in large deformation only
    std::vector<ElasticLaw::Directions> directions;   ///< of fibres, by piece
  };
} // namespace Cautery
