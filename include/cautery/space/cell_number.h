// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/grid/tria.h>

#include <cstdint>

namespace Cautery
{
  using namespace dealii;

  /// Signed: Open MPI 4.1 compares unsigned numbers of 64 bits as if they were signed.
  using CellNumber = std::int64_t;

  /** A cell's number in the undistributed mesh, the same for any number of processes. */
  template <int dim>
  CellNumber cell_number(const typename Triangulation<dim>::active_cell_iterator &cell)
  {
    const CellId id     = cell->id();
    CellNumber   number = id.get_coarse_cell_id();
    for (const auto child : id.get_child_indices())
      number = number * GeometryInfo<dim>::max_children_per_cell + child;
    return number;
  }

  /// How often a cell of the first mesh can be divided: `cell_order` leaves room for that.
  constexpr unsigned int most_divisions = 10;

  /** Numbers that differ between active cells of different sizes too, and are the same for any number of
   * processes: a cell has that of the first cell that it could be divided into. */
  template <int dim>
  CellNumber cell_order(const typename Triangulation<dim>::active_cell_iterator &cell)
  {
    return cell_number<dim>(cell) << (dim * (most_divisions - cell->level()));
  }

  /** How far apart such numbers are of cells on @p level of the mesh. */
  template <int dim>
  CellNumber cell_distance(const unsigned int level)
  {
    return CellNumber(1) << (dim * (most_divisions - level));
  }
} // namespace Cautery
