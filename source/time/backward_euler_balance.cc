// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/time/backward_euler_balance.h>
#include <cautery/time/balance_solver.h>
#include <cautery/time/line_search.h>

#include <cmath>

namespace Cautery
{
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
        if (!equation.changes())
          equation.inertia()->full.vmult(product, state.*equation.rate());
        force.add(1. / step.length(), equation.changes() ? momentum : product);
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
    keep_momentum(free_rate);
    prescribed_met = !equation.prescription_changes();
  }

  /// M v, with M as it is, where that changes.
  void BackwardEulerBalance::keep_momentum(const Vector &free_rate)
  {
    if (equation.inertia() == nullptr || !equation.changes())
      return;
    momentum.reinit(free_rate);
    equation.inertia()->full.vmult(momentum, free_rate);
  }

  /// Before the first step of a run, or on a new mesh.
  void BackwardEulerBalance::start_momentum(const State &state)
  {
    if (equation.inertia() == nullptr || !equation.changes() || momentum.size() > 0)
      return;
    refresh(state, state.*equation.unknown());
    keep_momentum(state.*equation.rate());
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
                         " rounds in the step to t = " + to_short_text(step.to) + " s (last change " +
                         to_short_text(change) + "); take a smaller Time/Step"));
    }
  } // namespace

  void BackwardEulerBalance::repeat_until_settled(const Step                      &step,
                                                  const State                     &state,
                                                  const std::function<Vector &()> &solve)
  {
    start_momentum(state);
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

  /// Newton's method for the rate, as far as C and M go; K and the loads are those of the last iterate.
  void BackwardEulerBalance::iterate(const Step &step, const State &state)
  {
    const bool has_slopes = equation.damping_excess() != nullptr;
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
        find_direction(step, has_slopes);
        change = direction.linfty_norm() * step.length();
        if (change <= numerics.iteration_tolerance)
          break;
        rounds.accelerate(rate, residual, direction);
        search(step, state);
      }
    // so that what has been assembled holds exactly, and nothing is lost from the books
    if (has_slopes)
      {
        new_system = prepare(step.length());
        find_direction(step, false);
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

  void BackwardEulerBalance::find_direction(const Step &step, const bool with_slopes)
  {
    if (with_slopes)
      {
        system.add(1., equation.damping_excess()->reduced);
        if (equation.inertia_excess() != nullptr)
          system.add(1. / step.length(), equation.inertia_excess()->reduced);
        system_length = 0.; // it is not that of the balance any more
      }
    if (new_system || with_slopes)
      set_solver();
    new_system       = false;
    const auto scope = cost.measure(name() + ": solve");
    n_iterations += solver.solve(direction, residual);
    equation.elimination().distribute(direction);
  }

  /// Goes along the direction, to its end or to where the balance is met.
  void BackwardEulerBalance::search(const Step &step, const State &state)
  {
    const Vector from = rate;
    follow_to_balance(residual * direction, [&](const double length) {
      rate = from;
      rate.add(length, direction);
      find_residual(step, state);
      return residual * direction;
    });
  }

  void BackwardEulerBalance::advance(const Step &step, State &state)
  {
    start_momentum(state);
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
        if (started && equation.inertia() != nullptr && equation.changes())
          momentum.reinit(rate);
      }
    archive.nodal("rate", rate);
    archive.nodal("momentum", momentum);
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
    errors[name()] = error.total();
  }
} // namespace Cautery
