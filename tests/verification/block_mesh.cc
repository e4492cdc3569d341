// SPDX-License-Identifier: LGPL-2.1-or-later
#include "block_mesh.h"

#include <cmath>
#include <fstream>
#include <iomanip>
#include <utility>
#include <vector>

namespace Verification
{
  namespace
  {
    using Corners = std::vector<unsigned int>;

    enum GmshType
    {
      triangle      = 2,
      quadrilateral = 3,
      tetrahedron   = 4,
      hexahedron    = 5
    };

    struct Element
    {
      GmshType type;
      int      group;
      Corners  nodes;
    };

    /// Those corners of a cell that lie on side @p side (2 d: lower, 2 d + 1: upper end of direction d).
    Corners on_side(const BlockMesh &block, const Corners &cell, const int side)
    {
      const auto [nx, ny, nz] = block.n_cells;
      Corners found;
      for (const auto node : cell)
        {
          const std::array<unsigned int, 3> index = {
            {node % (nx + 1), node / (nx + 1) % (ny + 1), node / ((nx + 1) * (ny + 1))}};
          if (index[side / 2] == (side % 2 == 0 ? 0 : block.n_cells[side / 2]))
            found.push_back(node);
        }
      return found;
    }

    std::vector<Corners> cells(const BlockMesh &block)
    {
      const auto [nx, ny, nz]          = block.n_cells;
      const unsigned int   steps[3]    = {1, nx + 1, (nx + 1) * (ny + 1)};
      const int            paths[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
      std::vector<Corners> result;
      for (unsigned int k = 0; k < nz; ++k)
        for (unsigned int j = 0; j < ny; ++j)
          for (unsigned int i = 0; i < nx; ++i)
            {
              const unsigned int o = i + j * steps[1] + k * steps[2];
              const unsigned int x = steps[0], y = steps[1], z = steps[2];
              if (!block.tetrahedra)
                result.push_back({o, o + x, o + x + y, o + y, o + z, o + x + z, o + x + y + z, o + y + z});
              else
                for (const auto &path : paths)
                  result.push_back(
                    {o, o + steps[path[0]], o + steps[path[0]] + steps[path[1]], o + x + y + z});
            }
      return result;
    }
  } // namespace

  void BlockMesh::write(const std::string &file_name) const
  {
    std::ofstream out(file_name);
    out << std::setprecision(17) << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n7\n";
    const std::string axes = "xyz";
    for (int side = 0; side < 6; ++side)
      out << "2 " << side + 1 << " \"" << axes[side / 2] << (side % 2 == 0 ? " min" : " max") << "\"\n";
    out << "3 7 \"block\"\n$EndPhysicalNames\n$Nodes\n"
        << (n_cells[0] + 1) * (n_cells[1] + 1) * (n_cells[2] + 1) << '\n';
    unsigned int number = 0;
    for (unsigned int k = 0; k <= n_cells[2]; ++k)
      for (unsigned int j = 0; j <= n_cells[1]; ++j)
        for (unsigned int i = 0; i <= n_cells[0]; ++i)
          {
            const unsigned int index[3] = {i, j, k};
            Point<3>           unit;
            ++number;
            for (int d = 0; d < 3; ++d)
              {
                const bool inside = index[d] > 0 && index[d] < n_cells[d];
                unit[d] = (index[d] + (inside ? distortion * std::sin(12.9898 * number + 78.233 * d) : 0.)) /
                          n_cells[d];
              }
            out << number << ' ' << place(unit) << '\n';
          }
    std::vector<Element> elements;
    const unsigned int   on_face = tetrahedra ? 3 : 4;
    for (const auto &cell : cells(*this))
      {
        elements.push_back({tetrahedra ? tetrahedron : hexahedron, 7, cell});
        for (int side = 0; side < 6; ++side)
          if (const auto nodes = on_side(*this, cell, side); nodes.size() == on_face)
            elements.push_back({tetrahedra ? triangle : quadrilateral, side + 1, nodes});
      }
    out << "$EndNodes\n$Elements\n" << elements.size() << '\n';
    for (unsigned int e = 0; e < elements.size(); ++e)
      {
        const auto &[type, group, nodes] = elements[e];
        out << e + 1 << ' ' << type << " 2 " << group << ' ' << group;
        for (const auto node : nodes)
          out << ' ' << node + 1;
        out << '\n';
      }
    out << "$EndElements\n";
  }
} // namespace Verification
