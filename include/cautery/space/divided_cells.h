// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/space/cell_number.h>

#include <map>
#include <memory>
#include <vector>

namespace Cautery
{
  /// What an adaption does to a cell.
  enum class CellChange : char
  {
    keep,
    refine, ///< into 2^dim
    coarsen ///< together with the others that were made of the same cell
  };

  /** The numbers (see `cell_order`) of the active cells of @p mesh, ascending. They say which cells of the
   * first mesh are divided, and how often. */
  template <int dim>
  std::vector<CellNumber> active_cells(const Triangulation<dim> &mesh);

  /**
   * The same after @p changes of some of them. More cells are refined and fewer coarsened, so that neighbours
   * across an edge differ by one division at most, and none come below the level @p coarsest.
   */
  template <int dim>
  std::vector<CellNumber> active_cells(const Triangulation<dim>               &mesh,
                                       const std::map<CellNumber, CellChange> &changes,
                                       const unsigned int                      coarsest);

  /**
   * @p first, its cells divided until the active ones are @p cells, which `active_cells` gave. Unlike one
   * that is refined and coarsened from mesh to mesh it does not depend on what came before, so that a run
   * that resumes has the same one. Errors: ExcInput where @p cells are of another mesh.
   */
  template <int dim>
  std::unique_ptr<Triangulation<dim>> divided(const Triangulation<dim>      &first,
                                              const std::vector<CellNumber> &cells);
} // namespace Cautery
