// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/linear_algebra.h>
#include <cautery/scene/numerics.h>
#include <cautery/solve/condensation.h>
#include <cautery/solve/projected_guess.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace Cautery
{
  /**
   * Solves A x = b with symmetric positive definite A again and again, the right-hand sides changing slowly:
   * the first guess comes from earlier solutions, and often nothing is left to do.
   */
  class LinearSolver
  {
  public:
    using Modes = std::function<std::vector<Vector>()>;

    /**
     * @p n_components unknowns stand together at each node; @p near_null_space gives the modes that multigrid
     * must not forget (asked for only where multigrid is used). Where @p kept is not empty, the systems are
     * condensed to these unknowns of this process, see Condensation.
     */
    LinearSolver(const LinearSolverSettings &settings,
                 const unsigned int          n_components,
                 Modes                       near_null_space,
                 const IndexSet             &kept = IndexSet());
    ~LinearSolver();

    /** The matrix from now on: sets up what solves with it. It must live as long as it is solved with. */
    void set_matrix(const SparseMatrix &matrix);

    /**
     * Solves until the residual is below the tolerance times the largest right-hand side met so far.
     * @return the number of iterations
     * Errors: ExcRun for right-hand sides that are not finite and for iterations that do not converge.
     */
    unsigned int solve(Vector &x, const Vector &b);

    /** Solves until the residual is below @p relative_tolerance times this right-hand side. */
    unsigned int solve(Vector &x, const Vector &b, const double relative_tolerance);

    /** The matrix, if there was one, has been set already. */
    void archive(Archive &archive);

    /** What is used, e.g. "CG + SSOR". */
    std::string description() const;

  private:
    struct Engine;

    void                set_up(const LinearSolverSettings::Method method);
    std::vector<Vector> modes() const;
    unsigned int        solve_to(Vector &x, const Vector &b, const double tolerance, const double scale);
    double              rounding() const;
    unsigned int        correct(const double reduction);
    unsigned int        apply(const double reduction);

    const LinearSolverSettings    settings;
    const unsigned int            n_components;
    const Modes                   near_null_space;
    const IndexSet                kept;
    std::unique_ptr<Condensation> condensation; ///< where not all is kept
    const SparseMatrix     *matrix = nullptr;   ///< what is solved with: all of A, or what it is condensed to
    std::unique_ptr<Engine> engine;             ///< of the matrix
    ProjectedGuess          guess;
    double                  largest_right_hand_side = 0.;
    Vector                  residual, solution, correction, image;
  };
} // namespace Cautery
