// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/exceptions.h>
#include <cautery/space/divided_cells.h>

#include <algorithm>
#include <string>

namespace Cautery
{
  template <int dim>
  std::vector<CellNumber> active_cells(const Triangulation<dim> &mesh)
  {
    std::vector<CellNumber> cells;
    for (const auto &cell : mesh.active_cell_iterators())
      cells.push_back(cell_order<dim>(cell));
    std::sort(cells.begin(), cells.end());
    return cells;
  }

  template <int dim>
  std::vector<CellNumber> active_cells(const Triangulation<dim>               &mesh,
                                       const std::map<CellNumber, CellChange> &changes,
                                       const unsigned int                      coarsest)
  {
    Triangulation<dim> flagged;
    flagged.copy_triangulation(mesh);
    for (const auto &cell : flagged.active_cell_iterators())
      {
        const auto change = changes.find(cell_order<dim>(cell));
        if (change == changes.end())
          continue;
        if (change->second == CellChange::refine)
          cell->set_refine_flag();
        else if (change->second == CellChange::coarsen && static_cast<unsigned int>(cell->level()) > coarsest)
          cell->set_coarsen_flag();
      }
    flagged.prepare_coarsening_and_refinement(); // takes flags away, and sets others
    std::vector<CellNumber> cells;
    for (const auto &cell : flagged.active_cell_iterators())
      {
        const CellNumber number = cell_order<dim>(cell);
        if (cell->refine_flag_set())
          for (unsigned int child = 0; child < GeometryInfo<dim>::max_children_per_cell; ++child)
            cells.push_back(number + child * cell_distance<dim>(cell->level() + 1));
        else if (!cell->coarsen_flag_set() || number % cell_distance<dim>(cell->level() - 1) == 0)
          cells.push_back(number); // of those that are merged, the first has the number of the whole
      }
    std::sort(cells.begin(), cells.end());
    return cells;
  }

  template <int dim>
  std::unique_ptr<Triangulation<dim>> divided(const Triangulation<dim>      &first,
                                              const std::vector<CellNumber> &cells)
  {
    auto result = std::make_unique<Triangulation<dim>>();
    result->copy_triangulation(first);
    bool more = true;
    while (more)
      {
        more = false;
        for (const auto &cell : result->active_cell_iterators())
          {
            const CellNumber number = cell_order<dim>(cell);
            const auto       next   = std::upper_bound(cells.begin(), cells.end(), number);
            if (next == cells.end() || *next >= number + cell_distance<dim>(cell->level()))
              continue;
            cell->set_refine_flag();
            more = true;
          }
        if (more)
          result->execute_coarsening_and_refinement();
      }
    AssertThrow(active_cells(*result) == cells,
                ExcInput("the " + std::to_string(cells.size()) +
                         " cells of an adapted mesh are not parts of the mesh that the scene begins with"));
    return result;
  }

  template std::vector<CellNumber> active_cells(const Triangulation<2> &);
  template std::vector<CellNumber> active_cells(const Triangulation<3> &);
  template std::vector<CellNumber>
  active_cells(const Triangulation<2> &, const std::map<CellNumber, CellChange> &, const unsigned int);
  template std::vector<CellNumber>
  active_cells(const Triangulation<3> &, const std::map<CellNumber, CellChange> &, const unsigned int);
  template std::unique_ptr<Triangulation<2>> divided(const Triangulation<2> &,
                                                     const std::vector<CellNumber> &);
  template std::unique_ptr<Triangulation<3>> divided(const Triangulation<3> &,
                                                     const std::vector<CellNumber> &);
} // namespace Cautery
