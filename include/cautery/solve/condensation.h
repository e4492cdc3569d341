// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/linear_algebra.h>

#include <deal.II/lac/trilinos_solver.h>

#include <vector>

namespace Cautery
{
  /**
   * Static condensation (thesis Eqs. 6-31 to 6-34): of A x = b with symmetric positive definite A only the
   * kept unknowns remain, under the Schur complement S = A_kk - A_kr A_rr^-1 A_rk. Exact: the rest follows.
   *
   * S is as sparse as A_kk but for a dense block over all kept unknowns that touch the rest. To make it costs
   * a solve for each of these, with A_rr factorised.
   */
  class Condensation
  {
  public:
    /**
     * @p kept are the unknowns of this process that remain: some, but not all of all. Collective.
     * Errors: ExcInput where S would have over 2^31 entries on one process.
     */
    Condensation(const SparseMatrix &matrix, const IndexSet &kept);

    /** S, its unknowns numbered as they follow each other in A. */
    const SparseMatrix &schur_complement() const { return schur; }

    /** b_k - A_kr A_rr^-1 b_r, and remembers b_r. */
    void reduce(const Vector &b, Vector &remaining);

    /** Sets @p x to @p remaining and what follows from it and from the last b. */
    void recover(const Vector &remaining, Vector &x);

    /** The kept part of @p x. */
    Vector kept_part(const Vector &x) const;

  private:
    /** Unknowns that stay together. */
    struct Part
    {
      std::vector<unsigned int> places;  ///< in the owned part of a vector of A
      IndexSet                  numbers; ///< in vectors of their own
    };

    void number(const IndexSet &owned, const IndexSet &kept_unknowns);
    void split(const SparseMatrix &matrix);
    void factorise();
    void complement();

    MPI_Comm                       communicator;
    Part                           kept, rest;
    SparseMatrix                   kept_kept, rest_kept, rest_rest, schur;
    SolverControl                  control;
    TrilinosWrappers::SolverDirect factorisation;
    Vector                         rest_load, rest_solution, rest_product, kept_product;
  };
} // namespace Cautery
