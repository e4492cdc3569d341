// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/parameters.h>

namespace Cautery
{
  /**
   * How dynamic relaxation comes to rest: section "Numerics/Relaxation".
   */
  struct RelaxationSettings
  {
    double       tolerance = 1e-8;   ///< on the norm of the forces left over, relative to those that act
    unsigned int max_steps = 200000; ///< for one equilibrium

    void parameters(Parameters &p);
  };
} // namespace Cautery
