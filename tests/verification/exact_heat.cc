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
  } // namespace

  void heat(Checks &checks)
  {
    pennes_slab(checks);
    point_source(checks);
  }
} // namespace Verification
