// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/heat.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <utility>

namespace Cautery
{
  namespace
  {
    const Expression *prescribed_temperature(const Boundary &boundary, const unsigned int)
    {
      return boundary.thermal == Boundary::Thermal::temperature ? &boundary.temperature : nullptr;
    }

    /// Row sums on the diagonal.
    void lump(FullMatrix<double> &matrix)
    {
      for (unsigned int i = 0; i < matrix.m(); ++i)
        {
          double sum = 0.;
          for (unsigned int j = 0; j < matrix.n(); ++j)
            {
              sum += matrix(i, j);
              matrix(i, j) = 0.;
            }
          matrix(i, i) = sum;
        }
    }
  } // namespace

  /// The terms of one cell: matrices and vectors by shape function, and the state at the quadrature points.
  template <int dim>
  struct Heat<dim>::CellTerms
  {
    CellTerms(const Field<dim> &field)
      : values(field.mapping(),
               field.element(),
               field.cell_quadrature(),
               update_values | update_gradients | update_JxW_values)
      , face_values(field.mapping(), field.element(), field.face_quadrature(), update_values | update_JxW_values)
      , dofs(field.element().n_dofs_per_cell())
      , before(values.n_quadrature_points)
      , now(values.n_quadrature_points)
      , ln_damage(dofs.size())
      , capacity(dofs.size(), dofs.size())
      , exchange(dofs.size(), dofs.size())
      , conduction(dofs.size(), dofs.size())
      , sum(dofs.size(), dofs.size())
      , blood_weights(dofs.size())
      , surface_weights(dofs.size())
      , blood_source(dofs.size())
      , metabolism(dofs.size())
      , metabolism_rate(dofs.size())
    {}

    void clear()
    {
      capacity        = 0.;
      exchange        = 0.;
      conduction      = 0.;
      blood_weights   = 0.;
      surface_weights = 0.;
      blood_source    = 0.;
      metabolism      = 0.;
      metabolism_rate = 0.;
    }

    FEValues<dim>                        values;
    FEFaceValues<dim>                    face_values;
    std::vector<types::global_dof_index> dofs;
    std::vector<double>                  before; ///< temperature at the step's start, K
    std::vector<double>                  now;    ///< at the iterate, K
    std::vector<double>                  ln_damage; ///< at the nodes
    FullMatrix<double>                   capacity, exchange, conduction, sum;
    dealii::Vector<double> blood_weights, surface_weights, blood_source, metabolism, metabolism_rate;
  };

  template <int dim>
  Heat<dim>::Heat(const Scene             &scene,
                  const Field<dim>        &field,
                  const TissueMap<dim>    &tissues,
                  const BoundaryMap<dim>  &boundaries,
                  const PointLocator<dim> &locator)
    : scene(scene)
    , field(field)
    , tissues(tissues)
    , boundaries(boundaries)
    , non_fourier(scene.effects.heat == Effects::Heat::non_fourier)
    , properties_change(scene.thermal_properties_change())
    , perfusion_stops(scene.effects.perfusion_stops_in_dead_tissue)
    , prescribed(field, boundaries, prescribed_temperature)
    , outside(scene, field, tissues, boundaries, locator)
  {
    fixed.reinit(field.relevant());
    prescribed.constrain(fixed);
    fixed.close();
    eliminated.reinit(fixed, field.owned());
    nothing_fixed.reinit(field.relevant());
    nothing_fixed.close();

    initialize_matrices();
    initialize_books();
    if (!changes())
      assemble(nullptr, nullptr, nullptr);
  }

  template <int dim>
  void Heat<dim>::initialize_matrices()
  {
    field.initialize_matrix(conduction.full, field, &nothing_fixed);
    field.initialize_matrix(conduction.reduced, field, &fixed);
    storage.full.reinit(conduction.full);
    storage.reduced.reinit(conduction.reduced);
    if (non_fourier)
      {
        relaxation.full.reinit(conduction.full);
        relaxation.reduced.reinit(conduction.reduced);
        bookkeeping.capacity.reinit(conduction.full);
        bookkeeping.exchange.reinit(conduction.full);
      }
  }

  template <int dim>
  void Heat<dim>::initialize_books()
  {
    inside                      = field.vector();
    bookkeeping.blood_weights   = field.vector();
    bookkeeping.surface_weights = field.vector();
    bookkeeping.blood_source    = field.vector();
    bookkeeping.metabolism      = field.vector();
    if (!non_fourier)
      return;
    bookkeeping.delay = field.vector();
    std::vector<types::global_dof_index> dofs(field.element().n_dofs_per_cell());
    for (const auto &cell : field.dof_handler().active_cell_iterators())
      if (!cell->is_artificial())
        {
          cell->get_dof_indices(dofs);
          for (const auto dof : dofs)
            if (field.owned().is_element(dof))
              bookkeeping.delay(dof) = tissues[cell->material_id()].thermal.relaxation_time;
        }
    bookkeeping.delay.compress(VectorOperation::insert);
  }

