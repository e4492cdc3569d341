// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/agreement.h>
#include <cautery/output/reactions.h>

#include <deal.II/base/mpi.h>

#include <iomanip>
#include <sstream>

namespace Cautery
{
  namespace
  {
    using Nodes = std::set<types::global_dof_index>;

    template <int dim>
    Nodes
    on_boundary(const Field<dim> &nodes, const BoundaryMap<dim> &boundaries, const unsigned int boundary)
    {
      Nodes                                result;
      std::vector<types::global_dof_index> dofs(nodes.element().n_dofs_per_cell());
      for (const auto &cell : nodes.dof_handler().active_cell_iterators())
        {
          if (cell->is_artificial() || !cell->at_boundary())
            continue;
          cell->get_dof_indices(dofs);
          for (const unsigned int face : cell->face_indices())
            if (cell->face(face)->at_boundary() && cell->face(face)->boundary_id() != no_surface &&
                boundaries.index(cell->face(face)->boundary_id()) == boundary)
              for (const unsigned int i : nodes.on_face(face))
                result.insert(dofs[i]);
        }
      return result;
    }

    template <int dim>
    Nodes within(const Field<dim> &nodes, const Point<3> &centre, const double radius)
    {
      Nodes                                result;
      std::vector<types::global_dof_index> dofs(nodes.element().n_dofs_per_cell());
      for (const auto &cell : nodes.dof_handler().active_cell_iterators())
        {
          if (!cell->is_locally_owned())
            continue;
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            {
              const auto place =
                nodes.mapping().transform_unit_to_real_cell(cell, nodes.element().unit_support_point(i));
              if (in_space<dim>(place).distance(centre) <= radius)
                result.insert(dofs[i]);
            }
        }
      return result;
    }
  } // namespace

  template <int dim>
  Reactions<dim>::Reactions(const Scene &scene, const Field<dim> &nodes, const BoundaryMap<dim> &boundaries)
    : scene(scene), nodes(&nodes)
  {
    find(boundaries);
  }

  template <int dim>
  void Reactions<dim>::use_mesh(const Field<dim> &new_nodes,
                                const PointLocator<dim> &,
                                const BoundaryMap<dim> &boundaries)
  {
    nodes = &new_nodes;
    find(boundaries);
  }

  template <int dim>
  void Reactions<dim>::find(const BoundaryMap<dim> &boundaries)
  {
    supports.clear();
    taken.clear();
    // as in Supports: prescribed displacements come first, then tools, then rollers
    const auto add_boundaries = [&](const std::set<Boundary::Mechanical> &kinds) {
      for (unsigned int b = 0; b < scene.boundaries.size(); ++b)
        if (kinds.count(scene.boundaries[b].mechanical) > 0)
          add(scene.boundaries[b].name, on_boundary(*nodes, boundaries, b));
    };
    add_boundaries({Boundary::Mechanical::fixed, Boundary::Mechanical::displacement});
    for (const Tool &tool : scene.tools)
      add(tool.name, within(*nodes, tool.centre, tool.radius));
    add_boundaries({Boundary::Mechanical::roller});
  }

  template <int dim>
  void Reactions<dim>::add(const std::string &name, const Nodes &held)
  {
    supports.push_back({name, {}});
    for (const auto node : held)
      if (nodes->owned().is_element(node) && taken.insert(node).second)
        supports.back().nodes.push_back(node);
  }

  template <int dim>
  void Reactions<dim>::observe(const Snapshot<dim> &snapshot)
  {
    Assert(snapshot.unbalanced_forces != nullptr, ExcInternalError());
    std::vector<double> sums(3 * supports.size(), 0.);
    for (unsigned int s = 0; s < supports.size(); ++s)
      for (const auto node : supports[s].nodes)
        for (unsigned int c = 0; c < dim; ++c)
          sums[3 * s + c] += (*snapshot.unbalanced_forces)(dim * node + c);
    Utilities::MPI::sum(sums, nodes->communicator(), sums);
    std::ostringstream rows;
    rows << std::setprecision(15);
    if (file.length() == 0)
      rows << "time_s,support,force_x_N,force_y_N,force_z_N\n";
    for (unsigned int s = 0; s < supports.size(); ++s)
      rows << snapshot.state.time << ',' << supports[s].name << ',' << sums[3 * s] << ',' << sums[3 * s + 1]
           << ',' << sums[3 * s + 2] << '\n';
    fail_together(nodes->communicator(), [&]() {
      if (Utilities::MPI::this_mpi_process(nodes->communicator()) == 0)
        file.add(rows.str());
    });
  }

  template class Reactions<2>;
  template class Reactions<3>;
} // namespace Cautery
