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
   * Tetrahedra (four corners) or hexahedra (eight) of one material, before they are packed for the kernel.
   * Corners are in deal.II's order.
   */
  template <int corners>
  struct CellMesh
  {
    using Corners = std::array<std::uint32_t, corners>;

    std::vector<Point<3>> nodes; ///< of the undeformed body, m; best in an order that keeps neighbours near
    std::vector<Corners>  cells;
    std::vector<Vector3<double>>
                directions; ///< of the fibres: for each cell, one unit vector for each family
    std::size_t n_fibres = 0;
  };
  using TetrahedraMesh = CellMesh<4>;
  using HexahedraMesh  = CellMesh<8>;

  /** Gradients of the shape functions at a point of integration, and the volume that it stands for. */
  template <int corners>
  struct IntegrationPoint
  {
    Vector3<double> gradients[corners] = {}; ///< 1/m
    double          volume             = 0.; ///< m3
  };

  /**
   * The points of a cell: one of a tetrahedron; of a hexahedron eight, or one with the mean gradients, for
   * which the patch test holds on any cell (Flanagan and Belytschko 1981).
   */
  std::vector<IntegrationPoint<4>> integration_points(const std::array<Point<3>, 4> &corners,
                                                      const int                      n_points = 1);
  std::vector<IntegrationPoint<8>> integration_points(const std::array<Point<3>, 8> &corners,
                                                      const int                      n_points);

  /**
   * Cells of one material as the kernel reads them. They follow each other as their first nodes do; within a
   * window, cells without a common node are grouped, so that lanes need not wait for each other's forces.
   */
  template <int corners, typename Number>
  class TledCells
  {
  public:
    TledCells(const CellMesh<corners> &mesh, const unsigned int lanes, const int n_points = 1);

    /** What the kernel needs, but for the nodes' `values` and `forces` (and `hourglass`). */
    CellSweep<Number> sweep(const SweepMaterial &material) const;

    struct Inverted
    {
      std::size_t cell; ///< in the order of the mesh
      double      jacobian;
    };
    /** The cell with the least J, if that is at most @p most at a point for these @p values (node records);
     * slow, for the message. */
    std::optional<Inverted> inverted_cell(const Number *values, const double most) const;

  private:
    void
    pack(const CellMesh<corners> &mesh, const std::size_t cell, const std::size_t g, const unsigned int lane);

    const unsigned int           lanes;
    const int                    n_points;
    const std::size_t            n_fibres;
    const std::size_t            n_rows; ///< of constants
    std::size_t                  n_groups = 0;
    AlignedVector<std::uint32_t> offsets;
    AlignedVector<Number>        constants;
    std::vector<std::size_t>     cell_of_lane; ///< in the mesh
  };

  /** The places of the corners of a cell, m. */
  template <int corners>
  std::array<Point<3>, corners> corner_places(const CellMesh<corners> &mesh, const std::size_t cell)
  {
    std::array<Point<3>, corners> result;
    for (int corner = 0; corner < corners; ++corner)
      result[corner] = mesh.nodes[mesh.cells[cell][corner]];
    return result;
  }

  /** The volume that each node stands for, m3, the integral of its shape function: density times this is the
   * lumped mass. */
  template <int corners>
  std::vector<double> lumped_volumes(const CellMesh<corners> &mesh);
} // namespace Cautery
