// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/parameters.h>
#include <cautery/scene/adaptive_settings.h>

namespace Cautery
{
  /**
   * Where the mesh comes from: section "Mesh".
   */
  struct MeshSettings
  {
    enum class Shape
    {
      box,
      file
    };
    /// In two dimensions tetrahedra are triangles and hexahedra are quadrilaterals.
    enum class Cells
    {
      tetrahedra,
      hexahedra
    };
    enum class LengthUnit
    {
      metre,
      centimetre,
      millimetre
    };

    Shape               shape        = Shape::box;
    Cells               cells        = Cells::tetrahedra;
    Point<3>            lower        = Point<3>();
    Point<3>            upper        = Point<3>(0.01, 0.01, 0.01); ///< m
    std::vector<double> subdivisions = {10, 10, 10};
    std::string         file_name; ///< complete path once the scene is read
    LengthUnit          length_unit = LengthUnit::metre;
    unsigned int        refinements = 0;
    AdaptiveSettings    adaptive;

    void parameters(Parameters &p);
  };
} // namespace Cautery
