// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/elastic_cell.h>
#include <cautery/physics/elasticity.h>
#include <cautery/physics/kept_nodes.h>
#include <cautery/physics/rigid_motions.h>

namespace Cautery
{
  namespace
  {
    template <int dim>
    IndexSet kept_displacements(const Scene             &scene,
                                const Field<dim>        &displacement,
                                const Field<dim>        &nodes,
                                const PointLocator<dim> &locator)
    {
      const IndexSet of_nodes = kept_nodes(scene, nodes, locator);
      if (of_nodes.size() == 0)
        return {};
      IndexSet result(displacement.n_unknowns());
      for (const auto node : of_nodes)
        result.add_range(dim * node, dim * (node + 1));
      result.compress();
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
    , has_inertia(scene.effects.deformation == Effects::Deformation::inertia)
    , properties_change(scene.effects.coupling != Effects::Coupling::off && scene.elastic_properties_change())
    , keeps_rate(has_inertia || (scene.effects.coupling == Effects::Coupling::two_way &&
                                 scene.effects.heat == Effects::Heat::non_fourier))
    , supports(scene, displacement, boundaries)
    , outer_load(scene, displacement, nodes, tissues, boundaries, locator)
    , kept(kept_displacements(scene, displacement, nodes, locator))
  {
    AssertThrow(
      !scene.numerics.mean_dilatation || !nodes.mesh().simplices(),
      ExcInput("Numerics/Mean dilatation = on is for hexahedra and quadrilaterals: a linear tetrahedron "
               "has one dilatation only; take hexahedra, or Element degree = 2"));
    nothing_fixed.reinit(displacement.relevant());
    nothing_fixed.close();
    if (!has_inertia)
      supports.check_held(scene);
    // in equilibrium, a body that nothing moves needs no products with prescribed values
    needs_full = has_inertia || scene.effects.coupling == Effects::Coupling::two_way || supports.move() ||
                 scene.output.reactions;
    initialize_matrices();
    if (scene.effects.coupling != Effects::Coupling::off && !properties_change)
      expansion_operator = std::make_unique<ThermalExpansionOperator<dim>>(
        displacement, nodes, tissues, scene.numerics.mean_dilatation);
    if (has_inertia)
      assemble_mass();
    if (!properties_change)
      assemble_stiffness(nullptr);
  }

  template <int dim>
  void Elasticity<dim>::initialize_matrices()
  {
    displacement.initialize_matrix(elastic.reduced, displacement, &supports.constraints());
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
    ElasticCellTerms<dim> terms(displacement, nodes, scene.numerics.mean_dilatation);
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
        supports.constraints().distribute_local_to_global(terms.stiffness, terms.dofs, elastic.reduced);
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
    ElasticCellTerms<dim> terms(displacement, nodes, scene.numerics.mean_dilatation);
    for (const auto &cell : displacement.dof_handler().active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        const Tissue &tissue = tissues[cell->material_id()];
        terms.reinit(cell, tissue, nullptr);
        terms.add_mass(tissue);
        supports.constraints().distribute_local_to_global(terms.mass, terms.dofs, mass.reduced);
        nothing_fixed.distribute_local_to_global(terms.mass, terms.dofs, mass.full);
      }
    mass.reduced.compress(VectorOperation::add);
    mass.full.compress(VectorOperation::add);
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
    outer_load.at(time, force);
    if (expansion_operator)
      expansion_operator->add_force(state.temperature, force);
    else if (properties_change)
      force.add(1., thermal_load);
  }

  template <int dim>
  Vector Elasticity<dim>::unbalanced_forces(const State &state) const
  {
    Vector outer = displacement.vector(), result = displacement.vector();
    load_at(state.time, state, outer);
    elastic.full.vmult(result, state.displacement);
    result -= outer;
    displacement.hanging().condense(result);
    return result;
  }

  template <int dim>
  void Elasticity<dim>::load(const Step &step, const State &state, Vector &force) const
  {
    load_at(step.to, state, force);
  }

  template class Elasticity<2>;
  template class Elasticity<3>;
} // namespace Cautery
