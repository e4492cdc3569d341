// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/archive.h>

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

    void archive(Archive &archive)
    {
      archive.shared("time", time);
      archive.shared("step", step);
      archive.nodal("temperature", temperature);
      archive.nodal("temperature rate", temperature_rate);
      archive.nodal("displacement", displacement);
      archive.nodal("displacement rate", displacement_rate);
      archive.nodal("ln damage", ln_damage);
    }
  };
} // namespace Cautery
