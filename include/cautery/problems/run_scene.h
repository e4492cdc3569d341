// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/problems/simulation.h>

namespace Cautery
{
  /** A run of @p scene, in its dimension. Errors: as those of Simulation. */
  RunRecord run_scene(const Scene       &scene,
                      const MPI_Comm     communicator,
                      const std::string &directory,
                      const Voice        voice  = Voice::speaks,
                      const bool         resume = false);

  /** What it is going to do and to cost. Errors: as those of Simulation. */
  std::string checked_scene(const Scene &scene, const MPI_Comm communicator);
} // namespace Cautery
