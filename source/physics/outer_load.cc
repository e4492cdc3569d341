// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/outer_load.h>

#include <deal.II/fe/fe_values.h>

#include <map>

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
    : displacement(displacement), constant(displacement.vector())
  {
    if (scene.effects.gravity)
      add_gravity(scene.loads.gravity, nodes, tissues);
    for (unsigned int b = 0; b < scene.boundaries.size(); ++b)
      if (scene.boundaries[b].mechanical == Boundary::Mechanical::traction)
        add_traction(scene.boundaries[b], boundaries.surfaces(b), nodes);
    add_points(scene.loads.points, locator);
    constant.compress(VectorOperation::add);
  }

  template <int dim>
  void OuterLoad<dim>::add_gravity(const Point<3>       &acceleration,
                                   const Field<dim>     &nodes,
                                   const TissueMap<dim> &tissues)
  {
    const auto   &fe = nodes.element();
    FEValues<dim> values(nodes.mapping(), fe, nodes.cell_quadrature(), update_values | update_JxW_values);
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (const auto &cell : nodes.dof_handler().active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        values.reinit(cell);
        cell->get_dof_indices(dofs);
        const double density = tissues[cell->material_id()].thermal.density;
        for (const unsigned int i : values.dof_indices())
          {
            double volume = 0.;
            for (const unsigned int q : values.quadrature_point_indices())
              volume += values.shape_value(i, q) * values.JxW(q);
            for (unsigned int c = 0; c < dim; ++c)
              constant(dim * dofs[i] + c) += density * volume * acceleration[c];
          }
      }
  }

  template <int dim>
  void OuterLoad<dim>::add_traction(const Boundary                     &boundary,
                                    const std::set<types::boundary_id> &surfaces,
                                    const Field<dim>                   &nodes)
  {
    FEFaceValues<dim>                    values(nodes.mapping(),
                             nodes.element(),
                             nodes.face_quadrature(),
                             update_values | update_quadrature_points | update_JxW_values);
    std::vector<types::global_dof_index> dofs(nodes.element().n_dofs_per_cell());
    Load                                 load{&boundary.traction, {}};
    for (const auto &cell : nodes.dof_handler().active_cell_iterators())
      {
        if (!cell->is_locally_owned() || !cell->at_boundary())
          continue;
        cell->get_dof_indices(dofs);
        for (const unsigned int face : cell->face_indices())
          {
            if (!cell->face(face)->at_boundary() || surfaces.count(cell->face(face)->boundary_id()) == 0)
              continue;
            values.reinit(cell, face);
            for (const unsigned int q : values.quadrature_point_indices())
              {
                Place place{in_space<dim>(values.quadrature_point(q)), {}};
                for (const unsigned int i : nodes.on_face(face))
                  place.weights.push_back({dim * dofs[i], values.shape_value(i, q) * values.JxW(q)});
                load.places.push_back(std::move(place));
              }
          }
      }
    add(std::move(load));
  }

  template <int dim>
  void OuterLoad<dim>::add_points(const std::vector<PointLoad> &loads, const PointLocator<dim> &locator)
  {
    std::vector<Point<dim>>  points;
    std::vector<std::string> names;
    for (const auto &load : loads)
      {
        points.push_back(in_plane<dim>(load.place));
        names.push_back("Loads/" + load.name + "/Place");
      }
    const auto                           places = locator.find_inside(points, names);
    const auto                          &fe     = displacement.element();
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (unsigned int p = 0; p < places.size(); ++p)
      {
        if (!places[p])
          continue;
        displacement.cell(places[p]->cell)->get_dof_indices(dofs);
        Place place{loads[p].place, {}};
        for (unsigned int i = 0; i < dofs.size(); ++i)
          if (fe.system_to_component_index(i).first == 0)
            place.weights.push_back({dofs[i], fe.shape_value(i, places[p]->unit)});
        add({&loads[p].force, {std::move(place)}});
      }
  }

  /** Makes one place of all, with each node once: that is the same where the density is. */
  template <int dim>
  void OuterLoad<dim>::gather(std::vector<Place> &places)
  {
    std::map<types::global_dof_index, double> sums;
    for (const auto &place : places)
      for (const auto &[unknown, weight] : place.weights)
        sums[unknown] += weight;
    places.resize(1);
    places.front().weights.assign(sums.begin(), sums.end());
  }

  template <int dim>
  void OuterLoad<dim>::add(Load load)
  {
    if (load.places.empty())
      return;
    if (load.density->depends_on_time())
      {
        if (!load.density->depends_on_place())
          gather(load.places);
        changing.push_back(std::move(load));
        return;
      }
    for (const auto &place : load.places)
      {
        const Tensor<1, 3> value = load.density->value(place.place, 0.);
        for (const auto &[unknown, weight] : place.weights)
          for (unsigned int c = 0; c < dim; ++c)
            constant(unknown + c) += weight * value[c];
      }
  }

  template <int dim>
  void OuterLoad<dim>::at(const double time, Vector &force) const
  {
    force.equ(1., constant); // an assignment may count as an insertion, after which nothing can be added
    for_each_changing(time, [&force](const types::global_dof_index unknown, const Tensor<1, 3> &value) {
      for (unsigned int c = 0; c < dim; ++c)
        force(unknown + c) += value[c];
    });
    force.compress(VectorOperation::add);
  }

  template class OuterLoad<2>;
  template class OuterLoad<3>;
} // namespace Cautery
