// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/output/fields.h>

#include <deal.II/base/mpi.h>
#include <deal.II/numerics/data_out.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace Cautery
{
  namespace
  {
    /// Below this ln(Omega) nothing is dead by far; viewers do not bear -infinity.
    constexpr double least_ln_damage = -100.;

    template <int dim>
    dealii::Vector<float> regions(const Field<dim> &nodes)
    {
      dealii::Vector<float> result(nodes.mesh().triangulation().n_active_cells());
      for (const auto &cell : nodes.mesh().triangulation().active_cell_iterators())
        result(cell->active_cell_index()) = cell->material_id();
      return result;
    }
  } // namespace

  template <int dim>
  void Fields<dim>::observe(const Snapshot<dim> &snapshot)
  {
    const Field<dim>   &nodes = snapshot.nodes;
    std::vector<Vector> kept; // DataOut only points to them
    auto                columns = nodal_columns(snapshot);
    kept.reserve(columns.size() + 1);

    DataOut<dim> data;
    data.attach_triangulation(
      nodes.mesh().triangulation()); // before any data: for the regions, which have no DoFs
    if (snapshot.displacement != nullptr)
      {
        kept.push_back(snapshot.displacement->ghosted(snapshot.state.displacement));
        data.add_data_vector(snapshot.displacement->dof_handler(),
                             kept.back(),
                             std::vector<std::string>(dim, "displacement_m"),
                             std::vector<DataComponentInterpretation::DataComponentInterpretation>(
                               dim, DataComponentInterpretation::component_is_part_of_vector));
      }
    for (auto &column : columns)
      {
        if (column.name.rfind("displacement", 0) == 0)
          continue;
        if (column.name == "ln_damage")
          for (double &value : column.values)
            value = std::max(value, least_ln_damage);
        kept.push_back(nodes.ghosted(column.values));
        data.add_data_vector(nodes.dof_handler(), kept.back(), column.name);
      }
    if (snapshot.gradient_errors != nullptr)
      for (const auto &[field, error] : *snapshot.gradient_errors)
        data.add_data_vector(error.cells, error_column(field), DataOut<dim>::type_cell_data);
    const auto region = regions(nodes);
    data.add_data_vector(region, "region", DataOut<dim>::type_cell_data);

    DataOutBase::VtkFlags flags;
    flags.compression_level =
      DataOutBase::VtkFlags::best_speed; // ten times faster than the default, a third larger
    data.set_flags(flags);
    // a nonlinear cell cannot be written for simplices: two patches an edge show degree 2 as well
    data.build_patches(nodes.mapping(), nodes.element().degree);
    const std::string file = "solution_" + Utilities::int_to_string(written.size(), 4) + ".vtu";
    data.write_vtu_in_parallel(directory + "/" + file, nodes.communicator());
    written.emplace_back(snapshot.state.time, file);
    write_index(nodes.communicator());
  }

  template <int dim>
  void Fields<dim>::write_index(const MPI_Comm communicator) const
  {
    if (Utilities::MPI::this_mpi_process(communicator) != 0)
      return;
    // replaced in one go: a reader never sees half an index
    const std::string name = directory + "/solution.pvd";
    {
      std::ofstream index(name + ".part");
      DataOutBase::write_pvd_record(index, written);
      AssertThrow(index, ExcRun("cannot write " + name + ": is the disk full?"));
    }
    std::filesystem::rename(name + ".part", name);
  }

  template class Fields<2>;
  template class Fields<3>;
} // namespace Cautery
