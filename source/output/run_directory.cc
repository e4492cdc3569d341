// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/output/run_directory.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>

namespace Cautery
{
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

  void prepare_directory(const std::string &directory, const Scene &scene, const MPI_Comm communicator)
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

  TemporaryDirectory::TemporaryDirectory(const MPI_Comm communicator)
    : owned(Utilities::MPI::this_mpi_process(communicator) == 0)
  {
    if (owned)
      {
        std::error_code error;
        name = (std::filesystem::temp_directory_path(error) / "cautery-XXXXXX").string();
        if (error || mkdtemp(name.data()) == nullptr)
          name.clear();
      }
    name = Utilities::MPI::broadcast(communicator, name, 0);
    AssertThrow(!name.empty(),
                ExcInput("no temporary directory for the trial can be made; set TMPDIR to one that can be "
                         "written"));
  }

  TemporaryDirectory::~TemporaryDirectory()
  {
    std::error_code error;
    if (owned)
      std::filesystem::remove_all(name, error);
  }
} // namespace Cautery
