// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/problems/adaption.h>
#include <cautery/space/cell_changes.h>
#include <cautery/space/nodal_transfer.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace Cautery
{
  template <int dim>
  Adapted<dim>
  adapt(const Scene &scene, const Body<dim> &body, const std::vector<CellNumber> &cells, Cost &cost)
  {
    // Before anything is made: a distributed triangulation of deal.II that goes takes all vectors with it
    // that IDA has borrowed from deal.II, so none may go while the present problem is in use.
    const bool same =
      Utilities::MPI::broadcast(body.mesh.communicator(), cells == body.mesh.cells_of_all(), 0);
    if (same)
      return {};
    Adapted<dim> result;
    result.body = cost.build(
      "adaption: mesh", [&]() { return std::make_unique<Body<dim>>(scene, Mesh<dim>(body.mesh, cells)); });
    result.problem = make_problem(scene, *result.body, cost);
    return result;
  }

  namespace
  {
    template <int dim>
    std::vector<CellChange>
    changes_for(const Scene &scene, const Body<dim> &body, Problem<dim> &problem, State &state, Cost &cost)
    {
      const AdaptiveSettings &settings = scene.mesh.adaptive;
      if (settings.follows_displacement())
        problem.complete(state);
      const auto                 scope = cost.measure("adaption: indicator");
      std::vector<GradientError> errors;
      if (settings.follows_temperature())
        errors.push_back(gradient_error(body.nodes, body.tissues, body.nodes, state.temperature));
      if (settings.follows_displacement())
        errors.push_back(
          gradient_error(body.nodes, body.tissues, *problem.displacement(), state.displacement));
      std::vector<IndicatedError> indicated;
      for (const auto &error : errors)
        indicated.push_back({error.cells, error.gradient});
      return cell_changes(body.mesh, scene.numerics.degree, indicated, settings);
    }

    template <int dim>
    Adapted<dim>
    changed(const Scene &scene, const Body<dim> &body, Problem<dim> &problem, State &state, Cost &cost)
    {
      const auto changes = changes_for(scene, body, problem, state, cost);
      return changes.empty() ? Adapted<dim>() : adapt(scene, body, body.mesh.cells_of_all(changes), cost);
    }

    template <int dim>
    State carry(const State        &state,
                const Body<dim>    &body,
                const Problem<dim> &problem,
                const Adapted<dim> &next,
                Cost               &cost)
    {
      const auto               scope = cost.measure("adaption: transfer");
      const NodalTransfer<dim> transfer(body.nodes, next.body->nodes);
      State                    result;
      result.time = state.time;
      result.step = state.step;
      for (const auto vector : {&State::temperature, &State::temperature_rate, &State::ln_damage})
        if ((state.*vector).size() > 0)
          result.*vector = transfer(state.*vector, body.nodes, next.body->nodes);
      for (const auto vector : {&State::displacement, &State::displacement_rate})
        if ((state.*vector).size() > 0)
          result.*vector = transfer(state.*vector, *problem.displacement(), *next.problem->displacement());
      return result;
    }
  } // namespace

  template <int dim>
  void adapt_to_first_step(const Scene                   &scene,
                           std::unique_ptr<Body<dim>>    &body,
                           std::unique_ptr<Problem<dim>> &problem,
                           Cost                          &cost)
  {
    if (!scene.mesh.adaptive.is_on())
      return;
    const double first = std::min(scene.time.step, scene.time.end);
    // a cell is divided once in a round, and not all of them in the first
    for (unsigned int round = 0; round < 4 * scene.mesh.adaptive.max_divisions; ++round)
      {
        State state = problem->start();
        while (state.time < first)
          problem->step(state, first);
        Adapted<dim> next = changed(scene, *body, *problem, state, cost);
        if (!next.problem)
          break;
        problem = std::move(next.problem); // before the body that the old one stands on goes
        body    = std::move(next.body);
      }
    // the trial has left its traces in this one
    problem.reset();
    problem = make_problem(scene, *body, cost);
  }

  template <int dim>
  Adapted<dim>
  adapt(const Scene &scene, const Body<dim> &body, Problem<dim> &problem, State &state, Cost &cost)
  {
    Adapted<dim> next = changed(scene, body, problem, state, cost);
    if (!next.problem)
      return {};
    State start = carry(state, body, problem, next, cost);
    next.problem->go_on(start, problem, state);
    state = start;
    return next;
  }

  template void
  adapt_to_first_step(const Scene &, std::unique_ptr<Body<2>> &, std::unique_ptr<Problem<2>> &, Cost &);
  template void
  adapt_to_first_step(const Scene &, std::unique_ptr<Body<3>> &, std::unique_ptr<Problem<3>> &, Cost &);
  template Adapted<2> adapt(const Scene &, const Body<2> &, Problem<2> &, State &, Cost &);
  template Adapted<3> adapt(const Scene &, const Body<3> &, Problem<3> &, State &, Cost &);
  template Adapted<2> adapt(const Scene &, const Body<2> &, const std::vector<CellNumber> &, Cost &);
  template Adapted<3> adapt(const Scene &, const Body<3> &, const std::vector<CellNumber> &, Cost &);
} // namespace Cautery
