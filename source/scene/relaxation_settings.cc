// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/scene/relaxation_settings.h>

namespace Cautery
{
  void RelaxationSettings::parameters(Parameters &p)
  {
    p.entry(
      "Tolerance",
      tolerance,
      "",
      "Euclidean norm of the forces that are left over at the nodes, relative to that of the forces that "
      "act there",
      Bounds::between_open(0., 1.));
    p.entry("Largest number of steps",
            max_steps,
            "For one equilibrium, after which the run fails",
            Bounds{1., 4e9, false, false});
  }
} // namespace Cautery
