// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/space/mesh.h>

#include <deal.II/base/point.h>
#include <deal.II/numerics/rtree.h>

#include <optional>
#include <string>
#include <vector>

namespace Cautery
{
  /**
   * Finds the cell around a place, and the one process that owns it. A place on a face or a node lies in
   * several cells; the one of the lowest number in the undistributed mesh is taken, so that the choice does
   * not depend on the number of processes. (The library's own search is wrong in simplices: it tests against
   * the unit cube.)
   */
  template <int dim>
  class PointLocator
  {
  public:
    /** A place within a locally owned cell; @p unit is in the reference cell, within 1e-9. */
    struct Location
    {
      typename Triangulation<dim>::active_cell_iterator cell;
      Point<dim>                                        unit;
    };

    /** `location` on the process that owns the place and nothing on the others, or `outside` on all. */
    struct Result
    {
      std::optional<Location> location;
      bool                    outside = false;
    };

    explicit PointLocator(const Mesh<dim> &mesh);

    /** Collective, with the same places (m) on all processes: one reduction for all of them. */
    std::vector<Result> find(const std::vector<Point<dim>> &places) const;

    /**
     * As `find`, for places that must lie within the body, each with the name of who wants it.
     * Errors: ExcInput "name: (x, y, z) m lies outside ...", with the nearest node.
     */
    std::vector<std::optional<Location>> find_inside(const std::vector<Point<dim>>  &places,
                                                     const std::vector<std::string> &names) const;

  private:
    using Cell = typename Triangulation<dim>::active_cell_iterator;

    std::optional<Location> find_among_own(const Point<dim> &place) const;
    Point<dim>              nearest_vertex(const Point<dim> &place) const;

    const Mesh<dim>                         &mesh;
    RTree<std::pair<BoundingBox<dim>, Cell>> boxes; ///< of the locally owned cells
  };
} // namespace Cautery
