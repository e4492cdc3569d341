// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/space/box.h>
#include <cautery/space/mesh.h>
#include <cautery/space/mesh_file.h>
#include <cautery/space/partition.h>

#include <deal.II/distributed/fully_distributed_tria.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_description.h>

#include <algorithm>

namespace Cautery
{
  namespace
  {
    constexpr unsigned int root = 0;

    template <int dim>
    SubCellData boundary_faces(const PlainMesh<dim> &mesh)
    {
      SubCellData faces;
      if constexpr (dim == 2)
        faces.boundary_lines = mesh.faces;
      else
        faces.boundary_quads = mesh.faces;
      return faces;
    }

    /**
     * Where the part of a process ends, faces of ghost cells look like the body's surface, of number 0. They
     * get a number that no surface has.
     */
    template <int dim>
    void mark_ends_of_part(const TriangulationDescription::Description<dim, dim> &part,
                           Triangulation<dim>                                    &cells)
    {
      for (const auto &level : part.cell_infos)
        for (const auto &info : level)
          {
            const auto cell = cells.create_cell_iterator(CellId(info.id));
            if (!cell->is_active() || !cell->is_ghost())
              continue;
            for (const unsigned int face : cell->face_indices())
              if (cell->face(face)->at_boundary() &&
                  std::none_of(info.boundary_ids.begin(), info.boundary_ids.end(), [face](const auto &real) {
                    return real.first == face;
                  }))
                cell->face(face)->set_boundary_id(no_surface);
          }
    }

    /** Runs @p work on the root process alone; where it rejects the input there, all processes reject it. */
    template <typename Work>
    void on_root(const MPI_Comm communicator, const Work &work)
    {
      std::string error;
      if (Utilities::MPI::this_mpi_process(communicator) == root)
        try
          {
            work();
          }
        catch (const ExcInput &exception)
          {
            error = message_of(exception);
          }
      error = Utilities::MPI::broadcast(communicator, error, root);
      AssertThrow(error.empty(), ExcInput(error));
    }

    template <typename Id>
    std::set<Id> ids(const std::map<Id, std::string> &names,
                     const std::vector<std::string>  &texts,
                     const std::string               &kind,
                     const std::string               &mesh,
                     const std::string               &parameter)
    {
      std::set<Id> found;
      for (const auto &text : texts)
        {
          bool known = false;
          for (const auto &[id, name] : names)
            if (text == "all" || text == name || text == std::to_string(id))
              {
                found.insert(id);
                known = true;
              }
          std::vector<std::string> existing;
          for (const auto &[id, name] : names)
            existing.push_back(std::to_string(id) + (name.empty() ? "" : " `" + name + "`"));
          AssertThrow(known,
                      ExcInput(parameter + ": there is no " + kind + " `" + text + "` in the mesh " + mesh +
                               "; give a name or number of: " + join(existing) + "; or all"));
        }
      return found;
    }
  } // namespace

  template <int dim>
  Mesh<dim>::Mesh(const MeshSettings &settings, const MPI_Comm communicator)
    : mpi_communicator(communicator)
    , adaptive(settings.adaptive.is_on())
    , coarsest(settings.refinements)
    , label(settings.shape == MeshSettings::Shape::box ? "box" : "`" + settings.file_name + "`")
  {
    std::unique_ptr<Triangulation<dim>> all;
    on_root(communicator, [&]() {
      all = make_whole(settings);
      if (adaptive)
        {
          first = std::make_shared<Triangulation<dim>>();
          first->copy_triangulation(*all);
        }
    });
    distribute(std::move(all));
    finish();
    AssertThrow(
      !adaptive || !simplices(),
      ExcInput("Mesh/Adaptive/Follow needs hexahedra (in two dimensions quadrilaterals), but the mesh " +
               label + " has simplices; choose nothing"));
  }

  template <int dim>
  Mesh<dim>::Mesh(const Mesh &mesh, const std::vector<CellNumber> &cells)
    : mpi_communicator(mesh.mpi_communicator)
    , adaptive(true)
    , coarsest(mesh.coarsest)
    , label(mesh.label)
    , first(mesh.first)
    , region_names(mesh.region_names)
    , surface_names(mesh.surface_names)
    , box(mesh.box)
    , mended(mesh.mended)
  {
    std::unique_ptr<Triangulation<dim>> all;
    on_root(mpi_communicator, [&]() { all = divided(*first, cells); });
    distribute(std::move(all));
    finish();
  }

  template <int dim>
  void Mesh<dim>::finish()
  {
    share_description();
    if (simplices())
      linear_mapping = std::make_unique<MappingFE<dim>>(FE_SimplexP<dim>(1));
    else
      linear_mapping = std::make_unique<MappingQ<dim>>(1);
    measure_volumes();
  }

