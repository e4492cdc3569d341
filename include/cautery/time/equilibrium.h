// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/cost.h>
#include <cautery/physics/balance.h>
#include <cautery/solve/linear_solver.h>

#include <map>
#include <string>

namespace Cautery
{
  /**
   * A part of a load, and the body in equilibrium with it.
   */
  struct BorneLoad
  {
    /** Time and temperature are at the load's share of the way from the last equilibrium to the one that was
     * asked for, the rest is as there. */
    State  state;
    Vector unbalanced_forces; ///< inner less outer ones, N per unknown, not condensed
  };

  /**
   * Finds the state in which forces balance, for the time of the state.
   */
  class Equilibrium
  {
  public:
    virtual ~Equilibrium() = default;

    /** Errors: ExcRun with the reason; @p state is then as before. */
    virtual void solve(State &state) = 0;

    /** Where `solve` has failed: the last load on the way that was borne; nullptr: none. */
    virtual const BorneLoad *last_borne() const { return nullptr; }

    /** What it remembers of earlier solutions, see Integrator::archive. */
    virtual void archive(Archive &archive, const State &state) = 0;

    /** Counts that a user may want to know; those of no work are left out. */
    virtual std::map<std::string, double> statistics() const = 0;
  };

  /**
   * K x = F: a balance without rates.
   */
  class LinearEquilibrium : public Equilibrium
  {
  public:
    LinearEquilibrium(Balance &balance, Cost &cost);

    void                          solve(State &state) override;
    void                          archive(Archive &archive, const State &state) override;
    std::map<std::string, double> statistics() const override;

  private:
    void set_matrix(const Vector &x);

    Balance     &equation;
    Cost        &cost;
    LinearSolver solver;
    Vector       force, solution, product;
    bool         ready        = false;
    unsigned int n_iterations = 0;
  };
} // namespace Cautery
