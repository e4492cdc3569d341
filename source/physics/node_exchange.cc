// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/node_exchange.h>

#include <deal.II/base/mpi.h>

namespace Cautery
{
  namespace
  {
    IndexSet numbers_of(const IndexSet &nodes, const unsigned int n_components)
    {
      IndexSet result(n_components * nodes.size());
      for (auto interval = nodes.begin_intervals(); interval != nodes.end_intervals(); ++interval)
        result.add_range(n_components * *interval->begin(), n_components * (interval->last() + 1));
      result.compress();
      return result;
    }
  } // namespace

  template <typename Number>
  NodeExchange<Number>::NodeExchange(const IndexSet    &own,
                                     const IndexSet    &touched,
                                     const unsigned int n_components,
                                     const MPI_Comm     communicator)
    : n_components(n_components)
    , partitioner(numbers_of(own, n_components), numbers_of(touched, n_components), communicator)
    , alone(Utilities::MPI::n_mpi_processes(communicator) == 1)
    , travelling(partitioner.n_import_indices())
  {
  }

  template <typename Number>
  void NodeExchange<Number>::collect(Numbers &numbers)
  {
    if (alone)
      return;
    const unsigned int      own = partitioner.locally_owned_size();
    const ArrayView<Number> ghosts(numbers.data() + own, numbers.size() - own);
    constexpr unsigned int  channel = 0;
    partitioner.import_from_ghosted_array_start<Number, MemorySpace::Host>(
      VectorOperation::add,
      channel,
      ghosts,
      ArrayView<Number>(travelling.data(), travelling.size()),
      requests);
    partitioner.import_from_ghosted_array_finish<Number, MemorySpace::Host>(
      VectorOperation::add,
      ArrayView<const Number>(travelling.data(), travelling.size()),
      ArrayView<Number>(numbers.data(), own),
      ghosts,
      requests);
  }

  template <typename Number>
  void NodeExchange<Number>::update(Numbers &numbers)
  {
    if (alone)
      return;
    const unsigned int      own = partitioner.locally_owned_size();
    const ArrayView<Number> ghosts(numbers.data() + own, numbers.size() - own);
    constexpr unsigned int  channel = 1;
    partitioner.export_to_ghosted_array_start<Number, MemorySpace::Host>(
      channel,
      ArrayView<const Number>(numbers.data(), own),
      ArrayView<Number>(travelling.data(), travelling.size()),
      ghosts,
      requests);
    partitioner.export_to_ghosted_array_finish<Number, MemorySpace::Host>(ghosts, requests);
  }

  template class NodeExchange<float>;
  template class NodeExchange<double>;
} // namespace Cautery
