// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/interruption.h>
#include <cautery/output/checkpoint.h>
#include <cautery/problems/problem.h>

#include <functional>

namespace Cautery
{
  /**
   * Sees to it that a run can go on after it has ended early: decides between steps whether its checkpoint is
   * due, by the number of steps, by the clock, or because a signal asks for it.
   *
   * A checkpoint is of the present state; with IDA, whose memory cannot be stored, of the last state at which
   * it has started anew. So the run that resumes takes the same steps as the one that does not end.
   */
  template <int dim>
  class Safekeeper
  {
  public:
    using Store = std::function<void(Archive &)>;

    /** Arguments must live as long as it. */
    Safekeeper(const std::string &directory,
               const Scene       &scene,
               const Body<dim>   &body,
               Problem<dim>      &problem,
               Cost              &cost);

    Checkpoint<dim> &checkpoint() { return file; }

    /** The mesh has been adapted: these are in the place of those so far. */
    void use(const Body<dim> &body, Problem<dim> &problem);

    /** The run has resumed at @p state, from a checkpoint that stays good for it. */
    void resumed_at(const State &state) { written_step = state.step; }

    /**
     * To be called before each step; @p store lists all that the run depends on. Returns whether the run is
     * asked to stop: then its checkpoint has been written. Collective. Errors: ExcRun where it cannot be
     * written.
     */
    bool look(const State &state, const Store &store);

    double time() const { return latest_time; } ///< of the state that is stored, s

  private:
    enum Need
    {
      nothing,
      due,
      asked,
      last
    };
    Need need(const State &state);
    void write(const Need reason);

    const CheckpointSettings &settings;
    const MPI_Comm            communicator;
    const bool                seldom; ///< the state can be stored only now and then
    Problem<dim>             *problem;
    Cost                     &cost;
    Checkpoint<dim>           file;
    Interruption              interruption;
    Timer                     clock; ///< since the last checkpoint
    Archive                   latest;
    double                    latest_time = 0.;
    unsigned int              latest_step = 0, written_step = 0;
  };
} // namespace Cautery
