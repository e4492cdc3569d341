// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/agreement.h>
#include <cautery/base/files.h>
#include <cautery/output/fields.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

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
    write(data, directory + "/" + file_name(times.size()), nodes.communicator());
    times.push_back(snapshot.state.time);
    fail_together(nodes.communicator(), [this]() { write_index(); });
  }

  template <int dim>
  std::string Fields<dim>::file_name(const unsigned int number) const
  {
    return "solution_" + Utilities::int_to_string(number, 4) + ".vtu";
  }

  /// Under its name once it is complete.
  template <int dim>
  void
  Fields<dim>::write(const DataOut<dim> &data, const std::string &file, const MPI_Comm communicator) const
  {
    const std::string part = file + ".part";
    errno                  = 0;
    try
      {
        if (Utilities::MPI::n_mpi_processes(communicator) == 1)
          {
            std::ofstream out(part);
            data.write_vtu(out);
            out.close();
            AssertThrow(out, ExcIO());
          }
        else
          data.write_vtu_in_parallel(part, communicator);
      }
    catch (const ExceptionBase &)
      {
        const std::string reason = errno != 0 ? std::strerror(errno) : "is the disk full?";
        std::remove(part.c_str());
        AssertThrow(false, ExcRun("cannot write " + file + ": " + reason));
      }
    fail_together(communicator, [&]() {
      if (indexes && std::rename(part.c_str(), file.c_str()) != 0)
        throw ExcRun("cannot write " + file + ": " + std::strerror(errno));
    });
  }

  template <int dim>
  void Fields<dim>::write_index() const
  {
    if (!indexes)
      return;
    std::vector<std::pair<double, std::string>> files;
    for (const double time : times)
      files.emplace_back(time, file_name(files.size()));
    std::ostringstream index;
    DataOutBase::write_pvd_record(index, files);
    replace_file(directory + "/solution.pvd", index.str());
  }

  template <int dim>
  void Fields<dim>::archive(Archive &archive)
  {
    archive.shared("fields", times);
    if (!indexes || !archive.restores())
      return;
    std::error_code error;
    for (unsigned int i = times.size(); std::filesystem::remove(directory + "/" + file_name(i), error); ++i)
      ;
    write_index();
  }

  template class Fields<2>;
  template class Fields<3>;
} // namespace Cautery
