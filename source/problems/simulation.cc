// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/agreement.h>
#include <cautery/output/run_directory.h>
#include <cautery/problems/description.h>
#include <cautery/problems/simulation.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <filesystem>

namespace Cautery
{
  template <int dim>
  Simulation<dim>::Simulation(const Scene &scene, const MPI_Comm communicator)
    : scene(scene)
    , communicator(communicator)
    , forecast(scene.time.end, 1 + scene.output.output_times(scene.time.end).size())
  {
    cost.build("set-up: mesh", [&]() { body = std::make_unique<Body<dim>>(scene, communicator); });
    problem = make_problem(scene, *body, cost);
    adapt_to_first_step(scene, body, problem, cost);
    meshes = std::make_unique<MeshHistory<dim>>(scene, body->mesh);
    audience =
      cost.build("set-up: observers", [&]() { return std::make_unique<Audience<dim>>(scene, *body, cost); });
  }

  template <int dim>
  Forecast::Result Simulation<dim>::trial()
  {
    const TemporaryDirectory directory(communicator);
    State                    state = problem->start();
    Progress                 progress(communicator, false, scene.time.end);
    last_good = state;
    audience->write_to(directory.path());
    begin(directory.path(), state, progress);
    go(state, progress, true);
    const double memory = Utilities::MPI::sum(Cost::peak_memory(), communicator);
    return forecast.result() ? *forecast.result() : Forecast::Result{cost.wall_seconds(), memory, state.step};
  }

  template <int dim>
  RunRecord Simulation<dim>::run(const std::string &directory, const Voice voice, const bool resume_it)
  {
    // what may refuse the input comes first: nothing must have been written, or be lost
    State    state = problem->start();
    Progress progress(communicator, voice == Voice::speaks, scene.time.end);
    audience->write_to(directory);
    if (voice == Voice::speaks) // runs of a study are short, and end as it does
      safekeeper = std::make_unique<Safekeeper<dim>>(directory, scene, *body, *problem, cost);
    last_good    = state;
    bool stopped = false;
    if (resume_it) // until the state is there, nothing must be written for it
      resume(directory, state, progress);
    try
      {
        if (!resume_it)
          begin(directory, state, progress);
        stopped = !go(state, progress, false);
      }
    catch (const ExcRun &failure)
      {
        if (!all_processes_come(communicator))
          throw; // nothing more can be done together
        AssertThrow(false, ExcRun(end_failed(directory, failure, progress)));
      }
    const std::string message =
      stopped ? "stopped by a signal at t = " + to_text(state.time) + " s; " +
                  safekeeper->checkpoint().file_name() + " holds t = " + to_text(safekeeper->time()) +
                  " s: go on with `cautery " + directory + "/scene.prm --resume --output " + directory + "`" :
                "";
    RunRecord result = finish(state, directory, stopped ? "stopped" : "done", message, progress);
    AssertThrow(!stopped, ExcRun(message));
    if (safekeeper)
      safekeeper->checkpoint().remove();
    return result;
  }

  template <int dim>
  void Simulation<dim>::begin(const std::string &directory, State &state, Progress &progress)
  {
    {
      const auto scope = cost.measure("output: files");
      prepare_directory(directory, scene, communicator);
      progress.log_to(directory + "/log.txt");
      progress.say(description(scene, *body, *problem));
    }
    audience->follow(state);
    observe(state);
  }

  /// The mesh that the checkpoint's state is on.
  template <int dim>
  void Simulation<dim>::take_stored_mesh(State &state)
  {
    Adapted<dim> stored = adapt(scene, *body, safekeeper->checkpoint().cells(), cost);
    if (!stored.problem)
      return;
    state = stored.problem->start();
    use(std::move(stored));
  }

