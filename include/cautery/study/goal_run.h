// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/study/outcome.h>

namespace Cautery
{
  /**
   * Looks for a mesh and for steps with which the temperature of the scene's probes (without probes the
   * highest of the run) errs by no more than Accuracy/Temperature within, says what it chose and why, and
   * runs the scene so into @p directory. First the steps become finer on a coarse mesh, until halving them
   * changes the answer little enough, then the mesh. Trial runs lie below @p directory and are not repeated.
   * Collective. Errors: ExcInput; ExcRun where the mesh would become too large.
   */
  void run_to_goal(const Origin      &origin,
                   const Scene       &scene,
                   const std::string &directory,
                   const MPI_Comm     communicator);
} // namespace Cautery
