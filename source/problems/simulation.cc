// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/agreement.h>
#include <cautery/output/fields.h>
#include <cautery/output/reactions.h>
#include <cautery/problems/adaption.h>
#include <cautery/problems/simulation.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <regex>
#include <sstream>
#include <utility>

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
    adaption.most_cells = adaption.last_cells = body->mesh.n_cells();
    next_adaption                             = scene.mesh.adaptive.interval;
    cost.build("set-up: observers", [&]() {
      probes = std::make_unique<Probes<dim>>(scene.output.probes(), body->locator, body->nodes);
      if (scene.effects.has_damage())
        ablation = std::make_unique<AblationZone<dim>>(scene.output.ablation_centre, body->nodes);
    });
  }

  template <int dim>
  std::string Simulation<dim>::description() const
  {
    std::ostringstream out;
    const auto        &mesh = body->mesh;
    if (!scene.title.empty())
      out << scene.title << "\n\n";
    const bool from_file = scene.mesh.shape == MeshSettings::Shape::file;
    out << "Effects on     " << join(scene.effects.on(), ", ") << '\n'
        << "Effects off    " << join(scene.effects.off(), ", ") << '\n'
        << "Mesh           "
        << (from_file ? std::filesystem::path(scene.mesh.file_name).filename().string() : "box") << ": "
        << mesh.n_cells() << ' '
        << (mesh.simplices() ? (dim == 3 ? "tetrahedra" : "triangles") :
                               (dim == 3 ? "hexahedra" : "quadrilaterals"))
        << ", " << mesh.n_vertices() << " nodes, " << mesh.volume() << (dim == 3 ? " m3" : " m2") << '\n';
    for (const auto &note : mesh.notes())
      out << "               note: " << note << '\n';
    out << "Unknowns      ";
    std::string comma;
    for (const auto &[name, number] : problem->unknowns())
      out << std::exchange(comma, ",") << ' ' << number << ' ' << name;
    out << '\n' << "Time           " << scene.time.end << " s, ";
    if (scene.time.integrator == TimeSettings::Integrator::ida)
      out << "steps chosen by IDA";
    else
      out << std::ceil(scene.time.end / scene.time.step * (1. - 1e-12)) << " steps of " << scene.time.step
          << " s";
    out << ", " << scene.output.output_times(scene.time.end).size() << " output times\n"
        << "Memory         " << std::fixed << std::setprecision(0)
        << 1e-6 * Utilities::MPI::max(Cost::peak_memory(), communicator)
        << " MB a process before the first step\n\n";
    return out.str();
  }

  namespace
  {
    void remove_results(const std::string &directory)
    {
      const std::regex results(
        "(summary\\.json|probes\\.csv|reactions\\.csv|log\\.txt|solution\\.pvd|checkpoint\\.h5|"
        "solution_[0-9]+(\\.[0-9]+)?\\.p?vtu)(\\.part)?");
      std::error_code error;
      for (const auto &entry : std::filesystem::directory_iterator(directory, error))
        if (std::regex_match(entry.path().filename().string(), results))
          std::filesystem::remove(entry.path(), error);
    }
  } // namespace

  template <int dim>
  void Simulation<dim>::prepare_directory(const std::string &directory) const
  {
    bool written = false;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::error_code error;
        std::filesystem::create_directories(directory, error);
        remove_results(directory); // an earlier run's are not true any more
        std::ofstream complete(directory + "/scene.prm");
        complete << scene.complete_text << std::flush;
        written = complete.good();
      }
    AssertThrow(
      Utilities::MPI::broadcast(communicator, written, 0),
      ExcInput("the output directory `" + directory + "` cannot be written; give another one with --output"));
  }

  template <int dim>
  Forecast::Result Simulation<dim>::trial()
  {
    const bool  makes = Utilities::MPI::this_mpi_process(communicator) == 0;
    std::string directory;
    if (makes)
      {
        directory = (std::filesystem::temp_directory_path() / "cautery-XXXXXX").string();
        if (mkdtemp(directory.data()) == nullptr)
          directory.clear();
      }
    directory = Utilities::MPI::broadcast(communicator, directory, 0);
    AssertThrow(!directory.empty(),
                ExcInput("no temporary directory for the trial can be made; set TMPDIR to one that can be "
                         "written"));
    // whatever happens, nothing of it stays
    const auto remove = [makes](const std::string *path) {
      std::error_code error;
      if (makes)
        std::filesystem::remove_all(*path, error);
    };
    const std::unique_ptr<const std::string, decltype(remove)> removal(&directory, remove);
    State                                                      state = problem->start();
    Progress                                                   progress(communicator, false, scene.time.end);
    last_good = state;
    make_outputs(directory);
    begin(directory, state, progress);
    go(state, progress, true);
    const double memory = Utilities::MPI::sum(Cost::peak_memory(), communicator);
    return forecast.result() ? *forecast.result() : Forecast::Result{cost.wall_seconds(), memory, state.step};
  }

  template <int dim>
  RunRecord Simulation<dim>::run(const std::string &directory, const Voice voice, const bool resume_it)
  {
    State    state = problem->start(); // which may refuse the input: nothing must have been written
    Progress progress(communicator, voice == Voice::speaks, scene.time.end);
    last_good = state;
    make_outputs(directory);
    const bool adapts = scene.mesh.adaptive.is_on();
    AssertThrow(
      !resume_it || !adapts,
      ExcInput("--resume: a run with Mesh/Adaptive on keeps no checkpoint; run it anew, or with one mesh"));
    // runs of a study are short, and end as it does; a checkpoint holds no mesh
    if (voice == Voice::speaks && !adapts)
      safekeeper = std::make_unique<Safekeeper<dim>>(directory, scene, *body, *problem, cost);
    bool stopped = false;
    try
      {
        if (resume_it)
          resume(directory, state, progress);
        else
          begin(directory, state, progress);
        stopped = !go(state, progress, false);
      }
    catch (const ExcRun &failure)
      {
        if (!all_processes_come(communicator))
          throw; // nothing more can be done together
        end_failed(directory, failure, progress);
        throw;
      }
    const std::string message =
      stopped ? "stopped by a signal at t = " + to_text(state.time) + " s; " +
                  safekeeper->checkpoint().file_name() + " holds t = " + to_text(safekeeper->time()) +
                  " s: go on with `cautery " + directory + "/scene.prm --resume --output " + directory + "`" :
                "";
    const RunRecord result = finish(state, directory, stopped ? "stopped" : "done", message, progress);
    AssertThrow(!stopped, ExcRun(message));
    if (safekeeper)
      safekeeper->checkpoint().remove();
    return result;
  }

  template <int dim>
  void Simulation<dim>::make_outputs(const std::string &directory)
  {
    const bool writes = Utilities::MPI::this_mpi_process(communicator) == 0;
    if (writes)
      probes->write_to(directory + "/probes.csv");
    if (scene.output.reactions)
      {
        auto reactions = std::make_unique<Reactions<dim>>(scene, body->nodes, body->boundaries);
        if (writes)
          reactions->write_to(directory + "/reactions.csv");
        others.push_back(std::move(reactions));
      }
    if (scene.output.fields)
      others.push_back(std::make_unique<Fields<dim>>(directory, writes));
  }

  template <int dim>
  void Simulation<dim>::begin(const std::string &directory, State &state, Progress &progress)
  {
    {
      const auto scope = cost.measure("output: files");
      prepare_directory(directory);
      progress.log_to(directory + "/log.txt");
      progress.say(description());
    }
    extremes.observe(state, dim);
    observe(state);
  }

  template <int dim>
  void Simulation<dim>::resume(const std::string &directory, State &state, Progress &progress)
  {
    progress.say(description()); // which the log has already
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
    progress.say("Resumed at t = " + to_text(state.time) + " s, step " + std::to_string(state.step) + "\n");
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
    archive.section("problem", [&]() { problem->archive(archive, state); });
    Extremes so_far = extremes.reduced(communicator);
    archive.section("extremes", [&]() { so_far.archive(archive); });
    extremes = so_far;
    archive.section("errors in space", [&]() {
      const auto field = [&](const std::string &name) {
        archive.shared(name + ", last", space_errors[name].last);
        archive.shared(name + ", largest", space_errors[name].largest);
      };
      if (scene.effects.has_heat())
        field("temperature");
      if (scene.effects.has_deformation())
        field("displacement");
    });
    archive.shared("last output", observed);
    fail_together(communicator, [&]() {
      probes->archive(archive);
      for (auto &observer : others)
        observer->archive(archive);
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
            advance(state, stop_before(time), progress);
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

  template <int dim>
  void Simulation<dim>::end_failed(const std::string &directory, const ExcRun &failure, Progress &progress)
  {
    std::ostringstream reason;
    failure.print_info(reason);
    try
      {
        observe_last_good();
        finish(last_good, directory, "failed", reason.str(), progress);
      }
    catch (const ExcRun &)
      {
        // a full disk takes nothing more: the reason is told, and what was written before stands
      }
  }

  template <int dim>
  void Simulation<dim>::say_step(const State &state, Progress &progress) const
  {
    progress.say(progress.line(state.time, state.step, extremes.reduced(communicator).hottest_now) + '\n');
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
                       " was reached at t = " + to_text(state.time) + " s; allow more, or larger steps"));
    AssertThrow(
      !scene.effects.has_heat() || std::isfinite(state.temperature.l1_norm()),
      ExcRun("the temperature is not finite at t = " + to_text(state.time) + " s; take a smaller Time/Step"));
    {
      const auto scope = cost.measure("output: extremes, last good state");
      extremes.observe(state, dim);
      last_good = state;
    }
    if (scene.output.every_step)
      say_step(state, progress);
    else
      progress.show(state.time, state.step, extremes.reduced(communicator).hottest_now);
  }

  namespace
  {
    /// Relative: times that are the same but for rounding.
    constexpr double same_time = 1e-12;
  } // namespace

  /// @p time, or when the mesh is adapted before; s.
  template <int dim>
  double Simulation<dim>::stop_before(const double time) const
  {
    const AdaptiveSettings &settings = scene.mesh.adaptive;
    const bool before = settings.is_on() && settings.interval > 0. && next_adaption < time * (1. - same_time);
    return before ? next_adaption : time;
  }

  /// If it is time.
  template <int dim>
  void Simulation<dim>::adapt_mesh(State &state, Progress &progress)
  {
    const AdaptiveSettings &settings = scene.mesh.adaptive;
    if (!settings.is_on() || settings.interval == 0. || state.time < next_adaption * (1. - same_time) ||
        state.time >= scene.time.end)
      return;
    next_adaption += settings.interval;
    Adapted<dim> next = adapt(scene, *body, *problem, state, cost);
    if (!next.problem)
      return;
    for (const auto &[name, count] : problem->statistics())
      past_statistics[name] += count;
    for (const auto &[name, error] : problem->time_errors())
      past_time_errors[name] += error;
    for (auto *observer : observers())
      observer->use_mesh(next.body->nodes, next.body->locator, next.body->boundaries);
    problem   = std::move(next.problem); // before the body that the old one stands on goes
    body      = std::move(next.body);
    last_good = state;
    ++adaption.times;
    adaption.last_cells = body->mesh.n_cells();
    adaption.most_cells = std::max(adaption.most_cells, adaption.last_cells);
    progress.say("t = " + to_text(state.time) + " s  mesh adapted: " + std::to_string(adaption.last_cells) +
                 " cells\n");
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
    extremes.observe(state, dim);
    std::optional<MechanicalFields<dim>> mechanical;
    if (problem->displacement() != nullptr)
      {
        const auto scope = cost.measure("deformation: strain and stress");
        mechanical       = problem->mechanical_fields(state);
      }
    std::optional<Vector> unbalanced;
    if (scene.output.reactions)
      {
        const auto scope = cost.measure("deformation: reactions");
        unbalanced       = problem->unbalanced_forces(state);
      }
    std::optional<GradientErrors> errors; // as dear as a step or two: where it is seen only
    if (scene.output.fields || state.time >= scene.time.end)
      {
        const auto scope = cost.measure("output: error indicator");
        errors           = gradient_errors(body->nodes, body->tissues, problem->displacement(), state);
        Cautery::observe(*errors, space_errors);
      }
    const Snapshot<dim> snapshot{state,
                                 body->nodes,
                                 problem->displacement(),
                                 mechanical ? &*mechanical : nullptr,
                                 unbalanced ? &*unbalanced : nullptr,
                                 errors ? &*errors : nullptr};
    const auto          look = [&](Observer<dim> &observer) {
      const auto scope = cost.measure(observer.name());
      observer.observe(snapshot);
    };
    for (auto *observer : observers())
      look(*observer);
    forecast.add_output(whole.wall_time());
  }

  template <int dim>
  std::vector<Observer<dim> *> Simulation<dim>::observers() const
  {
    std::vector<Observer<dim> *> result = {probes.get()};
    if (ablation)
      result.push_back(ablation.get());
    for (const auto &observer : others)
      result.push_back(observer.get());
    return result;
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
    result.statistics   = past_statistics;
    for (const auto &[name, count] : problem->statistics())
      result.statistics[name] += count;
    result.extremes    = extremes.reduced(communicator);
    result.balance     = problem->heat_totals(state);
    result.time_errors = past_time_errors;
    for (const auto &[name, error] : problem->time_errors())
      result.time_errors[name] += error;
    if (scene.mesh.adaptive.is_on())
      result.adaption = adaption;
    result.space_errors = space_errors;
    if (ablation)
      {
        RunRecord::Ablation zone;
        zone.volume = ablation->volume();
        zone.radius = ablation->radius();
        zone.centre = scene.output.ablation_centre;
        for (const auto &[id, volume] : ablation->volumes())
          zone.regions[std::to_string(id)] = {
            body->mesh.regions().at(id), volume, volume / body->mesh.volumes().at(id)};
        result.ablation = zone;
      }
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

  RunRecord run_scene(const Scene       &scene,
                      const MPI_Comm     communicator,
                      const std::string &directory,
                      const Voice        voice,
                      const bool         resume)
  {
    if (scene.dimension == 2)
      return Simulation<2>(scene, communicator).run(directory, voice, resume);
    return Simulation<3>(scene, communicator).run(directory, voice, resume);
  }

  namespace
  {
    template <int dim>
    std::string checked(const Scene &scene, const MPI_Comm communicator)
    {
      Simulation<dim>    simulation(scene, communicator);
      std::ostringstream out;
      out << simulation.description();
      const auto forecast = simulation.trial();
      out << std::setprecision(3) << "Forecast       about " << forecast.seconds << " s and " << std::fixed
          << std::setprecision(0) << 1e-6 * forecast.bytes << " MB, from a trial of the first "
          << forecast.after_steps << (forecast.after_steps == 1 ? " step" : " steps")
          << "\nThe scene is complete and consistent.\n";
      return out.str();
    }
  } // namespace

  std::string checked_scene(const Scene &scene, const MPI_Comm communicator)
  {
    return scene.dimension == 2 ? checked<2>(scene, communicator) : checked<3>(scene, communicator);
  }
} // namespace Cautery
