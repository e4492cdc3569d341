// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/scene/scene.h>
#include <cautery/space/field.h>
#include <cautery/space/points.h>

namespace Cautery
{
  /**
   * The nodes of this process that remain where a scene condenses the others away (`Numerics/Kept nodes`), as
   * unknowns of @p nodes; empty where it does not. Collective. Errors: ExcInput for names of no region, and
   * where nothing or everything would remain.
   */
  template <int dim>
  IndexSet kept_nodes(const Scene &scene, const Field<dim> &nodes, const PointLocator<dim> &locator);
} // namespace Cautery
