// SPDX-License-Identifier: LGPL-2.1-or-later
// The wrapper over IDA against exact solutions, at switches, and when something fails inside it. The output
// is the same on any number of processes.
#include <cautery/base/parameters.h>
#include <cautery/time/ida_solver.h>

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_cg.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <iostream>
#include <limits>
#include <stdexcept>

namespace Cautery::Test
{
  const MPI_Comm communicator = MPI_COMM_WORLD;

  ConditionalOStream out(std::cout, false);

  IndexSet owned(const unsigned int size)
  {
    const unsigned int processes = Utilities::MPI::n_mpi_processes(communicator);
    const unsigned int process   = Utilities::MPI::this_mpi_process(communicator);
    IndexSet           indices(size);
    indices.add_range(size * process / processes, size * (process + 1) / processes);
    return indices;
  }

  /** y_i' + k_i y_i = 0, and what a test wants to go wrong. */
  class Decay : public ImplicitSystem
  {
  public:
    static constexpr unsigned int size = 20;

    std::function<void(const double time, BlockVector &result)> in_residual = [](const double,
                                                                                 BlockVector &) {};
    std::function<void(const double time)>                      in_setup    = [](const double) {};
    std::function<void()>                                       in_solve    = []() {};

    static double rate(const unsigned int i) { return 0.5 + i / 10.; }

    BlockVector exact(const double time) const
    {
      BlockVector y({owned(size)}, communicator);
      for (const auto i : y.locally_owned_elements())
        y(i) = std::exp(-rate(i) * time);
      y.compress(VectorOperation::insert);
      return y;
    }

    BlockVector exact_rate(const double time) const
    {
      BlockVector y_dot = exact(time);
      for (const auto i : y_dot.locally_owned_elements())
        y_dot(i) = -rate(i) * std::exp(-rate(i) * time);
      y_dot.compress(VectorOperation::insert);
      return y_dot;
    }

    void
    residual(const double time, const BlockVector &y, const BlockVector &y_dot, BlockVector &result) override
    {
      for (const auto i : y.locally_owned_elements())
        result(i) = y_dot(i) + rate(i) * y(i);
      result.compress(VectorOperation::insert);
      in_residual(time, result);
    }

    void setup_jacobian(const double time,
                        const BlockVector &,
                        const BlockVector &,
                        const double new_alpha) override
    {
      alpha = new_alpha;
      in_setup(time);
    }

    void solve_jacobian(const BlockVector &right_hand_side, BlockVector &x, const double) override
    {
      for (const auto i : x.locally_owned_elements())
        x(i) = right_hand_side(i) / (alpha + rate(i));
      x.compress(VectorOperation::insert);
      in_solve();
    }

  private:
    double alpha = 0.;
  };

  /** y_i' + 10 y_i^4 = 0: the Jacobian changes with y. */
  class Radiation : public ImplicitSystem
  {
  public:
    static double exact(const double time) { return std::pow(1. + 30. * time, -1. / 3.); }

    void residual(const double, const BlockVector &y, const BlockVector &y_dot, BlockVector &result) override
    {
      for (const auto i : y.locally_owned_elements())
        result(i) = y_dot(i) + 10. * std::pow(y(i), 4);
      result.compress(VectorOperation::insert);
    }

    void setup_jacobian(const double, const BlockVector &y, const BlockVector &, const double alpha) override
    {
      jacobian = y;
      for (const auto i : y.locally_owned_elements())
        jacobian(i) = alpha + 40. * std::pow(y(i), 3);
      jacobian.compress(VectorOperation::insert);
    }

    void solve_jacobian(const BlockVector &right_hand_side, BlockVector &x, const double) override
    {
      for (const auto i : x.locally_owned_elements())
        x(i) = right_hand_side(i) / jacobian(i);
      x.compress(VectorOperation::insert);
    }

  private:
    BlockVector jacobian;
  };

  /**
   * Linear finite elements on (0, 1), zero at both ends: mass, stiffness, and their eigenvector sin(pi x).
   */
  class Bar
  {
  public:
    static constexpr unsigned int size = 199;

