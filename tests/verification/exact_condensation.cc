// SPDX-License-Identifier: LGPL-2.1-or-later
#include "chain.h"

namespace Verification
{
  namespace
  {
    std::string label(const std::vector<Override> &overrides)
    {
      std::string text;
      for (const auto &given : overrides)
        text += (text.empty() ? "" : ", ") + given.path + " = " + given.value;
      return text.empty() ? "linear tetrahedra" : text;
    }
  } // namespace

  /// Systems condensed to some of the nodes (thesis 6.3) give what the whole ones give.
  void condensation(Checks &checks)
  {
    const std::vector<std::vector<Override>> bodies = {
      {},
      {{"Mesh/Cells", "hexahedra"}, {"Numerics/Element degree", "2"}, {"Mesh/Subdivisions", "2"}},
      {{"Mesh/Cells", "hexahedra"}, {"Numerics/Method", "finite differences"}},
      {{"Effects/Coupling", "two-way"}},
      {{"Effects/Deformation", "inertia"}},
      {{"Numerics/Heat solver/Method", "direct"}, {"Numerics/Deformation solver/Method", "CG + AMG"}}};
    for (const auto &body : bodies)
      {
        const Outcome whole = run("condensed", body);
        for (const std::string kept : {"inside", "probes", "inside, probes"})
          {
            auto overrides = body;
            overrides.push_back({"Numerics/Kept nodes", kept});
            checks.below(label(body) + ", kept: " + kept,
                         difference_by_column(whole, run("condensed", overrides)),
                         1e-10);
          }
      }
  }
} // namespace Verification
