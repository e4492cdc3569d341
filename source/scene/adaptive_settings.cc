// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/scene/adaptive_settings.h>

namespace Cautery
{
  void AdaptiveSettings::parameters(Parameters &p)
  {
    p.entry("Follow",
            follow,
            Choices<Follow>{{"nothing", Follow::nothing},
                            {"temperature", Follow::temperature},
                            {"displacement", Follow::displacement},
                            {"both", Follow::both}},
            "Whose gradient a mesh of hexahedra is refined and coarsened for; "
            "nothing: the mesh stays");
    p.entry("Target error",
            target_error,
            "",
            "Error of that gradient, relative to it, that the mesh is made for, "
            "as the indicator finds it",
            Bounds::between_open(0., 1.));
    p.entry("Interval",
            interval,
            "s",
            "Time after which the mesh is adapted anew, best some steps of time; 0: only at the start, to "
            "the first step",
            Bounds::non_negative());
    p.entry("Largest number of divisions",
            max_divisions,
            "How often a cell of the mesh above may be divided into 2^dimension",
            Bounds::between(1, 6));
    p.entry("Largest number of cells",
            max_cells,
            "About; where the target needs more, the worst cells come first",
            Bounds{1., 1e9, false, false});
  }
} // namespace Cautery
