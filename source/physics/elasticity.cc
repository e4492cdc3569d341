// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/elastic_cell.h>
#include <cautery/physics/elasticity.h>
#include <cautery/physics/rigid_motions.h>
#include <cautery/physics/rollers.h>

#include <deal.II/fe/fe_values.h>

namespace Cautery
{
  namespace
  {
    const Expression no_displacement(0.);

    const Expression *prescribed_displacement(const Boundary &boundary, const unsigned int component)
    {
      if (boundary.mechanical == Boundary::Mechanical::fixed)
        return &no_displacement;
      return boundary.mechanical == Boundary::Mechanical::displacement ? &boundary.displacement[component] :
                                                                         nullptr;
    }

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
  Elasticity<dim>::Elasticity(const Scene             &scene,
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
    , has_inertia(scene.effects.deformation == Effects::Deformation::inertia)
    , properties_change(scene.effects.coupling != Effects::Coupling::off && scene.elastic_properties_change())
    , keeps_rate(has_inertia || (scene.effects.coupling == Effects::Coupling::two_way &&
                                 scene.effects.heat == Effects::Heat::non_fourier))
    , prescribed(displacement, boundaries, prescribed_displacement)
  {
    std::vector<Point<dim>>  places;
    std::vector<std::string> names;
    for (const auto &load : scene.loads.points)
      {
        places.push_back(in_plane<dim>(load.place));
        names.push_back("Loads/" + load.name + "/Place");
      }
    load_places = locator.find_inside(places, names);

    constrain(boundaries);
    if (!has_inertia)
      check_held();
    // in equilibrium, a body that nothing moves needs no products with prescribed values
    needs_full = has_inertia || scene.effects.coupling == Effects::Coupling::two_way || moved();
    initialize_matrices();
    if (scene.effects.coupling != Effects::Coupling::off && !properties_change)
      expansion_operator = std::make_unique<ThermalExpansionOperator<dim>>(displacement, nodes, tissues);

    for (const auto &load : scene.loads.points)
      outer_load_changes = outer_load_changes || load.force.depends_on_time();
    for (const auto &boundary : scene.boundaries)
      outer_load_changes = outer_load_changes || boundary.traction.depends_on_time();
    outer_load = displacement.vector();
    assemble_outer_load(0., outer_load);
    if (has_inertia)
      assemble_mass();
    if (!properties_change)
      assemble_stiffness(nullptr);
  }

  template <int dim>
  void Elasticity<dim>::constrain(const BoundaryMap<dim> &boundaries)
  {
    nothing_fixed.reinit(displacement.relevant());
    nothing_fixed.close();
    fixed.reinit(displacement.relevant());
    prescribed.constrain(fixed);
    constrain_rollers(displacement, boundaries, fixed);
    fixed.close();
    eliminated.reinit(fixed, displacement.owned());
  }

  /** Of what holds a body, a fixed surface holds it altogether; rollers may leave it a shift or a turn. */
  template <int dim>
  void Elasticity<dim>::check_held() const
  {
    for (const auto &boundary : scene.boundaries)
      if (boundary.mechanical == Boundary::Mechanical::fixed ||
          boundary.mechanical == Boundary::Mechanical::displacement)
        return;
    const unsigned int n_free = n_free_rigid_motions(displacement, eliminated);
    AssertThrow(n_free == 0,
                ExcInput("Boundaries: the rollers leave the body " + std::to_string(n_free) +
                         " shifts or turns as a whole, so it has no equilibrium; hold them with Mechanical = "
                         "fixed, displacement or more rollers, or set Effects/Deformation = inertia"));
  }

  template <int dim>
  void Elasticity<dim>::initialize_matrices()
  {
    displacement.initialize_matrix(elastic.reduced, displacement, &fixed);
    if (needs_full)
      displacement.initialize_matrix(elastic.full, displacement, &nothing_fixed);
    if (has_inertia)
      {
        mass.reduced.reinit(elastic.reduced);
        mass.full.reinit(elastic.full);
      }
    if (properties_change)
      thermal_load = displacement.vector();
  }

  template <int dim>
  std::vector<Vector> Elasticity<dim>::near_null_space() const
  {
    return rigid_motions(displacement);
  }

  template <int dim>
  void Elasticity<dim>::assemble_stiffness(const Vector *temperature)
  {
    ElasticCellTerms<dim> terms(displacement, nodes);
    elastic.reduced = 0.;
    elastic.full    = 0.;
    thermal_load    = 0.;
    for (const auto &cell : displacement.dof_handler().active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        const Tissue &tissue = tissues[cell->material_id()];
        terms.reinit(cell, tissue, temperature);
        terms.add_stiffness(tissue);
        fixed.distribute_local_to_global(terms.stiffness, terms.dofs, elastic.reduced);
        if (needs_full)
          nothing_fixed.distribute_local_to_global(terms.stiffness, terms.dofs, elastic.full);
        if (properties_change)
          thermal_load.add(terms.dofs, terms.thermal_load);
      }
    elastic.reduced.compress(VectorOperation::add);
    elastic.full.compress(VectorOperation::add);
    thermal_load.compress(VectorOperation::add);
  }

  template <int dim>
  void Elasticity<dim>::assemble_mass()
  {
    ElasticCellTerms<dim> terms(displacement, nodes);
    for (const auto &cell : displacement.dof_handler().active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        const Tissue &tissue = tissues[cell->material_id()];
        terms.reinit(cell, tissue, nullptr);
        terms.add_mass(tissue);
        fixed.distribute_local_to_global(terms.mass, terms.dofs, mass.reduced);
        nothing_fixed.distribute_local_to_global(terms.mass, terms.dofs, mass.full);
      }
    mass.reduced.compress(VectorOperation::add);
    mass.full.compress(VectorOperation::add);
  }

  template <int dim>
  void Elasticity<dim>::add_point_loads(const double time, Vector &force) const
  {
    const auto                          &fe = displacement.element();
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (unsigned int p = 0; p < load_places.size(); ++p)
      if (load_places[p])
        {
          const Tensor<1, 3> pull = scene.loads.points[p].force.value(scene.loads.points[p].place, time);
          displacement.cell(load_places[p]->cell)->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            force(dofs[i]) +=
              pull[fe.system_to_component_index(i).first] * fe.shape_value(i, load_places[p]->unit);
        }
  }

  template <int dim>
  void Elasticity<dim>::assemble_outer_load(const double time, Vector &force) const
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
  bool Elasticity<dim>::refresh(const State &state, const Vector &)
  {
    const Vector temperature = nodes.ghosted(state.temperature);
    assemble_stiffness(&temperature);
    return true;
  }

  template <int dim>
  void Elasticity<dim>::load_at(const double time, const State &state, Vector &force) const
  {
    if (outer_load_changes)
      assemble_outer_load(time, force);
    else
      force = outer_load;
    if (expansion_operator)
      expansion_operator->add_force(state.temperature, force);
    else if (properties_change)
      force.add(1., thermal_load);
  }

  template <int dim>
  void Elasticity<dim>::load(const Step &step, const State &state, Vector &force) const
  {
    load_at(step.to, state, force);
  }

  template class Elasticity<2>;
  template class Elasticity<3>;
} // namespace Cautery
