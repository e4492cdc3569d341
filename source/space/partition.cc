// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/child_process.h>
#include <cautery/base/exceptions.h>
#include <cautery/space/partition.h>

#include <deal.II/grid/grid_tools.h>

#include <cstring>
#include <vector>

namespace Cautery
{
  namespace
  {
    /// In bytes, of the active cells in their order.
    template <int dim>
    std::string cut(Triangulation<dim> &mesh, const unsigned int n)
    {
      GridTools::partition_triangulation(n, mesh, SparsityTools::Partitioner::metis);
      std::string parts;
      for (const auto &cell : mesh.active_cell_iterators())
        {
          const types::subdomain_id part = cell->subdomain_id();
          parts.append(reinterpret_cast<const char *>(&part), sizeof(part));
        }
      return parts;
    }
  } // namespace

  template <int dim>
  void partition(Triangulation<dim> &mesh, const unsigned int n)
  {
    const auto parts = found_by_child([&]() { return cut(mesh, n); });
    AssertThrow(parts && parts->size() == mesh.n_active_cells() * sizeof(types::subdomain_id),
                ExcRun("METIS cannot cut a mesh of " + std::to_string(mesh.n_active_cells()) +
                       " cells into " + std::to_string(n) + " parts; use fewer processes"));
    const char *next = parts->data();
    for (const auto &cell : mesh.active_cell_iterators())
      {
        types::subdomain_id part;
        std::memcpy(&part, next, sizeof(part));
        next += sizeof(part);
        cell->set_subdomain_id(part);
      }
  }

  template void partition(Triangulation<2> &, const unsigned int);
  template void partition(Triangulation<3> &, const unsigned int);
} // namespace Cautery