    Bar() : mode(owned(size), communicator)
    {
      DynamicSparsityPattern pattern(size);
      for (unsigned int i = 0; i < size; ++i)
        for (unsigned int j = std::max(i, 1u) - 1; j < std::min(i + 2, size); ++j)
          pattern.add(i, j);
      for (SparseMatrix *const matrix : {&mass, &stiffness, &jacobian})
        matrix->reinit(owned(size), pattern, communicator);
      for (const auto i : owned(size))
        {
          mode(i) = std::sin(numbers::PI * (i + 1) * h);
          for (unsigned int j = std::max<unsigned int>(i, 1u) - 1; j < std::min<unsigned int>(i + 2, size);
               ++j)
            {
              mass.set(i, j, i == j ? 4. * h / 6. : h / 6.);
              stiffness.set(i, j, i == j ? 2. / h : -1. / h);
            }
        }
      mode.compress(VectorOperation::insert);
      mass.compress(VectorOperation::insert);
      stiffness.compress(VectorOperation::insert);
      load = mode;
      mass.vmult(load, mode);
    }

    /** Of the discrete problem, so that errors are those of time integration alone. */
    double eigenvalue() const
    {
      const double c = std::cos(numbers::PI * h);
      return 6. / (h * h) * (1. - c) / (2. + c);
    }

    void set_jacobian(const double mass_factor)
    {
      jacobian.copy_from(stiffness);
      jacobian.add(mass_factor, mass);
    }

    static void
    solve(const SparseMatrix &matrix, const Vector &right_hand_side, Vector &x, const double tolerance)
    {
      ReductionControl control(10000, 1e-200, tolerance);
      SolverCG<Vector> cg(control);
      cg.solve(matrix, x, right_hand_side, PreconditionIdentity());
    }

    const double h = 1. / (size + 1);
    SparseMatrix mass, stiffness, jacobian;
    Vector       mode;
    Vector       load; ///< M times the mode
  };

  /** M T' + K T = source M mode. */
  class Diffusion : public ImplicitSystem
  {
  public:
    Bar    bar;
    double source = 1.;

    void residual(const double, const BlockVector &y, const BlockVector &y_dot, BlockVector &result) override
    {
      bar.mass.vmult(result.block(0), y_dot.block(0));
      bar.stiffness.vmult_add(result.block(0), y.block(0));
      result.block(0).add(-source, bar.load);
    }

    void setup_jacobian(const double, const BlockVector &, const BlockVector &, const double alpha) override
    {
      bar.set_jacobian(alpha);
    }

    void solve_jacobian(const BlockVector &right_hand_side, BlockVector &x, const double tolerance) override
    {
      Bar::solve(bar.jacobian, right_hand_side.block(0), x.block(0), tolerance);
    }

    /** T' that satisfies the equation. */
    void consistent_rate(const BlockVector &y, BlockVector &y_dot) const
    {
      Vector right_hand_side(bar.load);
      bar.stiffness.vmult(right_hand_side, y.block(0));
      right_hand_side.sadd(-1., source, bar.load);
      Bar::solve(bar.mass, right_hand_side, y_dot.block(0), 1e-12);
    }
  };

  /** V = T', tau M V' + M V + K T = M mode. */
  class Wave : public ImplicitSystem
  {
  public:
    Bar    bar;
    double tau = 0.1;

    void residual(const double, const BlockVector &y, const BlockVector &y_dot, BlockVector &result) override
    {
      result.block(0) = y_dot.block(0);
      result.block(0) -= y.block(1);
      Vector rates(y.block(1));
      rates.add(tau, y_dot.block(1));
      bar.mass.vmult(result.block(1), rates);
      bar.stiffness.vmult_add(result.block(1), y.block(0));
      result.block(1) -= bar.load;
    }

    void
    setup_jacobian(const double, const BlockVector &, const BlockVector &, const double new_alpha) override
    {
      alpha = new_alpha;
      bar.set_jacobian(alpha * (tau * alpha + 1.));
    }

    /** dV = alpha dT - r0 turns the second row into (K + alpha (tau alpha + 1) M) dT = r1 + (tau alpha + 1) M
     * r0. */
    void solve_jacobian(const BlockVector &r, BlockVector &x, const double tolerance) override
    {
      Vector reduced(r.block(1));
      bar.mass.vmult(reduced, r.block(0));
      reduced.sadd(tau * alpha + 1., 1., r.block(1));
      Bar::solve(bar.jacobian, reduced, x.block(0), tolerance);
      x.block(1) = r.block(0);
      x.block(1).sadd(-1., alpha, x.block(0));
    }

  private:
    double alpha = 0.;
  };

  double largest_difference(BlockVector a, const BlockVector &b)
  {
    a -= b;
    return a.linfty_norm();
  }

  double largest_difference(Vector a, const double factor, const Vector &b)
  {
    a.add(-factor, b);
    return a.linfty_norm();
  }

  void print_work(const IdaSolver &solver)
  {
    const IdaSolver::Statistics &work = solver.statistics();
    out << "    steps " << work.steps << ", residuals " << work.residual_evaluations << ", set-ups "
        << work.jacobian_set_ups << ", solves " << work.linear_solves << ", repeated "
        << work.error_test_failures << " + " << work.convergence_failures << ", last order "
        << work.last_order << std::endl;
  }

