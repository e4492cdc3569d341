// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/cost.h>
#include <cautery/output/nodal_columns.h>
#include <cautery/physics/heat_balance.h>
#include <cautery/physics/time_error.h>
#include <cautery/problems/body.h>
#include <cautery/time/equilibrium.h>

#include <map>
#include <memory>
#include <optional>
#include <string>

namespace Cautery
{
  /**
   * What a scene simulates: operators, an integrator, and what follows from their state. Only composed of
   * these.
   */
  template <int dim>
  class Problem
  {
  public:
    virtual ~Problem() = default;

    /** The state at t = 0, with exactly the vectors that the scene's effects need. */
    virtual State start() = 0;

    /**
     * Goes on from @p state, which is on this problem's nodes, where @p before, the same problem on another
     * mesh, has come to @p last. Completes what has no history. Collective. Errors: ExcRun.
     */
    virtual void go_on(State &state, Problem &before, const State &last) = 0;

    /** One step, at most to @p stop (s). Errors: ExcRun; @p state is then that of the last good step. */
    virtual void step(State &state, const double stop) = 0;

    /** Solves for what only an output asks for. */
    virtual void complete(State &) {}

    /** Collective; nothing where deformation is off. */
    virtual std::optional<MechanicalFields<dim>> mechanical_fields(const State &) const { return {}; }
    virtual const Field<dim>                    *displacement() const { return nullptr; }
    /** Inner less outer forces, N per unknown of the displacement: what supports bear, but for the inertia of
     * held nodes, and what moves the others. Collective; nothing where deformation is off. */
    virtual std::optional<Vector>     unbalanced_forces(const State &) { return {}; }
    virtual std::optional<HeatTotals> heat_totals(const State &) { return {}; }

    /** Where there was no equilibrium: see Equilibrium. */
    virtual const BorneLoad *last_borne() const { return nullptr; }

    /** All that it remembers besides @p state, which is that of the archive already. Collective where it
     * brings back. */
    virtual void archive(Archive &archive, const State &state) = 0;
    /** See Integrator. */
    virtual bool can_be_archived() const { return true; }
    virtual void start_anew() {}

    /** By name: temperature, displacement, ... */
    virtual std::map<std::string, types::global_dof_index> unknowns() const = 0;
    /** The names do not depend on what has been counted so far: archives are written and read by them. */
    virtual std::map<std::string, double> statistics() const = 0;
    /** See Integrator; the same holds. */
    virtual std::map<std::string, TimeError> time_errors() const { return {}; }
  };

  /** The problem for the effects of @p scene. Arguments must live as long as it. */
  template <int dim>
  std::unique_ptr<Problem<dim>> make_problem(const Scene &scene, const Body<dim> &body, Cost &cost);
} // namespace Cautery
