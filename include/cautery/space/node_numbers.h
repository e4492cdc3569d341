// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/space/cell_number.h>
#include <cautery/space/field.h>

#include <algorithm>
#include <limits>

namespace Cautery
{
  /**
   * Numbers of the process's own nodes, in the order of vectors of the scalar field @p nodes, that do not
   * depend on how many processes there are: each node's place in the first of its cells.
   */
  template <int dim>
  std::vector<CellNumber> node_numbers(const Field<dim> &nodes)
  {
    std::vector<CellNumber> result(nodes.owned().n_elements(), std::numeric_limits<CellNumber>::max());
    std::vector<types::global_dof_index> dofs(nodes.element().n_dofs_per_cell());
    for (const auto &cell : nodes.dof_handler().active_cell_iterators())
      {
        if (cell->is_artificial())
          continue;
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          if (nodes.owned().is_element(dofs[i]))
            {
              CellNumber &number = result[nodes.owned().index_within_set(dofs[i])];
              number             = std::min<CellNumber>(number, cell_order<dim>(cell) * dofs.size() + i);
            }
      }
    return result;
  }
} // namespace Cautery
