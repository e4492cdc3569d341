// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/agreement.h>
#include <cautery/base/version.h>
#include <cautery/problems/run_scene.h>
#include <cautery/study/accuracy_study.h>
#include <cautery/study/effect_study.h>
#include <cautery/study/goal_run.h>

#include <boost/program_options.hpp>

#include <cstdlib>
#include <filesystem>
#include <iostream>

namespace
{
  using namespace Cautery;
  namespace options = boost::program_options;

  enum ExitStatus
  {
    done        = 0,
    failed      = 1,
    wrong_input = 2
  };

  const char usage[] = R"(cautery simulates the thermal ablation of soft tissue.

  cautery SCENE.prm [options]          run a scene
  cautery SCENE.prm --resume           go on with a run that has ended early, from its last checkpoint
  cautery check SCENE.prm [options]    validate it; print effects, unknowns, steps, and what a run will cost
  cautery accuracy SCENE.prm [options] what accuracy costs in time: its ladders of mesh, step, ... run and compared
  cautery effects SCENE.prm [options]  what each effect changes in the answer and costs
  cautery parameters                   print the documented template of a scene
  mpirun -np N cautery ...             the same on N processes

Exit status: 0 done, 1 the run failed or was stopped by SIGTERM or SIGINT (it then writes its checkpoint; at
SIGUSR1 too, and goes on), 2 the input is wrong.
)";

  struct CommandLine
  {
    std::string           command = "run";
    std::string           scene;
    std::string           directory;
    bool                  resume = false;
    std::vector<Override> overrides;
  };

  options::options_description known_options()
  {
    options::options_description description("Options");
    auto                         option = description.add_options();
    option("output", options::value<std::string>(), "directory to write into");
    option("set",
           options::value<std::vector<std::string>>()->composing(),
           "\"Section/Entry=value\": replace an entry of the scene (may be given again)");
    option("resume", "go on from the checkpoint in the output directory");
    option("help,h", "print this");
    option("version", "print the version");
    return description;
  }

  CommandLine parse(const int argc, char **argv)
  {
    CommandLine                             line;
    options::variables_map                  given;
    options::options_description            all = known_options();
    options::positional_options_description positions;
    all.add_options()("words", options::value<std::vector<std::string>>());
    positions.add("words", -1);
    try
      {
        using namespace options::command_line_style;
        options::store(options::command_line_parser(argc, argv)
                         .options(all)
                         .positional(positions)
                         .style(default_style & ~allow_guessing)
                         .run(),
                       given);
      }
    catch (const options::error &error)
      {
        AssertThrow(false, ExcInput(std::string(error.what()) + "; see cautery --help"));
      }
    auto words =
      given.count("words") ? given["words"].as<std::vector<std::string>>() : std::vector<std::string>();
    if (given.count("help"))
      words = {"help"};
    if (given.count("version"))
      words = {"version"};
    AssertThrow(!words.empty(), ExcInput("give a scene to run; see cautery --help"));
    for (const std::string command : {"check", "accuracy", "effects", "parameters", "help", "version"})
      if (words.front() == command)
        {
          line.command = command;
          words.erase(words.begin());
          break;
        }
    const bool needs_scene =
      line.command != "parameters" && line.command != "help" && line.command != "version";
    AssertThrow(words.size() == (needs_scene ? 1 : 0),
                ExcInput((line.command == "run" ?
                            "give a scene, or a command and a scene" :
                            "`" + line.command + "` takes " + (needs_scene ? "one scene" : "nothing more")) +
                         (words.empty() ? "" : ", not `" + join(words, " ") + "`") + "; see cautery --help"));
    if (needs_scene)
      line.scene = words.front();
    line.resume = given.count("resume") > 0;
    AssertThrow(!line.resume || line.command == "run",
                ExcInput("--resume goes with a scene to run; see cautery --help"));
    if (given.count("output"))
      line.directory = given["output"].as<std::string>();
    if (given.count("set"))
      for (const auto &text : given["set"].as<std::vector<std::string>>())
        line.overrides.push_back(
          parse_override(text, "--set \"" + text + "\": write \"Section/Entry=value\""));
    return line;
  }

  /// Studies of a scene write beside its runs.
  std::string directory_of(const CommandLine &line, const Scene &scene)
  {
    if (!line.directory.empty())
      return line.directory;
    const std::string suffix = line.command == "run" ? "" : "_" + line.command;
    if (!scene.output.directory.empty())
      return scene.output.directory + suffix;
    return "output/" + std::filesystem::path(line.scene).stem().string() + suffix;
  }

  void act(const CommandLine &line, const Scene &scene)
  {
    const bool speaks = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    if (line.command == "check")
      {
        const std::string text = checked_scene(scene, MPI_COMM_WORLD);
        if (speaks)
          std::cout << text;
      }
    else if (line.command == "accuracy")
      {
        const Origin      origin{line.scene, line.overrides};
        const std::string directory = directory_of(line, scene);
        const auto        result    = study_accuracy(origin, scene, directory, MPI_COMM_WORLD);
        if (speaks)
          report_accuracy(result, origin, scene, directory);
      }
    else if (line.command == "effects")
      study_effects({line.scene, line.overrides}, scene, directory_of(line, scene), MPI_COMM_WORLD);
    else if (scene.accuracy.temperature_within > 0. && !line.resume)
      run_to_goal({line.scene, line.overrides}, scene, directory_of(line, scene), MPI_COMM_WORLD);
    else
      run_scene(scene, MPI_COMM_WORLD, directory_of(line, scene), Voice::speaks, line.resume);
  }

  void run(const CommandLine &line)
  {
    const bool speaks = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    if (line.command == "help" && speaks)
      std::cout << usage << '\n' << known_options();
    else if (line.command == "version" && speaks)
      std::cout << "cautery " << version << " (deal.II " << DEAL_II_PACKAGE_VERSION << ")\n";
    else if (line.command == "parameters" && speaks)
      std::cout << parameter_reference();
    if (line.scene.empty())
      return;
    const Scene scene = read_scene(line.scene, line.overrides);
    try
      {
        act(line, scene);
      }
    catch (const ExcInput &exception)
      {
        const std::string message = message_of(exception);
        AssertThrow(false,
                    ExcInput(message.rfind(line.scene, 0) == 0 ? message : line.scene + ": " + message));
      }
  }

  /// A process alone needs neither a daemon of Open MPI's nor a search for networks, which take as long as
  /// the rest of MPI_Init. Under a launcher nothing is changed, and what the user has set is kept.
  void start_alone_without_daemon()
  {
    for (const char *launched : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK", "SLURM_PROCID"})
      if (std::getenv(launched) != nullptr)
        return;
    const int keep = 0;
    setenv("OMPI_MCA_ess_singleton_isolated", "1", keep);
    setenv("OMPI_MCA_orte_create_session_dirs", "0", keep); // all such processes would share one, and race
    setenv("OMPI_MCA_sharedfp", "^sm", keep);               // it would put files there
    setenv("OMPI_MCA_pml", "ob1", keep);
    setenv("OMPI_MCA_btl", "self", keep);
  }

  /// One process says what all have met. What one has met alone it says itself, and ends the others, which
  /// wait for it.
  ExitStatus report(const std::exception &exception, const ExitStatus status)
  {
    const unsigned int process = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    const bool         alone   = !all_processes_come(MPI_COMM_WORLD);
    if (process == 0 || alone)
      std::cerr << "cautery: " << message_of(exception)
                << (alone ? " (on process " + std::to_string(process) + " alone)" : "") << std::endl;
    if (alone)
      MPI_Abort(MPI_COMM_WORLD, status);
    return status;
  }
} // namespace

int main(int argc, char **argv)
{
  deal_II_exceptions::suppress_stacktrace_in_exceptions();
  start_alone_without_daemon();
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  ExitStatus                       status = done;
  try
    {
      run(parse(argc, argv));
    }
  catch (const ExcInput &exception)
    {
      status = report(exception, wrong_input);
    }
  catch (const std::exception &exception)
    {
      status = report(exception, failed);
    }
  return status;
}
