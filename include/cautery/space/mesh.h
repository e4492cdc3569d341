// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/scene/mesh_settings.h>
#include <cautery/space/divided_cells.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/mpi.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/grid/tria.h>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace Cautery
{
  using namespace dealii;

  template <int dim>
  struct PlainMesh;

  /** The number of faces at which the part of a process ends inside the body; seen on ghost cells only. */
  constexpr types::boundary_id no_surface = numbers::internal_face_boundary_id - 1;

  /**
   * The body as cells of one kind, simplices or hypercubes, distributed over the processes.
   *
   * Process 0 makes or reads the mesh, mends and checks it (see `tidy`), refines it, cuts it with METIS and
   * sends each process its part. On one process the triangulation is a plain serial one: a distributed one
   * would only double time and memory. Either way ask `communicator()`, not the triangulation, for the
   * communicator.
   */
  template <int dim>
  class Mesh
  {
  public:
    /** Collective. Errors: ExcInput on all processes, see `make_box`, `read_mesh_file` and `tidy`. */
    Mesh(const MeshSettings &settings, const MPI_Comm communicator);

    /**
     * That mesh, which must be adaptive, with the cells @p cells: see `cells_of_all`. Collective. Errors:
     * ExcInput where these are of another mesh.
     */
    Mesh(const Mesh &mesh, const std::vector<CellNumber> &cells);

    /**
     * On process 0 the numbers (see `cell_order`) of all active cells, ascending; nothing on others. They are
     * all that an adapted mesh depends on, beside the scene.
     */
    std::vector<CellNumber> cells_of_all() const;

    /**
     * The same after @p changes, by the active cell index of each process, of its own cells. More cells are
     * refined and fewer coarsened, so that neighbours across an edge differ by one division at most, and none
     * are coarser than the scene's mesh. Hypercubes only. Collective.
     */
    std::vector<CellNumber> cells_of_all(const std::vector<CellChange> &changes) const;

    MPI_Comm                  communicator() const { return mpi_communicator; }
    const Triangulation<dim> &triangulation() const { return *cells; }
    const Mapping<dim>       &mapping() const { return *linear_mapping; }

    /** How often the cell was divided since the scene's mesh. */
    unsigned int divisions(const typename Triangulation<dim>::active_cell_iterator &cell) const
    {
      return cell->level() - coarsest;
    }
    ReferenceCell reference_cell() const { return cells->get_reference_cells().front(); }
    bool          simplices() const { return reference_cell().is_simplex(); }

    types::global_cell_index n_cells() const { return cells->n_global_active_cells(); }
    std::size_t              n_vertices() const { return vertices; }

    /** What the mesh is called in messages: "box" or the file's name. */
    const std::string &name() const { return label; }

    /** Those that have cells or faces, with their names ("" for none). Surface 0 has no physical group. */
    const std::map<types::material_id, std::string> &regions() const { return region_names; }
    const std::map<types::boundary_id, std::string> &surfaces() const { return surface_names; }

    /** Of each region, and of all (m^dim). */
    const std::map<types::material_id, double> &volumes() const { return region_volumes; }
    double                                      volume() const;
    const BoundingBox<dim>                     &bounding_box() const { return box; } ///< m

    /** What was mended in the file, one line each. */
    const std::vector<std::string> &notes() const { return mended; }

    /**
     * The ids that a user's texts mean: names, numbers, or "all". A name that several ids bear means all of
     * them. Errors: ExcInput that lists what there is.
     */
    std::set<types::material_id> region_ids(const std::vector<std::string> &texts,
                                            const std::string              &parameter) const;
    std::set<types::boundary_id> surface_ids(const std::vector<std::string> &texts,
                                             const std::string              &parameter) const;

  private:
    std::unique_ptr<Triangulation<dim>> make_whole(const MeshSettings &settings);
    const Triangulation<dim>           &undistributed() const { return whole ? *whole : *cells; }
    void                                distribute(std::unique_ptr<Triangulation<dim>> new_whole);
    void                                finish();
    void                                share_description();
    void                                measure_volumes();

    MPI_Comm                                  mpi_communicator;
    const bool                                adaptive;
    const unsigned int                        coarsest; ///< level: that of the scene's mesh
    std::string                               label;
    std::shared_ptr<Triangulation<dim>>       first; ///< the scene's mesh: of process 0, where it is adaptive
    std::unique_ptr<Triangulation<dim>>       whole; ///< of process 0, where it is distributed and adaptive
    std::unique_ptr<Triangulation<dim>>       cells;
    std::unique_ptr<Mapping<dim>>             linear_mapping;
    std::map<types::material_id, std::string> region_names;
    std::map<types::boundary_id, std::string> surface_names;
    std::map<types::material_id, double>      region_volumes;
    BoundingBox<dim>                          box;
    std::size_t                               vertices = 0;
    std::vector<std::string>                  mended;
  };
} // namespace Cautery
