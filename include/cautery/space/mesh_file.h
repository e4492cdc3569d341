// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/scene/mesh_settings.h>
#include <cautery/space/plain_mesh.h>

namespace Cautery
{
  /**
   * Reads `settings.file_name` (see GmshFile for the formats). Cells and faces take the tag of their physical
   * group as region and surface, those of none get 0. Only the corner nodes of cells are kept. The mesh is as
   * the file has it: `tidy` comes next.
   *
   * In two dimensions the file's triangles or quadrilaterals are the cells and its lines the faces.
   * Errors: ExcInput for a file that is missing, unreadable or cut off, cells of mixed kinds or another
   * dimension, and volumes in two physical groups.
   */
  template <int dim>
  PlainMesh<dim> read_mesh_file(const MeshSettings &settings);
} // namespace Cautery
