// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/cost.h>
#include <cautery/base/version.h>
#include <cautery/problems/run_scene.h>
#include <cautery/study/outcome.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace Cautery
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    /// Written last, and in one go: a folder that has it is finished.
    const std::string finished = "/outcome.json";

    /// A run so short may be made once more.
    constexpr double negligible = 0.5; // s
    /// The processor's clock may not see less, s.
    constexpr double shortest = 1e-3;

    std::string content(const std::string &file_name)
    {
      std::ifstream file(file_name);
      return std::string(std::istreambuf_iterator<char>(file), {});
    }
  } // namespace

  void require_answers(const std::vector<Quantity> &quantities,
                       const Outcome               &outcome,
                       const std::string           &directory)
  {
    for (unsigned int q = 0; q < quantities.size(); ++q)
      AssertThrow(
        !outcome.answers[q].values.empty(),
        ExcInput("Accuracy/Quantities: there is no `" + quantities[q].text() +
                 "` in probes.csv or summary.json below " + directory +
                 "/runs/scene; a probe's is `PROBE COLUMN` or `PROBE COLUMN at TIME`, a number of the "
                 "summary its path"));
  }

  Runner::Runner(const Origin                &origin,
                 const std::vector<Quantity> &quantities,
                 const unsigned int           repeats,
                 const std::string           &directory,
                 const MPI_Comm               communicator)
    : origin(origin)
    , quantities(quantities)
    , repeats(repeats)
    , directory(directory)
    , communicator(communicator)
  {
  }

  Scene Runner::scene_of(const std::vector<Override> &changes) const
  {
    auto all = changes;
    // pictures are not what a study compares, and the mesh and steps are the study's to choose
    all.push_back({"Output/Fields", "off"});
    all.push_back({"Accuracy/Temperature within", "0"});
    return origin.scene(all);
  }

  bool Runner::is_finished(const std::string &folder, const Scene &scene) const
  {
    bool found = false;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        found =
          content(folder + "/scene.prm") == scene.complete_text && std::filesystem::exists(folder + finished);
        if (found)
          {
            const auto outcome = Json::parse(content(folder + finished), nullptr, false);
            found              = !outcome.is_discarded() && outcome.at("version") == version &&
                    (outcome.contains("refused") || outcome.at("seconds").size() >= repeats) &&
                    outcome.at("processes") == Utilities::MPI::n_mpi_processes(communicator);
          }
      }
    return Utilities::MPI::broadcast(communicator, found, 0);
  }

  void Runner::carry_out(const Scene &scene, const std::string &folder)
  {
    Json       outcome = {{"version", version},
                          {"processes", Utilities::MPI::n_mpi_processes(communicator)},
                          {"seconds", Json::array()}};
    const auto run     = [&]() {
      Cost::forget_peak_memory();
      try
        {
          const double seconds = run_scene(scene, communicator, folder, Voice::silent).processor_seconds;
          return std::max(shortest, seconds);
        }
      catch (const ExcRun &)
        {
          return 0.; // summary.json has the reason
        }
    };
    try
      {
        // the first run of a process pays for what the others find in memory
        double seconds = run();
        if (!is_warm && seconds < negligible)
          seconds = run();
        is_warm = true;
        outcome["seconds"].push_back(seconds);
        for (unsigned int i = 1; i < repeats; ++i)
          outcome["seconds"].push_back(run());
      }
    catch (const ExcInput &exception)
      {
        outcome["refused"] = message_of(exception);
      }
    if (Utilities::MPI::this_mpi_process(communicator) != 0)
      return;
    {
      std::filesystem::create_directories(folder); // a run that was refused has made none
      std::ofstream(folder + "/scene.prm") << scene.complete_text;
      std::ofstream file(folder + finished + ".part");
      file << outcome.dump(2) << '\n';
      AssertThrow(file, ExcRun("cannot write into " + folder + ": is the disk full?"));
    }
    std::filesystem::rename(folder + finished + ".part", folder + finished);
  }

  Outcome Runner::read(const std::string &folder) const
  {
    Outcome    outcome;
    const Json cost = Json::parse(content(folder + finished));
    if (cost.contains("refused"))
      {
        outcome.message = cost.at("refused").get<std::string>();
        return outcome;
      }
    const Json summary = Json::parse(content(folder + "/summary.json"));
    outcome.message    = summary.at("message").get<std::string>();
    auto seconds       = cost.at("seconds").get<std::vector<double>>();
    std::nth_element(seconds.begin(), seconds.begin() + seconds.size() / 2, seconds.end());
    outcome.seconds = seconds[seconds.size() / 2];
    outcome.bytes   = summary.at("cost").at("peak_memory_bytes").get<double>();
    outcome.steps   = summary.at("time_steps").get<unsigned int>();
    for (const auto &number : summary.at("unknowns"))
      outcome.unknowns += number.get<types::global_dof_index>();
    if (outcome.succeeded())
      for (const auto &quantity : quantities)
        outcome.answers.push_back(quantity.read(folder));
    return outcome;
  }

  Outcome Runner::run(const std::string &name, const std::vector<Override> &changes)
  {
    const Scene scene           = scene_of(changes);
    const auto [place, unknown] = folders.emplace(scene.complete_text, directory + "/" + name);
    const std::string &folder   = place->second;
    const bool         is_new   = unknown && !is_finished(folder, scene);
    if (is_new)
      {
        if (Utilities::MPI::this_mpi_process(communicator) == 0)
          std::filesystem::remove(folder + finished);
        carry_out(scene, folder);
        MPI_Barrier(communicator);
      }
    Outcome outcome = read(folder); // by every process: small files, already closed
    outcome.is_new  = is_new;
    return outcome;
  }
} // namespace Cautery
