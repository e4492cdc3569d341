// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/problems/thermal_problem.h>
#include <cautery/time/backward_euler.h>
#include <cautery/time/ida_heat.h>

namespace Cautery
{
  template <int dim>
  void start_heat(const Scene &scene, const Field<dim> &nodes, State &state)
  {
    state.temperature   = initial_temperature(scene, nodes);
    const double lowest = state.temperature.min();
    AssertThrow(lowest >= 0.,
                ExcInput("Initial state/Temperature = " + scene.initial_temperature.text() +
                         ": it falls to " + to_short_text(lowest) +
                         " K in the body; temperatures are absolute, from 0 K on"));
    if (scene.effects.heat == Effects::Heat::non_fourier)
      state.temperature_rate = nodes.vector();
  }

  template <int dim>
  typename HeatBalance<dim>::Rule bookkeeping_rule(const TimeSettings &settings)
  {
    return settings.integrator == TimeSettings::Integrator::ida ? HeatBalance<dim>::Rule::trapezoid :
                                                                  HeatBalance<dim>::Rule::end_of_step;
  }

  template <int dim>
  std::unique_ptr<Integrator> make_heat_integrator(const Scene &scene, Heat<dim> &heat, Cost &cost)
  {
    if (scene.time.integrator == TimeSettings::Integrator::ida)
      return std::make_unique<IdaHeat<dim>>(scene.time, heat, cost);
    return std::make_unique<BackwardEuler>(scene.time, scene.numerics, std::vector<Balance *>{&heat}, cost);
  }

  template <int dim>
  ThermalProblem<dim>::ThermalProblem(const Scene &scene, const Body<dim> &body, Cost &cost)
    : scene(scene)
    , body(body)
    , cost(cost)
    , heat(cost.build(
        "heat: operators",
        [&]() { return Heat<dim>(scene, body.nodes, body.tissues, body.boundaries, body.locator); }))
    , integrator(make_heat_integrator(scene, heat, cost))
  {
    if (scene.effects.has_damage())
      cost.build("damage: operators", [&]() {
        if (scene.effects.damage == Effects::Damage::critical_thermal_load)
          gradients = std::make_unique<NodalGradients<dim>>(body.nodes, body.tissues);
        damage =
          std::make_unique<DamageHistory<dim>>(scene, body.nodes, body.tissues, gradients.get(), nullptr);
      });
  }

  template <int dim>
  State ThermalProblem<dim>::start()
  {
    State state;
    cost.build("heat: start", [&]() { start_heat(scene, body.nodes, state); });
    if (damage)
      cost.build("damage: start", [&]() { damage->start(state); });
    cost.build("heat: balance", [&]() {
      books = std::make_unique<HeatBalance<dim>>(heat, nullptr, state, bookkeeping_rule<dim>(scene.time));
    });
    return state;
  }

  template <int dim>
  void ThermalProblem<dim>::go_on(State &state, Problem<dim> &before, const State &last)
  {
    auto &earlier = dynamic_cast<ThermalProblem &>(before);
    heat.loads().go_on(earlier.heat.loads());
    books = std::make_unique<HeatBalance<dim>>(heat, nullptr, state, bookkeeping_rule<dim>(scene.time));
    books->go_on(*earlier.books, last, state);
    if (damage)
      damage->go_on(state);
  }

  template <int dim>
  void ThermalProblem<dim>::step(State &state, const double stop)
  {
    const double from = state.time;
    integrator->step(state, stop);
    {
      const auto scope = cost.measure("heat: balance");
      books->record({from, state.time}, state);
    }
    if (damage)
      {
        const auto scope = cost.measure("damage: history");
        damage->advance(state.time - from, state);
      }
  }

  template <int dim>
  std::optional<HeatTotals> ThermalProblem<dim>::heat_totals(const State &state)
  {
    return books->totals(state);
  }

  template <int dim>
  void archive_heat(
    Archive &archive, const State &state, Heat<dim> &heat, Integrator &integrator, HeatBalance<dim> &books)
  {
    archive.section("heat", [&]() { heat.archive(archive, state); });
    archive.section("integrator", [&]() { integrator.archive(archive, state); });
    archive.section("books", [&]() { books.archive(archive); });
  }

  template <int dim>
  void ThermalProblem<dim>::archive(Archive &archive, const State &state)
  {
    archive_heat(archive, state, heat, *integrator, *books);
    if (damage)
      damage->archive(archive);
  }

  template <int dim>
  std::map<std::string, types::global_dof_index> ThermalProblem<dim>::unknowns() const
  {
    std::map<std::string, types::global_dof_index> result = {{"temperature", body.nodes.n_unknowns()}};
    if (heat.relaxes())
      result["temperature_rate"] = body.nodes.n_unknowns();
    return result;
  }

  template void                        start_heat(const Scene &, const Field<2> &, State &);
  template void                        start_heat(const Scene &, const Field<3> &, State &);
  template std::unique_ptr<Integrator> make_heat_integrator(const Scene &, Heat<2> &, Cost &);
  template std::unique_ptr<Integrator> make_heat_integrator(const Scene &, Heat<3> &, Cost &);
  template void archive_heat(Archive &, const State &, Heat<2> &, Integrator &, HeatBalance<2> &);
  template void archive_heat(Archive &, const State &, Heat<3> &, Integrator &, HeatBalance<3> &);
  template HeatBalance<2>::Rule bookkeeping_rule<2>(const TimeSettings &);
  template HeatBalance<3>::Rule bookkeeping_rule<3>(const TimeSettings &);
  template class ThermalProblem<2>;
  template class ThermalProblem<3>;
} // namespace Cautery
