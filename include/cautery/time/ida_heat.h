// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/cost.h>
#include <cautery/physics/heat.h>
#include <cautery/solve/linear_solver.h>
#include <cautery/time/ida_solver.h>
#include <cautery/time/integrator.h>

#include <array>

namespace Cautery
{
  /**
   * Heat by IDA: C T' + K T = F, or as a first-order system T' = V, M V' + C V + K T = F + tau F'. Prescribed
   * temperatures are algebraic. Starts anew whenever a source is switched, V jumping by what the balance
   * says.
   */
  template <int dim>
  class IdaHeat : public Integrator, private ImplicitSystem
  {
  public:
    IdaHeat(const TimeSettings &settings, Heat<dim> &heat, Cost &cost);

    void step(State &state, const double stop) override;
    void archive(Archive &archive, const State &state) override;
    /** Only where it starts anew: the history of IDA's steps is not to be had. */
    bool                             can_be_archived() const override { return fresh; }
    void                             start_anew() override { fresh = true; }
    std::map<std::string, double>    statistics() const override;
    std::map<std::string, TimeError> time_errors() const override;

  private:
    void
    residual(const double time, const BlockVector &y, const BlockVector &y_dot, BlockVector &result) override;
    void setup_jacobian(const double       time,
                        const BlockVector &y,
                        const BlockVector &y_dot,
                        const double       new_alpha) override;
    void solve_jacobian(const BlockVector &right_hand_side, BlockVector &x, const double tolerance) override;

    void replace_constrained(const Vector &is, const Vector &should, Vector &residual);
    void start(State &state);
    void jump(const double time);
    void settle(const double time);
    void make_consistent(const double time);
    void refresh_properties(const Vector &temperature);
    /** A derivative of the prescribed temperatures, by finite differences with five weights. */
    void   differentiate_prescribed(const std::array<double, 5> &weights,
                                    const unsigned int           order,
                                    const double                 time,
                                    Vector                      &derivative) const;
    void   prescribed_rate(const double time, Vector &rate) const;
    void   prescribed_acceleration(const double time, Vector &acceleration) const;
    double next_switch(const double time) const;

    const TimeSettings       &settings;
    Heat<dim>                &heat;
    Cost                     &cost;
    const bool                second_order;
    const std::vector<double> switches;
    IdaSolver                 ida;
    LinearSolver              solver;      ///< of the Jacobian, reduced to temperatures
    LinearSolver              mass_solver; ///< of the highest derivative
    SparseMatrix              system;
    double                    alpha        = 0.;
    double                    within       = 0.; ///< a time in the present interval between switches, s
    bool                      fresh        = true;
    unsigned int              n_iterations = 0;
    const State              *properties   = nullptr; ///< the state whose damage stops perfusion
    BlockVector               y, y_dot, local_error;
    TimeError                 error;
    Vector                    force, product, boundary;
  };
} // namespace Cautery
