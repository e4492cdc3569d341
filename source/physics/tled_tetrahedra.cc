// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/laws/kinematics.h>
#include <cautery/physics/tled_tetrahedra.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Cautery
{
  TetrahedronShape::TetrahedronShape(const std::array<Point<3>, 4> &corners)
  {
    Matrix3<double> edges; // one column each
    for (int corner = 1; corner < 4; ++corner)
      for (int d = 0; d < 3; ++d)
        edges(d, corner - 1) = corners[corner][d] - corners[0][d];
    const Matrix3<double> cofactor = cofactors(edges);
    const double          determinant =
      edges(0, 0) * cofactor(0, 0) + edges(0, 1) * cofactor(0, 1) + edges(0, 2) * cofactor(0, 2);
    volume = std::abs(determinant) / 6.;
    for (int d = 0; d < 3; ++d)
      {
        for (int corner = 1; corner < 4; ++corner)
          gradients[corner][d] = cofactor(d, corner - 1) / determinant;
        gradients[0][d] = -(gradients[1][d] + gradients[2][d] + gradients[3][d]);
      }
  }

  namespace
  {
    TetrahedronShape shape(const TetrahedraMesh &mesh, const std::size_t cell)
    {
      std::array<Point<3>, 4> corners;
      for (int corner = 0; corner < 4; ++corner)
        corners[corner] = mesh.nodes[mesh.cells[cell][corner]];
      return TetrahedronShape(corners);
    }

    /**
     * Cells in groups of @p lanes that share no node where that can be had by looking @p window cells ahead.
     */
    std::vector<std::vector<std::size_t>>
    group_cells(const TetrahedraMesh &mesh, const unsigned int lanes, const std::size_t window)
    {
      std::vector<std::uint32_t> first_node(mesh.cells.size());
      for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
        first_node[cell] = *std::min_element(mesh.cells[cell].begin(), mesh.cells[cell].end());
      std::vector<std::size_t> order(mesh.cells.size());
      std::iota(order.begin(), order.end(), 0);
      std::stable_sort(order.begin(), order.end(), [&first_node](const std::size_t a, const std::size_t b) {
        return first_node[a] < first_node[b];
      });

      std::vector<std::vector<std::size_t>> groups;
      std::vector<std::size_t>              last_group(mesh.nodes.size(), 0); // that has the node, from 1
      std::vector<std::size_t>              waiting;
      auto                                  coming  = order.begin();
      const auto                            take_if = [&](std::vector<std::size_t> &group, const auto &good) {
        const auto moved = [&](const std::size_t cell) {
          if (group.size() == lanes || !good(cell))
            return false;
          for (const std::uint32_t node : mesh.cells[cell])
            last_group[node] = groups.size() + 1;
          group.push_back(cell);
          return true;
        };
        waiting.erase(std::remove_if(waiting.begin(), waiting.end(), moved), waiting.end());
      };
      while (true)
        {
          while (waiting.size() < window && coming != order.end())
            waiting.push_back(*coming++);
          if (waiting.empty())
            return groups;
          std::vector<std::size_t> group;
          take_if(group, [&](const std::size_t cell) {
            return std::none_of(mesh.cells[cell].begin(), mesh.cells[cell].end(), [&](const auto node) {
              return last_group[node] == groups.size() + 1;
            });
          });
          take_if(group, [](const std::size_t) { return true; });
          groups.push_back(group);
        }
    }
  } // namespace

  template <typename Number>
  TledTetrahedra<Number>::TledTetrahedra(const TetrahedraMesh &mesh, const unsigned int lanes)
    : lanes(lanes), n_rows(10 + 3 * mesh.n_fibres), cells(mesh.cells.size())
  {
    Assert(mesh.directions.size() == mesh.n_fibres * mesh.cells.size(),
           ExcDimensionMismatch(mesh.directions.size(), mesh.n_fibres * mesh.cells.size()));
    const auto groups = group_cells(mesh, lanes, 512);
    n_groups          = groups.size();
    offsets.resize(4 * lanes * n_groups);
    constants.resize(n_rows * lanes * n_groups);
    cell_of_lane.resize(lanes * n_groups, numbers::invalid_size_type);
    for (std::size_t g = 0; g < n_groups; ++g)
      pack(mesh, groups[g], g);
  }

  template <typename Number>
  void TledTetrahedra<Number>::pack(const TetrahedraMesh           &mesh,
                                    const std::vector<std::size_t> &group,
                                    const std::size_t               g)
  {
    Number        *rows    = &constants[n_rows * lanes * g];
    std::uint32_t *corners = &offsets[4 * lanes * g];
    for (unsigned int lane = 0; lane < group.size(); ++lane)
      {
        const std::size_t      cell    = group[lane];
        const TetrahedronShape form    = shape(mesh, cell);
        cell_of_lane[lanes * g + lane] = cell;
        for (int corner = 0; corner < 4; ++corner)
          corners[corner * lanes + lane] = node_record * mesh.cells[cell][corner];
        for (int corner = 1; corner < 4; ++corner)
          for (int d = 0; d < 3; ++d)
            rows[(3 * corner - 3 + d) * lanes + lane] = form.gradients[corner][d];
        rows[9 * lanes + lane] = form.volume;
        for (std::size_t f = 0; f < mesh.n_fibres; ++f)
          for (int d = 0; d < 3; ++d)
            rows[(10 + 3 * f + d) * lanes + lane] = mesh.directions[mesh.n_fibres * cell + f][d];
      }
  }

  template <typename Number>
  TetrahedraSweep<Number> TledTetrahedra<Number>::sweep(const SweepMaterial &material) const
  {
    TetrahedraSweep<Number> result;
    result.offsets   = offsets.data();
    result.constants = constants.data();
    result.n_groups  = n_groups;
    result.material  = material;
    return result;
  }

  template <typename Number>
  std::optional<std::size_t> TledTetrahedra<Number>::inverted_cell(const Number *values) const
  {
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < cell_of_lane.size(); ++i)
      {
        const std::size_t    g = i / lanes, lane = i % lanes;
        const Number        *rows    = &constants[n_rows * lanes * g] + lane;
        const std::uint32_t *corners = &offsets[4 * lanes * g] + lane;
        Matrix3<double>      h       = {};
        for (int corner = 1; corner < 4; ++corner)
          for (int c = 0; c < 3; ++c)
            for (int d = 0; d < 3; ++d)
              h(c, d) += (values[corners[corner * lanes] + c] - values[corners[0] + c]) *
                         rows[(3 * corner - 3 + d) * lanes];
        if (!(Deformation<double>(h).jacobian > 0.) && cell_of_lane[i] < first.value_or(cells))
          first = cell_of_lane[i];
      }
    return first;
  }

  std::vector<double> lumped_volumes(const TetrahedraMesh &mesh)
  {
    std::vector<double> result(mesh.nodes.size(), 0.);
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      for (const std::uint32_t node : mesh.cells[cell])
        result[node] += shape(mesh, cell).volume / 4.;
    return result;
  }

  template class TledTetrahedra<float>;
  template class TledTetrahedra<double>;
} // namespace Cautery
