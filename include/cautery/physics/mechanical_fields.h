// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/nodal_gradients.h>
#include <cautery/physics/tissue_elasticity.h>
#include <cautery/scene/scene.h>
#include <cautery/space/state.h>

#include <deal.II/base/symmetric_tensor.h>

#include <map>
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
    explicit MechanicalFields(const unsigned int n_nodes)
      : strain(n_nodes), stress(n_nodes), strain_energy(n_nodes, 0.), thermal_strain_energy(n_nodes, 0.)
    {
    }

    void add(const unsigned int node, const double share, const PointMechanics<dim> &point)
    {
      strain[node] += share * point.strain;
      add_stress(node, share, point);
    }

    /** And energies. */
    void add_stress(const unsigned int node, const double share, const PointMechanics<dim> &point)
    {
      stress[node] += share * point.stress;
      strain_energy[node] += share * point.strain_energy;
      thermal_strain_energy[node] += share * point.thermal_strain_energy;
    }

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
    PointMechanics<dim> mechanics(const unsigned int            tissue,
                                  const unsigned int            node,
                                  const Tensor<2, dim>         &gradient,
                                  const ElasticLaw::Directions &along,
                                  const State                  &state) const;
    /// What a cell gives to one of its nodes.
    struct CellPart
    {
      unsigned int        node;
      double              volume; ///< m^dim
      PointMechanics<dim> point;
    };

    void                  mend(const State &state, MechanicalFields<dim> &fields) const;
    std::vector<CellPart> in_cells(const State &state, std::map<unsigned int, double> &volumes) const;

    const bool                          expands;
    const OutputSettings::Stress        measure;
    const NodalGradients<dim>          &gradients;
    const Field<dim>                   &displacement;
    const TissueMap<dim>               &tissues;
    std::vector<TissueElasticity>       elasticities; ///< by tissue, in large deformation only
    std::vector<ElasticLaw::Directions> directions;   ///< of fibres, by piece
  };
} // namespace Cautery
