// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/linear_algebra.h>
#include <cautery/space/elimination.h>

namespace Cautery
{
  /**
   * Lifts temperatures that a step has left below a floor, by heat from warmer nodes: from neighbours in the
   * matrix A of the step first, in proportion to |A_ij| and to what each has above the floor; then from
   * farther and farther ones. Heat flows from warm to cold only, and 1^T A T, the heat that the step accounts
   * for, stays what it was.
   */
  class TemperatureLimiter
  {
  public:
    /**
     * Changes @p temperature (K; constrained entries are left alone) to at least @p floor. @p system (J/K) is
     * A, symmetric, with constrained rows and columns condensed away by @p constraints. Returns the heat that
     * each node got, 1^T A times its change (J); its sum is zero unless the body as a whole is below the
     * floor. Collective.
     */
    Vector
    lift(const SparseMatrix &system, const Elimination &constraints, const double floor, Vector &temperature);

    unsigned int steps() const { return n_steps; } ///< in which something was lifted

  private:
    void find_neighbours(const SparseMatrix &system);
    void find_weights(const SparseMatrix &system, const Elimination &constraints);
    void find_balance(const double floor, const Vector &temperature);
    void lend(const unsigned int reach, Vector &temperature);
    void share(const double floor, Vector &temperature);

    /** x = B^reach x, with B = |A| without its diagonal, over its largest row sum. */
    void spread(const unsigned int reach, Vector &x);

    SparseMatrix neighbours; ///< B
    Vector       weights;    ///< A 1 at the free nodes, 0 elsewhere, J/K
    Vector       lack;       ///< what nodes lack to the floor, J
    Vector       surplus;    ///< what they have above it, J
    Vector       paid, product;
    unsigned int n_steps = 0;
  };
} // namespace Cautery
