// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/heat.h>
#include <cautery/physics/kept_nodes.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace Cautery
{
  const Expression *prescribed_temperature(const Boundary &boundary, const unsigned int)
  {
    return boundary.thermal == Boundary::Thermal::temperature ? &boundary.temperature : nullptr;
  }

  template <int dim>
  Vector initial_temperature(const Scene &scene, const Field<dim> &nodes)
  {
    Vector                               result  = nodes.vector();
    const auto                          &support = nodes.element().get_unit_support_points();
    std::vector<types::global_dof_index> dofs(support.size());
    for (const auto &cell : nodes.dof_handler().active_cell_iterators())
      if (!cell->is_artificial())
        {
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            if (nodes.owned().is_element(dofs[i]))
              result(dofs[i]) = scene.initial_temperature.value(
                in_space<dim>(nodes.mapping().transform_unit_to_real_cell(cell, support[i])), 0.);
        }
    result.compress(VectorOperation::insert);
    nodes.hanging().distribute(result);
    return result;
  }

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
    , prescribed(field, boundaries, prescribed_temperature)
    , kept(kept_nodes(scene, field, locator))
    , outside(scene, field, tissues, boundaries, locator)
  {
    fixed.reinit(field.relevant());
    prescribed.constrain(fixed);
    fixed.merge(field.hanging_nodes());
    fixed.close();
    eliminated.reinit(fixed, field.owned(), field.communicator());
    nothing_fixed.reinit(field.relevant());
    nothing_fixed.close();

    initialize_matrices();
    initialize_books();
    if (scene.effects.perfusion_stops_in_dead_tissue)
      // IDA would have to start anew for every impulse
      stopped = std::make_unique<StoppedPerfusion<dim>>(
        field, non_fourier && scene.time.integrator != TimeSettings::Integrator::ida, conduction.full);
    if (!changes())
      assemble(nullptr, nullptr, nullptr);
    if (scene.numerics.temperature_limiter)
      {
        limiter         = std::make_unique<TemperatureLimiter>();
        lent_by_limiter = field.vector();
        coldest_start   = initial_temperature(scene, field).min();
      }
  }

  template <int dim>
  void Heat<dim>::initialize_matrices()
  {
    field.initialize_matrix(conduction.full, field, &nothing_fixed);
    field.initialize_matrix(conduction.reduced, field, &fixed);
    storage.full.reinit(conduction.full);
    storage.reduced.reinit(conduction.reduced);
    if (properties_change)
      {
        storage_excess.full.reinit(conduction.full);
        storage_excess.reduced.reinit(conduction.reduced);
      }
    if (non_fourier)
      {
        relaxation.full.reinit(conduction.full);
        relaxation.reduced.reinit(conduction.reduced);
        if (properties_change)
          {
            relaxation_excess.full.reinit(conduction.full);
            relaxation_excess.reduced.reinit(conduction.reduced);
          }
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
  void Heat<dim>::distribute(const double tau, HeatCellTerms<dim> &terms)
  {
    if (scene.numerics.capacity_matrix == Numerics::CapacityMatrix::lumped)
      terms.lump();
    const auto add = [&](ConstrainedMatrix &matrix, const FullMatrix<double> &local) {
      nothing_fixed.distribute_local_to_global(local, terms.dofs, matrix.full);
      fixed.distribute_local_to_global(local, terms.dofs, matrix.reduced);
    };
    FullMatrix<double> sum = terms.conduction;
    sum.add(1., terms.exchange);
    add(conduction, sum);
    sum = terms.capacity;
    if (non_fourier)
      sum.add(tau, terms.exchange);
    add(storage, sum);
    if (properties_change)
      add(storage_excess, terms.capacity_excess);
    if (non_fourier)
      {
        sum.equ(tau, terms.capacity);
        add(relaxation, sum);
        if (properties_change)
          {
            sum.equ(tau, terms.capacity_excess);
            add(relaxation_excess, sum);
          }
        nothing_fixed.distribute_local_to_global(terms.capacity, terms.dofs, bookkeeping.capacity);
        nothing_fixed.distribute_local_to_global(terms.exchange, terms.dofs, bookkeeping.exchange);
      }
    if (stopped)
      stopped->add(tau, terms, nothing_fixed);
    bookkeeping.blood_weights.add(terms.dofs, terms.blood_weights);
    bookkeeping.surface_weights.add(terms.dofs, terms.surface_weights);
    bookkeeping.blood_source.add(terms.dofs, terms.blood_source);
    distribute_metabolism(tau, terms);
  }

  template <int dim>
  void Heat<dim>::distribute_metabolism(const double tau, HeatCellTerms<dim> &terms)
  {
    bookkeeping.metabolism.add(terms.dofs, terms.metabolism);
    if (non_fourier)
      {
        terms.metabolism_growth *= tau;
        inside.add(terms.dofs, terms.metabolism_growth);
      }
  }

  template <int dim>
  void Heat<dim>::assemble(const Vector *before, const Vector *now, const Vector *ln_damage)
  {
    for (auto *matrix : {&relaxation, &relaxation_excess, &storage, &storage_excess, &conduction})
      {
        matrix->full    = 0.;
        matrix->reduced = 0.;
      }
    bookkeeping.capacity = 0.;
    bookkeeping.exchange = 0.;
    if (stopped)
      stopped->clear();
    for (auto *vector : {&inside,
                         &bookkeeping.blood_weights,
                         &bookkeeping.surface_weights,
                         &bookkeeping.blood_source,
                         &bookkeeping.metabolism})
      *vector = 0.;

    HeatCellTerms<dim> terms(scene, field);
    for (const auto &cell : field.dof_handler().active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        const Tissue &tissue = tissues[cell->material_id()];
        terms.reinit(cell, before, now, ln_damage);
        terms.add_volume(tissue);
        terms.add_metabolism(tissue);
        if (cell->at_boundary())
          terms.add_surfaces(cell, boundaries);
        distribute(tissue.thermal.relaxation_time, terms);
      }
    finish();
  }

  template <int dim>
  void Heat<dim>::finish()
  {
    assembled = true;
    for (auto *matrix : {&relaxation, &relaxation_excess, &storage, &storage_excess, &conduction})
      {
        matrix->full.compress(VectorOperation::add);
        matrix->reduced.compress(VectorOperation::add);
      }
    bookkeeping.capacity.compress(VectorOperation::add);
    bookkeeping.exchange.compress(VectorOperation::add);
    if (stopped)
      stopped->compress();
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
    const bool died = stopped && stopped->update(state);
    if (!properties_change && !died && assembled)
      {
        if (scene.effects.metabolism == Effects::Metabolism::q10)
          assemble_metabolism(state.temperature, x);
        return false;
      }
    const Vector before    = field.ghosted(state.temperature);
    const Vector now       = field.ghosted(x);
    const Vector ln_damage = stopped ? field.ghosted(state.ln_damage) : Vector();
    const bool   change    = died && assembled;
    if (change)
      stopped->before_change(state);
    assemble(&before, &now, stopped ? &ln_damage : nullptr);
    if (change)
      stopped->after_change(state);
    return true;
  }

  template <int dim>
  void Heat<dim>::assemble_metabolism(const Vector &temperature_before, const Vector &temperature_now)
  {
    const Vector       before = field.ghosted(temperature_before);
    const Vector       now    = field.ghosted(temperature_now);
    HeatCellTerms<dim> terms(scene, field);
    inside                 = 0.;
    bookkeeping.metabolism = 0.;
    for (const auto &cell : field.dof_handler().active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        const Tissue &tissue = tissues[cell->material_id()];
        terms.reinit(cell, &before, &now, nullptr);
        terms.add_metabolism(tissue);
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
    if (stopped)
      stopped->add_impulse(step, force);
    outside.add(step, force);
  }

  template <int dim>
  void Heat<dim>::load_at(const double time, const double within, Vector &force) const
  {
    force = bookkeeping.blood_source;
    force += bookkeeping.metabolism;
    outside.add_at(time, within, force);
  }

  /// Of all that sets temperatures at the end of @p step.
  template <int dim>
  double Heat<dim>::coldest_data(const Step &step) const
  {
    double coldest = coldest_start;
    if (scene.effects.perfusion)
      for (const auto &tissue : scene.tissues)
        coldest = std::min(coldest, tissue.perfusion.temperature);
    double here = coldest;
    prescribed.for_each_owned([&](const auto, const Expression &value, const Point<3> &place) {
      here = std::min(here, value.value(place, step.to));
    });
    // the mean of the surroundings' temperature around a node
    Vector surroundings = field.vector();
    outside.add_convection_at(step.to, surroundings);
    for (unsigned int i = 0; i < surroundings.locally_owned_size(); ++i)
      if (const double weight = bookkeeping.surface_weights.begin()[i]; weight > 0.)
        here = std::min(here, surroundings.begin()[i] / weight);
    return Utilities::MPI::min(here, field.communicator());
  }

  template <int dim>
  void Heat<dim>::limit(const Step &step, const State &state, const SparseMatrix &system, Vector &rate)
  {
    if (!limiter)
      return;
    AssertThrow(
      !outside.take_heat(step),
      ExcRun("Numerics/Temperature limiter = on, but a source or a flux takes heat away in the step to t = " +
             to_short_text(step.to) + " s, so that no datum tells how cold the body may get; turn it off"));
    const double floor = std::min(coldest_data(step), state.temperature.min());
    lent_by_limiter    = 0.;
    Vector temperature = state.temperature;
    temperature.add(step.length(), rate);
    if (temperature.min() >= floor)
      return;
    Vector change   = temperature;
    lent_by_limiter = limiter->lift(system, eliminated, floor, temperature);
    lent_by_limiter *= 1. / step.length();
    change.sadd(-1., 1., temperature);
    eliminated.distribute(change);
    rate.add(1. / step.length(), change);
  }

  template <int dim>
  void Heat<dim>::archive(Archive &archive, const State &state)
  {
    outside.archive(archive);
    if (!changes())
      return;
    if (stopped)
      stopped->archive(archive, state.temperature);
    if (!archive.restores())
      return;
    State last = state;
    if (stopped && stopped->ln_damage().size() > 0)
      last.ln_damage = stopped->ln_damage();
    assembled = false;
    refresh(last, last.temperature);
  }

  template Vector initial_temperature(const Scene &, const Field<2> &);
  template Vector initial_temperature(const Scene &, const Field<3> &);
  template class Heat<2>;
  template class Heat<3>;
} // namespace Cautery
