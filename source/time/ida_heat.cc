// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/time/balance_solver.h>
#include <cautery/time/ida_heat.h>

#include <algorithm>
#include <cmath>

namespace Cautery
{
  namespace
  {
    /// Of the whole run: the delay of the flux below which it is not followed at starts.
    constexpr double invisible = 1e-6;
    /// Of the duration of a run: 6 * 0.05 s and 0.3 s are the same time, and nothing can be done in between.
    constexpr double same_time = 1e-12;

    /// A temperature may err by the tolerance; its rate by that in one second.
    std::vector<double> tolerances(const TimeSettings &settings, const bool second_order)
    {
      return std::vector<double>(second_order ? 2 : 1, settings.absolute_tolerance);
    }

    /// The switch that is no farther than @p close from @p time; if there is none, @p time.
    double switch_at(const std::vector<double> &switches, const double time, const double close)
    {
      const auto found = std::lower_bound(switches.begin(), switches.end(), time - close);
      return found != switches.end() && *found <= time + close ? *found : time;
    }
  } // namespace

  template <int dim>
  IdaHeat<dim>::IdaHeat(const TimeSettings &settings, Heat<dim> &heat, Cost &cost)
    : settings(settings)
    , heat(heat)
    , cost(cost)
    , second_order(heat.relaxes())
    , switches(heat.loads().switching_times(settings.end))
    , ida(*this, settings.relative_tolerance, tolerances(settings, second_order), settings.max_steps)
    , solver(solver_of(heat))
    , mass_solver(solver_of(heat))
  {
    for (auto *vector : {&y, &y_dot, &local_error})
      {
        vector->reinit(second_order ? 2 : 1);
        for (unsigned int b = 0; b < vector->n_blocks(); ++b)
          vector->block(b) = heat.nodes().vector();
        vector->collect_sizes();
      }
    force = product = boundary = heat.nodes().vector();
  }

  template <int dim>
  double IdaHeat<dim>::next_switch(const double time) const
  {
    const auto after = std::upper_bound(switches.begin(), switches.end(), time + same_time * settings.end);
    return after == switches.end() ? settings.end : *after;
  }

  template <int dim>
  void IdaHeat<dim>::differentiate_prescribed(const std::array<double, 5> &weights,
                                              const unsigned int           order,
                                              const double                 time,
                                              Vector                      &derivative) const
  {
    derivative = 0.;
    if (!heat.prescription_changes())
      return;
    // From the right: before t = 0 an expression need not have a value. The distance is long because IDA's
    // choice of steps must not hang on rounding, which differs with the number of processes and is divided by
    // it.
    const double distance = 1e-4 * settings.end;
    Vector       values(derivative);
    for (unsigned int i = 0; i < weights.size(); ++i)
      {
        heat.prescribe(time + i * distance, values);
        derivative.add(weights[i] / (12. * std::pow(distance, order)), values);
      }
  }

  template <int dim>
  void IdaHeat<dim>::prescribed_rate(const double time, Vector &rate) const
  {
    differentiate_prescribed({{-25., 48., -36., 16., -3.}}, 1, time, rate);
  }

  template <int dim>
  void IdaHeat<dim>::prescribed_acceleration(const double time, Vector &acceleration) const
  {
    differentiate_prescribed({{35., -104., 114., -56., 11.}}, 2, time, acceleration);
  }

  template <int dim>
  void IdaHeat<dim>::refresh_properties(const Vector &temperature)
  {
    if (!heat.changes())
      return;
    State now;
    now.temperature = temperature;
    if (properties != nullptr)
      now.ln_damage = properties->ln_damage;
    heat.refresh(now, temperature);
  }

