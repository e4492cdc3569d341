// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/node_exchange.h>
#include <cautery/physics/tled_kernel.h>
#include <cautery/space/field.h>

namespace Cautery
{
  /**
   * The nodes of explicit loops on a process: records of node_record numbers, first those of its own nodes in
   * the order of the field's vectors, then those of nodes of other processes that its cells touch.
   */
  template <typename Number>
  class TledNodes
  {
  public:
    using Records = typename NodeExchange<Number>::Numbers;

    /** @p field: the scalar field, of degree 1. */
    explicit TledNodes(const Field<3> &field);

    std::uint32_t n_own() const { return records.n_own(); }
    std::uint32_t n_all() const { return records.n_all(); }
    MPI_Comm      communicator() const { return records.communicator(); }

    /** Of all, in the undeformed body, m. */
    const std::vector<Point<3>> &places() const { return corners; }

    /** Of all cells' edges, m. Collective. */
    double shortest_edge() const;

    /** The place in the records of the unknown @p node of the scalar field. */
    std::uint32_t local(const types::global_dof_index node) const { return records.local(node); }

    /** What all processes together have found for this one's nodes, each by its own cells: one number a node.
     */
    std::vector<double> sum(const std::vector<double> &of_all) const;

    Records zero() const { return records.zero(); }
    void    collect(Records &values) { records.collect(values); } ///< see NodeExchange
    void    update(Records &values) { records.update(values); }

    /** The same for one number a node. */
    NodeExchange<Number> scalars() const;

  private:
    const Field<3>       &field;
    const IndexSet        touched;
    NodeExchange<Number>  records;
    std::vector<Point<3>> corners;
  };
} // namespace Cautery
