// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/time/backward_euler.h>
#include <cautery/time/balance_solver.h>

#include <deal.II/lac/full_matrix.h>

#include <cmath>

namespace Cautery
{
  namespace
  {
    /// Of what is left over along a direction at the start of a search, at its end beyond the goal.
    constexpr double       flattened         = 0.5;
    constexpr unsigned int most_attempts     = 12;
    constexpr unsigned int remembered_rounds = 5;
  } // namespace

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
    for (auto *vector : {&force, &rate, &prescribed_rate, &product})
      if (vector->size() == 0) // the rate may be there already, of a run that has been resumed
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
      {
        find_prescribed_rate(step, x);
        subtract_prescribed(step);
      }
    equation.elimination().condense(force);
  }

  void BackwardEulerBalance::find_prescribed_rate(const Step &step, const Vector &x)
  {
    prescribed_rate = x;
    equation.prescribe(step.to, prescribed_rate);
    prescribed_rate -= x;
    prescribed_rate *= 1. / step.length();
    equation.elimination().keep_constrained(prescribed_rate);
  }

  void BackwardEulerBalance::subtract_prescribed(const Step &step)
  {
    const double dt = step.length();
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
    complete(free_rate);
    equation.limit(step, state, system, free_rate);
    (state.*equation.unknown()).add(step.length(), free_rate);
    if (equation.damping() != nullptr || equation.inertia() != nullptr)
      {
        const auto scope = cost.measure(name() + ": error of steps");
        error.record(step, free_rate, equation);
      }
    if (equation.rate() != nullptr)
      state.*equation.rate() = free_rate;
    prescribed_met = !equation.prescription_changes();
  }

  void BackwardEulerBalance::refresh(const State &state, const Vector &iterate)
  {
    const auto scope = cost.measure(name() + ": assembly");
    if (equation.refresh(state, iterate))
      system_length = 0.;
  }

  namespace
  {
    void require_rounds(const bool         are_left,
                        const Numerics    &numerics,
                        const std::string &name,
                        const Step        &step,
                        const double       change)
    {
      AssertThrow(are_left,
                  ExcRun("the iteration for " + name + " did not converge in " +
                         std::to_string(numerics.max_iterations) +
                         " rounds in the step to t = " + to_text(step.to) + " s (last change " +
                         to_text(change) + "); take a smaller Time/Step"));
    }
  } // namespace

  void BackwardEulerBalance::repeat_until_settled(const Step                      &step,
                                                  const State                     &state,
                                                  const std::function<Vector &()> &solve)
  {
    if (!equation.depends_on_iterate())
      {
        if (equation.changes())
          refresh(state, state.*equation.unknown());
        solve();
        return;
      }
    Vector iterate = state.*equation.unknown();
    double change  = std::numeric_limits<double>::max();
    for (unsigned int i = 0; change > numerics.iteration_tolerance; ++i)
      {
        require_rounds(i < numerics.max_iterations, numerics, name(), step, change);
        refresh(state, iterate);
        Vector next = state.*equation.unknown();
        next.add(step.length(), complete(solve()));
        iterate -= next;
        change  = iterate.linfty_norm();
        iterate = next;
      }
  }

  /// Newton's method for the rate, as far as C goes; K and the loads are those of the last iterate.
  void BackwardEulerBalance::iterate(const Step &step, const State &state)
  {
    const ConstrainedMatrix *excess = equation.damping_excess();
    // the last step's rate, where there is one, brings the first iterate close
    for (auto *vector : {&rate, &product, &residual})
      if (vector->size() == 0)
        vector->reinit(state.*equation.unknown());
    find_prescribed_rate(step, state.*equation.unknown());
    drop_prescribed();
    complete(rate);
    find_residual(step, state);
    rounds.clear();
    double change = std::numeric_limits<double>::max();
    for (unsigned int i = 0;; ++i)
      {
        require_rounds(i < numerics.max_iterations, numerics, name(), step, change);
        find_direction(excess);
        change = direction.linfty_norm() * step.length();
        if (change <= numerics.iteration_tolerance)
          break;
        accelerate();
        search(step, state);
      }
    // so that what has been assembled holds exactly, and nothing is lost from the books
    if (excess != nullptr)
      {
        new_system = prepare(step.length());
        find_direction(nullptr);
      }
    rate += direction;
  }

  /// The matrices at the present rate, and what is left over of the balance.
  void BackwardEulerBalance::find_residual(const Step &step, const State &state)
  {
    product = state.*equation.unknown();
    product.add(step.length(), rate);
    refresh(state, product);
    new_system = prepare(step.length()) || new_system;
    update_right_hand_side(step, state);
    drop_prescribed();
    system.vmult(residual, rate);
    residual.sadd(-1., 1., force);
    complete(rate);
  }

  void BackwardEulerBalance::drop_prescribed()
  {
    product = rate;
    equation.elimination().keep_constrained(product);
    rate -= product;
  }

  void BackwardEulerBalance::find_direction(const ConstrainedMatrix *excess)
  {
    if (excess != nullptr)
      system.add(1., excess->reduced);
    if (new_system || excess != nullptr)
      set_solver();
    new_system = false;
    if (excess != nullptr)
      system_length = 0.; // it is not that of the balance any more
    const auto scope = cost.measure(name() + ": solve");
    n_iterations += solver.solve(direction, residual);
    equation.elimination().distribute(direction);
  }

  /**
   * What lags behind makes rounds slow: with the last few of them, the direction is combined that leaves the
   * shortest one for the next (Anderson 1965). Where that does not lead on, it stays what it was.
   */
  void BackwardEulerBalance::accelerate()
  {
    if (rounds.size() > remembered_rounds)
      rounds.erase(rounds.begin());
    const unsigned int  n = rounds.size();
    std::vector<Vector> turns; // the changes of direction between rounds
    for (unsigned int i = 0; i < n; ++i)
      {
        turns.push_back(i + 1 < n ? rounds[i + 1].direction : direction);
        turns.back() -= rounds[i].direction;
      }
    FullMatrix<double>     products(n, n);
    dealii::Vector<double> wanted(n), shares(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        wanted(i) = turns[i] * direction;
        for (unsigned int k = 0; k < n; ++k)
          products(i, k) = turns[i] * turns[k] * (i == k ? 1. + 1e-12 : 1.);
      }
    rounds.push_back({rate, direction});
    if (n == 0 || products.trace() == 0.)
      return;
    products.gauss_jordan();
    products.vmult(shares, wanted);
    for (unsigned int i = 0; i < n; ++i)
      {
        turns[i] += rounds[i + 1].rate;
        turns[i] -= rounds[i].rate;
        direction.add(-shares(i), turns[i]);
      }
    if (!(residual * direction > 0.))
      direction = rounds.back().direction;
  }

  /**
   * Goes along the direction to its end, or if the balance along it is overshot by more than half of what it
   * lacked, to about the place where it is met: by false position (Illinois), as at a peak of the capacity it
   * falls suddenly.
   */
  void BackwardEulerBalance::search(const Step &step, const State &state)
  {
    const Vector from    = rate;
    const auto   lack_at = [&](const double length) {
      rate = from;
      rate.add(length, direction);
      find_residual(step, state);
      return residual * direction;
    };
    const double start = residual * direction;
    double       near = 0., far = 1., lack_near = start, lack_far = lack_at(far);
    if (lack_far >= -flattened * start)
      return;
    for (unsigned int attempt = 0; attempt < most_attempts; ++attempt)
      {
        const double width  = far - near;
        const double secant = near + width * lack_near / (lack_near - lack_far);
        const double length = std::min(std::max(secant, near + 0.05 * width), far - 0.05 * width);
        const double lack   = lack_at(length);
        if (std::abs(lack) <= flattened * start)
          break;
        (lack > 0. ? near : far)           = length;
        (lack > 0. ? lack_near : lack_far) = lack;
        (lack > 0. ? lack_far : lack_near) *= 0.5;
      }
  }

  void BackwardEulerBalance::advance(const Step &step, State &state)
  {
    if (equation.depends_on_iterate())
      {
        iterate(step, state);
        apply(step, rate, state);
        return;
      }
    if (equation.changes())
      refresh(state, state.*equation.unknown());
    if (prepare(step.length()))
      set_solver();
    update_right_hand_side(step, state);
    {
      const auto scope = cost.measure(name() + ": solve");
      n_iterations += solver.solve(rate, force);
    }
    apply(step, rate, state);
  }

  void BackwardEulerBalance::set_solver()
  {
    cost.build(name() + ": set-up", [&]() { solver.set_matrix(system); });
  }

  void BackwardEulerBalance::archive(Archive                     &archive,
                                     const State                 &state,
                                     const std::function<void()> &archive_solver)
  {
    double length  = system_length;
    bool   started = rate.size() > 0;
    archive.shared("length of the step", length);
    archive.shared("prescribed values met", prescribed_met);
    archive.shared("linear iterations", n_iterations);
    archive.shared("started", started);
    if (archive.restores())
      {
        system_length = 0.;
        if (length > 0.)
          prepare(length);
        if (started)
          rate.reinit(state.*equation.unknown());
      }
    archive.nodal("rate", rate);
    error.archive(archive, state.*equation.unknown());
    archive_solver();
  }

  void BackwardEulerBalance::archive(Archive &archive, const State &state)
  {
    this->archive(archive, state, [&]() {
      if (archive.restores() && system_length > 0.)
        set_solver();
      solver.archive(archive);
    });
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

  void BackwardEuler::archive(Archive &archive, const State &state)
  {
    for (auto &balance : balances)
      archive.section(balance->name(), [&]() { balance->archive(archive, state); });
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
