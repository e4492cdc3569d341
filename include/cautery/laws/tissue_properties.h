// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/parameters.h>

namespace Cautery
{
  /**
   * What a tissue does with heat: rho C dT/dt = div(k grad T), with the flux delayed by the characteristic
   * time tau_p in the non-Fourier model (thesis Eqs. 4-22 and 6-8).
   */
  struct ThermalProperties
  {
    double              density         = 1000.; ///< kg/m3
    TemperatureFunction conductivity    = 0.613; ///< W/(m K)
    TemperatureFunction specific_heat   = 4192.; ///< J/(kg K)
    double              relaxation_time = 16.;   ///< s

    bool constant() const { return conductivity.is_constant() && specific_heat.is_constant(); }

    /** rho C at @p temperature (K), in J/(m3 K). */
    double heat_capacity(const double temperature) const
    {
      return density * specific_heat.value(temperature);
    }

    void parameters(Parameters &p)
    {
      p.entry("Density", density, "kg/m3", "Mass per volume", Bounds::positive());
      p.entry("Conductivity",
              conductivity,
              "W/(m K)",
              "Thermal conductivity: a number, a table `T: k, T: k, ...` or an expression in T",
              Bounds::positive());
      p.entry("Specific heat",
              specific_heat,
              "J/(kg K)",
              "Specific heat capacity: a number, a table `T: C, T: C, ...` or an expression in T",
              Bounds::positive());
      p.entry("Relaxation time",
              relaxation_time,
              "s",
              "Characteristic time tau_p of the heat flux in the non-Fourier model",
              Bounds::non_negative());
    }
  };
} // namespace Cautery
