// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/coupling.h>
#include <cautery/time/backward_euler.h>

namespace Cautery
{
  /**
   * Backward Euler for heat and deformation that act on each other (thesis Eqs. 4-22, 6-8 and 6-27): one
   * linear system
   *
   *   A_T V + (D + D_tau / dt) w = r_T,     -dt G V + A_u w = r_u
   *
   * for the rates V of temperature and w of displacement. D is the feedback, G the thermal expansion. Solved
   * by FGMRES, preconditioned by solving one balance after the other, which alone would converge only while
   * the coupling is weak.
   */
  template <int dim>
  class CoupledBackwardEuler : public Integrator
  {
  public:
    CoupledBackwardEuler(const TimeSettings                  &settings,
                         const Numerics                      &numerics,
                         Balance                             &heat,
                         Balance                             &deformation,
                         const ThermalExpansionOperator<dim> &expansion,
                         const ThermoelasticFeedback<dim>    &feedback,
                         Cost                                &cost);

    void                             step(State &state, const double stop) override;
    void                             archive(Archive &archive, const State &state) override;
    std::map<std::string, double>    statistics() const override;
    std::map<std::string, TimeError> time_errors() const override;

  private:
    void prepare(const double new_length, const State &state);
    void set_heat_solver();
    void set_deformation_solver(const double new_length, const State &state);
    void assemble_right_hand_sides(const Step &step, const State &state);
    void solve(const Step &step);

    const TimeSettings                  &settings;
    const Numerics                      &numerics;
    BackwardEulerBalance                 heat;
    BackwardEulerBalance                 deformation;
    const ThermalExpansionOperator<dim> &expansion;
    const ThermoelasticFeedback<dim>    &feedback;
    Cost                                &cost;
    LinearSolver                         heat_solver;
    LinearSolver                         deformation_solver;
    double                               length = 0.; ///< of the last step, s
    SparseMatrix                         cooling;     ///< D + D_tau / dt
    BlockVector                          rates;       ///< V, w
    BlockVector                          right_hand_side;
    double                               largest_right_hand_side = 0.;
    unsigned int                         n_iterations            = 0;
  };
} // namespace Cautery
