// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/grid/reference_cell.h>
#include <deal.II/grid/tria_description.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace Cautery
{
  using namespace dealii;

  /**
   * A mesh as plain arrays, before deal.II makes a triangulation of it. It lives on process 0 only.
   * Vertices are numbered in deal.II's order within each cell and face.
   */
  template <int dim>
  struct PlainMesh
  {
    std::vector<Point<dim>>        vertices; ///< m
    std::vector<CellData<dim>>     cells;    ///< all of one kind; the material id is the region
    std::vector<CellData<dim - 1>> faces;    ///< those with a boundary id, the surface

    std::map<types::material_id, std::string>
      regions; ///< the name of each region that has cells, "" for none
    std::map<types::boundary_id, std::string>
      surfaces; ///< the name of each surface that has faces, "" for none

    std::vector<std::string> notes; ///< what was mended, for the log
  };

  /** The determinant of the @p edges of a cell, over that of a cube with the same @p diameter. */
  template <int dim>
  double relative_volume(const Tensor<2, dim> &edges, const double diameter)
  {
    return diameter > 0. ? determinant(edges / (diameter / std::sqrt(dim))) : 0.;
  }

  /** deal.II calls a cell of a smaller relative volume distorted. */
  constexpr double least_volume = 1e-12;

  template <int dim>
  ReferenceCell reference_cell(const PlainMesh<dim> &mesh)
  {
    return ReferenceCell::n_vertices_to_type(dim, mesh.cells.front().vertices.size());
  }

  /**
   * Makes a mesh of unknown origin fit for deal.II. With a note each: drops duplicate cells, turns inverted
   * cells round, drops tagged faces that are not on the boundary, and points out coinciding vertices. Regions
   * and surfaces that have nothing left are forgotten; boundary faces of no surface become surface 0 without
   * a name.
   *
   * Errors: ExcInput, beginning with @p name, for coordinates that are not finite, cells or faces in two
   * groups, cells without volume (below least_volume), cells that are inverted at some corners only, and
   * faces that more than two cells share.
   */
  template <int dim>
  void tidy(PlainMesh<dim> &mesh, const std::string &name);
} // namespace Cautery
