// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/problems/mechanical_problem.h>
#include <cautery/time/backward_euler.h>

namespace Cautery
{
  template <int dim>
  MechanicalProblem<dim>::MechanicalProblem(const Scene &scene, const Body<dim> &body, Cost &cost)
    : scene(scene)
    , field(cost.build("deformation: operators", [&]() { return Field<dim>(body.nodes, dim); }))
    , statics(cost.build("deformation: operators", [&]() { return Statics<dim>(scene, body, field, cost); }))
    , gradients(
        cost.build("deformation: operators", [&]() { return NodalGradients<dim>(body.nodes, body.tissues); }))
    , recovery(scene, gradients, field, body.tissues)
  {
    if (scene.effects.deformation == Effects::Deformation::inertia)
      integrator = std::make_unique<BackwardEuler>(
        scene.time, scene.numerics, std::vector<Balance *>{statics.small.get()}, cost);
  }

  template <int dim>
  State MechanicalProblem<dim>::start()
  {
    State state;
    state.displacement = field.vector();
    if (integrator)
      state.displacement_rate = field.vector();
    return state;
  }

  template <int dim>
  void MechanicalProblem<dim>::go_on(State &state, Problem<dim> &, const State &)
  {
    if (integrator)
      return;
    state.displacement = 0.; // where Newton's method begins
    complete(state);
  }

  template <int dim>
  void MechanicalProblem<dim>::step(State &state, const double stop)
  {
    if (integrator)
      {
        integrator->step(state, stop);
        return;
      }
    // nothing remembers the past: only the displacement at outputs is asked for; found here, so that where
    // there is none the last output is the last good state
    state.time = stop;
    ++state.step;
    complete(state);
  }

  template <int dim>
  void MechanicalProblem<dim>::complete(State &state)
  {
    if (integrator || solved_at == state.time)
      return;
    statics.equilibrium->solve(state);
    solved_at = state.time;
  }

  template <int dim>
  std::optional<MechanicalFields<dim>> MechanicalProblem<dim>::mechanical_fields(const State &state) const
  {
    return recovery.evaluate(state);
  }

  template <int dim>
  std::optional<Vector> MechanicalProblem<dim>::unbalanced_forces(const State &state)
  {
    return statics.unbalanced_forces(state);
  }

  template <int dim>
  void MechanicalProblem<dim>::archive(Archive &archive, const State &state)
  {
    archive.shared("solved at", solved_at);
    if (integrator)
      integrator->archive(archive, state);
    if (statics.equilibrium)
      archive.section("equilibrium", [&]() { statics.equilibrium->archive(archive, state); });
  }

  template <int dim>
  std::map<std::string, types::global_dof_index> MechanicalProblem<dim>::unknowns() const
  {
    std::map<std::string, types::global_dof_index> result = {{"displacement", field.n_unknowns()}};
    if (integrator)
      result["displacement_rate"] = field.n_unknowns();
    return result;
  }

  template <int dim>
  std::map<std::string, double> MechanicalProblem<dim>::statistics() const
  {
    return integrator ? integrator->statistics() : statics.equilibrium->statistics();
  }

  template class MechanicalProblem<2>;
  template class MechanicalProblem<3>;
} // namespace Cautery
