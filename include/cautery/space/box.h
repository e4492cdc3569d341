// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/scene/mesh_settings.h>
#include <cautery/space/plain_mesh.h>

namespace Cautery
{
  /**
   * A box with faces along the axes, cut into equal boxes, and for simplices each of these into the dim!
   * simplices around its main diagonal (Kuhn's or Freudenthal's cut, which conforms from box to box): 10 x 10
   * x 10 gives 1331 vertices and 6000 tetrahedra. Region 1 is "box"; the surfaces are 1 "x min", 2 "x max", 3
   * "y min" and so on.
   *
   * In two dimensions a third entry of the places and of the subdivisions is ignored.
   * Errors: ExcInput for a box without volume and for subdivisions that are not 1 or dim positive whole
   * numbers.
   */
  template <int dim>
  PlainMesh<dim> make_box(const MeshSettings &settings);
} // namespace Cautery
