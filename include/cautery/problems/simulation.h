// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/output/ablation_zone.h>
#include <cautery/output/extremes.h>
#include <cautery/output/probes.h>
#include <cautery/output/progress.h>
#include <cautery/output/run_record.h>
#include <cautery/problems/problem.h>

#include <memory>
#include <string>
#include <vector>

namespace Cautery
{
  /**
   * A run: the problem, its course in time, and those who look at it.
   */
  template <int dim>
  class Simulation
  {
  public:
    /** Builds everything and writes nothing. Errors: ExcInput. */
    Simulation(const Scene &scene, const MPI_Comm communicator);

    /** What it is going to do: effects, mesh, unknowns, memory, steps. */
    std::string description() const;

    /** Makes the state at the start, as a run does, and forgets it. Errors: ExcInput, ExcRun. */
    void check() { problem->start(); }

    /** Runs and writes into @p directory. Errors: ExcRun, after the last good state has been written. */
    void run(const std::string &directory);

  private:
    void      prepare_directory(const std::string &directory) const;
    void      advance(State &state, const double stop, Progress &progress);
    void      observe(State &state);
    void      observe_last_good();
    void      say_step(const State &state, Progress &progress) const; ///< collective
    RunRecord record(const State &state) const;
    void
    finish(const State &state, const std::string &directory, const std::string &failure, Progress &progress);

    const Scene                                &scene;
    const MPI_Comm                              communicator;
    mutable Cost                                cost;
    std::unique_ptr<Body<dim>>                  body;
    std::unique_ptr<Problem<dim>>               problem;
    std::unique_ptr<Probes<dim>>                probes;
    std::unique_ptr<AblationZone<dim>>          ablation;
    std::vector<std::unique_ptr<Observer<dim>>> others;
    Extremes                                    extremes;
    State                                       last_good;          ///< after the last complete step
    double                                      observed     = -1.; ///< s; when the outputs were last asked
    double                                      loop_seconds = 0.;
  };
} // namespace Cautery
