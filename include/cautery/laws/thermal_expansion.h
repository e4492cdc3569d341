// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/parameters.h>
#include <cautery/laws/linear_elastic.h>

#include <cmath>

namespace Cautery
{
  /**
   * The thermal part of the multiplicative decomposition, F_theta = s(T) I, for linear elasticity:
   * exact    S = (lambda tr(E) I + 2 mu E) / s - 3/2 (s - 1/s) K I, s = exp(int alpha dT)  (thesis Eqs. 4-6,
   * 4-9), linear   S = lambda tr(E) I + 2 mu E - 3 K (int alpha dT) I                             (Eqs. 4-10,
   * 4-11).
   */
  struct ThermalExpansion
  {
    enum class Form
    {
      linearised,
      exact
    };

    TemperatureFunction coefficient           = 3e-4; ///< alpha, 1/K
    double              reference_temperature = 310.; ///< T_0, stress-free, K
    Form                form                  = Form::linearised;

    /** int alpha dT from the stress-free temperature. */
    double strain(const double temperature) const
    {
      return coefficient.integral(reference_temperature, temperature);
    }

    /** What the elastic stress is multiplied with: 1 or 1/s. */
    double stiffness_factor(const double temperature) const
    {
      return form == Form::linearised ? 1. : std::exp(-strain(temperature));
    }

    /** The pressure of a tissue that is held in place, per bulk modulus: 3 int alpha dT, or 3/2 (s - 1/s). */
    double pressure_factor(const double temperature) const
    {
      const double e = strain(temperature);
      return form == Form::linearised ? 3. * e : 3. * std::sinh(e);
    }

    /** Is the stress linear in temperature with constant coefficients? */
    bool linear() const { return form == Form::linearised && coefficient.is_constant(); }

    /** beta = 3 K alpha, in Pa/K (Eq. 4-13). */
    double beta(const Lame &lame, const double temperature) const
    {
      return 3. * lame.bulk_modulus() * coefficient.value(temperature);
    }

    void parameters(Parameters &p)
    {
      p.entry(
        "Thermal expansion coefficient",
        coefficient,
        "1/K",
        "Linear coefficient of thermal expansion: a number, a table `T: alpha, ...` or an expression in T");
      p.entry("Reference temperature",
              reference_temperature,
              "K",
              "Temperature without thermal stress, T_0",
              Bounds::positive());
      p.entry("Thermal stretch",
              form,
              Choices<Form>{{"linearised", Form::linearised}, {"exact", Form::exact}},
              "Thermal stretch 1 + alpha (T - T_0), or exp(int alpha dT) as in Eq. 4-9");
    }
  };
} // namespace Cautery
