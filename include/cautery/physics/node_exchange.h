// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/index_set.h>
#include <deal.II/base/partitioner.h>

namespace Cautery
{
  using namespace dealii;

  /**
   * Numbers at the nodes of a process, some for each: first those of its own nodes, then those of nodes of
   * other processes that its cells touch.
   */
  template <typename Number>
  class NodeExchange
  {
  public:
    using Numbers = AlignedVector<Number>;

    /** @p touched: the nodes of the process's cells, those of other processes among them. */
    NodeExchange(const IndexSet    &own,
                 const IndexSet    &touched,
                 const unsigned int n_components,
                 const MPI_Comm     communicator);

    std::uint32_t n_own() const { return partitioner.locally_owned_size() / n_components; }
    std::uint32_t n_all() const { return n_own() + partitioner.n_ghost_indices() / n_components; }
    MPI_Comm      communicator() const { return partitioner.get_mpi_communicator(); }

    std::uint32_t local(const types::global_dof_index node) const
    {
      return partitioner.global_to_local(n_components * node) / n_components;
    }
    types::global_dof_index global(const std::uint32_t node) const
    {
      return partitioner.local_to_global(n_components * node) / n_components;
    }

    Numbers zero() const { return Numbers(n_components * n_all(), Number(0.)); }

    /** Adds what other processes have found for this one's nodes, and forgets what it found for theirs. */
    void collect(Numbers &numbers);

    /** Fetches the numbers of other processes' nodes. */
    void update(Numbers &numbers);

  private:
    const unsigned int                n_components;
    const Utilities::MPI::Partitioner partitioner;
    const bool                        alone;
    Numbers                           travelling;
    std::vector<MPI_Request>          requests;
  };
} // namespace Cautery
