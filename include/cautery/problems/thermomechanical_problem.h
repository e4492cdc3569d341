// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/damage_history.h>
#include <cautery/problems/problem.h>
#include <cautery/problems/statics.h>
#include <cautery/time/integrator.h>

namespace Cautery
{
  /**
   * Heat and deformation, one way or two way coupled or not at all, and damage. Without inertia and feedback
   * the displacement has no history: it is solved for when an output or an effect asks.
   */
  template <int dim>
  class ThermomechanicalProblem : public Problem<dim>
  {
  public:
    ThermomechanicalProblem(const Scene &scene, const Body<dim> &body, Cost &cost);

    State            start() override;
    void             go_on(State &state, Problem<dim> &before, const State &last) override;
    void             step(State &state, const double stop) override;
    void             complete(State &state) override;
    const BorneLoad *last_borne() const override { return statics.last_borne(); }
    std::optional<MechanicalFields<dim>> mechanical_fields(const State &state) const override;
    const Field<dim>                    *displacement() const override { return &field; }
    std::optional<Vector>                unbalanced_forces(const State &state) override;
    std::optional<HeatTotals>            heat_totals(const State &state) override;
    void                                 archive(Archive &archive, const State &state) override;
    bool can_be_archived() const override { return integrator->can_be_archived(); }
    void start_anew() override { integrator->start_anew(); }
    std::map<std::string, types::global_dof_index> unknowns() const override;
    std::map<std::string, double>                  statistics() const override;
    std::map<std::string, TimeError> time_errors() const override { return integrator->time_errors(); }

  private:
    void make_integrator();

    const Scene                                &scene;
    const Body<dim>                            &body;
    Cost                                       &cost;
    Field<dim>                                  field;
    Heat<dim>                                   heat;
    Statics<dim>                                statics;
    const bool                                  displacement_at_every_step;
    std::unique_ptr<ThermoelasticFeedback<dim>> feedback;
    std::unique_ptr<Integrator>                 integrator;
    NodalGradients<dim>                         gradients;
    MechanicalRecovery<dim>                     recovery;
    std::unique_ptr<DamageHistory<dim>>         damage;
    std::unique_ptr<HeatBalance<dim>>           books;
    double                                      solved_at = -1.; ///< time of the displacement, s
  };
} // namespace Cautery
