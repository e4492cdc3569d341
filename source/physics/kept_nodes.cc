// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/kept_nodes.h>

#include <deal.II/base/mpi.h>

namespace Cautery
{
  namespace
  {
    /// Marks nodes, also those of other processes.
    template <int dim>
    class Marks
    {
    public:
      explicit Marks(const Field<dim> &nodes) : nodes(nodes), marks(nodes.vector()) {}

      void add_cell(const typename Triangulation<dim>::active_cell_iterator &cell)
      {
        dofs.resize(nodes.element().n_dofs_per_cell());
        nodes.cell(cell)->get_dof_indices(dofs);
        for (const auto dof : dofs)
          marks(dof) += 1.;
      }

      void add_regions(const std::set<types::material_id> &regions)
      {
        for (const auto &cell : nodes.mesh().triangulation().active_cell_iterators())
          if (cell->is_locally_owned() && regions.count(cell->material_id()) == 1)
            add_cell(cell);
      }

      void add_probes(const std::vector<Probe> &probes, const PointLocator<dim> &locator)
      {
        std::vector<Point<dim>> places;
        for (const auto &probe : probes)
          {
            places.emplace_back();
            for (unsigned int d = 0; d < dim; ++d)
              places.back()[d] = probe.place[d];
          }
        for (const auto &found : locator.find(places))
          if (found.location)
            add_cell(found.location->cell);
      }

      void add_inside()
      {
        std::vector<types::global_dof_index> of_cell(nodes.element().n_dofs_per_cell());
        Vector                               on_surface = nodes.vector();
        for (const auto &cell : nodes.dof_handler().active_cell_iterators())
          if (cell->is_locally_owned())
            for (const unsigned int face : cell->face_indices())
              if (cell->face(face)->at_boundary())
                {
                  cell->get_dof_indices(of_cell);
                  for (const unsigned int i : nodes.on_face(face))
                    on_surface(of_cell[i]) += 1.;
                }
        on_surface.compress(VectorOperation::add);
        for (const auto node : nodes.owned())
          if (on_surface(node) == 0.)
            marks(node) += 1.;
      }

      IndexSet marked()
      {
        marks.compress(VectorOperation::add);
        IndexSet result(nodes.n_unknowns());
        for (const auto node : nodes.owned())
          if (marks(node) > 0.)
            result.add_index(node);
        return result;
      }

    private:
      const Field<dim>                    &nodes;
      Vector                               marks;
      std::vector<types::global_dof_index> dofs;
    };
  } // namespace

  template <int dim>
  IndexSet kept_nodes(const Scene &scene, const Field<dim> &nodes, const PointLocator<dim> &locator)
  {
    if (scene.numerics.kept_nodes.empty())
      return {};
    Marks<dim> marks(nodes);
    for (const auto &name : scene.numerics.kept_nodes)
      if (name == "inside")
        marks.add_inside();
      else if (name == "probes")
        marks.add_probes(scene.output.probes(), locator);
      else
        marks.add_regions(nodes.mesh().region_ids({name}, "Numerics/Kept nodes"));
    IndexSet   kept   = marks.marked();
    const auto n_kept = Utilities::MPI::sum(kept.n_elements(), nodes.communicator());
    AssertThrow(
      n_kept > 0 && n_kept < nodes.n_unknowns(),
      ExcInput("Numerics/Kept nodes keeps " + std::to_string(n_kept) + " of " +
               std::to_string(nodes.n_unknowns()) +
               " nodes, so that there is nothing to condense; name fewer or other nodes, or none for "
               "no condensation"));
    return kept;
  }

  template IndexSet kept_nodes(const Scene &, const Field<2> &, const PointLocator<2> &);
  template IndexSet kept_nodes(const Scene &, const Field<3> &, const PointLocator<3> &);
} // namespace Cautery
