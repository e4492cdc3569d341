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
   * Finds the state in which forces balance, for the time of the state.
   */
  class Equilibrium
  {
  public:
    virtual ~Equilibrium() = default;

    /** Errors: ExcRun with the reason; @p state is then as before. */
    virtual void solve(State &state) = 0;

    /**
     * Where `solve` has failed on the way from one load to the next: the last load that was borne, as the
     * state at that share of the way from the last equilibrium; nullptr: none.
     */
    virtual const State *last_borne() const { return nullptr; }

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