  template <int dim>
  std::unique_ptr<Triangulation<dim>> Mesh<dim>::make_whole(const MeshSettings &settings)
  {
    PlainMesh<dim> plain;
    if (settings.shape == MeshSettings::Shape::box)
      plain = make_box<dim>(settings);
    else
      {
        plain = read_mesh_file<dim>(settings);
        tidy(plain, "Mesh file " + label);
      }
    region_names  = plain.regions;
    surface_names = plain.surfaces;
    mended        = plain.notes;
    box           = BoundingBox<dim>(plain.vertices);

    auto whole = std::make_unique<Triangulation<dim>>();
    whole->create_triangulation(plain.vertices, plain.cells, boundary_faces(plain));
    whole->refine_global(settings.refinements);
    const unsigned int n_processes = Utilities::MPI::n_mpi_processes(mpi_communicator);
    AssertThrow(whole->n_active_cells() >= n_processes,
                ExcInput("The mesh " + label + " has " + std::to_string(whole->n_active_cells()) +
                         " cells for " + std::to_string(n_processes) +
                         " processes; use fewer processes or smaller cells"));
    return whole;
  }

  template <int dim>
  std::vector<CellNumber> Mesh<dim>::cells_of_all() const
  {
    return Utilities::MPI::this_mpi_process(mpi_communicator) == root ? active_cells(undistributed()) :
                                                                        std::vector<CellNumber>();
  }

  template <int dim>
  std::vector<CellNumber> Mesh<dim>::cells_of_all(const std::vector<CellChange> &changes) const
  {
    std::map<CellNumber, char> own;
    for (const auto &cell : cells->active_cell_iterators())
      if (cell->is_locally_owned() && changes[cell->active_cell_index()] != CellChange::keep)
        own[cell_order<dim>(cell)] = static_cast<char>(changes[cell->active_cell_index()]);
    std::map<CellNumber, CellChange> all;
    for (const auto &part : Utilities::MPI::gather(mpi_communicator, own, root))
      for (const auto &[cell, change] : part)
        all[cell] = static_cast<CellChange>(change);
    return Utilities::MPI::this_mpi_process(mpi_communicator) == root ?
             active_cells(undistributed(), all, coarsest) :
             std::vector<CellNumber>();
  }

  template <int dim>
  void Mesh<dim>::distribute(std::unique_ptr<Triangulation<dim>> new_whole)
  {
    if (new_whole)
      vertices = new_whole->n_used_vertices();
    const unsigned int n_processes = Utilities::MPI::n_mpi_processes(mpi_communicator);
    if (n_processes == 1)
      {
        cells = std::move(new_whole);
        return;
      }
    whole = std::move(new_whole);

    using Description = TriangulationDescription::Description<dim, dim>;
    std::map<unsigned int, Description> parts;
    if (whole)
      {
        partition(*whole, n_processes);
        for (unsigned int process = 0; process < n_processes; ++process)
          parts[process] = TriangulationDescription::Utilities::create_description_from_triangulation(
            *whole, mpi_communicator, TriangulationDescription::Settings::default_setting, process);
        if (!adaptive)
          whole.reset();
      }
    Description part = Utilities::MPI::some_to_some(mpi_communicator, parts).at(root);
    part.comm        = mpi_communicator; // which does not travel
    auto distributed = std::make_unique<parallel::fullydistributed::Triangulation<dim>>(mpi_communicator);
    distributed->create_triangulation(part);
    mark_ends_of_part<dim>(part, *distributed);
    cells = std::move(distributed);
  }

  template <int dim>
  void Mesh<dim>::share_description()
  {
    region_names  = Utilities::MPI::broadcast(mpi_communicator, region_names, root);
    surface_names = Utilities::MPI::broadcast(mpi_communicator, surface_names, root);
    mended        = Utilities::MPI::broadcast(mpi_communicator, mended, root);
    vertices      = Utilities::MPI::broadcast(mpi_communicator, vertices, root);
    box = BoundingBox<dim>(Utilities::MPI::broadcast(mpi_communicator, box.get_boundary_points(), root));
  }

  template <int dim>
  void Mesh<dim>::measure_volumes()
  {
    for (const auto &region : region_names)
      region_volumes[region.first] = 0.;
    for (const auto &cell : cells->active_cell_iterators())
      if (cell->is_locally_owned())
        region_volumes.at(cell->material_id()) += cell->measure();
    for (auto &region : region_volumes)
      region.second = Utilities::MPI::sum(region.second, mpi_communicator);
  }

  template <int dim>
  double Mesh<dim>::volume() const
  {
    double sum = 0.;
    for (const auto &region : region_volumes)
      sum += region.second;
    return sum;
  }

  template <int dim>
  std::set<types::material_id> Mesh<dim>::region_ids(const std::vector<std::string> &texts,
                                                     const std::string              &parameter) const
  {
    return ids(region_names, texts, "region", label, parameter);
  }

  template <int dim>
  std::set<types::boundary_id> Mesh<dim>::surface_ids(const std::vector<std::string> &texts,
                                                      const std::string              &parameter) const
  {
    return ids(surface_names, texts, "surface", label, parameter);
  }

  template class Mesh<2>;
  template class Mesh<3>;
} // namespace Cautery
