// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/time/backward_euler.h>
#include <cautery/time/balance_solver.h>

#include <cmath>

namespace Cautery
{
  Step next_step(const double time, const double length, const double stop)
  {
    return {time, time + length * (1. + 1e-9) >= stop ? stop : time + length};
  }

  BackwardEulerBalance::BackwardEulerBalance(Balance &balance, const Numerics &numerics, Cost &cost)
    : equation(balance), numerics(numerics), cost(cost), solver(solver_of(balance))
  {
  }

  bool BackwardEulerBalance::prepare(const double length)
  {
    // Lengths that differ by rounding alone would each cost a factorisation.
    if (std::abs(length - system_length) <= 1e-9 * length)
      return false;
    system_length = length;
    cost.build(name() + ": set-up", [&]() {
      system.copy_from(equation.stiffness().reduced);
      system *= length;
      if (equation.damping() != nullptr)
        system.add(1., equation.damping()->reduced);
      if (equation.inertia() != nullptr)
        system.add(1. / length, equation.inertia()->reduced);
    });
    return true;
  }

  void BackwardEulerBalance::update_right_hand_side(const Step &step, const State &state)
  {
    const auto    scope = cost.measure(name() + ": load");
    const Vector &x     = state.*equation.unknown();
    if (force.size() == 0)
      for (auto *vector : {&force, &rate, &prescribed_rate, &product})
        vector->reinit(x);

    equation.load(step, state, force);
    equation.stiffness().full.vmult(product, x);
    force -= product;
    if (equation.inertia() != nullptr)
      {
        equation.inertia()->full.vmult(product, state.*equation.rate());
        force.add(1. / step.length(), product);
      }
    if (!prescribed_met)
      subtract_prescribed(step, x);
    equation.elimination().condense(force);
  }

  void BackwardEulerBalance::subtract_prescribed(const Step &step, const Vector &x)
  {
    const double dt = step.length();
    prescribed_rate = x;
    equation.prescribe(step.to, prescribed_rate);
    prescribed_rate -= x;
    prescribed_rate *= 1. / dt;
    equation.elimination().keep_constrained(prescribed_rate);

    equation.stiffness().full.vmult(product, prescribed_rate);
    force.add(-dt, product);
    if (equation.damping() != nullptr)
      {
        equation.damping()->full.vmult(product, prescribed_rate);
        force -= product;
      }
    if (equation.inertia() != nullptr)
      {
        equation.inertia()->full.vmult(product, prescribed_rate);
        force.add(-1. / dt, product);
      }
  }

  const Vector &BackwardEulerBalance::complete(Vector &free_rate)
  {
    equation.elimination().distribute(free_rate);
    if (!prescribed_met)
      free_rate += prescribed_rate;
    return free_rate;
  }

  void BackwardEulerBalance::apply(const Step &step, Vector &free_rate, State &state)
  {
    (state.*equation.unknown()).add(step.length(), complete(free_rate));
    if (equation.damping() != nullptr || equation.inertia() != nullptr)
      error.record(step, free_rate, equation);
    if (equation.rate() != nullptr)
      state.*equation.rate() = free_rate;
    prescribed_met = !equation.prescription_changes();
  }

  void BackwardEulerBalance::repeat_until_settled(const Step                      &step,
                                                  const State                     &state,
                                                  const std::function<Vector &()> &solve)
  {
    const auto refresh = [&](const Vector &iterate) {
      const auto scope = cost.measure(name() + ": assembly");
      if (equation.refresh(state, iterate))
        system_length = 0.;
    };
    if (!equation.depends_on_iterate())
      {
        if (equation.changes())
          refresh(state.*equation.unknown());
        solve();
        return;
      }
    // the last step's rate, where there is one, brings the first iterate close
    Vector iterate = state.*equation.unknown();
    if (rate.size() > 0)
      iterate.add(step.length(), rate);
    double change = std::numeric_limits<double>::max();
    for (unsigned int i = 0; change > numerics.iteration_tolerance; ++i)
      {
        AssertThrow(i < numerics.max_iterations,
                    ExcRun("the iteration for " + name() + " did not converge in " +
                           std::to_string(numerics.max_iterations) +
                           " rounds in the step to t = " + to_text(step.to) + " s (last change " +
                           to_text(change) + "); take a smaller Time/Step"));
        refresh(iterate);
        Vector next = state.*equation.unknown();
        next.add(step.length(), complete(solve()));
        iterate -= next;
        change  = iterate.linfty_norm();
        iterate = next;
      }
  }

  void BackwardEulerBalance::advance(const Step &step, State &state)
  {
    repeat_until_settled(step, state, [&]() -> Vector & {
      if (prepare(step.length()))
        cost.build(name() + ": set-up", [&]() { solver.set_matrix(system); });
      update_right_hand_side(step, state);
      const auto scope = cost.measure(name() + ": solve");
      n_iterations += solver.solve(rate, force);
      return rate;
    });
    apply(step, rate, state);
  }

  void BackwardEulerBalance::add_time_error(std::map<std::string, TimeError> &errors) const
  {
    if (error.total().steps > 0)
      errors[name()] = error.total();
  }

  BackwardEuler::BackwardEuler(const TimeSettings           &settings,
                               const Numerics               &numerics,
                               const std::vector<Balance *> &list,
                               Cost                         &cost)
    : settings(settings)
  {
    for (Balance *balance : list)
      balances.push_back(std::make_unique<BackwardEulerBalance>(*balance, numerics, cost));
  }

  void BackwardEuler::step(State &state, const double stop)
  {
    const Step step = next_step(state.time, settings.step, stop);
    for (auto &balance : balances)
      balance->advance(step, state);
    state.time = step.to;
    ++state.step;
  }

  std::map<std::string, double> BackwardEuler::statistics() const
  {
    std::map<std::string, double> result;
    for (const auto &balance : balances)
      result["linear_iterations_" + balance->name()] = balance->iterations();
    return result;
  }

  std::map<std::string, TimeError> BackwardEuler::time_errors() const
  {
    std::map<std::string, TimeError> result;
    for (const auto &balance : balances)
      balance->add_time_error(result);
    return result;
  }
} // namespace Cautery
