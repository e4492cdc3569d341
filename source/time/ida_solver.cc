// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/parameters.h>
#include <cautery/time/ida_solver.h>

#include <deal.II/base/mpi.h>
#include <deal.II/sundials/n_vector.h>

#include <idas/idas.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace Cautery
{
  using SUNDIALS::internal::make_nvector_view;
  using SUNDIALS::internal::unwrap_nvector;
  using SUNDIALS::internal::unwrap_nvector_const;

  namespace
  {
    /// Of each linear solve, relative to its right-hand side: a correction that is accepted is seldom larger
    /// than some tolerances. Looser solves (1e-3) add noise to the estimated errors: 10 to 50 % more steps,
    /// and answers that differ by a tenth of the tolerance from one number of processes to another. Tighter
    /// ones change nothing.
    constexpr double linear_tolerance = 1e-6;

    /// Relative to the time that is left to the next stop.
    constexpr double smallest_step = 1e-12;

    struct Release
    {
      void operator()(SUNContext handle) const { SUNContext_Free(&handle); }
      void operator()(SUNMatrix handle) const { SUNMatFreeEmpty(handle); }
      void operator()(SUNLinearSolver handle) const { SUNLinSolFreeEmpty(handle); }
      void operator()(void *handle) const { IDAFree(&handle); }
    };

    bool is_finite(const BlockVector &vector)
    {
      for (unsigned int b = 0; b < vector.n_blocks(); ++b)
        for (const double value : vector.block(b))
          if (!std::isfinite(value))
            return false;
      return true;
    }

    std::string remedy(const int flag)
    {
      switch (flag)
        {
        case IDA_TOO_MUCH_ACC:
          return "The tolerances are below rounding errors: raise them.";
        case IDA_ERR_FAIL:
          return "The error stays too large however small the step. Does something jump here? Restart there, "
                 "or "
                 "raise the tolerances.";
        case IDA_CONV_FAIL:
          return "Newton's iteration fails however small the step. Look for properties that change abruptly.";
        case IDA_REP_RES_ERR:
          return "The residual is not finite however small the step. Look for properties or sources that are "
                 "undefined at the solution reached.";
        default:
          return "";
        }
    }
  } // namespace

  /**
   * The handles of the C interface, in the order in which they depend on each other.
   *
   * IDA is told that the linear solver is direct and has a matrix (an empty one), because this is the kind
   * for which it decides itself when to set the Jacobian up, also again after a failure of Newton's
   * iteration. For the kind "matrix-embedded" it has no set-up, and for "iterative" its tolerance assumes
   * that F has the unit of y.
   */
  struct IdaSolver::Memory
  {
    explicit Memory(const BlockVector &y) : communicator(y.block(0).get_mpi_communicator()), layout(y)
    {
      SUNContext new_context = nullptr;
      AssertThrow(SUNContext_Create(&communicator, &new_context) == 0, ExcRun("SUNDIALS cannot start."));
      context.reset(new_context);
      matrix.reset(SUNMatNewEmpty(new_context));
      linear_solver.reset(SUNLinSolNewEmpty(new_context));
      ida.reset(IDACreate(new_context));
      AssertThrow(matrix && linear_solver && ida, ExcRun("SUNDIALS is out of memory."));
    }

    MPI_Comm                                     communicator;
    const BlockVector                            layout; ///< for temporary vectors; its entries mean nothing
    std::unique_ptr<_SUNContext, Release>        context;
    std::unique_ptr<_generic_SUNMatrix, Release> matrix;
    std::unique_ptr<_generic_SUNLinearSolver, Release> linear_solver;
    std::unique_ptr<void, Release>                     ida;
  };

  /**
   * What IDA calls: no exception may leave these. They return zero, or a positive number for a failure that a
   * smaller step may cure, or a negative one.
   */
  struct IdaSolver::Callbacks
  {
    static int residual(double time, N_Vector y, N_Vector y_dot, N_Vector result, void *solver)
    {
      auto &self = *static_cast<IdaSolver *>(solver);
      ++self.total.residual_evaluations;
      auto &values = *unwrap_nvector<BlockVector>(result);
      return self.guard(
        [&]() {
          self.system.residual(
            time, *unwrap_nvector_const<BlockVector>(y), *unwrap_nvector_const<BlockVector>(y_dot), values);
        },
        &values);
    }

    static int setup_jacobian(double   time,
                              double   alpha,
                              N_Vector y,
                              N_Vector y_dot,
                              N_Vector /*residual*/,
                              SUNMatrix /*matrix*/,
                              void *solver,
                              N_Vector /*temporary*/,
                              N_Vector /*temporary*/,
                              N_Vector /*temporary*/)
    {
      auto &self = *static_cast<IdaSolver *>(solver);
      ++self.total.jacobian_set_ups;
      return self.guard([&]() {
        self.system.setup_jacobian(
          time, *unwrap_nvector_const<BlockVector>(y), *unwrap_nvector_const<BlockVector>(y_dot), alpha);
      });
    }

    static int
    solve_jacobian(SUNLinearSolver linear_solver, SUNMatrix, N_Vector x, N_Vector right_hand_side, double)
    {
      auto &self = *static_cast<IdaSolver *>(linear_solver->content);
      ++self.total.linear_solves;
      auto     &solution = *unwrap_nvector<BlockVector>(x);
      const int outcome  = self.guard(
        [&]() {
          self.system.solve_jacobian(
            *unwrap_nvector_const<BlockVector>(right_hand_side), solution, linear_tolerance);
        },
        &solution);
      // IDA takes any number that it does not know for a success
      return outcome == 0 ? SUNLS_SUCCESS : outcome > 0 ? SUNLS_PACKAGE_FAIL_REC : SUNLS_PACKAGE_FAIL_UNREC;
    }

    static int set_weights(N_Vector y, N_Vector weights, void *solver)
    {
      static_cast<IdaSolver *>(solver)->set_weights(*unwrap_nvector_const<BlockVector>(y),
                                                    *unwrap_nvector<BlockVector>(weights));
      return 0;
    }

    static void keep_message(int, const char *, const char *, char *text, void *solver)
    {
      static_cast<IdaSolver *>(solver)->message = text;
    }

    static SUNLinearSolver_Type linear_solver_type(SUNLinearSolver) { return SUNLINEARSOLVER_DIRECT; }
    static int                  clear_matrix(SUNMatrix) { return 0; }
  };

  IdaSolver::IdaSolver(ImplicitSystem            &system,
                       const double               relative_tolerance,
                       const std::vector<double> &absolute_tolerances,
                       const unsigned int         max_steps)
    : system(system)
    , relative_tolerance(relative_tolerance)
    , absolute_tolerances(absolute_tolerances)
    , max_steps(max_steps)
  {
    Assert(relative_tolerance >= 0., ExcMessage("The relative tolerance must not be negative."));
    Assert(
      std::all_of(absolute_tolerances.begin(), absolute_tolerances.end(), [](double a) { return a > 0.; }),
      ExcMessage("Absolute tolerances must be positive: a value may be zero."));
  }

  IdaSolver::~IdaSolver() = default;

  void IdaSolver::restart(const double       time,
                          const BlockVector &y,
                          const BlockVector &y_dot,
                          const double       initial_step)
  {
    AssertDimension(y.n_blocks(), absolute_tolerances.size());
    before_restart = total;
    current_time   = time;
    memory         = std::make_unique<Memory>(y);

    const bool finite = is_finite(y) && is_finite(y_dot);
    AssertThrow(Utilities::MPI::min(finite ? 1 : 0, memory->communicator) == 1,
                ExcRun("The state that the integration should start from at t = " + to_short_text(time) +
                       " s is not finite."));

    memory->matrix->ops->zero           = &Callbacks::clear_matrix;
    memory->linear_solver->ops->gettype = &Callbacks::linear_solver_type;
    memory->linear_solver->ops->solve   = &Callbacks::solve_jacobian;
    memory->linear_solver->content      = this;

    void *const ida        = memory->ida.get();
    const auto  y_view     = make_nvector_view(y, memory->context.get());
    const auto  y_dot_view = make_nvector_view(y_dot, memory->context.get());
    check(IDASetErrHandlerFn(ida, &Callbacks::keep_message, this), "IDASetErrHandlerFn");
    check(IDASetUserData(ida, this), "IDASetUserData");
    check(IDAInit(ida, &Callbacks::residual, time, y_view, y_dot_view), "IDAInit");
    // IDA's own weights go through deal.II's entry-wise operations: slower than all the rest of IDA's step
    check(IDAWFtolerances(ida, &Callbacks::set_weights), "IDAWFtolerances");
    check(IDASetLinearSolver(ida, memory->linear_solver.get(), memory->matrix.get()), "IDASetLinearSolver");
    check(IDASetJacFn(ida, &Callbacks::setup_jacobian), "IDASetJacFn");
    // By default IDA keeps a Jacobian until alpha has changed by a quarter and scales the correction. In the
    // unit test that saves a fifth of the set-ups, which are cheap for an iterative solver, and costs a sixth
    // more solves.
    check(IDASetDeltaCjLSetup(ida, 0.), "IDASetDeltaCjLSetup");
    check(IDASetInitStep(ida, initial_step), "IDASetInitStep");
  }

  double IdaSolver::step(BlockVector &y, BlockVector &y_dot, const double stop_time)
  {
    Assert(memory, ExcMessage("restart() comes first."));
    AssertThrow(total.steps < max_steps,
                ExcRun("The largest number of steps, " + std::to_string(max_steps) +
                       ", is used up at t = " + to_short_text(current_time) + " s (last step " +
                       to_short_text(total.last_step) + " s). Allow more steps or raise the tolerances."));

    void *const ida        = memory->ida.get();
    const auto  y_view     = make_nvector_view(y, memory->context.get());
    const auto  y_dot_view = make_nvector_view(y_dot, memory->context.get());
    check(IDASetStopTime(ida, stop_time), "IDASetStopTime");
    // Where a result is no longer finite, IDA would creep up to that time for ever
    check(IDASetMinStep(ida, smallest_step * std::max(stop_time - current_time, 0.)), "IDASetMinStep");
    message.clear();
    const int flag = IDASolve(ida, stop_time, &current_time, y_view, y_dot_view, IDA_ONE_STEP);
    update_statistics();
    if (exception)
      std::rethrow_exception(std::exchange(exception, nullptr));
    check(flag, "IDASolve");
    return current_time;
  }

  void IdaSolver::interpolate(const double time, BlockVector &y, BlockVector &y_dot) const
  {
    Assert(memory, ExcMessage("restart() comes first."));
    check(IDAGetDky(memory->ida.get(), time, 0, make_nvector_view(y, memory->context.get())), "IDAGetDky");
    check(IDAGetDky(memory->ida.get(), time, 1, make_nvector_view(y_dot, memory->context.get())),
          "IDAGetDky");
  }

  double IdaSolver::estimated_error() const
  {
    Assert(memory, ExcMessage("restart() comes first."));
    BlockVector error(memory->layout);
    BlockVector weights(memory->layout);
    check(IDAGetEstLocalErrors(memory->ida.get(), make_nvector_view(error, memory->context.get())),
          "IDAGetEstLocalErrors");
    check(IDAGetErrWeights(memory->ida.get(), make_nvector_view(weights, memory->context.get())),
          "IDAGetErrWeights");
    error.scale(weights);
    return error.l2_norm() / std::sqrt(error.size());
  }

  void IdaSolver::archive(Archive &archive)
  {
    archive.shared("steps", total.steps);
    archive.shared("residual evaluations", total.residual_evaluations);
    archive.shared("Jacobian set-ups", total.jacobian_set_ups);
    archive.shared("linear solves", total.linear_solves);
    archive.shared("error test failures", total.error_test_failures);
    archive.shared("convergence failures", total.convergence_failures);
    archive.shared("last order", total.last_order);
    archive.shared("last step", total.last_step);
  }

  void IdaSolver::local_error(BlockVector &error) const
  {
    Assert(memory, ExcMessage("restart() comes first."));
    check(IDAGetEstLocalErrors(memory->ida.get(), make_nvector_view(error, memory->context.get())),
          "IDAGetEstLocalErrors");
    error *= 1. / (total.last_order + 1.);
  }

  void IdaSolver::check(const int flag, const std::string &function) const
  {
    if (flag >= 0)
      return;
    char             *text = IDAGetReturnFlagName(flag);
    const std::string name = text;
    std::free(text);
    throw ExcRun(function + " stopped at t = " + to_short_text(current_time) + " s, after step " +
                 std::to_string(total.steps) + " of " + to_short_text(total.last_step) + " s: " + name +
                 ". " + message + " " + remedy(flag));
  }

  int IdaSolver::guard(const std::function<void()> &callback, const BlockVector *result)
  {
    enum Outcome : int
    {
      success,
      not_finite,
      failure
    };
    int outcome = success;
    try
      {
        callback();
        if (result != nullptr && !is_finite(*result))
          outcome = not_finite;
      }
    catch (...)
      {
        exception = std::current_exception();
        outcome   = failure;
      }

    // All processes must give IDA the same answer, or they wait for each other for ever
    outcome = Utilities::MPI::max(outcome, memory->communicator);
    if (outcome == failure && !exception)
      exception = std::make_exception_ptr(ExcRun("Another process failed; its message tells why."));
    return outcome == success ? 0 : outcome == not_finite ? 1 : -1;
  }

  void IdaSolver::set_weights(const BlockVector &y, BlockVector &weights) const
  {
    for (unsigned int b = 0; b < y.n_blocks(); ++b)
      std::transform(y.block(b).begin(), y.block(b).end(), weights.block(b).begin(), [&](const double value) {
        return 1. / (relative_tolerance * std::fabs(value) + absolute_tolerances[b]);
      });
  }

  void IdaSolver::update_statistics()
  {
    long        steps = 0, error_test_failures = 0, convergence_failures = 0;
    int         order = 0;
    void *const ida   = memory->ida.get();
    check(IDAGetNumSteps(ida, &steps), "IDAGetNumSteps");
    check(IDAGetNumErrTestFails(ida, &error_test_failures), "IDAGetNumErrTestFails");
    check(IDAGetNumStepSolveFails(ida, &convergence_failures), "IDAGetNumStepSolveFails");
    check(IDAGetLastOrder(ida, &order), "IDAGetLastOrder");
    check(IDAGetLastStep(ida, &total.last_step), "IDAGetLastStep");
    total.steps                = before_restart.steps + steps;
    total.error_test_failures  = before_restart.error_test_failures + error_test_failures;
    total.convergence_failures = before_restart.convergence_failures + convergence_failures;
    total.last_order           = order;
  }
} // namespace Cautery
