// SPDX-License-Identifier: LGPL-2.1-or-later
#include "chain.h"

namespace Verification
{
  namespace
  {
    constexpr double young = 10.2e6, poisson = 0.35, density = 1000., gravity = 9.81;
    constexpr double mu     = young / (2. * (1. + poisson));
    constexpr double lambda = young * poisson / ((1. + poisson) * (1. - 2. * poisson));
    constexpr double height = 0.1;

    const std::vector<std::string> cells = {"tetrahedra", "hexahedra"};

    /// Heat that is on, but does nothing, with a stretch that makes the stiffness depend on it.
    const std::vector<Override> idle_heat = {{"Effects/Heat", "Fourier"},
                                             {"Effects/Heat sources", "off"},
                                             {"Effects/Coupling", "expansion"},
                                             {"Tissues/tissue/Thermal stretch", "exact"},
                                             {"Boundaries/floor/Thermal", "insulated"},
                                             {"Boundaries/walls/Thermal", "insulated"},
                                             {"Boundaries/top/Thermal", "insulated"}};

    /// With no support, backward Euler falls by -g dt^2 n (n + 1) / 2 after n steps, exactly.
    void free_fall(Checks &checks)
    {
      const double step = 1e-3, n = 20.;
      const double fall = -gravity * step * step * n * (n + 1.) / 2.;
      for (const std::string &kind : cells)
        for (const bool heated : {false, true})
          {
            std::vector<Override> overrides = {{"Mesh/Cells", kind},
                                               {"Effects/Deformation", "inertia"},
                                               {"Effects/Gravity", "on"},
                                               {"Boundaries/floor/Mechanical", "free"},
                                               {"Time/Step", to_text(step)}};
            if (heated)
              overrides.insert(overrides.end(), idle_heat.begin(), idle_heat.end());
            const Outcome     outcome = run("column", overrides);
            const std::string name    = "free fall, " + kind + (heated ? ", exact stretch" : "");
            for (const std::string probe : {"top", "middle"})
              checks.near(name + ", " + probe + ", u_z, m",
                          outcome.end(probe, "displacement_z_m"),
                          fall,
                          1e-9 * std::abs(fall));
            checks.near(name + ", estimated error, m",
                        outcome.summary.at("errors").at("time").at("deformation").at("sum_over_steps_m"),
                        gravity * step * step * n / 2.,
                        1e-9 * std::abs(fall));
            checks.near(name + ", stress_zz, Pa", outcome.end("middle", "stress_zz_Pa"), 0., 1e-6);
          }
    }

    /**
     * Gravity that sets in at t = 0 makes the column swing in the modes sin(k z), k = (m - 1/2) pi / H, of
     * frequency omega = k c, each driven by -2 g / (k H). Backward Euler (of the given step) follows each by
     * its own recurrence: slower, and damped.
     */
    double swing(const double z, const double time, const double step)
    {
      const double speed = std::sqrt((lambda + 2. * mu) / density);
      double       u     = 0.;
      for (unsigned int m = 1; m <= 400; ++m)
        {
          const double k     = (m - 0.5) * numbers::PI / height;
          const double omega = k * speed;
          const double drive = -2. * gravity / (k * height);
          double       q = 0., rate = 0.;
          for (long n = std::lround(time / step); n > 0; --n)
            {
              rate = (rate + step * (drive - omega * omega * q)) / (1. + omega * omega * step * step);
              q += step * rate;
            }
          u += q * std::sin(k * z);
        }
      return u;
    }

    /**
     * Ten elements of degree 2 err in the first frequency by (k h)^4 / 1440 = 4e-7; higher modes, where
     * backward Euler damps them within a few steps, add what 0.1 % of the static deflection allows. A swing
     * takes 4 H / c = 3.1 ms.
     */
    void swinging_column(Checks &checks)
    {
      const double still = -density * gravity / (lambda + 2. * mu) * 0.5 * height * height;
      for (const std::string &kind : cells)
        {
          const Outcome outcome = run("column",
                                      {{"Mesh/Cells", kind},
                                       {"Numerics/Element degree", "2"},
                                       {"Effects/Deformation", "inertia"},
                                       {"Effects/Gravity", "on"},
                                       {"Time/End", "0.006"},
                                       {"Time/Step", "2e-5"},
                                       {"Output/Times", "0.001, 0.002, 0.004"}});
          for (const std::string time : {"0.001", "0.002", "0.004", "0.006"})
            for (const auto &[probe, z] : {std::pair{"top", 0.1}, std::pair{"middle", 0.05}})
              checks.near("swinging column, " + kind + ", " + time + " s, " + probe + ", u_z, m",
                          outcome.at(time, probe, "displacement_z_m"),
                          swing(z, std::stod(time), 2e-5),
                          1e-3 * std::abs(still));
        }
    }

    /// rho C T' = -beta T_0 div u': the heat of an even compression stays where it is, in both models of
    /// heat.
    void adiabatic_compression(Checks &checks)
    {
      const double beta = 3. * (lambda + 2. * mu / 3.) * 3e-4;
      for (const std::string &kind : cells)
        for (const std::string model : {"Fourier", "non-Fourier"})
          {
            const Outcome outcome = run("compression", {{"Mesh/Cells", kind}, {"Effects/Heat", model}});
            for (const std::string time : {"0.5", "2", "5"})
              {
                const double compression = 6e-3 * std::stod(time) * std::stod(time);
                checks.near("adiabatic compression, " + kind + ", " + model + ", " + time + " s, K",
                            outcome.at(time, "inside", "temperature_K") - 310.,
                            beta * 310. * compression / (density * 4192.),
                            1e-9);
              }
          }
    }
  } // namespace

  void motion(Checks &checks)
  {
    free_fall(checks);
    swinging_column(checks);
    adiabatic_compression(checks);
  }
} // namespace Verification
