// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/output/ablation_zone.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Cautery
{
  namespace
  {
    /**
     * The unit cube, cut into n^dim cubes and each of these into dim! simplices along its diagonal (Kuhn).
     * Those with x >= y >= z fill one simplex, which (x - y, y - z, z) maps to the reference simplex.
     */
    template <int dim>
    std::vector<std::vector<Point<dim>>> linear_parts(const bool simplices, const unsigned int n)
    {
      std::vector<std::vector<Point<dim>>> parts;
      unsigned int                         n_cubes = 1;
      for (unsigned int d = 0; d < dim; ++d)
        n_cubes *= n;
      for (unsigned int cube = 0; cube < n_cubes; ++cube)
        {
          Point<dim> corner;
          for (unsigned int d = 0, rest = cube; d < dim; ++d, rest /= n)
            corner[d] = static_cast<double>(rest % n) / n;
          std::array<unsigned int, dim> order;
          std::iota(order.begin(), order.end(), 0);
          do
            {
              std::vector<Point<dim>> part = {corner};
              for (const unsigned int d : order)
                {
                  part.push_back(part.back());
                  part.back()[d] += 1. / n;
                }
              const auto inside = [](const Point<dim> &p) {
                for (unsigned int d = 0; d + 1 < dim; ++d)
                  if (p[d] < p[d + 1] - 1e-12)
                    return false;
                return true;
              };
              if (simplices && !std::all_of(part.begin(), part.end(), inside))
                continue;
              if (simplices)
                for (auto &p : part)
                  for (unsigned int d = 0; d + 1 < dim; ++d)
                    p[d] -= p[d + 1];
              parts.push_back(part);
            }
          while (std::next_permutation(order.begin(), order.end()));
        }
      return parts;
    }

    /// Where a linear function falls from @p above to zero on its way to @p below, as a share of the way.
    double way_to_zero(const double above, const double below) { return above / (above - below); }

    /// The share of a triangle or tetrahedron in which the linear function with these corner values is not
    /// negative.
    double share_above_zero(std::vector<double> values)
    {
      std::sort(values.begin(), values.end(), std::greater<double>());
      const unsigned int n = values.size();
      const unsigned int n_above =
        std::count_if(values.begin(), values.end(), [](double v) { return v >= 0.; });
      const auto cut_off = [&](const unsigned int corner) {
        double share = 1.;
        for (unsigned int j = 0; j < n; ++j)
          if (j != corner)
            share *= values[corner] >= 0. ? way_to_zero(values[corner], values[j]) :
                                            1. - way_to_zero(values[j], values[corner]);
        return share;
      };
      if (n_above == 0 || n_above == n)
        return n_above == 0 ? 0. : 1.;
      if (n_above == 1)
        return cut_off(0);
      if (n_above == n - 1)
        return 1. - cut_off(n - 1);
      // a tetrahedron with two corners on each side: a wedge, made of three tetrahedra
      const double ac = way_to_zero(values[0], values[2]), ad = way_to_zero(values[0], values[3]);
      const double bc = way_to_zero(values[1], values[2]), bd = way_to_zero(values[1], values[3]);
      return bc * bd + ac * ad * (1. - bd) + ac * (1. - bc) * bd;
    }

    template <int dim>
    double simplex_volume(const std::vector<Point<dim>> &corners)
    {
      Tensor<2, dim> edges;
      for (unsigned int d = 0; d < dim; ++d)
        edges[d] = corners[d + 1] - corners[0];
      return std::abs(determinant(edges)) / (dim == 3 ? 6. : 2.);
    }
  } // namespace

  template <int dim>
  AblationZone<dim>::AblationZone(const Point<3> &about, const Field<dim> &nodes)
  {
    for (unsigned int d = 0; d < dim; ++d)
      centre[d] = about[d];
    const auto &support = nodes.element().get_unit_support_points();
    for (const auto &corners : linear_parts<dim>(nodes.mesh().simplices(), nodes.element().degree))
      {
        parts.emplace_back();
        for (const auto &corner : corners)
          parts.back().push_back(std::min_element(support.begin(),
                                                  support.end(),
                                                  [&corner](const Point<dim> &a, const Point<dim> &b) {
                                                    return a.distance_square(corner) <
                                                           b.distance_square(corner);
                                                  }) -
                                 support.begin());
      }
  }

  template <int dim>
  void AblationZone<dim>::add_part(const std::vector<Point<dim>> &corners,
                                   const std::vector<double>     &ln_damage,
                                   const types::material_id       region)
  {
    const double share = share_above_zero(ln_damage);
    if (share == 0.)
      return;
    dead[region] += share * simplex_volume(corners);
    // the farthest point of the dead part is one of its corners: a corner of the simplex, or a cut edge
    for (unsigned int i = 0; i < corners.size(); ++i)
      if (ln_damage[i] >= 0.)
        {
          largest = std::max(largest, centre.distance(corners[i]));
          for (unsigned int j = 0; j < corners.size(); ++j)
            if (ln_damage[j] < 0.)
              largest = std::max(largest,
                                 centre.distance(corners[i] + way_to_zero(ln_damage[i], ln_damage[j]) *
                                                                (corners[j] - corners[i])));
        }
  }

  template <int dim>
  void AblationZone<dim>::observe(const Snapshot<dim> &snapshot)
  {
    const Field<dim>                    &nodes     = snapshot.nodes;
    const Vector                         ln_damage = nodes.ghosted(snapshot.state.ln_damage);
    std::vector<types::global_dof_index> dofs(nodes.element().n_dofs_per_cell());
    std::vector<Point<dim>>              corners(dim + 1);
    std::vector<double>                  values(dim + 1);
    largest = 0.;
    dead.clear();
    for (const auto &[region, name] : nodes.mesh().regions())
      dead[region] = 0.;
    for (const auto &cell : nodes.dof_handler().active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        cell->get_dof_indices(dofs);
        for (const auto &part : parts)
          {
            for (unsigned int i = 0; i < part.size(); ++i)
              values[i] = ln_damage(dofs[part[i]]);
            if (*std::max_element(values.begin(), values.end()) < 0.)
              continue;
            for (unsigned int i = 0; i < part.size(); ++i)
              corners[i] = nodes.mapping().transform_unit_to_real_cell(
                cell, nodes.element().unit_support_point(part[i]));
            add_part(corners, values, cell->material_id());
          }
      }
    for (auto &[region, volume] : dead)
      volume = Utilities::MPI::sum(volume, nodes.communicator());
    largest = Utilities::MPI::max(largest, nodes.communicator());
  }

  template <int dim>
  double AblationZone<dim>::volume() const
  {
    double sum = 0.;
    for (const auto &[region, volume] : dead)
      sum += volume;
    return sum;
  }

  template class AblationZone<2>;
  template class AblationZone<3>;
} // namespace Cautery
