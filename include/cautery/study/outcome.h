// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/study/quantity.h>
#include <cautery/study/variant.h>

#include <deal.II/base/mpi.h>

namespace Cautery
{
  /**
   * What came out when a variant was run.
   */
  struct Outcome
  {
    std::string             message;       ///< why it failed; empty: it did not
    double                  seconds  = 0.; ///< processor time, median of the repeats
    double                  bytes    = 0.; ///< most memory, of all processes
    unsigned int            steps    = 0;
    types::global_dof_index unknowns = 0;
    std::vector<Series>     answers; ///< of each quantity
    bool                    is_new = true;

    bool succeeded() const { return message.empty(); }
  };

  /** Errors: ExcInput where a run, whose study is in @p directory, did not answer one of @p quantities. */
  void require_answers(const std::vector<Quantity> &quantities,
                       const Outcome               &outcome,
                       const std::string           &directory);

  /**
   * Time is that of the processor, so that what else runs on the machine does not count; on a quiet one it is
   * the wall time.
   *
   * Runs variants of a scene, each in a folder of its own below one directory, once: what is there already,
   * of this program's version and for the same complete scene, is taken from there.
   */
  class Runner
  {
  public:
    Runner(const Origin                &origin,
           const std::vector<Quantity> &quantities,
           const unsigned int           repeats,
           const std::string           &directory,
           const MPI_Comm               communicator);

    /**
     * Collective. A run that fails, or that the mesh of the variant does not allow, is an outcome too.
     * Errors: ExcInput where the entries do not fit the scene.
     * @param name of the folder.
     */
    Outcome run(const std::string &name, const std::vector<Override> &changes);

  private:
    Scene   scene_of(const std::vector<Override> &changes) const;
    Outcome read(const std::string &folder) const;
    bool    is_finished(const std::string &folder, const Scene &scene) const;
    void    carry_out(const Scene &scene, const std::string &folder);

    const Origin                      &origin;
    const std::vector<Quantity>       &quantities;
    const unsigned int                 repeats;
    const std::string                  directory;
    const MPI_Comm                     communicator;
    std::map<std::string, std::string> folders; ///< by complete scene
    bool                               is_warm = false;
  };
} // namespace Cautery
