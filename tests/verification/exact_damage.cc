// SPDX-License-Identifier: LGPL-2.1-or-later
#include "chain.h"

namespace Verification
{
  namespace
  {
    // the thesis's Tables 4 and 6
    const double     ln_frequency      = std::log(1.98e106);
    constexpr double activation_energy = 667000., molar_volume = 0.285, gas_constant = 8.314;

    double ln_rate(const double temperature, const double strain_energy)
    {
      return ln_frequency - (activation_energy - molar_volume * strain_energy) / (gas_constant * temperature);
    }

    double ln_damage(const std::string &law, const std::vector<Override> &more = {})
    {
      std::vector<Override> overrides = {{"Effects/Damage", law}};
      overrides.insert(overrides.end(), more.begin(), more.end());
      return run("warm_block", overrides).end("inside", "ln_damage");
    }

    /// At a constant temperature the rate is constant too: ln Omega = ln(rate t), to the digits written.
    void constant_temperature(Checks &checks)
    {
      const double ln_time = std::log(8.);
      checks.near("Arrhenius at 340 K, ln Omega", ln_damage("Arrhenius"), ln_rate(340., 0.) + ln_time, 1e-8);
      checks.near("CEM43 at 319.15 K = 46 C, ln Omega",
                  ln_damage("CEM43", {{"Initial state/Temperature", "319.15"}}),
                  std::log(8. / 60. * 8. / 240.),
                  1e-8);
      checks.near("CEM43 at 314.15 K = 41 C, ln Omega",
                  ln_damage("CEM43", {{"Initial state/Temperature", "314.15"}}),
                  std::log(8. / 60. / 16. / 240.),
                  1e-8);
    }

    /**
     * Free expansion by e = alpha dT has the elastic energy 1/2 (3 K e)(3 e) and no stress, so no thermal
     * strain energy.
     */
    void strain_energy(Checks &checks)
    {
      const double bulk = 10.2e6 / (3. * (1. - 2. * 0.35)), e = 3e-4 * 30.;
      const double energy = 4.5 * bulk * e * e;
      checks.near("thermo-mechanical strain energy, free expansion, ln Omega",
                  ln_damage("thermo-mechanical strain energy"),
                  ln_rate(340., energy) + std::log(8.),
                  1e-7);
      checks.near("thermal strain energy, free expansion, ln Omega",
                  ln_damage("thermal strain energy"),
                  ln_rate(340., 0.) + std::log(8.),
                  1e-7);
    }

    /// A temperature of 500 K/m over the block: |q| = k 500 K/m everywhere, over the lethal load of 1e6 J/m2.
    void thermal_load(Checks &checks)
    {
      const std::string profile = "330 + 500*x";
      const double      found   = ln_damage("critical thermal load",
                                     {{"Initial state/Temperature", profile},
                                             {"Boundaries/outer/Thermal", "temperature"},
                                             {"Boundaries/outer/Temperature", profile},
                                             {"Boundaries/sliding/Thermal", "temperature"},
                                             {"Boundaries/sliding/Temperature", profile}});
      checks.near(
        "critical thermal load of a constant flux, ln Omega", found, std::log(0.613 * 500. * 8. / 1e6), 1e-8);
    }

    /**
     * T rises by 2.5 K/s. The logarithm of the rate is nearly straight in a step, so that the rule errs by
     * O(dt^2) with a small constant: its deviation from a straight line is (Delta E / R T^3) (T')^2 dt^2 / 8
     * = 3e-3 for 1 s.
     */
    void rising_temperature(Checks &checks)
    {
      const std::vector<Override> rising = {{"Heat sources/Names", "glow"},
                                            {"Heat sources/glow/Type", "uniform"},
                                            {"Heat sources/glow/Power", to_text(2.5 * 4.192e6)}};
      double                      omega  = 0.;
      constexpr unsigned int      n      = 20000;
      for (unsigned int i = 0; i < n; ++i)
        omega += std::exp(ln_rate(340. + 2.5 * 8. * (i + 0.5) / n, 0.)) * 8. / n;
      std::vector<double> errors;
      for (const std::string step : {"1", "0.5"})
        {
          auto with_step = rising;
          with_step.push_back({"Time/Step", step});
          errors.push_back(std::abs(ln_damage("Arrhenius", with_step) - std::log(omega)));
        }
      checks.below("Arrhenius at a rising temperature, dt = 1 s, error of ln Omega", errors[0], 3e-3);
      checks.near("the same, error falls by the factor", errors[0] / errors[1], 4., 0.3);
    }
  } // namespace

  void damage(Checks &checks)
  {
    constant_temperature(checks);
    strain_energy(checks);
    thermal_load(checks);
    rising_temperature(checks);
  }
} // namespace Verification
