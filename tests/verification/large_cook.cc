// SPDX-License-Identifier: LGPL-2.1-or-later
#include "large.h"

namespace Verification
{
  namespace
  {
    /**
     * How far the upper right corner of scenes/cook.prm goes up, m, on n x n hexahedra in one layer, or six
     * tetrahedra for each, which are finer towards the clamped corners.
     */
    double tip(const Element &element, const unsigned int n, const std::vector<Override> &method = {})
    {
      const std::string name = std::filesystem::absolute("cook.msh");
      const double      deep = 48. / n; // one layer of cells
      BlockMesh{element.tetrahedra,
                {{n, n, 1}},
                0.,
                [deep](const Point<3> &unit) {
                  const double x = unit[0] * (0.3 + 0.7 * unit[0]);
                  const double y = unit[1] - 0.7 * std::sin(2. * numbers::PI * unit[1]) / (2. * numbers::PI);
                  return Point<3>(48. * x, 44. * x + y * (44. - 28. * x), deep * unit[2]);
                }}
        .write(name);
      const auto outcome =
        run("cook",
            joined({{{"Mesh/File name", name}, {"Numerics/Element degree", std::to_string(element.degree)}},
                    method}));
      std::cout << "  " << element.name << ", " << n << " x " << n << ": "
                << outcome.end("tip", "displacement_y_m") << " m, " << outcome.summary.at("statistics").dump()
                << '\n';
      return outcome.end("tip", "displacement_y_m");
    }
  } // namespace

  void cook(Checks &checks)
  {
    std::cout << std::setprecision(6);
    // The clamped corners are singular, so that no mesh of these converges at full order: the limit of three.
    const auto limit = [](const Element &element) {
      const double coarse = tip(element, 4), middle = tip(element, 8), fine = tip(element, 16);
      const double ratio = (middle - coarse) / (fine - middle);
      return fine + (fine - middle) / (ratio - 1.);
    };
    const double reference = limit(elements[3]);
    checks.near(
      "limit of tetrahedra over that of hexahedra, degree 2", limit(elements[1]) / reference, 1., 5e-3);
    checks.below("hexahedra of degree 1 lock: share of the limit", tip(elements[2], 16) / reference, 0.6);
    checks.below("tetrahedra of degree 1 lock: share of the limit", tip(elements[0], 16) / reference, 0.6);
    const std::vector<Override> averaged = {{"Numerics/Large equilibrium", "dynamic relaxation"},
                                            {"Numerics/Relaxation/Tolerance", "1e-5"},
                                            {"Numerics/Explicit/Averaged pressure", "on"}};
    checks.near("with averaged pressure they do not", tip(elements[0], 48, averaged) / reference, 1., 0.02);
  }
} // namespace Verification
