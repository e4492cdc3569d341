// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/parameters.h>

namespace Cautery
{
  /**
   * How equilibrium in large deformation is found: section "Numerics/Newton".
   */
  struct NewtonSettings
  {
    double       tolerance      = 1e-8; ///< on the norm of the forces left over, relative to those that act
    unsigned int max_iterations = 20;   ///< for one step of the load
    double       smallest_step  = 1e-3; ///< share of the load

    void parameters(Parameters &p);
  };
} // namespace Cautery
