// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/balance.h>
#include <cautery/physics/dead_nodes.h>
#include <cautery/physics/heat_cell.h>

#include <limits>

namespace Cautery
{
  /**
   * What follows for Heat where perfusion stops at nodes that have died. Heat assembles anew then; and in the
   * non-Fourier model the term (1 + tau d/dt) [w (T - T_b)] has an impulse where w jumps: the flux of heat
   * does not follow at once, but the blood's share goes into the tissue at once.
   */
  template <int dim>
  class StoppedPerfusion
  {
  public:
    /** @p has_impulse: in the non-Fourier model, where the integrator takes it. @p like has the pattern of
     * the matrices. */
    StoppedPerfusion(const Field<dim> &field, const bool has_impulse, const SparseMatrix &like);

    /** Is another node dead in @p state than before? Collective. */
    bool update(const State &state) { return dead.update(state.ln_damage); }

    /** Around an assembly for the step from @p state on that takes notice of more dead nodes: the impulse is
     * what they make different. */
    void before_change(const State &state);
    void after_change(const State &state);

    /** An assembly: cell by cell, where the flux is delayed by @p tau (s). */
    void clear();
    void add(const double tau, const HeatCellTerms<dim> &terms, const AffineConstraints<double> &constraints);
    void compress();

    /** Adds the impulse as a power over @p step, if that is the one that it belongs to; W per node. */
    void add_impulse(const Step &step, Vector &force) const;

    /** ln Omega when a node last died, as far as has been assembled; empty: nothing has. */
    const Vector &ln_damage() const { return dead.ln_damage(); }
    /** @p like has the layout of the nodes. Collective where it brings back. */
    void archive(Archive &archive, const Vector &like) { dead.archive(archive, like); }

  private:
    /// int tau w (T - T_b) N + int tau h T N
    Vector delayed(const Vector &temperature) const;

    const bool has_impulse;
    DeadNodes  dead;
    // C - int rho C N N is the same, but not bit for bit in a resumed run, where C depends on temperature
    SparseMatrix exchange;     ///< int tau w N N + int tau h N N
    Vector       blood_source; ///< int tau w T_b N
    Vector       impulse;      ///< by which int tau w (T - T_b) N has fallen, J per node
    double       fell_at = std::numeric_limits<double>::quiet_NaN(); ///< s
  };
} // namespace Cautery