  template <int dim>
  std::vector<Vector> Heat<dim>::near_null_space() const
  {
    Vector constant = field.vector();
    constant        = 1.;
    return {constant};
  }

  template <int dim>
  void Heat<dim>::add_cell(const Tissue &tissue, CellTerms &terms) const
  {
    const bool   perfused = scene.effects.perfusion;
    const double w        = perfused ? tissue.perfusion.coefficient() : 0.;
    const auto  &values   = terms.values;
    for (const unsigned int q : values.quadrature_point_indices())
      {
        const double before = terms.before[q];
        const double now    = terms.now[q];
        // the mean heat capacity between both temperatures stores exactly the difference of enthalpy
        const double heat_capacity =
          std::abs(now - before) < 1e-6 ?
            tissue.thermal.heat_capacity(now) :
            tissue.thermal.density * tissue.thermal.specific_heat.integral(before, now) / (now - before);
        const double k = tissue.thermal.conductivity.value(now);

        double alive = 1.;
        if (perfusion_stops)
          {
            alive = 0.;
            for (const unsigned int i : values.dof_indices())
              alive += terms.ln_damage[i] < 0. ? values.shape_value(i, q) : 0.;
          }
        for (const unsigned int i : values.dof_indices())
          {
            const double weight = values.shape_value(i, q) * values.JxW(q);
            terms.blood_weights(i) += w * alive * weight;
            for (const unsigned int j : values.dof_indices())
              {
                const double product = weight * values.shape_value(j, q);
                terms.capacity(i, j) += heat_capacity * product;
                terms.exchange(i, j) += w * alive * product;
                terms.conduction(i, j) +=
                  k * (values.shape_grad(i, q) * values.shape_grad(j, q)) * values.JxW(q);
              }
          }
      }
    terms.blood_source.add(tissue.perfusion.temperature, terms.blood_weights);
  }

  template <int dim>
  void Heat<dim>::add_metabolism(const Tissue &tissue, CellTerms &terms) const
  {
    if (scene.effects.metabolism == Effects::Metabolism::off)
      return;
    const bool  grows  = scene.effects.metabolism == Effects::Metabolism::q10;
    const auto &values = terms.values;
    for (const unsigned int q : values.quadrature_point_indices())
      {
        const double heat   = grows ? tissue.metabolism.q10_heat(terms.now[q]) : tissue.metabolism.heat;
        const double growth = grows ? heat - tissue.metabolism.q10_heat(terms.before[q]) : 0.;
        for (const unsigned int i : values.dof_indices())
          {
            const double weight = values.shape_value(i, q) * values.JxW(q);
            terms.metabolism(i) += heat * weight;
            terms.metabolism_rate(i) += growth * weight;
          }
      }
  }

  template <int dim>
  void
  Heat<dim>::add_surfaces(const typename DoFHandler<dim>::active_cell_iterator &cell, CellTerms &terms) const
  {
    for (const unsigned int face : cell->face_indices())
      {
        if (!cell->face(face)->at_boundary())
          continue;
        const Boundary &boundary = boundaries[cell->face(face)->boundary_id()];
        if (boundary.thermal != Boundary::Thermal::convection)
          continue;
        const auto &values = terms.face_values;
        terms.face_values.reinit(cell, face);
        for (const unsigned int q : values.quadrature_point_indices())
          for (const unsigned int i : values.dof_indices())
            {
              const double weight = boundary.transfer_coefficient * values.shape_value(i, q) * values.JxW(q);
              terms.surface_weights(i) += weight;
              for (const unsigned int j : values.dof_indices())
                terms.exchange(i, j) += weight * values.shape_value(j, q);
            }
      }
  }

  template <int dim>
  void Heat<dim>::distribute(const double tau, CellTerms &terms)
  {
    if (scene.numerics.capacity_matrix == Numerics::CapacityMatrix::lumped)
      {
        lump(terms.capacity);
        lump(terms.exchange);
      }
    const auto add = [&](ConstrainedMatrix &matrix) {
      nothing_fixed.distribute_local_to_global(terms.sum, terms.dofs, matrix.full);
      fixed.distribute_local_to_global(terms.sum, terms.dofs, matrix.reduced);
    };
    terms.sum = terms.conduction;
    terms.sum.add(1., terms.exchange);
    add(conduction);
    terms.sum = terms.capacity;
    if (non_fourier)
      terms.sum.add(tau, terms.exchange);
    add(storage);
    if (non_fourier)
      {
        terms.sum.equ(tau, terms.capacity);
        add(relaxation);
        nothing_fixed.distribute_local_to_global(terms.capacity, terms.dofs, bookkeeping.capacity);
        nothing_fixed.distribute_local_to_global(terms.exchange, terms.dofs, bookkeeping.exchange);
      }
    bookkeeping.blood_weights.add(terms.dofs, terms.blood_weights);
    bookkeeping.surface_weights.add(terms.dofs, terms.surface_weights);
    bookkeeping.blood_source.add(terms.dofs, terms.blood_source);
    distribute_metabolism(tau, terms);
  }

