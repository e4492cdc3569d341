// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/problems/mechanical_problem.h>
#include <cautery/problems/thermal_problem.h>
#include <cautery/problems/thermomechanical_problem.h>
#include <cautery/time/coupled_backward_euler.h>
#include <cautery/time/ida_heat.h>

namespace Cautery
{
  namespace
  {
    bool every_step(const Scene &scene)
    {
      return scene.numerics.displacement_at == Numerics::DisplacementAt::every_step ||
             scene.effects.damage_needs_strain_energy();
    }
  } // namespace

  template <int dim>
  ThermomechanicalProblem<dim>::ThermomechanicalProblem(const Scene &scene, const Body<dim> &body, Cost &cost)
    : scene(scene)
    , body(body)
    , cost(cost)
    , field(cost.build("deformation: operators", [&]() { return Field<dim>(body.nodes, dim); }))
    , heat(cost.build(
        "heat: operators",
        [&]() { return Heat<dim>(scene, body.nodes, body.tissues, body.boundaries, body.locator); }))
    , statics(cost.build("deformation: operators", [&]() { return Statics<dim>(scene, body, field, cost); }))
    , displacement_at_every_step(every_step(scene))
    , gradients(
        cost.build("deformation: operators", [&]() { return NodalGradients<dim>(body.nodes, body.tissues); }))
    , recovery(scene, gradients, field, body.tissues)
  {
    make_integrator();
    if (scene.effects.has_damage())
      cost.build("damage: operators", [&]() {
        damage = std::make_unique<DamageHistory<dim>>(scene, body.nodes, body.tissues, &gradients, &recovery);
      });
  }

  template <int dim>
  void ThermomechanicalProblem<dim>::make_integrator()
  {
    if (scene.effects.coupling == Effects::Coupling::two_way)
      {
        cost.build("coupling: operators", [&]() {
          feedback = std::make_unique<ThermoelasticFeedback<dim>>(
            body.nodes, field, body.tissues, heat.relaxes(), scene.numerics.mean_dilatation);
        });
        integrator = std::make_unique<CoupledBackwardEuler<dim>>(
          scene.time, scene.numerics, heat, *statics.small, *statics.small->expansion(), *feedback, cost);
      }
    else if (scene.time.integrator == TimeSettings::Integrator::ida)
      integrator = std::make_unique<IdaHeat<dim>>(scene.time, heat, cost);
    else
      {
        std::vector<Balance *> balances = {&heat};
        if (scene.effects.deformation == Effects::Deformation::inertia)
          balances.push_back(statics.small.get());
        integrator = std::make_unique<BackwardEuler>(scene.time, scene.numerics, balances, cost);
      }
  }

  template <int dim>
  State ThermomechanicalProblem<dim>::start()
  {
    State state;
    cost.build("heat: start", [&]() { start_heat(scene, body.nodes, state); });
    state.displacement = field.vector();
    if (statics.small && statics.small->rate() != nullptr)
      state.displacement_rate = field.vector();
    // with inertia a body starts at rest and undeformed; without it, in equilibrium
    if (statics.equilibrium && (displacement_at_every_step || feedback))
      {
        statics.equilibrium->solve(state);
        solved_at = state.time;
      }
    if (damage)
      cost.build("damage: start", [&]() { damage->start(state); });
    cost.build("heat: balance", [&]() {
      books =
        std::make_unique<HeatBalance<dim>>(heat, feedback.get(), state, bookkeeping_rule<dim>(scene.time));
    });
    return state;
  }

  template <int dim>
  void ThermomechanicalProblem<dim>::go_on(State &state, Problem<dim> &before, const State &last)
  {
    auto &earlier = dynamic_cast<ThermomechanicalProblem &>(before);
    heat.loads().go_on(earlier.heat.loads());
    if (statics.equilibrium)
      state.displacement = 0.; // where Newton's method begins
    if (statics.equilibrium && (displacement_at_every_step || feedback))
      {
        statics.equilibrium->solve(state);
        solved_at = state.time;
      }
    books =
      std::make_unique<HeatBalance<dim>>(heat, feedback.get(), state, bookkeeping_rule<dim>(scene.time));
    books->go_on(*earlier.books, last, state);
    if (damage)
      damage->go_on(state);
  }

  template <int dim>
  void ThermomechanicalProblem<dim>::step(State &state, const double stop)
  {
    const double from = state.time;
    integrator->step(state, stop);
    {
      const auto scope = cost.measure("heat: balance");
      books->record({from, state.time}, state);
    }
    if (displacement_at_every_step)
      complete(state);
    if (damage)
      {
        const auto scope = cost.measure("damage: history");
        damage->advance(state.time - from, state);
      }
  }

  template <int dim>
  void ThermomechanicalProblem<dim>::complete(State &state)
  {
    const bool integrated = feedback || !statics.equilibrium;
    if (integrated || solved_at == state.time)
      return;
    statics.equilibrium->solve(state);
    solved_at = state.time;
  }

  template <int dim>
  std::optional<MechanicalFields<dim>>
  ThermomechanicalProblem<dim>::mechanical_fields(const State &state) const
  {
    return recovery.evaluate(state);
  }

  template <int dim>
  std::optional<Vector> ThermomechanicalProblem<dim>::unbalanced_forces(const State &state)
  {
    return statics.unbalanced_forces(state);
  }

  template <int dim>
  std::optional<HeatTotals> ThermomechanicalProblem<dim>::heat_totals(const State &state)
  {
    return books->totals(state);
  }

  template <int dim>
  void ThermomechanicalProblem<dim>::archive(Archive &archive, const State &state)
  {
    archive_heat(archive, state, heat, *integrator, *books);
    archive.shared("solved at", solved_at);
    if (statics.equilibrium)
      archive.section("equilibrium", [&]() { statics.equilibrium->archive(archive, state); });
    if (damage)
      damage->archive(archive);
  }

  template <int dim>
  std::map<std::string, types::global_dof_index> ThermomechanicalProblem<dim>::unknowns() const
  {
    std::map<std::string, types::global_dof_index> result = {{"temperature", body.nodes.n_unknowns()},
                                                             {"displacement", field.n_unknowns()}};
    if (heat.relaxes())
      result["temperature_rate"] = body.nodes.n_unknowns();
    if (statics.small && statics.small->rate() != nullptr)
      result["displacement_rate"] = field.n_unknowns();
    return result;
  }

  template <int dim>
  std::map<std::string, double> ThermomechanicalProblem<dim>::statistics() const
  {
    auto result = integrator->statistics();
    if (statics.equilibrium)
      result.merge(statics.equilibrium->statistics());
    return result;
  }

  template class ThermomechanicalProblem<2>;
  template class ThermomechanicalProblem<3>;
} // namespace Cautery
