// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/damage_history.h>
#include <cautery/problems/problem.h>
#include <cautery/time/central_difference.h>

namespace Cautery
{
  /**
   * Explicit dynamics, explicit heat, or both; or explicit dynamics with heat that another integrator finds.
   * @tparam Number the precision of the explicit loops.
   */
  template <typename Number>
  class ExplicitProblem : public Problem<3>
  {
  public:
    ExplicitProblem(const Scene &scene, const Body<3> &body, Cost &cost);

    State                              start() override;
    void                               go_on(State &state, Problem<3> &before, const State &last) override;
    void                               step(State &state, const double stop) override;
    std::optional<MechanicalFields<3>> mechanical_fields(const State &state) const override;
    const Field<3>                    *displacement() const override { return field.get(); }
    std::optional<Vector>              unbalanced_forces(const State &state) override;
    std::optional<HeatTotals>          heat_totals(const State &state) override;
    void                               archive(Archive &archive, const State &state) override;
    bool can_be_archived() const override { return !heat_integrator || heat_integrator->can_be_archived(); }
    void start_anew() override;
    std::map<std::string, types::global_dof_index> unknowns() const override;
    std::map<std::string, double>                  statistics() const override;
    std::map<std::string, TimeError>               time_errors() const override;

  private:
    void make_motion();
    void make_heat();
    void make_damage();

    const Scene   &scene;
    const Body<3> &body;
    Cost          &cost;

    TledNodes<Number> nodes;
    TledBody<Number>  cells;

    // of motion
    std::unique_ptr<Field<3>>               field;
    std::unique_ptr<Supports<3>>            supports;
    std::unique_ptr<OuterLoad<3>>           load;
    std::unique_ptr<ExplicitMotion<Number>> motion;
    std::unique_ptr<NodalGradients<3>>      gradients;
    std::unique_ptr<MechanicalRecovery<3>>  recovery;

    // of heat: explicit, or with matrices
    std::unique_ptr<ExplicitHeat<Number>> explicit_heat;
    std::unique_ptr<Heat<3>>              heat;
    std::unique_ptr<Integrator>           heat_integrator;
    std::unique_ptr<HeatBalance<3>>       books;

    std::unique_ptr<CentralDifference<Number>> central_difference;
    std::unique_ptr<DamageHistory<3>>          damage;
  };
} // namespace Cautery
