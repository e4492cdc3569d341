// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/scene/newton_settings.h>

namespace Cautery
{
  void NewtonSettings::parameters(Parameters &p)
  {
    p.entry(
      "Tolerance",
      tolerance,
      "",
      "Euclidean norm of the forces that are left over at the nodes, relative to that of the forces that "
      "act there",
      Bounds::between_open(0., 1.));
    p.entry("Largest number of iterations",
            max_iterations,
            "For one step of the load, after which the step is halved",
            Bounds{1., 1e6, false, false});
    p.entry(
      "Smallest load step",
      smallest_step,
      "",
      "Share of the load's change since the last equilibrium below which the run fails; 1: no load steps",
      Bounds{1e-12, 1., false, false});
  }
} // namespace Cautery
