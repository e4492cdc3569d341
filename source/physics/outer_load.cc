// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/outer_load.h>

#include <deal.II/fe/fe_values.h>

namespace Cautery
{
  namespace
  {
    template <int dim>
    Point<dim> in_plane(const Point<3> &place)
    {
      Point<dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = place[d];
      return result;
    }
  } // namespace

  template <int dim>
  OuterLoad<dim>::OuterLoad(const Scene             &scene,
                            const Field<dim>        &displacement,
                            const Field<dim>        &nodes,
                            const TissueMap<dim>    &tissues,
                            const BoundaryMap<dim>  &boundaries,
                            const PointLocator<dim> &locator)
    : scene(scene)
    , displacement(displacement)
    , nodes(nodes)
    , tissues(tissues)
    , boundaries(boundaries)
    , at_start(displacement.vector())
  {
    std::vector<Point<dim>>  points;
    std::vector<std::string> names;
    for (const auto &load : scene.loads.points)
      {
        points.push_back(in_plane<dim>(load.place));
        names.push_back("Loads/" + load.name + "/Place");
        changes = changes || load.force.depends_on_time();
      }
    places = locator.find_inside(points, names);
    for (const auto &boundary : scene.boundaries)
      changes = changes || boundary.traction.depends_on_time();
    assemble(0., at_start);
  }

  template <int dim>
  void OuterLoad<dim>::add_point_loads(const double time, Vector &force) const
  {
    const auto                          &fe = displacement.element();
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (unsigned int p = 0; p < places.size(); ++p)
      if (places[p])
        {
          const Tensor<1, 3> pull = scene.loads.points[p].force.value(scene.loads.points[p].place, time);
          displacement.cell(places[p]->cell)->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            force(dofs[i]) +=
              pull[fe.system_to_component_index(i).first] * fe.shape_value(i, places[p]->unit);
        }
  }

  template <int dim>
  void OuterLoad<dim>::assemble(const double time, Vector &force) const
  {
    const auto   &fe = displacement.element();
    FEValues<dim> values(
      nodes.mapping(), nodes.element(), nodes.cell_quadrature(), update_values | update_JxW_values);
    FEFaceValues<dim>                    face_values(nodes.mapping(),
                                  nodes.element(),
                                  nodes.face_quadrature(),
                                  update_values | update_quadrature_points | update_JxW_values);
    dealii::Vector<double>               local(fe.n_dofs_per_cell());
    std::vector<types::global_dof_index> dofs(local.size());
    const auto add = [&](const auto &at, const unsigned int q, const Tensor<1, 3> &density) {
      for (unsigned int i = 0; i < local.size(); ++i)
        {
          const auto [component, node] = fe.system_to_component_index(i);
          local(i) += density[component] * at.shape_value(node, q) * at.JxW(q);
        }
    };

    force          = 0.;
    auto node_cell = nodes.dof_handler().begin_active();
    for (const auto &cell : displacement.dof_handler().active_cell_iterators())
      {
        if (cell->is_locally_owned() && (scene.effects.gravity || cell->at_boundary()))
          {
            local = 0.;
            if (scene.effects.gravity)
              {
                values.reinit(node_cell);
                for (const unsigned int q : values.quadrature_point_indices())
                  add(values,
                      q,
                      tissues[cell->material_id()].thermal.density * Tensor<1, 3>(scene.loads.gravity));
              }
            for (const unsigned int face : cell->face_indices())
              if (cell->face(face)->at_boundary() &&
                  boundaries[cell->face(face)->boundary_id()].mechanical == Boundary::Mechanical::traction)
                {
                  const auto &traction = boundaries[cell->face(face)->boundary_id()].traction;
                  face_values.reinit(node_cell, face);
                  for (const unsigned int q : face_values.quadrature_point_indices())
                    add(face_values, q, traction.value(in_space<dim>(face_values.quadrature_point(q)), time));
                }
            cell->get_dof_indices(dofs);
            force.add(dofs, local);
          }
        ++node_cell;
      }
    add_point_loads(time, force);
    force.compress(VectorOperation::add);
  }

  template <int dim>
  void OuterLoad<dim>::at(const double time, Vector &force) const
  {
    if (changes)
      assemble(time, force);
    else
      force = at_start;
  }

  template class OuterLoad<2>;
  template class OuterLoad<3>;
} // namespace Cautery
