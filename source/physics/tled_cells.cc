// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/laws/kinematics.h>
#include <cautery/physics/tled_cells.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Cautery
{
  namespace
  {
    /** The inverse of @p matrix transposed, and its determinant. */
    std::pair<Matrix3<double>, double> inverse_transpose(const Matrix3<double> &matrix)
    {
      Matrix3<double> result = cofactors(matrix);
      const double    determinant =
        matrix(0, 0) * result(0, 0) + matrix(0, 1) * result(0, 1) + matrix(0, 2) * result(0, 2);
      for (double &entry : result.entries)
        entry /= determinant;
      return {result, determinant};
    }

    /** Sign of coordinate @p d, -1 or 1, of corner @p corner of deal.II's hexahedron. */
    double sign(const int corner, const int d) { return (corner >> d & 1) != 0 ? 1. : -1.; }

    /** 1 at the first corner, and products of the signs, for the four modes that no gradient sees. */
    double hourglass_mode(const int mode, const int corner)
    {
      const double x = sign(corner, 0), y = sign(corner, 1), z = sign(corner, 2);
      const double modes[4] = {y * z, z * x, x * y, x * y * z};
      return modes[mode];
    }

    IntegrationPoint<8> hexahedron_point(const std::array<Point<3>, 8> &corners, const double (&at)[3])
    {
      Vector3<double> reference[8];
      Matrix3<double> jacobian = {};
      for (int a = 0; a < 8; ++a)
        for (int d = 0; d < 3; ++d)
          {
            const int e = (d + 1) % 3, f = (d + 2) % 3;
            reference[a][d] = sign(a, d) * (1. + sign(a, e) * at[e]) * (1. + sign(a, f) * at[f]) / 8.;
            for (int c = 0; c < 3; ++c)
              jacobian(c, d) += corners[a][c] * reference[a][d];
          }
      const auto          inverse = inverse_transpose(jacobian);
      IntegrationPoint<8> result;
      result.volume = inverse.second;
      for (int a = 0; a < 8; ++a)
        result.gradients[a] = inverse.first * reference[a];
      return result;
    }

    /**
     * Cells in groups of @p lanes that share no node where that can be had by looking @p window cells ahead.
     */
    template <int corners>
    std::vector<std::vector<std::size_t>>
    group_cells(const CellMesh<corners> &mesh, const unsigned int lanes, const std::size_t window)
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

  std::vector<IntegrationPoint<4>> integration_points(const std::array<Point<3>, 4> &corners, const int)
  {
    Matrix3<double> edges; // one column each
    for (int corner = 1; corner < 4; ++corner)
      for (int d = 0; d < 3; ++d)
        edges(d, corner - 1) = corners[corner][d] - corners[0][d];
    const auto          inverse = inverse_transpose(edges);
    IntegrationPoint<4> result;
    result.volume = std::abs(inverse.second) / 6.;
    for (int corner = 1; corner < 4; ++corner)
      for (int d = 0; d < 3; ++d)
        {
          result.gradients[corner][d] = inverse.first(d, corner - 1);
          result.gradients[0][d] -= inverse.first(d, corner - 1);
        }
    return {result};
  }

  std::vector<IntegrationPoint<8>> integration_points(const std::array<Point<3>, 8> &corners,
                                                      const int                      n_points)
  {
    std::vector<IntegrationPoint<8>> result;
    for (int q = 0; q < 8; ++q)
      {
        const double at[3] = {
          sign(q, 0) / std::sqrt(3.), sign(q, 1) / std::sqrt(3.), sign(q, 2) / std::sqrt(3.)};
        result.push_back(hexahedron_point(corners, at));
      }
    if (n_points == 8)
      return result;
    IntegrationPoint<8> mean;
    for (const auto &point : result)
      mean.volume += point.volume;
    for (const auto &point : result)
      for (int a = 0; a < 8; ++a)
        for (int d = 0; d < 3; ++d)
          mean.gradients[a][d] += point.gradients[a][d] * point.volume / mean.volume;
    return {mean};
  }

  template <int corners, typename Number>
  TledCells<corners, Number>::TledCells(const CellMesh<corners> &mesh,
                                        const unsigned int       lanes,
                                        const int                n_points)
    : lanes(lanes)
    , n_points(n_points)
    , n_fibres(mesh.n_fibres)
    , n_rows(n_points * (3 * corners - 2) + (corners == 8 && n_points == 1 ? 29 : 0) + 3 * mesh.n_fibres)
  {
    Assert(mesh.directions.size() == mesh.n_fibres * mesh.cells.size(),
           ExcDimensionMismatch(mesh.directions.size(), mesh.n_fibres * mesh.cells.size()));
    const auto groups = group_cells(mesh, lanes, 512);
    n_groups          = groups.size();
    offsets.resize(corners * lanes * n_groups);
    constants.resize(n_rows * lanes * n_groups);
    cell_of_lane.resize(lanes * n_groups, numbers::invalid_size_type);
    for (std::size_t g = 0; g < n_groups; ++g)
      for (unsigned int lane = 0; lane < groups[g].size(); ++lane)
        pack(mesh, groups[g][lane], g, lane);
  }

  template <int corners, typename Number>
  void TledCells<corners, Number>::pack(const CellMesh<corners> &mesh,
                                        const std::size_t        cell,
                                        const std::size_t        g,
                                        const unsigned int       lane)
  {
    Number    *next   = &constants[n_rows * lanes * g] + lane;
    const auto append = [&](const double number) {
      *next = number;
      next += lanes;
    };
    cell_of_lane[lanes * g + lane] = cell;
    for (int corner = 0; corner < corners; ++corner)
      offsets[(corners * g + corner) * lanes + lane] = node_record * mesh.cells[cell][corner];

    const auto places = corner_places(mesh, cell);
    const auto points = integration_points(places, n_points);
    for (const auto &point : points)
      {
        for (int corner = 1; corner < corners; ++corner)
          for (int d = 0; d < 3; ++d)
            append(point.gradients[corner][d]);
        append(point.volume);
      }
    if constexpr (corners == 8)
      if (n_points == 1)
        {
          // gamma = h - (h.x_j) dN/dx_j: h without what is affine in it
          double squares = 0.;
          for (const auto &gradient : points[0].gradients)
            squares += dot(gradient, gradient);
          for (int mode = 0; mode < 4; ++mode)
            {
              Vector3<double> moment = {};
              for (int a = 0; a < 8; ++a)
                for (int d = 0; d < 3; ++d)
                  moment[d] += hourglass_mode(mode, a) * places[a][d];
              for (int a = 1; a < 8; ++a)
                append(hourglass_mode(mode, a) - dot(moment, points[0].gradients[a]));
            }
          append(squares * points[0].volume);
        }
    for (std::size_t f = 0; f < mesh.n_fibres; ++f)
      for (int d = 0; d < 3; ++d)
        append(mesh.directions[mesh.n_fibres * cell + f][d]);
  }

  template <int corners, typename Number>
  CellSweep<Number> TledCells<corners, Number>::sweep(const SweepMaterial &material) const
  {
    Assert(material.n_fibres == n_fibres, ExcDimensionMismatch(material.n_fibres, n_fibres));
    CellSweep<Number> result;
    result.offsets   = offsets.data();
    result.constants = constants.data();
    result.n_groups  = n_groups;
    result.n_points  = n_points;
    result.material  = material;
    return result;
  }

  template <int corners, typename Number>
  std::optional<typename TledCells<corners, Number>::Inverted>
  TledCells<corners, Number>::inverted_cell(const Number *values, const double most) const
  {
    std::optional<Inverted> worst;
    for (std::size_t i = 0; i < cell_of_lane.size(); ++i)
      for (int q = 0; q < n_points; ++q)
        {
          const std::size_t    g = i / lanes, lane = i % lanes;
          const Number        *rows = &constants[(n_rows * g + q * (3 * corners - 2)) * lanes] + lane;
          const std::uint32_t *node = &offsets[corners * lanes * g] + lane;
          Matrix3<double>      h    = {};
          for (int corner = 1; corner < corners; ++corner)
            for (int c = 0; c < 3; ++c)
              for (int d = 0; d < 3; ++d)
                h(c, d) += (values[node[corner * lanes] + c] - values[node[0] + c]) *
                           rows[(3 * corner - 3 + d) * lanes];
          const double jacobian = Deformation<double>(h).jacobian;
          if (cell_of_lane[i] != numbers::invalid_size_type && !(jacobian > most) &&
              !(worst && jacobian >= worst->jacobian))
            worst = {cell_of_lane[i], jacobian};
        }
    return worst;
  }

  template <int corners>
  std::vector<double> lumped_volumes(const CellMesh<corners> &mesh)
  {
    std::vector<double> result(mesh.nodes.size(), 0.);
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
      {
        const auto points = integration_points(corner_places(mesh, cell), corners);
        for (unsigned int q = 0; q < points.size(); ++q)
          for (int a = 0; a < corners; ++a)
            {
              double shape = 1. / corners;
              if (corners == 8)
                for (int d = 0; d < 3; ++d)
                  shape *= 1. + sign(a, d) * sign(q, d) / std::sqrt(3.);
              result[mesh.cells[cell][a]] += shape * points[q].volume;
            }
      }
    return result;
  }

  template class TledCells<4, float>;
  template class TledCells<4, double>;
  template class TledCells<8, float>;
  template class TledCells<8, double>;
  template std::vector<double> lumped_volumes(const TetrahedraMesh &);
  template std::vector<double> lumped_volumes(const HexahedraMesh &);
} // namespace Cautery