  template <int dim>
  void Simulation<dim>::resume(const std::string &directory, State &state, Progress &progress)
  {
    if (scene.mesh.adaptive.is_on())
      take_stored_mesh(state);
    progress.say(description(scene, *body, *problem)); // which the log has already
    progress.log_to(directory + "/log.txt");
    Archive stored = safekeeper->checkpoint().read();
    archive(stored, state, progress);
    safekeeper->resumed_at(state);
    last_good            = state;
    resumed_from         = state.time;
    resumed_step         = state.step;
    unsigned int to_come = 0;
    for (const double time : scene.output.output_times(scene.time.end))
      to_come += time > state.time ? 1 : 0;
    forecast.resume(to_come);
    progress.say("Resumed at t = " + to_short_text(state.time) + " s, step " + std::to_string(state.step) +
                 "\n");
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::error_code error;
        std::filesystem::remove(directory + "/summary.json", error); // of the run that has ended early
      }
  }

  /** All that the rest of the run depends on. The files come last: they are cut where all else fits. */
  template <int dim>
  void Simulation<dim>::archive(Archive &archive, State &state, Progress &progress)
  {
    archive.section("state", [&]() { state.archive(archive); });
    archive.section("meshes", [&]() { meshes->archive(archive, *problem); });
    archive.section("problem", [&]() { problem->archive(archive, state); });
    audience->archive(archive);
    archive.shared("last output", observed);
    written = observed;
    fail_together(communicator, [&]() {
      audience->archive_files(archive);
      progress.archive(state.time, archive);
    });
  }

  template <int dim>
  bool Simulation<dim>::go(State &state, Progress &progress, const bool only_trial)
  {
    const auto store = [&](Archive &stored) { archive(stored, state, progress); };
    for (const double time : scene.output.output_times(scene.time.end))
      {
        if (time <= state.time)
          continue; // before it resumed
        while (state.time < time)
          {
            if (safekeeper && safekeeper->look(state, store))
              return false;
            advance(state, meshes->stop_before(time), progress);
            adapt_mesh(state, progress);
            if (only_trial && forecast.result())
              return true;
          }
        observe(state);
        if (!scene.output.every_step)
          say_step(state, progress);
      }
    return true;
  }

  /// What is to be said of it.
  template <int dim>
  std::string
  Simulation<dim>::end_failed(const std::string &directory, const ExcRun &failure, Progress &progress)
  {
    std::string message = message_of(failure);
    try
      {
        observe_last_good();
        if (written == last_good.time)
          message += "; the last good state is that of t = " + to_short_text(last_good.time) + " s";
        message += observe_last_borne();
        finish(last_good, directory, "failed", message, progress);
      }
    catch (const ExcRun &)
      {
        // a full disk takes nothing more: the reason is told, and what was written before stands
      }
    return message;
  }

  template <int dim>
  void Simulation<dim>::say_step(const State &state, Progress &progress) const
  {
    progress.say(progress.line(state.time, state.step, audience->hottest_now()) + '\n');
  }

  /// All processes must agree on when enough is known.
  template <int dim>
  void Simulation<dim>::foretell(const double length, const double seconds, const double time)
  {
    forecast.add_step(length, Utilities::MPI::max(seconds, communicator));
    if (forecast.knows_enough())
      forecast.make(time,
                    Utilities::MPI::max(cost.wall_seconds(), communicator),
                    Utilities::MPI::sum(Cost::peak_memory(), communicator));
  }

  template <int dim>
  void Simulation<dim>::advance(State &state, const double stop, Progress &progress)
  {
    const Timer  timer;
    const double from = state.time;
    problem->step(state, stop);
    loop_seconds += timer.wall_time();
    if (!forecast.result())
      foretell(state.time - from, timer.wall_time(), state.time);
    AssertThrow(state.step <= scene.time.max_steps,
                ExcRun("Time/Largest number of steps = " + std::to_string(scene.time.max_steps) +
                       " was reached at t = " + to_short_text(state.time) +
                       " s; allow more, or larger steps"));
    AssertThrow(!scene.effects.has_heat() || std::isfinite(state.temperature.l1_norm()),
                ExcRun("the temperature is not finite at t = " + to_short_text(state.time) +
                       " s; take a smaller Time/Step"));
    {
      const auto scope = cost.measure("output: extremes, last good state");
      audience->follow(state);
      last_good = state;
    }
    if (scene.output.every_step)
      say_step(state, progress);
    else
      progress.show(state.time, state.step, audience->hottest_now());
  }

  /// If it is time.
  template <int dim>
  void Simulation<dim>::adapt_mesh(State &state, Progress &progress)
  {
    if (!meshes->is_due(state.time))
      return;
    Adapted<dim> next = adapt(scene, *body, *problem, state, cost);
    if (!next.problem)
      return;
    meshes->change(*problem, next.body->mesh);
    use(std::move(next));
    last_good = state;
    progress.say("t = " + to_short_text(state.time) +
                 " s  mesh adapted: " + std::to_string(body->mesh.n_cells()) + " cells\n");
  }

  template <int dim>
  void Simulation<dim>::use(Adapted<dim> next)
  {
    audience->use(*next.body);
    if (safekeeper)
      safekeeper->use(*next.body, *next.problem);
    problem = std::move(next.problem); // before the body that the old one stands on goes
    body    = std::move(next.body);
  }

  template <int dim>
  void Simulation<dim>::observe_last_good()
  {
    if (observed == last_good.time)
      return;
    try
      {
        observe(last_good);
      }
    catch (const ExcRun &)
      {
        // What an output adds to the state may fail as the step did: the outputs before it stand.
      }
  }

  /// What is to be said of it.
  template <int dim>
  std::string Simulation<dim>::observe_last_borne()
  {
    const BorneLoad *borne = problem->last_borne();
    if (borne == nullptr)
      return {};
    try
      {
        audience->look(*borne, *problem);
        return "; the last load that was borne is written as t = " + to_text(borne->state.time) + " s";
      }
    catch (const ExcRun &)
      {
        return {}; // as above
      }
  }

  template <int dim>
  void Simulation<dim>::observe(State &state)
  {
    observed = state.time;
    const Timer whole;
    {
      const Timer timer;
      problem->complete(state);
      if (state.step > 0)
        loop_seconds += timer.wall_time();
    }
    audience->look(state, *problem);
    written = state.time;
    forecast.add_output(whole.wall_time());
  }

  template <int dim>
  RunRecord Simulation<dim>::record(const State &state) const
  {
    RunRecord result;
    result.title        = scene.title;
    result.effects      = scene.effects;
    result.dimension    = dim;
    result.end_time     = state.time;
    result.resumed_from = resumed_from;
    result.unknowns     = problem->unknowns();
    result.time_steps   = state.step;
    result.steps_here   = state.step - resumed_step;
    result.balance      = problem->heat_totals(state);
    meshes->tell(*problem, result);
    audience->tell(result);
    result.wall_seconds      = cost.wall_seconds();
    result.processor_seconds = Utilities::MPI::max(cost.processor_seconds(), communicator);
    result.seconds_per_step  = result.steps_here > 0 ? loop_seconds / result.steps_here : 0.;
    result.seconds_by_part   = cost.seconds_by_part();
    result.seconds_by_effect = cost.seconds_by_effect();
    for (const auto &[effect, bytes] : cost.bytes_by_effect())
      result.bytes_by_effect[effect] = Utilities::MPI::sum(bytes, communicator);
    result.peak_memory = Utilities::MPI::sum(Cost::peak_memory(), communicator);
    result.forecast    = forecast.result();
    result.processes   = Utilities::MPI::n_mpi_processes(communicator);
    return result;
  }

  template <int dim>
  RunRecord Simulation<dim>::finish(const State       &state,
                                    const std::string &directory,
                                    const std::string &status,
                                    const std::string &message,
                                    Progress          &progress)
  {
    RunRecord result = record(state);
    result.status    = status;
    result.message   = message;
    fail_together(communicator, [&]() {
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
        result.write(directory + "/summary.json");
    });
    progress.say('\n' + result.text() + "Results        " + directory + '\n');
    return result;
  }

  template class Simulation<2>;
  template class Simulation<3>;

} // namespace Cautery
