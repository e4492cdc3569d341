// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/tled_nodes.h>

#include <algorithm>
#include <limits>

namespace Cautery
{
  namespace
  {
    IndexSet nodes_of_own_cells(const Field<3> &field)
    {
      std::vector<types::global_dof_index> touched, dofs(field.element().n_dofs_per_cell());
      for (const auto &cell : field.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          {
            cell->get_dof_indices(dofs);
            touched.insert(touched.end(), dofs.begin(), dofs.end());
          }
      std::sort(touched.begin(), touched.end());
      touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
      IndexSet result(field.n_unknowns());
      result.add_indices(touched.begin(), touched.end());
      result.compress();
      return result;
    }
  } // namespace

  template <typename Number>
  TledNodes<Number>::TledNodes(const Field<3> &field)
    : field(field)
    , touched(nodes_of_own_cells(field))
    , records(field.owned(), touched, node_record, field.communicator())
    , corners(n_all())
  {
    std::vector<types::global_dof_index> dofs(field.element().n_dofs_per_cell());
    for (const auto &cell : field.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(dofs);
          for (unsigned int corner = 0; corner < dofs.size(); ++corner)
            corners[local(dofs[corner])] = cell->vertex(corner);
        }
  }

  template <typename Number>
  NodeExchange<Number> TledNodes<Number>::scalars() const
  {
    return NodeExchange<Number>(field.owned(), touched, 1, field.communicator());
  }

  template <typename Number>
  double TledNodes<Number>::shortest_edge() const
  {
    double shortest = std::numeric_limits<double>::max();
    for (const auto &cell : field.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int line : cell->line_indices())
          shortest = std::min(shortest, cell->line(line)->diameter());
    return Utilities::MPI::min(shortest, communicator());
  }

  template <typename Number>
  std::vector<double> TledNodes<Number>::sum(const std::vector<double> &of_all) const
  {
    Vector sums = field.vector();
    for (std::uint32_t node = 0; node < n_all(); ++node)
      sums(records.global(node)) += of_all[node];
    sums.compress(VectorOperation::add);
    return {sums.begin(), sums.end()};
  }

  template class TledNodes<float>;
  template class TledNodes<double>;
} // namespace Cautery