  template <int dim>
  void IdaHeat<dim>::residual(const double       time,
                              const BlockVector &now,
                              const BlockVector &now_dot,
                              BlockVector       &result)
  {
    refresh_properties(now.block(0));
    Vector &balance = result.block(second_order ? 1 : 0);
    heat.load_at(time, within, force);
    heat.stiffness().full.vmult(balance, now.block(0));
    balance -= force;
    heat.damping()->full.vmult(product, second_order ? now.block(1) : now_dot.block(0));
    balance += product;
    if (second_order)
      {
        heat.inertia()->full.vmult(product, now_dot.block(1));
        balance += product;
        result.block(0) = now_dot.block(0);
        result.block(0) -= now.block(1);
      }

    // constrained entries: T - g = 0 and V - g' = 0
    heat.elimination().condense(balance);
    boundary = now.block(0);
    heat.prescribe(time, boundary);
    replace_constrained(now.block(0), boundary, result.block(0));
    if (second_order)
      {
        prescribed_rate(time, boundary);
        product = now.block(1);
        heat.elimination().distribute(product); // hanging nodes follow free ones too
        heat.elimination().keep_constrained(product);
        boundary += product;
        replace_constrained(now.block(1), boundary, result.block(1));
      }
  }

  template <int dim>
  void IdaHeat<dim>::replace_constrained(const Vector &is, const Vector &should, Vector &residual)
  {
    product = is;
    product -= should;
    heat.elimination().keep_constrained(product);
    heat.elimination().clear(residual);
    residual += product;
  }

  template <int dim>
  void
  IdaHeat<dim>::setup_jacobian(const double, const BlockVector &, const BlockVector &, const double new_alpha)
  {
    alpha = new_alpha;
    system.copy_from(heat.stiffness().reduced);
    system.add(alpha, heat.damping()->reduced);
    if (second_order)
      system.add(alpha * alpha, heat.inertia()->reduced);
    solver.set_matrix(system);
  }

  template <int dim>
  void
  IdaHeat<dim>::solve_jacobian(const BlockVector &right_hand_side, BlockVector &x, const double tolerance)
  {
    Vector fixed = right_hand_side.block(0); // prescribed entries of the solution
    heat.elimination().keep_constrained(fixed);
    Vector lag = heat.nodes().vector(); // alpha dT - dV
    if (second_order)
      {
        // V = alpha T - lag turns the second row into (K + alpha C + alpha^2 M) T = b + (alpha M + C) lag
        lag = right_hand_side.block(1);
        heat.elimination().keep_constrained(lag);
        lag.sadd(-1., alpha, fixed);
        Vector free = right_hand_side.block(0);
        heat.elimination().clear(free);
        lag += free;
        heat.nodes().hanging().add_dependence(lag);
        force = right_hand_side.block(1);
        heat.damping()->full.vmult(product, lag);
        force += product;
        heat.inertia()->full.vmult(product, lag);
        force.add(alpha, product);
      }
    else
      force = right_hand_side.block(0);
    heat.nodes().hanging().add_dependence(fixed);
    if (fixed.linfty_norm() > 0.)
      {
        heat.stiffness().full.vmult(product, fixed);
        force -= product;
        heat.damping()->full.vmult(product, fixed);
        force.add(-alpha, product);
        if (second_order)
          {
            heat.inertia()->full.vmult(product, fixed);
            force.add(-alpha * alpha, product);
          }
      }
    heat.elimination().condense(force);
    n_iterations += solver.solve(x.block(0), force, tolerance);
    heat.elimination().distribute(x.block(0));
    x.block(0) += fixed;
    if (second_order)
      {
        x.block(1).equ(alpha, x.block(0));
        x.block(1) -= lag;
      }
  }

  template <int dim>
  void IdaHeat<dim>::jump(const double time)
  {
    if (!second_order)
      return;
    force = 0.;
    heat.loads().add_jump(time, force);
    // through the capacity matrix, prescribed rates that jump (from zero at the start) take part
    prescribed_rate(time, boundary);
    boundary -= y.block(1);
    heat.elimination().keep_constrained(boundary);
    heat.nodes().hanging().distribute(boundary);
    heat.inertia()->full.vmult(product, boundary);
    force -= product;
    heat.elimination().condense(force);
    mass_solver.set_matrix(heat.inertia()->reduced);
    mass_solver.solve(product, force, 1e-12);
    heat.elimination().distribute(product);
    y.block(1) += product;
  }

