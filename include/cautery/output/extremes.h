// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/space/state.h>

#include <limits>

namespace Cautery
{
  /**
   * The largest and smallest values of a whole run, at every step.
   */
  struct Extremes
  {
    double temperature_max  = -std::numeric_limits<double>::infinity(); ///< K
    double temperature_min  = std::numeric_limits<double>::infinity();  ///< K
    double displacement_max = 0.;                                       ///< m
    double ln_damage_max    = -std::numeric_limits<double>::infinity();

    double hottest_now = 0.; ///< K, at the last step

    /** Of a run so far: those of all processes. */
    void archive(Archive &archive);

    /** Of this process. */
    void observe(const State &state, const unsigned int dimension);

    /** Over all processes. Collective. */
    Extremes reduced(const MPI_Comm communicator) const;
  };
} // namespace Cautery
