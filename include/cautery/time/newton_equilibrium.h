// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/large_elasticity.h>
#include <cautery/scene/newton_settings.h>
#include <cautery/time/equilibrium.h>

namespace Cautery
{
  /**
   * Equilibrium in large deformation by Newton's method.
   *
   * From the last equilibrium the load (forces, prescribed displacements, temperature) goes in one step to
   * the new one. Where Newton's method fails or turns a cell inside out, the step is halved, and doubled
   * again where it succeeds quickly. Each iteration goes along its direction until the energy is past the
   * steepest of its descent. Linear systems are solved the more accurately the smaller the residual is
   * (forcing terms of Dembo, Eisenstat and Steihaug, SIAM J. Numer. Anal. 19 (1982) 400-408), so that
   * convergence stays quadratic.
   */
  template <int dim>
  class NewtonEquilibrium : public Equilibrium
  {
  public:
    NewtonEquilibrium(LargeElasticity<dim>       &body,
                      const NewtonSettings       &settings,
                      const LinearSolverSettings &solver_settings,
                      Cost                       &cost);

    void                          solve(State &state) override;
    const BorneLoad              *last_borne() const override { return borne ? &*borne : nullptr; }
    void                          archive(Archive &archive, const State &state) override;
    std::map<std::string, double> statistics() const override;

    /** The relative residual before each iteration of the last step of the load, and after them. */
    const std::vector<double> &residuals() const { return history; }

  private:
    /// Why a step of the load failed; empty where it did not.
    using Failure = std::string;

    void    keep_borne(const State &asked, const Loading &load, const Vector &x, const double share);
    Failure iterate(const Loading &from, const Loading &target, Vector &x);
    Failure advance(const Loading &target, const Vector &moves, Vector &x);
    Failure descend(const Loading &target, Vector &x);
    Failure find_direction(const Loading &target, const Vector &moves, const Vector &x);
    Failure factorise_and_solve(const SparseMatrix &tangent);
    Failure search(const Loading &target, Vector &x);
    std::optional<InvertedCell> find_residual(const Vector &x, const Loading &target);
    /// N, the largest of all equilibria so far.
    double acting_forces(const Loading &target) const;
    double relative_residual(const Loading &target) const;

    LargeElasticity<dim>      &body;
    const NewtonSettings       settings;
    const LinearSolverSettings solver_settings;
    Cost                      &cost;
    LinearSolver               solver;
    std::optional<State>       last;    ///< equilibrium: its time and temperature
    Loading                    reached; ///< in it
    std::optional<BorneLoad>   borne;
    double                     typical    = 0.; ///< the forces that acted in the equilibria so far, N
    double                     start_norm = 0.; ///< of the residual at the start of the step, N
    Vector                     residual, direction, right_hand_side;
    std::vector<double>        history;
    unsigned int               n_linear = 0, n_newton = 0, n_steps = 0;
  };
} // namespace Cautery
