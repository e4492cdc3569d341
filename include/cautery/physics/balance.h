// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/scene/numerics.h>
#include <cautery/space/elimination.h>
#include <cautery/space/state.h>

#include <string>
#include <vector>

namespace Cautery
{
  /// One step in time, in s.
  struct Step
  {
    double from;
    double to;

    double length() const { return to - from; }
  };

  /**
   * A matrix twice: complete, for products with vectors that hold prescribed values, and with the constrained
   * unknowns condensed away (rows and columns empty but for a positive diagonal), to be solved with.
   */
  struct ConstrainedMatrix
  {
    SparseMatrix full;
    SparseMatrix reduced;
  };

  /**
   * A balance M x'' + C x' + K x = F(t), of heat or of momentum, discretised in space. What time integration
   * needs to know, and nothing else. A term that is off has no matrix.
   */
  class Balance
  {
  public:
    virtual ~Balance() = default;

    virtual std::string              name() const      = 0; ///< "heat" or "deformation"
    virtual const ConstrainedMatrix *inertia() const   = 0; ///< M
    virtual const ConstrainedMatrix *damping() const   = 0; ///< C
    virtual const ConstrainedMatrix &stiffness() const = 0; ///< K
    /** What Newton's method adds to C where that is a mean over the step: d(C x')/dx' - C; nullptr: nothing.
     */
    virtual const ConstrainedMatrix *damping_excess() const { return nullptr; }
    /** The same for M: d(M x')/dx' - M. */
    virtual const ConstrainedMatrix *inertia_excess() const { return nullptr; }

    /** Its part of the state: x and, where the state keeps it, x' (or nullptr). */
    virtual Vector State::*unknown() const = 0;
    virtual Vector State::*rate() const    = 0;

    /** The constrained unknowns. */
    virtual const Elimination &elimination() const = 0;

    /** Sets the prescribed entries of @p x to their values at @p time. */
    virtual void prescribe(const double time, Vector &x) const = 0;
    /** Do these values change in time? */
    virtual bool prescription_changes() const = 0;

    /** F, averaged over @p step as backward Euler needs it; @p state holds what other balances have reached.
     */
    virtual void load(const Step &step, const State &state, Vector &force) const = 0;

    /** Does it jump strictly between these times (s)? */
    virtual bool jumps_within(const double /*from*/, const double /*to*/) const { return false; }

    /** Do the matrices depend on the state? */
    virtual bool changes() const = 0;
    /** Do they, or the load, depend on the balance's own unknown, so that a step must be repeated? */
    virtual bool depends_on_iterate() const { return changes(); }

    /**
     * Assembles anew for a step of the given length from @p state to the iterate @p x. Returns whether the
     * matrices are others than before.
     */
    virtual bool refresh(const State &state, const Vector &x) = 0;

    /** May change the @p rate of the unknown over @p step, from @p state on, that the condensed matrix @p
     * system of backward Euler has given. */
    virtual void
    limit(const Step & /*step*/, const State & /*state*/, const SparseMatrix & /*system*/, Vector & /*rate*/)
    {
    }

    virtual const LinearSolverSettings &solver_settings() const = 0;
    /** The unknowns of this process that remain where others are condensed away; empty: all. */
    virtual const IndexSet &kept_unknowns() const = 0;
    virtual unsigned int    n_components() const  = 0;
    /** The modes that the stiffness matrix does not see, for multigrid. */
    virtual std::vector<Vector> near_null_space() const = 0;
  };
} // namespace Cautery