  /** Steps to @p end; the largest estimated error on the way. */
  double march(IdaSolver &solver, BlockVector &y, BlockVector &y_dot, const double end)
  {
    double largest_estimate = 0.;
    for (double time = -1.; time != end;)
      {
        time             = solver.step(y, y_dot, end);
        largest_estimate = std::max(largest_estimate, solver.estimated_error());
      }
    return largest_estimate;
  }

  void test_decay()
  {
    out << "y' = -k y to t = 2: error at the end and between steps, in tolerances" << std::endl;
    for (const double tolerance : {1e-3, 1e-5, 1e-7})
      {
        Decay       decay;
        IdaSolver   solver(decay, 0., {tolerance}, 10000);
        BlockVector y = decay.exact(0.), y_dot = decay.exact_rate(0.), between = y, between_rate = y;
        solver.restart(0., y, y_dot);
        const double estimate = march(solver, y, y_dot, 2.);
        const double middle   = 2. - 0.5 * solver.statistics().last_step;
        solver.interpolate(middle, between, between_rate);
        out << "  " << tolerance << ": " << largest_difference(y, decay.exact(2.)) / tolerance << ", "
            << largest_difference(between, decay.exact(middle)) / tolerance << "; rate "
            << largest_difference(between_rate, decay.exact_rate(middle)) / tolerance
            << "; largest estimate at most 1: " << (estimate > 0. && estimate <= 1. ? "yes" : "NO")
            << std::endl;
        print_work(solver);
      }
  }

  void test_radiation()
  {
    out << "y' = -10 y^4 to t = 10: error in tolerances" << std::endl;
    for (const double tolerance : {1e-4, 1e-6})
      {
        Radiation   radiation;
        IdaSolver   solver(radiation, tolerance, {1e-3 * tolerance}, 10000);
        BlockVector y({owned(Decay::size)}, communicator), y_dot = y;
        y     = 1.;
        y_dot = -10.;
        solver.restart(0., y, y_dot);
        march(solver, y, y_dot, 10.);
        y.add(-Radiation::exact(10.));
        out << "  " << tolerance << ": " << y.linfty_norm() / (tolerance * Radiation::exact(10.))
            << std::endl;
        print_work(solver);
      }
  }

  void test_diffusion()
  {
    out << "M T' + K T = F, F on until t = 0.1: error at 0.1 and 0.3, in tolerances" << std::endl;
    for (const double tolerance : {1e-4, 1e-6})
      {
        Diffusion    diffusion;
        IdaSolver    solver(diffusion, 0., {tolerance}, 10000);
        BlockVector  y({owned(Bar::size)}, communicator), y_dot = y;
        const double eigenvalue = diffusion.bar.eigenvalue();
        y_dot.block(0)          = diffusion.bar.mode;

        solver.restart(0., y, y_dot);
        march(solver, y, y_dot, 0.1);
        const double peak = (1. - std::exp(-0.1 * eigenvalue)) / eigenvalue;
        out << "  " << tolerance << ": "
            << largest_difference(y.block(0), peak, diffusion.bar.mode) / tolerance;

        diffusion.source = 0.;
        diffusion.consistent_rate(y, y_dot);
        solver.restart(0.1, y, y_dot, 1e-5);
        solver.step(y, y_dot, 0.3);
        const double first_step = solver.statistics().last_step;
        march(solver, y, y_dot, 0.3);
        out << ", "
            << largest_difference(y.block(0), peak * std::exp(-0.2 * eigenvalue), diffusion.bar.mode) /
                 tolerance
            << "; first step " << first_step << std::endl;
        print_work(solver);
      }
  }

  void test_wave()
  {
    out << "tau M T'' + M T' + K T = F to t = 1: error of T and T', in tolerances" << std::endl;
    for (const double tolerance : {1e-4, 1e-6})
      {
        Wave        wave;
        IdaSolver   solver(wave, 0., {tolerance, 10. * tolerance}, 10000);
        BlockVector y({owned(Bar::size), owned(Bar::size)}, communicator), y_dot = y;
        y_dot.block(1).add(1. / wave.tau, wave.bar.mode);
        solver.restart(0., y, y_dot);
        march(solver, y, y_dot, 1.);

        const double damping   = 0.5 / wave.tau;
        const double frequency = std::sqrt(wave.bar.eigenvalue() / wave.tau - damping * damping);
        const double T =
          (1. - std::exp(-damping) * (std::cos(frequency) + damping / frequency * std::sin(frequency))) /
          wave.bar.eigenvalue();
        const double V = std::exp(-damping) * std::sin(frequency) / (wave.tau * frequency);
        out << "  " << tolerance << ": " << largest_difference(y.block(0), T, wave.bar.mode) / tolerance
            << ", " << largest_difference(y.block(1), V, wave.bar.mode) / (10. * tolerance) << std::endl;
        print_work(solver);
      }
  }

