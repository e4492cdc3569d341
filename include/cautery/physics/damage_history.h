// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/mechanical_fields.h>
#include <cautery/scene/scene.h>

#include <vector>

namespace Cautery
{
  /**
   * The history of damage at every node, kept in State::ln_damage. A node where tissues meet follows the one
   * that has the largest volume there.
   */
  template <int dim>
  class DamageHistory
  {
  public:
    /** @p recovery: needed by the laws with strain energy only, else nullptr. */
    DamageHistory(const Scene                   &scene,
                  const Field<dim>              &nodes,
                  const TissueMap<dim>          &tissues,
                  const NodalGradients<dim>     *gradients,
                  const MechanicalRecovery<dim> *recovery);

    /** Sets "no damage" at the start of a run. */
    void start(State &state);

    /** Goes on from a state in the course of a run. */
    void go_on(const State &state) { last_ln_rates = ln_rates(state); }

    /** Adds the damage of the step that has just brought @p state to its time, of the length @p duration (s).
     */
    void advance(const double duration, State &state);

    void archive(Archive &archive) { archive.nodal("last ln rates", last_ln_rates); }

  private:
    double              ln_gain(const double ln_start, const double ln_end, const double duration) const;
    std::vector<double> ln_rates(const State &state) const;
    std::vector<double> strain_energies(const State &state) const;
    std::vector<double> heat_fluxes(const State &state) const;

    const Effects::Damage            law;
    const DamageSettings::Quadrature quadrature;
    const Field<dim>                &nodes;
    const TissueMap<dim>            &tissues;
    const NodalGradients<dim>       *gradients;
    const MechanicalRecovery<dim>   *recovery;
    std::vector<unsigned int>        node_tissue;
    std::vector<double>              last_ln_rates;
  };
} // namespace Cautery
