// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/parameters.h>

namespace Cautery
{
  /**
   * How explicit steps are taken: section "Numerics/Explicit".
   */
  struct ExplicitSettings
  {
    enum class Precision
    {
      single_precision,
      double_precision
    };

    Precision    precision         = Precision::double_precision;
    double       motion_step       = 0.;  ///< s; 0: the stable step
    double       heat_step         = 0.;  ///< s; 0: the stable step
    double       safety            = 0.9; ///< share of the stable step that is taken
    bool         unstable_steps    = false;
    double       damping           = 0.; ///< proportional to mass, 1/s
    unsigned int hexahedron_points = 8;  ///< of integration: 8, or 1 with hourglass control
    double       hourglass         = 0.05;
    bool         averaged_pressure = false; ///< against locking of tetrahedra

    void parameters(Parameters &p);
  };
} // namespace Cautery
