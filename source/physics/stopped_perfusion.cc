// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/stopped_perfusion.h>

namespace Cautery
{
  template <int dim>
  StoppedPerfusion<dim>::StoppedPerfusion(const Field<dim>   &field,
                                          const bool          has_impulse,
                                          const SparseMatrix &like)
    : has_impulse(has_impulse)
  {
    if (!has_impulse)
      return;
    exchange.reinit(like);
    blood_source = field.vector();
  }

  template <int dim>
  void StoppedPerfusion<dim>::clear()
  {
    if (!has_impulse)
      return;
    exchange     = 0.;
    blood_source = 0.;
  }

  template <int dim>
  void StoppedPerfusion<dim>::add(const double                     tau,
                                  const HeatCellTerms<dim>        &terms,
                                  const AffineConstraints<double> &constraints)
  {
    if (!has_impulse)
      return;
    FullMatrix<double> product = terms.exchange;
    product *= tau;
    constraints.distribute_local_to_global(product, terms.dofs, exchange);
    dealii::Vector<double> source = terms.blood_source;
    source *= tau;
    blood_source.add(terms.dofs, source);
  }

  template <int dim>
  void StoppedPerfusion<dim>::compress()
  {
    if (!has_impulse)
      return;
    exchange.compress(VectorOperation::add);
    blood_source.compress(VectorOperation::add);
  }

  template <int dim>
  Vector StoppedPerfusion<dim>::delayed(const Vector &temperature) const
  {
    Vector result(temperature);
    exchange.vmult(result, temperature);
    result -= blood_source;
    return result;
  }

  template <int dim>
  void StoppedPerfusion<dim>::before_change(const State &state)
  {
    if (has_impulse)
      impulse = delayed(state.temperature);
  }

  template <int dim>
  void StoppedPerfusion<dim>::after_change(const State &state)
  {
    if (!has_impulse)
      return;
    impulse -= delayed(state.temperature);
    fell_at = state.time;
  }

  template <int dim>
  void StoppedPerfusion<dim>::add_impulse(const Step &step, Vector &force) const
  {
    if (step.from == fell_at)
      force.add(1. / step.length(), impulse);
  }

  template class StoppedPerfusion<2>;
  template class StoppedPerfusion<3>;
} // namespace Cautery
