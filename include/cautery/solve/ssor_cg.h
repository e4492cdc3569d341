// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/linear_algebra.h>

#include <memory>

namespace Cautery
{
  /**
   * Conjugate gradients, preconditioned by symmetric successive over-relaxation in blocks of one node, in
   * which a whole iteration reads the matrix's lower triangle twice and nothing else.
   *
   * With A = L + D + L^T, P = D / omega and E = P + L the preconditioner is E P^-1 E^T, positive definite for
   * any A that is: no pivot can be lost, as incomplete factorisations lose them near incompressibility and on
   * quadratic elements. As A = E + E^T - (2 - omega) P, the preconditioned matrix E^-1 A E^-T costs two
   * triangular solves, not two solves and a product: Eisenstat, SIAM J. Sci. Stat. Comput. 2 (1981) 1-4. No
   * library of Debian's has it; what it gains over Trilinos' preconditioners stands in doc/performance.md.
   * Each process relaxes its own unknowns.
   */
  class SsorCG
  {
  public:
    virtual ~SsorCG() = default;

    /** For a symmetric positive definite @p matrix, with blocks of @p n_components (1, 2 or 3) rows. */
    static std::unique_ptr<SsorCG> make(const SparseMatrix &matrix, const unsigned int n_components);

    /**
     * Solves A x = @p r from x = 0 until the residual's norm in the preconditioner's inverse, which is close
     * to the energy of the error, has fallen by the factor @p reduction.
     * @return the number of iterations, @p max_iterations + 1 where these were not enough
     */
    virtual unsigned int
    solve(Vector &x, const Vector &r, const double reduction, const unsigned int max_iterations) = 0;
  };
} // namespace Cautery