  /**
   * Where the flux settles within a time that nobody can see, while temperatures stay what they are, the rate
   * starts settled: no step would be short enough to follow it.
   */
  template <int dim>
  void IdaHeat<dim>::settle(const double time)
  {
    const double delay = second_order ? heat.books().delay.max() : 0.;
    if (delay == 0. || delay > invisible * settings.end)
      return;
    refresh_properties(y.block(0));
    heat.load_at(time, within, force);
    heat.stiffness().full.vmult(product, y.block(0));
    force -= product;
    prescribed_rate(time, boundary);
    heat.damping()->full.vmult(product, boundary);
    force -= product;
    heat.elimination().condense(force);
    mass_solver.set_matrix(heat.damping()->reduced);
    mass_solver.solve(product, force, 1e-12);
    heat.elimination().distribute(product);
    product += boundary;
    boundary = product;
    boundary -= y.block(1);
    if (delay * boundary.linfty_norm() < 0.01 * settings.absolute_tolerance)
      y.block(1) = product;
  }

  template <int dim>
  void IdaHeat<dim>::make_consistent(const double time)
  {
    heat.prescribe(time, y.block(0));
    prescribed_rate(time, boundary);
    if (second_order)
      {
        heat.elimination().distribute(y.block(1));
        y.block(1) += boundary;
        y_dot.block(0) = y.block(1);
      }
    // the highest derivative from the balance
    Vector &highest = y_dot.block(second_order ? 1 : 0);
    Vector  rate    = boundary; // its prescribed part
    refresh_properties(y.block(0));
    heat.load_at(time, within, force);
    heat.stiffness().full.vmult(product, y.block(0));
    force -= product;
    heat.damping()->full.vmult(product, second_order ? y.block(1) : rate);
    force -= product;
    if (second_order)
      {
        prescribed_acceleration(time, rate);
        heat.inertia()->full.vmult(product, rate);
        force -= product;
      }
    heat.elimination().condense(force);
    // NOLINTNEXTLINE(clang-analyzer-core.NonNullParamChecker): the second order comes with the inertia
    mass_solver.set_matrix(second_order ? heat.inertia()->reduced : heat.damping()->reduced);
    mass_solver.solve(highest, force, 1e-12);
    heat.elimination().distribute(highest);
    highest += rate;
  }

  template <int dim>
  void IdaHeat<dim>::start(State &state)
  {
    y.block(0) = state.temperature;
    if (second_order)
      y.block(1) = state.temperature_rate;
    within = 0.5 * (state.time + next_switch(state.time));
    refresh_properties(y.block(0));
    jump(switch_at(switches, state.time, same_time * settings.end));
    settle(state.time);
    make_consistent(state.time);
    ida.restart(state.time, y, y_dot);
    fresh = false;
  }

  template <int dim>
  void IdaHeat<dim>::step(State &state, const double stop)
  {
    const auto scope = cost.measure("heat: IDA");
    properties       = &state;
    if (fresh)
      start(state);
    const double switch_time = next_switch(state.time);
    const bool   together    = std::abs(switch_time - stop) <= same_time * settings.end;
    state.time               = ida.step(y, y_dot, together ? stop : std::min(stop, switch_time));
    state.temperature        = y.block(0);
    if (second_order)
      state.temperature_rate = y.block(1);
    ++state.step;
    ida.local_error(local_error);
    heat.elimination().clear(local_error.block(0)); // prescribed temperatures do not err
    error.add(local_error.block(0).linfty_norm());
    fresh = state.time >= switch_time - same_time * settings.end && switch_time < settings.end;
  }

  template <int dim>
  void IdaHeat<dim>::archive(Archive &archive, const State &)
  {
    archive.shared("linear iterations", n_iterations);
    error.archive(archive);
    ida.archive(archive);
    fresh = fresh || archive.restores();
  }

  template <int dim>
  std::map<std::string, double> IdaHeat<dim>::statistics() const
  {
    const auto &counts = ida.statistics();
    return {
      {"linear_iterations_heat", static_cast<double>(n_iterations)},
      {"residual_evaluations", static_cast<double>(counts.residual_evaluations)},
      {"jacobian_set_ups", static_cast<double>(counts.jacobian_set_ups)},
      {"repeated_steps", static_cast<double>(counts.error_test_failures + counts.convergence_failures)}};
  }

  template <int dim>
  std::map<std::string, TimeError> IdaHeat<dim>::time_errors() const
  {
    return {{heat.name(), error}};
  }

  template class IdaHeat<2>;
  template class IdaHeat<3>;
} // namespace Cautery
