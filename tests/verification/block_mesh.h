// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>

#include <array>
#include <functional>
#include <string>

namespace Verification
{
  using namespace dealii;

  /** A block of cells with bent insides, for what must not depend on the cells' form. */
  struct BlockMesh
  {
    bool                        tetrahedra;              ///< six for each hexahedron
    std::array<unsigned int, 3> n_cells;                 ///< along each edge
    double                      distortion;              ///< of inner nodes, relative to the cells' edges
    std::function<Point<3>(const Point<3> &unit)> place; ///< of the unit cube's points, m

    /** As gmsh's format 2.2, with the surfaces `x min` to `z max`. */
    void write(const std::string &file_name) const;
  };
} // namespace Verification
