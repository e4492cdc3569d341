// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/scene/tool.h>

namespace Cautery
{
  void Tool::parameters(Parameters &p)
  {
    p.entry("Centre", centre, "m", "Of the sphere within which the nodes are held, in the undeformed body");
    p.entry("Radius", radius, "m", "Of that sphere", Bounds::positive());
    p.entry("Displacement", displacement, "m", "Of these nodes, in x, y, z, t");
  }
} // namespace Cautery
