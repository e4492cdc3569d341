// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/parameters.h>

#include <cmath>
#include <limits>

namespace Cautery
{
  /**
   * Every measure of damage is scaled so that tissue is dead at Omega >= 1, and kept as ln(Omega): Omega
   * itself reaches 1e72 in the thesis's second tissue. A law gives ln(dOmega/dt), with dOmega/dt in 1/s;
   * -infinity is no damage.
   */
  constexpr double no_damage = -std::numeric_limits<double>::infinity();

  /**
   * dOmega/dt = A exp(-(Delta E - V_mol W) / (R T)) (thesis Eq. 2-2 with W = 0; Eqs. 2-3 and 5-7 with the
   * strain energy density W).
   */
  struct Arrhenius
  {
    double frequency_factor  = 1.98e106; ///< A, 1/s
    double activation_energy = 667000.;  ///< Delta E, J/mol
    double molar_volume      = 0.285;    ///< V_mol, m3/mol

    static constexpr double gas_constant = 8.314; ///< J/(mol K), thesis Table 4

    /** @p temperature in K, @p strain_energy in J/m3. */
    double ln_rate(const double temperature, const double strain_energy) const
    {
      if (temperature <= 0.)
        return no_damage;
      return std::log(frequency_factor) -
             (activation_energy - molar_volume * strain_energy) / (gas_constant * temperature);
    }

    void parameters(Parameters &p);
  };

  /**
   * Cumulative equivalent minutes at 43 degrees Celsius, int R^(43 - T) dt (Sapareto and Dewey 1984), over
   * the lethal dose.
   */
  struct Cem43
  {
    double lethal_dose = 240.; ///< min

    double ln_rate(const double temperature) const
    {
      const double excess = temperature - (273.15 + 43.);
      const double base   = excess >= 0. ? 0.5 : 0.25;
      return -excess * std::log(base) - std::log(60. * lethal_dose);
    }

    void parameters(Parameters &p)
    {
      p.entry("Lethal dose",
              lethal_dose,
              "min",
              "Equivalent minutes at 43 degrees Celsius that kill the tissue",
              Bounds::positive());
    }
  };

  /**
   * Critical thermal load: the heat that has flowed through a point, int |q| dt (thesis Eq. 2-1), over a
   * lethal load.
   */
  struct CriticalThermalLoad
  {
    double lethal_load = 1e6; ///< J/m2

    /** @p heat_flux: |q| in W/m2. */
    double ln_rate(const double heat_flux) const { return std::log(heat_flux / lethal_load); }

    void parameters(Parameters &p)
    {
      p.entry(
        "Lethal load", lethal_load, "J/m2", "Heat through an area that kills the tissue", Bounds::positive());
    }
  };

  /** ln(exp(a) + exp(b)) without overflow. */
  inline double ln_add(const double a, const double b)
  {
    const double larger = std::max(a, b);
    if (!std::isfinite(larger)) // no damage at all, or beyond all numbers
      return larger;
    return larger + std::log1p(std::exp(std::min(a, b) - larger));
  }

  /**
   * ln of the integral over @p duration (s) of a rate whose logarithm runs in a straight line from @p
   * ln_start to
   * @p ln_end: exact for that line, second order for a smooth rate, free of overflow.
   */
  inline double ln_integral(const double ln_start, const double ln_end, const double duration)
  {
    const double larger = std::max(ln_start, ln_end);
    const double fall   = larger - std::min(ln_start, ln_end);
    if (!std::isfinite(larger))
      return larger;
    // (1 - exp(-fall)) / fall, with its limits for a flat line and for an infinite fall
    const double mean = fall < 1e-12 ? 1. : (std::isfinite(fall) ? -std::expm1(-fall) / fall : 0.);
    return mean > 0. ? larger + std::log(mean * duration) : no_damage;
  }
} // namespace Cautery
