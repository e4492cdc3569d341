// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/damage_history.h>

#include <cmath>

namespace Cautery
{
  namespace
  {
    template <int dim>
    std::vector<unsigned int> largest_tissues(const Field<dim> &nodes, const TissueMap<dim> &tissues)
    {
      std::vector<unsigned int>            result(nodes.owned().n_elements(), 0);
      std::vector<types::global_dof_index> dofs(nodes.element().n_dofs_per_cell());
      std::vector<std::vector<double>>     volumes(result.size(), std::vector<double>(tissues.size(), 0.));
      for (const auto &cell : nodes.dof_handler().active_cell_iterators())
        if (!cell->is_artificial())
          {
            cell->get_dof_indices(dofs);
            for (const auto dof : dofs)
              if (nodes.owned().is_element(dof))
                volumes[nodes.owned().index_within_set(dof)][tissues.index(cell->material_id())] +=
                  cell->measure();
          }
      // of equal volumes (but for rounding, which depends on the order of cells) the first tissue wins
      for (unsigned int node = 0; node < result.size(); ++node)
        for (unsigned int t = 1; t < tissues.size(); ++t)
          if (volumes[node][t] > volumes[node][result[node]] * (1. + 1e-9))
            result[node] = t;
      return result;
    }
  } // namespace

  template <int dim>
  DamageHistory<dim>::DamageHistory(const Scene                   &scene,
                                    const Field<dim>              &nodes,
                                    const TissueMap<dim>          &tissues,
                                    const NodalGradients<dim>     *gradients,
                                    const MechanicalRecovery<dim> *recovery)
    : law(scene.effects.damage)
    , quadrature(scene.damage.quadrature)
    , nodes(nodes)
    , tissues(tissues)
    , gradients(gradients)
    , recovery(recovery)
    , node_tissue(largest_tissues(nodes, tissues))
  {
  }

  template <int dim>
  void DamageHistory<dim>::start(State &state)
  {
    state.ln_damage = nodes.vector();
    std::fill(state.ln_damage.begin(), state.ln_damage.end(), no_damage);
    last_ln_rates = ln_rates(state);
  }

  template <int dim>
  std::vector<double> DamageHistory<dim>::strain_energies(const State &state) const
  {
    const auto fields = recovery->evaluate(state);
    return law == Effects::Damage::thermal_strain_energy ? fields.thermal_strain_energy :
                                                           fields.strain_energy;
  }

  template <int dim>
  std::vector<double> DamageHistory<dim>::heat_fluxes(const State &state) const
  {
    const auto          values = gradients->evaluate(nodes, state.temperature);
    std::vector<double> fluxes(node_tissue.size(), 0.);
    for (unsigned int p = 0; p < gradients->pieces().size(); ++p)
      {
        const auto    &piece = gradients->pieces()[p];
        Tensor<1, dim> slope;
        for (unsigned int d = 0; d < dim; ++d)
          slope[d] = values[p * dim + d];
        const double temperature = state.temperature.begin()[piece.node];
        fluxes[piece.node] +=
          piece.share * tissues.tissue(piece.tissue).thermal.conductivity.value(temperature) * slope.norm();
      }
    return fluxes;
  }

  template <int dim>
  std::vector<double> DamageHistory<dim>::ln_rates(const State &state) const
  {
    const bool by_energy = law == Effects::Damage::thermal_strain_energy ||
                           law == Effects::Damage::thermo_mechanical_strain_energy;
    const auto energies = by_energy ? strain_energies(state) : std::vector<double>();
    const auto fluxes =
      law == Effects::Damage::critical_thermal_load ? heat_fluxes(state) : std::vector<double>();
    std::vector<double> rates(node_tissue.size());
    for (unsigned int node = 0; node < rates.size(); ++node)
      {
        const Tissue &tissue      = tissues.tissue(node_tissue[node]);
        const double  temperature = state.temperature.begin()[node];
        if (law == Effects::Damage::critical_thermal_load)
          rates[node] = tissue.critical_thermal_load.ln_rate(fluxes[node]);
        else if (law == Effects::Damage::cem43)
          rates[node] = tissue.cem43.ln_rate(temperature);
        else
          rates[node] = tissue.arrhenius.ln_rate(temperature, by_energy ? energies[node] : 0.);
      }
    return rates;
  }

  template <int dim>
  double DamageHistory<dim>::ln_gain(const double ln_start, const double ln_end, const double duration) const
  {
    if (quadrature == DamageSettings::Quadrature::end_of_step)
      return ln_end + std::log(duration);
    // Fluxes may start from nothing, where an exponential would only repeat the rounding they start with.
    if (law == Effects::Damage::critical_thermal_load)
      return ln_add(ln_start, ln_end) + std::log(0.5 * duration);
    return ln_integral(ln_start, ln_end, duration);
  }

  template <int dim>
  void DamageHistory<dim>::advance(const double duration, State &state)
  {
    const auto rates = ln_rates(state);
    for (unsigned int node = 0; node < rates.size(); ++node)
      {
        double &ln_damage = state.ln_damage.begin()[node];
        ln_damage         = ln_add(ln_damage, ln_gain(last_ln_rates[node], rates[node], duration));
      }
    last_ln_rates = rates;
  }

  template class DamageHistory<2>;
  template class DamageHistory<3>;
} // namespace Cautery
