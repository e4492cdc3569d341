// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/parameters.h>

#include <cmath>

namespace Cautery
{
  /**
   * Heat carried away by blood, C_b omega_b (T_b - T) (Pennes; thesis Eq. 4-18 without its second blood
   * density, because omega_b is a mass flow already).
   */
  struct Perfusion
  {
    double rate          = 0.5;   ///< omega_b, kg/(m3 s)
    double specific_heat = 3600.; ///< C_b, J/(kg K)
    double temperature   = 310.;  ///< T_b, K

    /** C_b omega_b, in W/(m3 K). */
    double coefficient() const { return specific_heat * rate; }

    void parameters(Parameters &p)
    {
      p.entry(
        "Perfusion rate", rate, "kg/(m3 s)", "Mass flow of blood through a volume", Bounds::non_negative());
      p.entry("Blood specific heat", specific_heat, "J/(kg K)", "Specific heat of blood", Bounds::positive());
      p.entry("Blood temperature", temperature, "K", "Arterial temperature", Bounds::positive());
    }
  };

  /**
   * Metabolic heat: constant, or growing by the factor Q10 every 10 K (thesis Eq. 4-17 with factor 2).
   */
  struct Metabolism
  {
    double heat             = 33800.; ///< at the base temperature, W/m3
    double q10              = 2.;
    double base_temperature = 310.; ///< K

    /** W/m3 at @p temperature (K), of the Q10 form. */
    template <typename Number>
    Number q10_heat(const Number &temperature) const
    {
      using std::exp;
      return heat * exp(std::log(q10) * (temperature - base_temperature) / 10.);
    }

    void parameters(Parameters &p)
    {
      p.entry(
        "Metabolic heat", heat, "W/m3", "Metabolic heat (at the base temperature)", Bounds::non_negative());
      p.entry(
        "Metabolic Q10", q10, "", "Growth of the metabolic heat in 10 K, for `Q10`", Bounds::positive());
      p.entry("Metabolic base temperature",
              base_temperature,
              "K",
              "Temperature of the given metabolic heat, for `Q10`",
              Bounds::positive());
    }
  };
} // namespace Cautery
