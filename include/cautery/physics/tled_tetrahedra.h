// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/tled_kernel.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/point.h>

#include <array>
#include <optional>
#include <vector>

namespace Cautery
{
  using namespace dealii;

  /**
   * Tetrahedra of one material, before they are packed for the kernel.
   */
  struct TetrahedraMesh
  {
    using Corners = std::array<std::uint32_t, 4>;

    std::vector<Point<3>> nodes; ///< of the undeformed body, m; best in an order that keeps neighbours near
    std::vector<Corners>  cells;
    std::vector<Vector3<double>>
                directions; ///< of the fibres: for each cell, one unit vector for each family
    std::size_t n_fibres = 0;
  };

  /** Shape functions of a linear tetrahedron. */
  struct TetrahedronShape
  {
    explicit TetrahedronShape(const std::array<Point<3>, 4> &corners);

    Vector3<double> gradients[4]; ///< 1/m
    double          volume;       ///< m3
  };

  /**
   * Tetrahedra of one material as the kernel reads them. Cells follow each other as their first nodes do;
   * within a window, cells without a common node are grouped, so that lanes need not wait for each other's
   * forces.
   */
  template <typename Number>
  class TledTetrahedra
  {
  public:
    TledTetrahedra(const TetrahedraMesh &mesh, const unsigned int lanes);

    /** What the kernel needs, but for the nodes' `values` and `forces`. */
    TetrahedraSweep<Number> sweep(const SweepMaterial &material) const;

    std::size_t n_cells() const { return cells; }

    /** The first cell, in the order of the mesh, whose J is not positive for these @p values (node records).
     */
    std::optional<std::size_t> inverted_cell(const Number *values) const;

  private:
    void pack(const TetrahedraMesh &mesh, const std::vector<std::size_t> &group, const std::size_t g);

    const unsigned int           lanes;
    const std::size_t            n_rows; ///< of constants
    const std::size_t            cells;
    std::size_t                  n_groups;
    AlignedVector<std::uint32_t> offsets;
    AlignedVector<Number>        constants;
    std::vector<std::size_t>     cell_of_lane; ///< in the mesh
  };

  /** A quarter of each cell's volume at its corners, m3: density times this is the lumped mass. */
  std::vector<double> lumped_volumes(const TetrahedraMesh &mesh);
} // namespace Cautery