  template <int dim>
  void Heat<dim>::distribute_metabolism(const double tau, CellTerms &terms)
  {
    bookkeeping.metabolism.add(terms.dofs, terms.metabolism);
    if (non_fourier)
      {
        terms.metabolism_rate *= tau;
        inside.add(terms.dofs, terms.metabolism_rate);
      }
  }

  template <int dim>
  void Heat<dim>::assemble(const Vector *before, const Vector *now, const Vector *ln_damage)
  {
    for (auto *matrix : {&relaxation, &storage, &conduction})
      {
        matrix->full    = 0.;
        matrix->reduced = 0.;
      }
    bookkeeping.capacity = 0.;
    bookkeeping.exchange = 0.;
    for (auto *vector : {&inside,
                         &bookkeeping.blood_weights,
                         &bookkeeping.surface_weights,
                         &bookkeeping.blood_source,
                         &bookkeeping.metabolism})
      *vector = 0.;

    CellTerms terms(field);
    for (const auto &cell : field.dof_handler().active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        const Tissue &tissue = tissues[cell->material_id()];
        terms.values.reinit(cell);
        terms.clear();
        cell->get_dof_indices(terms.dofs);
        if (before != nullptr)
          {
            terms.values.get_function_values(*before, terms.before);
            terms.values.get_function_values(*now, terms.now);
          }
        if (ln_damage != nullptr)
          cell->get_dof_values(*ln_damage, terms.ln_damage.begin(), terms.ln_damage.end());
        add_cell(tissue, terms);
        add_metabolism(tissue, terms);
        if (cell->at_boundary())
          add_surfaces(cell, terms);
        distribute(tissue.thermal.relaxation_time, terms);
      }
    finish();
  }

  template <int dim>
  void Heat<dim>::finish()
  {
    assembled = true;
    for (auto *matrix : {&relaxation, &storage, &conduction})
      {
        matrix->full.compress(VectorOperation::add);
        matrix->reduced.compress(VectorOperation::add);
      }
    bookkeeping.capacity.compress(VectorOperation::add);
    bookkeeping.exchange.compress(VectorOperation::add);
    for (auto *vector : {&inside,
                         &bookkeeping.blood_weights,
                         &bookkeeping.surface_weights,
                         &bookkeeping.blood_source,
                         &bookkeeping.metabolism})
      vector->compress(VectorOperation::add);
  }

  template <int dim>
  bool Heat<dim>::refresh(const State &state, const Vector &x)
  {
    const bool new_dead = perfusion_stops && dead_changed(state);
    if (!properties_change && !new_dead && assembled)
      {
        if (scene.effects.metabolism == Effects::Metabolism::q10)
          assemble_metabolism(state.temperature, x);
        return false;
      }
    const Vector before = field.ghosted(state.temperature);
    const Vector now    = field.ghosted(x);
    if (perfusion_stops)
      {
        const Vector ln_damage = field.ghosted(state.ln_damage);
        assemble(&before, &now, &ln_damage);
      }
    else
      assemble(&before, &now, nullptr);
    return true;
  }

  template <int dim>
  bool Heat<dim>::dead_changed(const State &state)
  {
    unsigned int dead = 0;
    for (const double value : state.ln_damage)
      dead += value >= 0. ? 1 : 0;
    dead = Utilities::MPI::sum(dead, field.communicator());
    return std::exchange(n_dead, dead) != dead;
  }

  template <int dim>
  void Heat<dim>::assemble_metabolism(const Vector &temperature_before, const Vector &temperature_now)
  {
    const Vector before = field.ghosted(temperature_before);
    const Vector now    = field.ghosted(temperature_now);
    CellTerms    terms(field);
    inside                 = 0.;
    bookkeeping.metabolism = 0.;
    for (const auto &cell : field.dof_handler().active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        const Tissue &tissue = tissues[cell->material_id()];
        terms.values.reinit(cell);
        terms.clear();
        cell->get_dof_indices(terms.dofs);
        terms.values.get_function_values(before, terms.before);
        terms.values.get_function_values(now, terms.now);
        add_metabolism(tissue, terms);
        distribute_metabolism(tissue.thermal.relaxation_time, terms);
      }
    inside.compress(VectorOperation::add);
    bookkeeping.metabolism.compress(VectorOperation::add);
  }

  template <int dim>
  void Heat<dim>::load(const Step &step, const State &, Vector &force) const
  {
    force.equ(1. / step.length(), inside); // tau dQ_met/dt, a difference quotient
    force.add(1., bookkeeping.blood_source, 1., bookkeeping.metabolism);
    outside.add(step, force);
  }

  template <int dim>
  void Heat<dim>::load_at(const double time, const double within, Vector &force) const
  {
    force = bookkeeping.blood_source;
    force += bookkeeping.metabolism;
    outside.add_at(time, within, force);
  }

  template class Heat<2>;
  template class Heat<3>;
} // namespace Cautery