  void print(const ExcRun &exception) { out << "  ExcRun: " << message_of(exception) << std::endl; }

  /** Marches until an exception comes, and says which; y must then be that of the last good step. */
  void expect_failure(const std::string &title, Decay &decay, const unsigned int max_steps = 1000)
  {
    out << title << std::endl;
    IdaSolver   solver(decay, 0., {1e-6}, max_steps);
    BlockVector y = decay.exact(0.), y_dot = decay.exact_rate(0.);
    double      time = 0.;
    try
      {
        solver.restart(time, y, y_dot);
        while (time < 1.)
          time = solver.step(y, y_dot, 1.);
        out << "  NO exception" << std::endl;
      }
    catch (const ExcRun &exception)
      {
        print(exception);
      }
    catch (const std::exception &exception)
      {
        out << "  " << exception.what() << std::endl;
      }
    out << "  last good state kept: "
        << (largest_difference(y, decay.exact(time)) < 1e-4 &&
                largest_difference(y_dot, decay.exact_rate(time)) < 1e-3 ?
              "yes" :
              "NO")
        << std::endl;
  }

  void test_failures()
  {
    const bool thrower = Utilities::MPI::this_mpi_process(communicator) == 0;
    const auto fail    = [thrower](const bool now) {
      if (now && thrower)
        throw std::runtime_error("what the callback threw");
    };
    const double not_a_number = std::numeric_limits<double>::quiet_NaN();
    {
      Decay decay;
      decay.in_residual = [&](const double time, BlockVector &) { fail(time > 0.5); };
      expect_failure("The residual of one process throws after t = 0.5", decay);
    }
    {
      Decay decay;
      decay.in_residual = [&](const double, BlockVector &) { fail(true); };
      expect_failure("It throws at once", decay);
    }
    {
      Decay decay;
      decay.in_setup = [&](const double time) { fail(time > 0.1); };
      expect_failure("The set-up of the Jacobian throws", decay);
    }
    {
      Decay        decay;
      unsigned int solves = 0;
      decay.in_solve      = [&]() { fail(++solves > 20); };
      expect_failure("The linear solve throws", decay);
    }
    {
      Decay decay;
      decay.in_residual = [&](const double time, BlockVector &result) {
        if (time > 0.5 && thrower)
          *result.block(0).begin() = not_a_number;
      };
      expect_failure("The residual of one process is not finite after t = 0.5", decay);
    }
    {
      Decay decay;
      expect_failure("Too many steps", decay, 30);
    }
    {
      Decay decay;
      out << "The start is not finite" << std::endl;
      IdaSolver   solver(decay, 0., {1e-6}, 1000);
      BlockVector y = decay.exact(0.), y_dot = y;
      if (thrower)
        *y.block(0).begin() = not_a_number;
      try
        {
          solver.restart(0., y, y_dot);
        }
      catch (const ExcRun &exception)
        {
          print(exception);
        }
    }
  }

  void test_recovery()
  {
    out << "A residual that is not finite three times is only a reason for smaller steps" << std::endl;
    Decay        decay;
    unsigned int failures = 0;
    decay.in_residual     = [&](const double time, BlockVector &result) {
      if (time > 0.5 && failures < 3)
        {
          ++failures;
          *result.block(0).begin() = std::numeric_limits<double>::infinity();
        }
    };
    IdaSolver   solver(decay, 0., {1e-6}, 1000);
    BlockVector y = decay.exact(0.), y_dot = decay.exact_rate(0.);
    solver.restart(0., y, y_dot);
    march(solver, y, y_dot, 1.);
    out << "  error " << largest_difference(y, decay.exact(1.)) / 1e-6 << " tolerances" << std::endl;
    print_work(solver);
  }
} // namespace Cautery::Test

int main(int argc, char **argv)
{
  using namespace Cautery;
  using namespace Cautery::Test;
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  out.set_condition(Utilities::MPI::this_mpi_process(communicator) == 0);
  out << std::setprecision(2);
  deal_II_exceptions::suppress_stacktrace_in_exceptions();

  test_decay();
  test_radiation();
  test_diffusion();
  test_wave();
  test_failures();
  test_recovery();
}
