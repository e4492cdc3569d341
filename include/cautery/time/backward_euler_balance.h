// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/cost.h>
#include <cautery/physics/balance.h>
#include <cautery/solve/linear_solver.h>
#include <cautery/time/acceleration.h>
#include <cautery/time/rate_difference.h>

#include <functional>
#include <map>
#include <string>

namespace Cautery
{
  /**
   * One balance in backward Euler's scheme (thesis Eqs. 6-25 to 6-27), written for the rate v = (x - x_old) /
   * dt: (M / dt + C + dt K) v = F - K x_old + M v_old / dt. The rate form has no differences of large
   * numbers, and becomes Fourier's scheme exactly as M goes to 0.
   */
  class BackwardEulerBalance
  {
  public:
    BackwardEulerBalance(Balance &balance, const Numerics &numerics, Cost &cost);

    /** Advances its part of @p state over @p step, iterating where the matrices depend on the state. */
    void advance(const Step &step, State &state);

    // The pieces of a step, of which a coupled step is made too.

    /** Makes the system matrix for steps of @p length (s); returns false if it is that already. */
    bool prepare(const double length);
    /** Computes the condensed right-hand side, in which what prescribed entries do is accounted for. */
    void update_right_hand_side(const Step &step, const State &state);
    /** Adds the prescribed part to @p free_rate, then x += dt v. */
    void apply(const Step &step, Vector &free_rate, State &state);
    /**
     * For steps of several balances: calls @p solve, which returns the free rate; where the matrices depend
     * on the state, again with new ones until the unknown does not change any more. Errors: ExcRun.
     */
    void repeat_until_settled(const Step &step, const State &state, const std::function<Vector &()> &solve);

    /** What it remembers, with @p archive_solver called in between, once the system matrix is there. */
    void archive(Archive &archive, const State &state, const std::function<void()> &archive_solver);
    void archive(Archive &archive, const State &state);

    Balance            &balance() { return equation; }
    const SparseMatrix &system_matrix() const { return system; }
    const Vector       &right_hand_side() const { return force; }
    /** The rates of the prescribed entries, zero elsewhere; empty where they are zero. */
    const Vector &prescribed_rates() const { return prescribed_met ? no_rates : prescribed_rate; }
    unsigned int  iterations() const { return n_iterations; }
    std::string   name() const { return equation.name(); }
    /** Adds the estimate of the errors of the steps taken, where the balance has rates. */
    void add_time_error(std::map<std::string, TimeError> &errors) const;

  private:
    void          set_solver();
    void          find_prescribed_rate(const Step &step, const Vector &x);
    void          subtract_prescribed(const Step &step);
    void          drop_prescribed();
    void          keep_momentum(const Vector &free_rate);
    void          start_momentum(const State &state);
    void          refresh(const State &state, const Vector &iterate);
    void          iterate(const Step &step, const State &state);
    void          find_residual(const Step &step, const State &state);
    void          find_direction(const Step &step, const bool with_slopes);
    void          search(const Step &step, const State &state);
    const Vector &complete(Vector &free_rate);

    Balance        &equation;
    const Numerics &numerics;
    Cost           &cost;
    LinearSolver    solver;
    SparseMatrix    system;
    double          system_length  = 0.;    ///< of the step that `system` is for, s
    bool            new_system     = false; ///< which the solver of the iteration has not seen
    bool            prescribed_met = false; ///< does x have its prescribed values already, for good?
    unsigned int    n_iterations   = 0;
    RateDifference  error;
    Vector          force, rate, prescribed_rate, product;
    Vector          momentum; ///< M v of the last step, where M changes: M is taken with what it was then
    Vector          residual, direction; ///< of the iteration
    Acceleration    rounds;              ///< of the iteration
    const Vector    no_rates;
  };
} // namespace Cautery
