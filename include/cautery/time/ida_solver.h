// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/archive.h>

#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace Cautery
{
  /**
   * What IDA integrates: F(t, y, y') = 0, with the Jacobian J = dF/dy + alpha dF/dy'.
   *
   * No vector has ghost entries. A result that is not finite asks for a smaller step; an exception ends the
   * run and arrives where step() was called. Both may come from one process alone, once its collective calls
   * are done.
   */
  class ImplicitSystem
  {
  public:
    virtual ~ImplicitSystem() = default;

    virtual void
    residual(const double time, const BlockVector &y, const BlockVector &y_dot, BlockVector &result) = 0;

    /** Called whenever alpha (1/s) has changed, and when Newton's iteration fails with that of an older y. */
    virtual void
    setup_jacobian(const double time, const BlockVector &y, const BlockVector &y_dot, const double alpha) = 0;

    /** J x = right_hand_side; x comes as zero. The tolerance is relative to the right-hand side's norm. */
    virtual void
    solve_jacobian(const BlockVector &right_hand_side, BlockVector &x, const double tolerance) = 0;
  };

  /**
   * SUNDIALS' IDA: backward differentiation formulas of order one to five with a step chosen from the local
   * error, one internal step at a time. deal.II's own class ignores every error.
   *
   * The local error of y_i is held against relative_tolerance |y_i| + absolute_tolerance, the mean square
   * over all unknowns being at most one: a few unknowns among many may err by far more than their tolerance.
   *
   * Errors: ExcRun with IDA's reason, time, step and a remedy; whatever the system throws. y and y' are then
   * those of the last good step.
   */
  class IdaSolver
  {
  public:
    struct Statistics
    {
      unsigned long steps                = 0;
      unsigned long residual_evaluations = 0;
      unsigned long jacobian_set_ups     = 0;
      unsigned long linear_solves        = 0;
      unsigned long error_test_failures  = 0; ///< steps repeated because they were too inaccurate
      unsigned long convergence_failures = 0; ///< steps repeated: Newton failed or a result was not finite
      unsigned int  last_order           = 0;
      double        last_step            = 0.; ///< s
    };

    /** @p absolute_tolerances: one for each block of y, positive, in the unit of the block. */
    IdaSolver(ImplicitSystem            &system,
              const double               relative_tolerance,
              const std::vector<double> &absolute_tolerances,
              const unsigned int         max_steps);
    ~IdaSolver();

    /**
     * Begins anew, with order one: at the start and wherever y' jumps. @p y and @p y_dot must satisfy F = 0.
     * With @p initial_step (s) zero IDA chooses: a thousandth of the time to the next stop, or less if y' is
     * large.
     */
    void restart(const double       time,
                 const BlockVector &y,
                 const BlockVector &y_dot,
                 const double       initial_step = 0.);

    /**
     * One step, cut short to land on @p stop_time exactly if it would pass it. Frequent stops shorten all
     * steps; to look at a time in between, interpolate() is free.
     * @return the new time, s
     */
    double step(BlockVector &y, BlockVector &y_dot, const double stop_time);

    /** The solution at a time within the last step, to the accuracy of the method. */
    void interpolate(const double time, BlockVector &y, BlockVector &y_dot) const;

    /** The local error of the last step in the norm of the error test: 1 is the tolerance. */
    double estimated_error() const;

    /**
     * The estimated error of the last step alone, by unknown. IDA gives the difference to its prediction; a
     * step among equal ones errs by 1 / (order + 1) of it, one among growing steps by up to twice as much.
     */
    void local_error(BlockVector &error) const;

    /** Since construction, over all restarts. */
    const Statistics &statistics() const { return total; }

    /** The statistics; all else is IDA's own, so that restart() must follow where it brings back. */
    void archive(Archive &archive);

  private:
    struct Memory;
    struct Callbacks;

    void check(const int flag, const std::string &function) const;
    int  guard(const std::function<void()> &callback, const BlockVector *result = nullptr);
    void set_weights(const BlockVector &y, BlockVector &weights) const;
    void update_statistics();

    ImplicitSystem           &system;
    const double              relative_tolerance;
    const std::vector<double> absolute_tolerances;
    const unsigned int        max_steps;

    std::unique_ptr<Memory> memory; ///< IDA's, new with each restart
    Statistics              total;
    Statistics              before_restart;
    double                  current_time = 0.;
    std::exception_ptr      exception; ///< thrown inside a callback, on its way to the caller of step()
    std::string             message;   ///< IDA's last one
  };
} // namespace Cautery
