// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/problems/explicit_problem.h>
#include <cautery/problems/thermal_problem.h>

namespace Cautery
{
  template <typename Number>
  ExplicitProblem<Number>::ExplicitProblem(const Scene &scene, const Body<3> &body, Cost &cost)
    : scene(scene)
    , body(body)
    , cost(cost)
    , nodes(body.nodes)
    , cells(cost.build("set-up: packed cells",
                       [&]() { return TledBody<Number>(scene, body.nodes, body.tissues, nodes); }))
  {
    if (scene.effects.has_deformation())
      cost.build("deformation: operators", [&]() { make_motion(); });
    if (scene.effects.has_heat())
      cost.build("heat: operators", [&]() { make_heat(); });
    cost.build("set-up: explicit steps", [&]() {
      central_difference = std::make_unique<CentralDifference<Number>>(
        scene, body.nodes, cells, nodes, motion.get(), explicit_heat.get(), cost);
    });
    if (scene.effects.has_damage())
      cost.build("damage: operators", [&]() { make_damage(); });
  }

  template <typename Number>
  void ExplicitProblem<Number>::make_motion()
  {
    field    = std::make_unique<Field<3>>(body.nodes, 3);
    supports = std::make_unique<Supports<3>>(scene, *field, body.boundaries);
    load =
      std::make_unique<OuterLoad<3>>(scene, *field, body.nodes, body.tissues, body.boundaries, body.locator);
    motion    = std::make_unique<ExplicitMotion<Number>>(cells, nodes, *supports, *load);
    gradients = std::make_unique<NodalGradients<3>>(body.nodes, body.tissues);
    recovery  = std::make_unique<MechanicalRecovery<3>>(scene, *gradients, *field, body.tissues);
  }

  template <typename Number>
  void ExplicitProblem<Number>::make_heat()
  {
    if (scene.time.integrator == TimeSettings::Integrator::explicit_steps)
      {
        explicit_heat = std::make_unique<ExplicitHeat<Number>>(
          scene, body.nodes, body.tissues, body.boundaries, body.locator, cells, nodes);
        return;
      }
    heat = std::make_unique<Heat<3>>(scene, body.nodes, body.tissues, body.boundaries, body.locator);
    heat_integrator = make_heat_integrator(scene, *heat, cost);
  }

  template <typename Number>
  void ExplicitProblem<Number>::make_damage()
  {
    if (!gradients && scene.effects.damage == Effects::Damage::critical_thermal_load)
      gradients = std::make_unique<NodalGradients<3>>(body.nodes, body.tissues);
    damage =
      std::make_unique<DamageHistory<3>>(scene, body.nodes, body.tissues, gradients.get(), recovery.get());
  }

  template <typename Number>
  State ExplicitProblem<Number>::start()
  {
    State state;
    if (scene.effects.has_heat())
      cost.build("heat: start", [&]() { start_heat(scene, body.nodes, state); });
    if (field)
      state.displacement = field->vector();
    if (damage)
      cost.build("damage: start", [&]() { damage->start(state); });
    if (heat)
      cost.build("heat: balance", [&]() {
        books = std::make_unique<HeatBalance<3>>(*heat, nullptr, state, bookkeeping_rule<3>(scene.time));
      });
    central_difference->start(state);
    return state;
  }

  template <typename Number>
  void ExplicitProblem<Number>::go_on(State &, Problem<3> &, const State &)
  {
    Assert(false, ExcMessage("Explicit steps do not know hanging nodes; scenes with both are refused."));
  }

  template <typename Number>
  void ExplicitProblem<Number>::step(State &state, const double stop)
  {
    const double from = state.time;
    if (heat)
      {
        heat_integrator->step(state, stop);
        {
          const auto scope = cost.measure("heat: balance");
          books->record({from, state.time}, state);
        }
        central_difference->follow({from, state.time}, state);
      }
    else
      central_difference->step(state, stop);
    if (damage)
      {
        const auto scope = cost.measure("damage: history");
        damage->advance(state.time - from, state);
      }
  }

  template <typename Number>
  std::optional<MechanicalFields<3>> ExplicitProblem<Number>::mechanical_fields(const State &state) const
  {
    if (!recovery)
      return {};
    return recovery->evaluate(state);
  }

  template <typename Number>
  std::optional<Vector> ExplicitProblem<Number>::unbalanced_forces(const State &state)
  {
    if (!field)
      return {};
    return Cautery::unbalanced_forces(cells, nodes, *load, *field, state);
  }

  template <typename Number>
  std::optional<HeatTotals> ExplicitProblem<Number>::heat_totals(const State &state)
  {
    if (explicit_heat)
      return explicit_heat->totals(state);
    if (books)
      return books->totals(state);
    return {};
  }

  template <typename Number>
  void ExplicitProblem<Number>::archive(Archive &archive, const State &state)
  {
    if (heat)
      archive_heat(archive, state, *heat, *heat_integrator, *books);
    archive.section("explicit loop", [&]() { central_difference->archive(archive, state); });
    if (damage)
      damage->archive(archive);
  }

  template <typename Number>
  void ExplicitProblem<Number>::start_anew()
  {
    if (heat_integrator)
      heat_integrator->start_anew();
  }

  template <typename Number>
  std::map<std::string, types::global_dof_index> ExplicitProblem<Number>::unknowns() const
  {
    std::map<std::string, types::global_dof_index> result;
    if (scene.effects.has_heat())
      result["temperature"] = body.nodes.n_unknowns();
    if (scene.effects.heat == Effects::Heat::non_fourier)
      result["temperature_rate"] = body.nodes.n_unknowns();
    if (field)
      result["displacement"] = result["displacement_rate"] = field->n_unknowns();
    return result;
  }

  template <typename Number>
  std::map<std::string, double> ExplicitProblem<Number>::statistics() const
  {
    auto result = central_difference->statistics();
    if (heat_integrator)
      result.merge(heat_integrator->statistics());
    return result;
  }

  template <typename Number>
  std::map<std::string, TimeError> ExplicitProblem<Number>::time_errors() const
  {
    return heat_integrator ? heat_integrator->time_errors() : std::map<std::string, TimeError>();
  }

  template class ExplicitProblem<float>;
  template class ExplicitProblem<double>;
} // namespace Cautery
