// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/child_process.h>
#include <cautery/base/exceptions.h>
#include <cautery/space/partition.h>

#include <deal.II/base/utilities.h>

#include <deal.II/grid/grid_tools.h>

#include <vector>

namespace Cautery
{
  template <int dim>
  void partition(Triangulation<dim> &mesh, const unsigned int n)
  {
    using Parts     = std::vector<types::subdomain_id>; // of the active cells in their order
    const auto said = found_by_child([&]() {
      GridTools::partition_triangulation(n, mesh, SparsityTools::Partitioner::metis);
      Parts parts(mesh.n_active_cells());
      GridTools::get_subdomain_association(mesh, parts);
      const std::vector<char> bytes = Utilities::pack(parts, false);
      return std::string(bytes.begin(), bytes.end());
    });
    AssertThrow(said,
                ExcRun("METIS cannot cut a mesh of " + std::to_string(mesh.n_active_cells()) +
                       " cells into " + std::to_string(n) + " parts; use fewer processes"));
    const auto parts = Utilities::unpack<Parts>(std::vector<char>(said->begin(), said->end()), false);
    auto       part  = parts.begin();
    for (const auto &cell : mesh.active_cell_iterators())
      cell->set_subdomain_id(*part++);
  }

  template void partition(Triangulation<2> &, const unsigned int);
  template void partition(Triangulation<3> &, const unsigned int);
} // namespace Cautery
