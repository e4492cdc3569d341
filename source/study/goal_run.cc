// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/problems/run_scene.h>
#include <cautery/study/goal_run.h>
#include <cautery/study/study_progress.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <sstream>

namespace Cautery
{
  namespace
  {
    /// Shares of the error that is allowed: the rest is left for what the estimates do not see.
    constexpr double share_of_time  = 0.25;
    constexpr double share_of_space = 0.5;
    /// A mesh with more unknowns than this is not tried.
    constexpr types::global_dof_index most_unknowns = 2000000;

    using Changes = std::vector<Override>;

    /// Steps of IDA where it knows the scene's effects, else half of those before. Errors fall like 10^-level
    /// or 2^-level.
    class TimeLevels
    {
    public:
      TimeLevels(const Origin &origin, const Scene &scene) : step(scene.time.step), ida(true)
      {
        try
          {
            origin.scene(changes(0));
          }
        catch (const ExcInput &)
          {
            ida = false;
          }
      }

      Changes changes(const unsigned int level) const
      {
        if (!ida)
          return {{"Time/Step", to_text(step / std::pow(2., level))}};
        const int exponent = -3 - static_cast<int>(level);
        return {{"Time/Integrator", "IDA"},
                {"Time/Relative tolerance", to_text(std::pow(10., exponent))},
                {"Time/Absolute tolerance", to_text(std::pow(10., exponent + 1))}};
      }

      /// How much more wrong a level is than the next one that differs from it by @p distance.
      double error_of_finer(const double distance) const { return ida ? distance / 9. : distance; }

    private:
      const double step;
      bool         ida;
    };

    /// Boxes: half of the scene's subdivisions, then by half as many again; files: as they are, then refined.
    Changes mesh_changes(const Scene &scene, const unsigned int level)
    {
      if (scene.mesh.shape == MeshSettings::Shape::file)
        return {{"Mesh/Refinements", std::to_string(scene.mesh.refinements + level)}};
      std::vector<std::string> numbers;
      for (const double number : scene.mesh.subdivisions)
        numbers.push_back(to_text(std::max(2., std::round(0.5 * number * std::pow(1.5, level)))));
      return {{"Mesh/Subdivisions", join(numbers)}};
    }

    double mesh_ratio(const Scene &scene) { return scene.mesh.shape == MeshSettings::Shape::file ? 2. : 1.5; }

    std::vector<Quantity> judged_temperatures(const Scene &scene)
    {
      std::vector<Quantity> quantities;
      for (const auto &name : scene.output.probe_names)
        quantities.emplace_back(name + " temperature_K");
      if (quantities.empty())
        quantities.emplace_back("/extremes/temperature_max_K");
      return quantities;
    }

    /**
     * The trial runs, by levels of mesh and time.
     */
    class Search
    {
    public:
      Search(const Origin      &origin,
             const Scene       &scene,
             const std::string &directory,
             const MPI_Comm     communicator)
        : scene(scene)
        , quantities(judged_temperatures(scene))
        , times(origin, scene)
        , runner(origin, quantities, 1, directory + "/trials", communicator)
        , progress(0, Utilities::MPI::this_mpi_process(communicator) == 0)
      {
      }

      void find_time()
      {
        const double allowed = share_of_time * scene.accuracy.temperature_within;
        do
          {
            AssertThrow(time_level < 12, ExcRun(failure("steps")));
            ++time_level;
            time_error = times.error_of_finer(distance(run(0, time_level), run(0, time_level - 1)));
          }
        while (time_error > allowed);
      }

      void find_mesh()
      {
        const double allowed = share_of_space * scene.accuracy.temperature_within;
        double       before  = 0.;
        do
          {
            ++mesh_level;
            const double change = distance(run(mesh_level, time_level), run(mesh_level - 1, time_level));
            // the rate at which changes shrink gives the sum of those to come; from the second change on
            const double slowest = 1. / mesh_ratio(scene); // of a first order
            const double shrunk =
              before > 0. ? std::min(std::max(change / before, slowest * slowest), slowest) : slowest;
            mesh_error = change * shrunk / (1. - shrunk);
            before     = change;
          }
        while (mesh_error > allowed);
      }

      Changes changes() const { return changes(mesh_level, time_level); }

      std::string text() const
      {
        std::ostringstream out;
        out << "Temperature within " << scene.accuracy.temperature_within << " K: chose "
            << changes_text(changes()) << "\n               estimated errors: " << mesh_error
            << " K from the mesh, " << time_error << " K from the steps\n";
        return out.str();
      }

    private:
      Changes changes(const unsigned int mesh, const unsigned int time) const
      {
        Changes    all     = mesh_changes(scene, mesh);
        const auto of_time = times.changes(time);
        all.insert(all.end(), of_time.begin(), of_time.end());
        return all;
      }

      Outcome run(const unsigned int mesh, const unsigned int time)
      {
        const std::string name    = "mesh_" + std::to_string(mesh) + "_time_" + std::to_string(time);
        Outcome           outcome = runner.run(name, changes(mesh, time));
        if (outcome.is_new)
          progress.say(changes_text(changes(mesh, time)), outcome);
        AssertThrow(outcome.succeeded(), ExcRun("a trial run failed: " + outcome.message));
        AssertThrow(outcome.unknowns <= most_unknowns, ExcRun(failure("mesh")));
        return outcome;
      }

      double distance(const Outcome &a, const Outcome &b) const
      {
        double largest = 0.;
        for (unsigned int q = 0; q < quantities.size(); ++q)
          largest = std::max(largest, a.answers[q].distance(b.answers[q]));
        return largest;
      }

      std::string failure(const std::string &what) const
      {
        return "Accuracy/Temperature within = " + to_text(scene.accuracy.temperature_within) + " K: the " +
               what + " would become too fine; estimated so far: " + to_text(mesh_error) +
               " K from the mesh, " + to_text(time_error) +
               " K from the steps. Does a point source or a jump leave the temperature without a limit? "
               "Allow "
               "more, or spread the heat over a radius";
      }

      const Scene                &scene;
      const std::vector<Quantity> quantities;
      const TimeLevels            times;
      Runner                      runner;
      StudyProgress               progress;
      unsigned int                mesh_level = 0, time_level = 0;
      double                      mesh_error = 0., time_error = 0.; ///< K
    };
  } // namespace

  void run_to_goal(const Origin      &origin,
                   const Scene       &scene,
                   const std::string &directory,
                   const MPI_Comm     communicator)
  {
    const bool speaks = Utilities::MPI::this_mpi_process(communicator) == 0;
    AssertThrow(
      scene.effects.has_heat(),
      ExcInput("Accuracy/Temperature within: there is no temperature; turn Effects/Heat on or set 0"));
    if (speaks)
      std::cout << "Looking for a mesh and steps that keep temperatures within "
                << scene.accuracy.temperature_within << " K" << std::endl;
    Search search(origin, scene, directory, communicator);
    search.find_time();
    search.find_mesh();
    auto changes = search.changes();
    changes.push_back({"Accuracy/Temperature within", "0"});
    if (speaks)
      std::cout << search.text() << std::endl;
    run_scene(origin.scene(changes), communicator, directory, Voice::speaks);
    if (!speaks)
      return;
    std::ofstream file(directory + "/choice.txt");
    file << search.text() << std::flush;
    AssertThrow(file, ExcRun("cannot write into " + directory + ": is the disk full?"));
  }
} // namespace Cautery
