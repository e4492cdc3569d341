// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/mechanical_fields.h>
#include <cautery/problems/problem.h>
#include <cautery/problems/statics.h>
#include <cautery/time/integrator.h>

namespace Cautery
{
  /**
   * Deformation without heat: in equilibrium with the loads of each output time, or with inertia.
   */
  template <int dim>
  class MechanicalProblem : public Problem<dim>
  {
  public:
    MechanicalProblem(const Scene &scene, const Body<dim> &body, Cost &cost);

    State            start() override;
    void             go_on(State &state, Problem<dim> &before, const State &last) override;
    void             step(State &state, const double stop) override;
    void             complete(State &state) override;
    const BorneLoad *last_borne() const override { return statics.last_borne(); }
    std::optional<MechanicalFields<dim>>           mechanical_fields(const State &state) const override;
    const Field<dim>                              *displacement() const override { return &field; }
    std::optional<Vector>                          unbalanced_forces(const State &state) override;
    void                                           archive(Archive &archive, const State &state) override;
    std::map<std::string, types::global_dof_index> unknowns() const override;
    std::map<std::string, double>                  statistics() const override;
    std::map<std::string, TimeError>               time_errors() const override
    {
      return integrator ? integrator->time_errors() : std::map<std::string, TimeError>();
    }

  private:
    const Scene                &scene;
    Field<dim>                  field;
    Statics<dim>                statics;
    std::unique_ptr<Integrator> integrator; ///< with inertia only
    NodalGradients<dim>         gradients;
    MechanicalRecovery<dim>     recovery;
    double                      solved_at = -1.; ///< time of the displacement, s
  };
} // namespace Cautery
