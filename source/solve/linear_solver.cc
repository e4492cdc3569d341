// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/solve/linear_solver.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_solver.h>

#include <Epetra_MultiVector.h>
#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>

#include <cmath>

namespace Cautery
{
  namespace
  {
    using Method = LinearSolverSettings::Method;

    /// By size: measured on the chapter 4 cube, see doc/performance.md.
    Method
    choose(const Method asked, const types::global_dof_index n_unknowns, const unsigned int n_components)
    {
      if (asked != Method::automatic)
        return asked;
      if (n_components == 1)
        return n_unknowns < 1000 ? Method::direct : Method::cg_incomplete_cholesky;
      if (n_unknowns < 6000)
        return Method::direct;
      return n_unknowns < 100000 ? Method::cg_incomplete_cholesky : Method::cg_amg;
    }
  } // namespace

  /// A factorisation, or a preconditioner for conjugate gradients.
  struct LinearSolver::Engine
  {
    Method                                              method;
    SolverControl                                       control;
    std::unique_ptr<TrilinosWrappers::SolverDirect>     factorisation;
    std::unique_ptr<TrilinosWrappers::PreconditionBase> preconditioner;
    std::vector<double> mode_values; ///< of multigrid, which keeps a pointer to them
  };

  LinearSolver::LinearSolver(const LinearSolverSettings &settings,
                             const unsigned int          n_components,
                             Modes                       near_null_space)
    : settings(settings)
    , n_components(n_components)
    , near_null_space(std::move(near_null_space))
    , guess(settings.guesses)
  {
  }

  LinearSolver::~LinearSolver() = default;

  void LinearSolver::set_matrix(const SparseMatrix &new_matrix)
  {
    matrix = &new_matrix;
    engine.reset();
    guess.clear();
  }

  std::string LinearSolver::description() const
  {
    if (!engine || engine->method == Method::direct)
      return "direct";
    return engine->method == Method::cg_amg ? "CG + AMG" : "CG + incomplete Cholesky";
  }

  namespace
  {
    std::unique_ptr<TrilinosWrappers::SolverDirect> factorise(const SparseMatrix &matrix,
                                                              SolverControl      &control)
    {
      auto solver = std::make_unique<TrilinosWrappers::SolverDirect>(
        control, TrilinosWrappers::SolverDirect::AdditionalData(false, "Amesos_Klu"));
      solver->initialize(matrix);
      return solver;
    }

    std::unique_ptr<TrilinosWrappers::PreconditionBase> multigrid(const SparseMatrix        &matrix,
                                                                  const unsigned int         n_components,
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
      auto amg = std::make_unique<TrilinosWrappers::PreconditionAMG>();
      amg->initialize(matrix, list);
      return amg;
    }
  } // namespace

  void LinearSolver::set_up()
  {
    engine         = std::make_unique<Engine>();
    engine->method = choose(settings.method, matrix->m(), n_components);
    if (engine->method == Method::direct)
      engine->factorisation = factorise(*matrix, engine->control);
    else if (engine->method == Method::cg_amg)
      engine->preconditioner = multigrid(*matrix, n_components, near_null_space(), engine->mode_values);
    else
      {
        auto cholesky = std::make_unique<TrilinosWrappers::PreconditionIC>();
        cholesky->initialize(*matrix);
        engine->preconditioner = std::move(cholesky);
      }
    const IndexSet rows = matrix->locally_owned_range_indices();
    for (auto *vector : {&residual, &correction, &image, &whole_image})
      vector->reinit(rows, matrix->get_mpi_communicator());
  }

  unsigned int LinearSolver::solve(Vector &x, const Vector &b)
  {
    largest_right_hand_side = std::max(largest_right_hand_side, b.l2_norm());
    return solve_to(x, b, settings.tolerance * largest_right_hand_side);
  }

  unsigned int LinearSolver::solve(Vector &x, const Vector &b, const double relative_tolerance)
  {
    return solve_to(x, b, relative_tolerance * b.l2_norm());
  }

  unsigned int LinearSolver::solve_to(Vector &x, const Vector &b, const double goal)
  {
    AssertThrow(
      std::isfinite(b.l2_norm()),
      ExcRun("a right-hand side is not finite: the solution has blown up; take a smaller Time/Step"));
    if (!engine)
      set_up();
    residual = b;
    guess.apply(x, residual);
    if (residual.l2_norm() <= goal)
      return 0;

    unsigned int iterations = 1;
    correction              = 0.;
    if (engine->factorisation)
      engine->factorisation->solve(correction, residual);
    else
      {
        SolverControl control(settings.max_iterations, goal);
        try
          {
            SolverCG<Vector>(control).solve(*matrix, correction, residual, *engine->preconditioner);
          }
        catch (const SolverControl::NoConvergence &failure)
          {
            AssertThrow(false,
                        ExcRun(description() + " did not converge in " + std::to_string(failure.last_step) +
                               " iterations (residual " + to_text(failure.last_residual) + ", asked " +
                               to_text(goal) +
                               "); choose Method = direct or CG + AMG, or a larger Tolerance in the solver's "
                               "section of Numerics"));
          }
        iterations = control.last_step();
      }
    x += correction;
    if (settings.guesses > 0)
      {
        matrix->vmult(image, correction);
        if (guess.size() + 1 > settings.guesses)
          matrix->vmult(whole_image, x);
        guess.learn(x, whole_image, correction, image);
      }
    return iterations;
  }
} // namespace Cautery
