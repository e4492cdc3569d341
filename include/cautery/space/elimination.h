// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/linear_algebra.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/partitioner.h>
#include <deal.II/lac/affine_constraints.h>

#include <memory>
#include <vector>

namespace Cautery
{
  /**
   * Homogeneous constraints x = C y in the form that the time loop needs: all indices are local, so that a
   * call costs microseconds where AffineConstraints looks every number up. Most constraints concern one node
   * and hence one process; those of hanging nodes may reach over to others, and only then do processes talk.
   */
  class Elimination
  {
  public:
    /** Collective. */
    void
    reinit(const AffineConstraints<double> &constraints, const IndexSet &owned, const MPI_Comm communicator);

    /** C^T residual: each constrained row is added to those it depends on, then set to zero. Collective. */
    void condense(Vector &residual) const;

    /** C y: sets the constrained entries from the free ones. Collective. */
    void distribute(Vector &x) const;

    /** Adds to the constrained entries what follows from those they depend on. Collective. */
    void add_dependence(Vector &x) const;

    /** Sets the constrained entries to zero. */
    void clear(Vector &x) const;

    /** Sets the constrained entries of @p to to those of @p from. */
    void copy_constrained(const Vector &from, Vector &to) const;

    /** Sets to zero all but the constrained entries. */
    void keep_constrained(Vector &x) const;

  private:
    struct Line
    {
      unsigned int                                 row;
      std::vector<std::pair<unsigned int, double>> depends_on; ///< beyond the owned entries: imported ones
    };
    void import(const Vector &x) const;

    std::vector<Line>                                  lines;
    unsigned int                                       n_owned = 0;
    std::shared_ptr<const Utilities::MPI::Partitioner> partitioner; ///< none: nothing is imported
    mutable std::vector<double>                        imported;
  };
} // namespace Cautery
