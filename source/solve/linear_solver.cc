// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/solve/linear_solver.h>
#include <cautery/solve/ssor_cg.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_richardson.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_solver.h>

#include <Epetra_MultiVector.h>
#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace Cautery
{
  namespace
  {
    using Method = LinearSolverSettings::Method;

    /// Of the right-hand side: a residual that rounding keeps from falling further is taken if it is below.
    constexpr double least_accuracy = 1e-8;

    /**
     * Measured on the chapter 4 cube (doc/performance.md): SSOR needs next to no set-up and least time; its
     * iterations grow with the mesh, and from some 300,000 displacements multigrid keeps up with it.
     */
    Method
    choose(const Method asked, const types::global_dof_index n_unknowns, const unsigned int n_components)
    {
      if (asked != Method::automatic)
        return asked;
      return n_components > 1 && n_unknowns > 300000 ? Method::cg_amg : Method::cg_ssor;
    }
  } // namespace

  /// A factorisation, or what iterations are made of.
  struct LinearSolver::Engine
  {
    Method                                          method;
    SolverControl                                   control;
    std::unique_ptr<TrilinosWrappers::SolverDirect> factorisation;
    std::unique_ptr<SsorCG>                         ssor;
    std::unique_ptr<TrilinosWrappers::PreconditionBase>
                        preconditioner; ///< multigrid, or a sweep of Gauss-Seidel
    std::vector<double> mode_values;    ///< of multigrid, which keeps a pointer to them
  };

  LinearSolver::LinearSolver(const LinearSolverSettings &settings,
                             const unsigned int          n_components,
                             Modes                       near_null_space,
                             const IndexSet             &kept)
    : settings(settings)
    , n_components(n_components)
    , near_null_space(std::move(near_null_space))
    , kept(kept)
    , guess(settings.guesses)
  {
  }

  LinearSolver::~LinearSolver() = default;

  void LinearSolver::set_matrix(const SparseMatrix &new_matrix)
  {
    if (kept.size() > 0)
      condensation = std::make_unique<Condensation>(new_matrix, kept);
    matrix = condensation ? &condensation->schur_complement() : &new_matrix;
    guess.clear(matrix->linfty_norm());
    set_up(choose(settings.method, matrix->m(), n_components));
    const IndexSet rows = matrix->locally_owned_range_indices();
    for (auto *vector : {&residual, &solution, &correction, &image})
      vector->reinit(rows, matrix->get_mpi_communicator());
  }

  std::string LinearSolver::description() const
  {
    switch (engine->method)
      {
      case Method::direct:
        return "direct";
      case Method::cg_amg:
        return "CG + AMG";
      case Method::gauss_seidel:
        return "Gauss-Seidel";
      default:
        return "CG + SSOR";
      }
  }

  namespace
  {
    std::unique_ptr<TrilinosWrappers::SolverDirect> factorise(const SparseMatrix &matrix,
                                                              SolverControl      &control)
    {
      auto solver = std::make_unique<TrilinosWrappers::SolverDirect>(
        control, TrilinosWrappers::SolverDirect::AdditionalData(false, "Amesos_Klu"));
      try
        {
          solver->initialize(matrix);
        }
      catch (const TrilinosWrappers::SolverDirect::ExcTrilinosError &)
        {
          AssertThrow(false, ExcRun("the direct solver finds the matrix singular"));
        }
      return solver;
    }

    std::unique_ptr<TrilinosWrappers::PreconditionBase> make_multigrid(const SparseMatrix &matrix,
                                                                       const unsigned int  n_components,
                                                                       const std::vector<Vector> &modes,
                                                                       std::vector<double>       &values)
    {
      for (const auto &mode : modes)
        values.insert(values.end(), mode.begin(), mode.end());

      Teuchos::ParameterList list;
      ML_Epetra::SetDefaults("SA", list);
      list.set("ML output", 0);
      list.set("smoother: type", "Chebyshev");
      list.set("smoother: sweeps", 2);
      list.set("smoother: ifpack overlap", 0);
      list.set("aggregation: threshold", n_components > 1 ? 0.02 : 1e-4);
      list.set("coarse: type", "Amesos-KLU");
      list.set("PDE equations", static_cast<int>(n_components));
      list.set("null space: type", "pre-computed");
      list.set("null space: dimension", static_cast<int>(modes.size()));
      list.set("null space: vectors", values.data());
      list.set("null space: add default vectors", false);
      // its estimates of eigenvalues start from random numbers: the same, however often it was set up before
      std::srand(1);
      ML_set_random_seed(1);
      auto amg = std::make_unique<TrilinosWrappers::PreconditionAMG>();
      amg->initialize(matrix, list);
      return amg;
    }

    /// The lower triangle of the process's own block: other processes' unknowns count as they were (Jacobi).
    std::unique_ptr<TrilinosWrappers::PreconditionBase> make_sweep(const SparseMatrix &matrix)
    {
      auto sweep = std::make_unique<TrilinosWrappers::PreconditionSOR>();
      sweep->initialize(matrix);
      return sweep;
    }
  } // namespace

  void LinearSolver::set_up(const Method method)
  {
    engine         = std::make_unique<Engine>();
    engine->method = method;
    if (engine->method == Method::direct)
      engine->factorisation = factorise(*matrix, engine->control);
    else if (engine->method == Method::cg_amg)
      engine->preconditioner = make_multigrid(*matrix, n_components, modes(), engine->mode_values);
    else if (engine->method == Method::gauss_seidel)
      engine->preconditioner = make_sweep(*matrix);
    else
      engine->ssor = SsorCG::make(*matrix, n_components);
  }

  std::vector<Vector> LinearSolver::modes() const
  {
    std::vector<Vector> result = near_null_space();
    if (condensation)
      for (auto &mode : result)
        mode = condensation->kept_part(mode);
    return result;
  }

  unsigned int LinearSolver::solve(Vector &x, const Vector &b)
  {
    largest_right_hand_side = std::max(largest_right_hand_side, b.l2_norm());
    return solve_to(x, b, settings.tolerance, largest_right_hand_side);
  }

  unsigned int LinearSolver::solve(Vector &x, const Vector &b, const double relative_tolerance)
  {
    return solve_to(x, b, relative_tolerance, b.l2_norm());
  }

  /// What products with the solution leave of a residual that is zero.
  double LinearSolver::rounding() const
  {
    return std::numeric_limits<double>::epsilon() * matrix->linfty_norm() * solution.l2_norm();
  }

  unsigned int LinearSolver::solve_to(Vector &x, const Vector &b, const double tolerance, const double scale)
  {
    const double goal = tolerance * scale;
    AssertThrow(
      std::isfinite(b.l2_norm()),
      ExcRun("a right-hand side is not finite: the solution has blown up; take a smaller Time/Step"));
    Assert(engine, ExcInternalError());
    if (condensation)
      condensation->reduce(b, residual);
    else
      residual = b;
    guess.apply(solution, residual);
    unsigned int iterations = 0;
    double       last       = std::numeric_limits<double>::infinity();
    for (double norm = residual.l2_norm(); !(norm <= goal); norm = residual.l2_norm())
      {
        if (!(norm < 0.5 * last) && norm <= least_accuracy * scale && norm <= rounding())
          break;
        AssertThrow(norm < 0.5 * std::exchange(last, norm),
                    ExcRun(description() + " gets no closer than a residual of " + to_text(norm) +
                           ", where " + to_text(goal) + " was asked: the matrix is close to singular"));
        // More accurate than asked: the guesses are no better than the directions that they are made of, and
        // every error in these becomes one more direction.
        iterations += correct(0.3 * goal / norm);
        solution += correction;
        residual -= image;
        guess.learn(correction, image);
      }
    // only now: what fails leaves x alone
    if (condensation)
      condensation->recover(solution, x);
    else
      x = solution;
    return iterations;
  }

  void LinearSolver::archive(Archive &archive)
  {
    archive.shared("largest right-hand side", largest_right_hand_side);
    if (!engine)
      return;
    unsigned int method = static_cast<unsigned int>(engine->method);
    archive.shared("method", method);
    if (method != static_cast<unsigned int>(engine->method))
      set_up(static_cast<Method>(method));
    guess.archive(archive);
  }

  unsigned int LinearSolver::correct(const double reduction)
  {
    unsigned int iterations = apply(reduction);
    if (iterations > settings.max_iterations && settings.method == Method::automatic &&
        engine->method != Method::cg_amg)
      {
        set_up(Method::cg_amg);
        iterations = apply(reduction);
      }
    AssertThrow(iterations <= settings.max_iterations,
                ExcRun(description() + " did not converge in " + std::to_string(settings.max_iterations) +
                       " iterations; choose Method = direct or CG + AMG, or a larger Tolerance in the "
                       "solver's section of Numerics"));
    return iterations;
  }

  /// correction = an approximation of A^-1 residual; returns the number of iterations, more than the largest
  /// where these were not enough.
  unsigned int LinearSolver::apply(const double reduction)
  {
    unsigned int iterations = 1;
    if (engine->ssor)
      iterations = engine->ssor->solve(correction, residual, reduction, settings.max_iterations);
    else if (engine->preconditioner)
      {
        SolverControl control(settings.max_iterations, reduction * residual.l2_norm());
        correction = 0.;
        try
          {
            if (engine->method == Method::gauss_seidel)
              SolverRichardson<Vector>(control).solve(*matrix, correction, residual, *engine->preconditioner);
            else
              SolverCG<Vector>(control).solve(*matrix, correction, residual, *engine->preconditioner);
            iterations = control.last_step();
          }
        catch (const SolverControl::NoConvergence &)
          {
            iterations = settings.max_iterations + 1;
          }
      }
    else
      engine->factorisation->solve(correction, residual);
    matrix->vmult(image, correction);
    return iterations;
  }
} // namespace Cautery
