// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/output/forecast.h>
#include <cautery/output/progress.h>
#include <cautery/problems/adaption.h>
#include <cautery/problems/audience.h>
#include <cautery/problems/mesh_history.h>
#include <cautery/problems/safekeeper.h>

#include <memory>
#include <string>
#include <vector>

namespace Cautery
{
  /// What a run says beside its files.
  enum class Voice
  {
    speaks,
    silent
  };

  /**
   * A run: the problem, its course in time, and those who look at it.
   */
  template <int dim>
  class Simulation
  {
  public:
    /** Builds everything and writes nothing. Errors: ExcInput. */
    Simulation(const Scene &scene, const MPI_Comm communicator);

    const Body<dim>    &simulated_body() const { return *body; }
    const Problem<dim> &simulated_problem() const { return *problem; }

    /**
     * What a run is going to cost, from a trial of its first steps, whose files are removed again. The
     * simulation is of no more use then. Errors: ExcInput, ExcRun.
     */
    Forecast::Result trial();

    /**
     * Runs and writes into @p directory; with @p resume goes on from the checkpoint there. Errors: ExcRun,
     * after the last good state has been written; ExcInput for what cannot be resumed, with nothing changed.
     */
    RunRecord run(const std::string &directory, const Voice voice = Voice::speaks, const bool resume = false);

  private:
    void begin(const std::string &directory, State &state, Progress &progress);
    void resume(const std::string &directory, State &state, Progress &progress);
    void archive(Archive &archive, State &state, Progress &progress);
    /// To the end, or until the forecast is made. False where it has been asked to stop.
    bool        go(State &state, Progress &progress, const bool only_trial);
    std::string end_failed(const std::string &directory, const ExcRun &failure, Progress &progress);
    void        advance(State &state, const double stop, Progress &progress);
    void        adapt_mesh(State &state, Progress &progress);
    void        use(Adapted<dim> next);
    void        take_stored_mesh(State &state);
    void        foretell(const double length, const double seconds, const double time);
    void        observe(State &state);
    void        observe_last_good();
    std::string observe_last_borne();
    void        say_step(const State &state, Progress &progress) const; ///< collective
    RunRecord   record(const State &state) const;
    RunRecord   finish(const State       &state,
                       const std::string &directory,
                       const std::string &status,
                       const std::string &message,
                       Progress          &progress);

    const Scene                      &scene;
    const MPI_Comm                    communicator;
    mutable Cost                      cost;
    std::unique_ptr<Body<dim>>        body;
    std::unique_ptr<Problem<dim>>     problem;
    std::unique_ptr<Audience<dim>>    audience;
    std::unique_ptr<Safekeeper<dim>>  safekeeper;
    std::unique_ptr<MeshHistory<dim>> meshes;
    Forecast                          forecast;
    State                             last_good;          ///< after the last complete step
    double                            observed     = -1.; ///< s; when the outputs were last asked
    double                            written      = -1.; ///< s; and had all been written
    double                            loop_seconds = 0.;
    std::optional<double>             resumed_from;     ///< s
    unsigned int                      resumed_step = 0; ///< 0: the run began at its start
  };
} // namespace Cautery
