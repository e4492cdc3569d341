// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/linear_algebra.h>

#include <deal.II/base/index_set.h>
#include <deal.II/lac/affine_constraints.h>

#include <vector>

namespace Cautery
{
  /**
   * Homogeneous constraints x = C y in the form that the time loop needs: all indices are local, so that a
   * call costs microseconds where AffineConstraints looks every number up. The unknowns of a constraint
   * belong to one node and hence to one process.
   */
  class Elimination
  {
  public:
    void reinit(const AffineConstraints<double> &constraints, const IndexSet &owned);

    /** C^T residual: each constrained row is added to those it depends on, then set to zero. */
    void condense(Vector &residual) const;

    /** C y: sets the constrained entries from the free ones. */
    void distribute(Vector &x) const;

    /** Sets the constrained entries to zero. */
    void clear(Vector &x) const;

    /** Sets the constrained entries of @p to to those of @p from. */
    void copy_constrained(const Vector &from, Vector &to) const;

    /** Sets to zero all but the constrained entries. */
    void keep_constrained(Vector &x) const;

    bool empty() const { return lines.empty(); }

  private:
    struct Line
    {
      unsigned int                                 row;
      std::vector<std::pair<unsigned int, double>> depends_on;
    };
    std::vector<Line> lines;
  };
} // namespace Cautery
