// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/linear_algebra.h>

namespace Cautery
{
  /**
   * All that changes in time. A vector of an effect that is off has no entries.
   */
  struct State
  {
    double       time = 0.; ///< s
    unsigned int step = 0;

    Vector temperature;       ///< K, nodes
    Vector temperature_rate;  ///< K/s, nodes; non-Fourier only
    Vector displacement;      ///< m, dim per node
    Vector displacement_rate; ///< m/s, dim per node; inertia or two-way non-Fourier coupling only
    Vector ln_damage;         ///< ln(Omega), nodes
  };
} // namespace Cautery
