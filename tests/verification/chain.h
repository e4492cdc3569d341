// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/problems/simulation.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>

namespace Verification
{
  using namespace Cautery;

  /// What a run leaves for its user: probes.csv and summary.json.
  struct Outcome
  {
    /// By (time in s as written, probe), then by column.
    std::map<std::pair<std::string, std::string>, std::map<std::string, double>> probes;
    nlohmann::json                                                               summary;

    double at(const std::string &time, const std::string &probe, const std::string &column) const
    {
      return probes.at({time, probe}).at(column);
    }
    /** At the last time. */
    double end(const std::string &probe, const std::string &column) const
    {
      return at(to_text(summary.at("end_time_s")), probe, column);
    }
    double balance(const std::string &entry) const { return summary.at("balance").at(entry); }
  };

  inline std::vector<std::string> split(const std::string &line)
  {
    std::vector<std::string> words;
    std::istringstream       stream(line);
    for (std::string word; std::getline(stream, word, ',');)
      words.push_back(word);
    return words;
  }

  inline Outcome read_outcome(const std::string &directory)
  {
    Outcome       outcome;
    std::ifstream probes(directory + "/probes.csv");
    std::string   line;
    if (std::getline(probes, line))
      {
        const auto columns = split(line);
        while (std::getline(probes, line))
          {
            const auto words = split(line);
            auto      &row   = outcome.probes[{words.at(0), words.at(1)}];
            for (unsigned int c = 2; c < columns.size(); ++c)
              row[columns[c]] = std::stod(words.at(c));
          }
      }
    outcome.summary = nlohmann::json::parse(std::ifstream(directory + "/summary.json"));
    return outcome;
  }

  /// Runs a scene of this folder through the whole program, its log kept from the screen. Collective; the
  /// outcome is empty but on process 0.
  inline Outcome run(const std::string           &scene_name,
                     const std::vector<Override> &overrides    = {},
                     const MPI_Comm               communicator = MPI_COMM_SELF)
  {
    static unsigned int n_runs    = 0;
    const std::string   directory = scene_name + "_" + std::to_string(++n_runs);
    auto                all       = overrides;
    all.push_back({"Output/Fields", "off"});
    const Scene        scene = read_scene(VERIFICATION_SCENES "/" + scene_name + ".prm", all);
    std::ostringstream log;
    auto *const        screen = std::cout.rdbuf(log.rdbuf());
    try
      {
        Simulation<3>(scene, communicator).run(directory);
      }
    catch (...)
      {
        std::cout.rdbuf(screen);
        std::cout << scene_name << '\n' << log.str();
        throw;
      }
    std::cout.rdbuf(screen);
    return Utilities::MPI::this_mpi_process(communicator) == 0 ? read_outcome(directory) : Outcome();
  }

  /// The largest difference of any column, relative to the column's largest value.
  inline double difference_by_column(const Outcome &one, const Outcome &other)
  {
    std::map<std::string, double> largest, apart;
    for (const auto &[place, row] : one.probes)
      for (const auto &[column, value] : row)
        {
          const double second = other.probes.at(place).at(column);
          largest[column]     = std::max(largest[column], std::isfinite(value) ? std::abs(value) : 0.);
          apart[column] =
            std::max(apart[column], value == second ? 0. : std::abs(value - second)); // no damage: -infinity
        }
    double result = 0.;
    for (const auto &[column, value] : apart)
      if (value > 0.)
        result = std::max(result, value / largest[column]);
    return result;
  }

  /// Counts what is wrong and prints every comparison.
  class Checks
  {
  public:
    void near(const std::string &what, const double found, const double exact, const double tolerance)
    {
      const double error = std::abs(found - exact);
      report(what, error <= tolerance); // false for NaN
      std::cout << std::setprecision(8) << found << ", exact " << exact << ", error " << std::setprecision(2)
                << error << " of " << tolerance << '\n';
    }

    void below(const std::string &what, const double found, const double limit)
    {
      report(what, found <= limit);
      std::cout << std::setprecision(3) << found << ", at most " << limit << '\n';
    }

    void holds(const std::string &what, const bool condition)
    {
      report(what, condition);
      std::cout << '\n';
    }

    bool all_right() const { return n_checks > 0 && n_wrong == 0; }

  private:
    void report(const std::string &what, const bool right)
    {
      ++n_checks;
      n_wrong += right ? 0 : 1;
      std::cout << (right ? "  right  " : "  WRONG  ") << what << ": ";
    }

    unsigned int n_checks = 0;
    unsigned int n_wrong  = 0;
  };

  /** The main program of a test of several @p groups: runs the one that is named; 0 if all is right in it. */
  inline int
  run_group(int argc, char **argv, const std::map<std::string, std::function<void(Checks &)>> &groups)
  {
    deal_II_exceptions::suppress_stacktrace_in_exceptions();
    Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
    Checks                           checks;
    try
      {
        groups.at(argc > 1 ? argv[1] : "")(checks);
      }
    catch (const std::exception &exception)
      {
        std::cerr << exception.what() << std::endl;
        return 2;
      }
    return checks.all_right() ? 0 : 1;
  }

  /// Each group: exact_*.cc.
  void heat(Checks &checks);
  void waves(Checks &checks);
  void damage(Checks &checks);
  void deformation(Checks &checks);
  void motion(Checks &checks);
  void balance(Checks &checks);
  void stencils(Checks &checks);
  void condensation(Checks &checks);
  void time_errors(Checks &checks);
} // namespace Verification
