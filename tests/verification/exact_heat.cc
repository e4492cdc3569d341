// SPDX-License-Identifier: LGPL-2.1-or-later
#include "chain.h"

namespace Verification
{
  namespace
  {
    // the thesis's tissue
    constexpr double conductivity = 0.613, perfusion = 1800., body_temperature = 310.;
    const double     decay_length = std::sqrt(conductivity / perfusion);

    /**
     * T = T_b + Q/w + (T_1 - T_b - Q/w) cosh((X - x) / L) / cosh(X / L). Elements of degree 2 err at their
     * nodes by (h/L)^4 / 720 of the rise: 2e-6 K.
     */
    void pennes_slab(Checks &checks)
    {
      const double width = 0.02, plateau = body_temperature + 33800. / perfusion;
      const auto   exact = [&](const double x) {
        return plateau +
               (320. - plateau) * std::cosh((width - x) / decay_length) / std::cosh(width / decay_length);
      };
      for (const std::string cells : {"tetrahedra", "hexahedra"})
        {
          const Outcome outcome = run("slab", {{"Mesh/Cells", cells}});
          checks.near("Pennes slab, " + cells + ", middle, K",
                      outcome.end("middle", "temperature_K"),
                      exact(0.01),
                      1e-5);
          checks.near(
            "Pennes slab, " + cells + ", end, K", outcome.end("end", "temperature_K"), exact(0.02), 1e-5);
        }
    }

    /**
     * T = T_b + P exp(-r/L) / (4 pi k r). Away from the source, linear elements err by O(h^2): about a
     * quarter from a mesh to the next, with corrections of higher order, as the source is 4 and then 8 cells
     * away.
     */
    void point_source(Checks &checks)
    {
      const auto exact = [](const double r) {
        return body_temperature + 0.08 / (4. * numbers::PI * conductivity * r) * std::exp(-r / decay_length);
      };
      const std::map<std::string, double> radii = {{"axis", 0.0025}, {"diagonal", 0.00125 * std::sqrt(6.)}};
      for (const std::string cells : {"tetrahedra", "hexahedra"})
        {
          const Outcome coarse = run("point_source", {{"Mesh/Cells", cells}, {"Mesh/Subdivisions", "16"}});
          const Outcome fine   = run("point_source", {{"Mesh/Cells", cells}, {"Mesh/Subdivisions", "32"}});
          for (const auto &[probe, radius] : radii)
            {
              const double before = coarse.end(probe, "temperature_K") - exact(radius);
              const double after  = fine.end(probe, "temperature_K") - exact(radius);
              checks.near("point source, " + cells + ", " + probe + ", error falls by the factor",
                          before / after,
                          4.,
                          1.);
              checks.below("point source, " + cells + ", " + probe + ", error over rise",
                           std::abs(after) / (exact(radius) - body_temperature),
                           2e-2);
            }
        }
    }

    /// Everything on that moves heat, with lumped capacities, so that only the steps differ.
    Outcome all_effects(const std::vector<Override> &models, const std::vector<Override> &integrator)
    {
      std::vector<Override> overrides = {{"Numerics/Capacity matrix", "lumped"}};
      overrides.insert(overrides.end(), models.begin(), models.end());
      overrides.insert(overrides.end(), integrator.begin(), integrator.end());
      return run("balance", overrides);
    }

    /**
     * Explicit steps are of first order in time: they come half as near to IDA with half the step, and two of
     * them together nearer still.
     */
    void explicit_steps(Checks &checks)
    {
      const auto by = [](const std::string &step) {
        return std::vector<Override>{{"Time/Integrator", "explicit"}, {"Time/Step", step}};
      };
      const std::vector<Override> ida = {
        {"Time/Integrator", "IDA"}, {"Time/Relative tolerance", "1e-9"}, {"Time/Absolute tolerance", "1e-9"}};
      for (const std::string cells : {"tetrahedra", "hexahedra"})
        for (const std::string heat : {"Fourier", "non-Fourier"})
          {
            const std::vector<Override> model = {{"Mesh/Cells", cells}, {"Effects/Heat", heat}};
            const Outcome exact = all_effects(model, ida), coarse = all_effects(model, by("0.1")),
                          fine = all_effects(model, by("0.05"));
            double first = 0., second = 0., together = 0.;
            for (const auto &[place, row] : exact.probes)
              {
                const double wanted = row.at("temperature_K");
                const double one    = coarse.probes.at(place).at("temperature_K") - wanted;
                const double other  = fine.probes.at(place).at("temperature_K") - wanted;
                first               = std::max(first, std::abs(one));
                second              = std::max(second, std::abs(other));
                together            = std::max(together, std::abs(2. * other - one));
              }
            const std::string what = "explicit heat, " + cells + ", " + heat + ": ";
            checks.holds(what + "it is warmed", exact.summary.at("extremes").at("temperature_max_K") > 313.2);
            checks.near(what + "half the step, error falls by the factor", first / second, 2., 0.1);
            checks.below(what + "two steps extrapolated against IDA, K", together, 1e-4);
          }
    }

    /// Explicit dynamics follows heat, whichever integrator finds it.
    void motion_with_any_heat(Checks &checks)
    {
      const std::vector<Override> moving = {{"Effects/Deformation", "explicit dynamics"},
                                            {"Effects/Coupling", "expansion"},
                                            {"Tissues/tissue/Young's modulus", "1000"},
                                            {"Numerics/Explicit/Damping", "50"}};
      const Outcome               by_ida =
        all_effects(moving, {{"Time/Integrator", "IDA"}, {"Time/Relative tolerance", "1e-7"}});
      for (const std::string integrator : {"explicit", "backward Euler"})
        {
          const Outcome other = all_effects(moving, {{"Time/Integrator", integrator}, {"Time/Step", "0.05"}});
          double        largest = 0., apart = 0.;
          for (const auto &[place, row] : by_ida.probes)
            for (const std::string column : {"displacement_x_m", "displacement_y_m", "displacement_z_m"})
              {
                largest = std::max(largest, std::abs(row.at(column)));
                apart   = std::max(apart, std::abs(row.at(column) - other.probes.at(place).at(column)));
              }
          checks.holds("it moves", largest > 1e-6);
          checks.below("explicit dynamics with heat by " + integrator + " against IDA, displacement",
                       apart / largest,
                       5e-3);
        }
    }
  } // namespace

  void heat(Checks &checks)
  {
    pennes_slab(checks);
    point_source(checks);
    explicit_steps(checks);
    motion_with_any_heat(checks);
  }
} // namespace Verification
