// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/damage_history.h>
#include <cautery/problems/problem.h>
#include <cautery/time/integrator.h>

namespace Cautery
{
  /**
   * Heat, and the damage that follows from it.
   */
  template <int dim>
  class ThermalProblem : public Problem<dim>
  {
  public:
    ThermalProblem(const Scene &scene, const Body<dim> &body, Cost &cost);

    State                     start() override;
    void                      go_on(State &state, Problem<dim> &before, const State &last) override;
    void                      step(State &state, const double stop) override;
    std::optional<HeatTotals> heat_totals(const State &state) override;
    void                      archive(Archive &archive, const State &state) override;
    bool                      can_be_archived() const override { return integrator->can_be_archived(); }
    void                      start_anew() override { integrator->start_anew(); }
    std::map<std::string, types::global_dof_index> unknowns() const override;
    std::map<std::string, double>    statistics() const override { return integrator->statistics(); }
    std::map<std::string, TimeError> time_errors() const override { return integrator->time_errors(); }

  private:
    const Scene                         &scene;
    const Body<dim>                     &body;
    Cost                                &cost;
    Heat<dim>                            heat;
    std::unique_ptr<Integrator>          integrator;
    std::unique_ptr<NodalGradients<dim>> gradients; ///< for the damage law of heat flux only
    std::unique_ptr<DamageHistory<dim>>  damage;
    std::unique_ptr<HeatBalance<dim>>    books;
  };

  /** The temperature at t = 0 and, for the non-Fourier model, its rate: zero. */
  template <int dim>
  void start_heat(const Scene &scene, const Field<dim> &nodes, State &state);

  /** Backward Euler or IDA, as the scene says. Arguments must live as long as it. */
  template <int dim>
  std::unique_ptr<Integrator> make_heat_integrator(const Scene &scene, Heat<dim> &heat, Cost &cost);

  /** Heat, what advances it, and its books, see Problem::archive. */
  template <int dim>
  void archive_heat(
    Archive &archive, const State &state, Heat<dim> &heat, Integrator &integrator, HeatBalance<dim> &books);

  /** How the books integrate over a step of the scene's integrator. */
  template <int dim>
  typename HeatBalance<dim>::Rule bookkeeping_rule(const TimeSettings &settings);
} // namespace Cautery
