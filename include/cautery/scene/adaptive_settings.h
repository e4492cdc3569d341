// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/parameters.h>

namespace Cautery
{
  /**
   * How the mesh follows the solution: section "Mesh/Adaptive".
   */
  struct AdaptiveSettings
  {
    /// Whose gradient's error decides.
    enum class Follow
    {
      nothing,
      temperature,
      displacement,
      both
    };

    Follow       follow        = Follow::nothing;
    double       target_error  = 0.05; ///< of the gradient, relative to it
    double       interval      = 0.;   ///< s; 0: at the start only
    unsigned int max_divisions = 3;    ///< of a cell of the scene's mesh
    unsigned int max_cells     = 200000;

    bool is_on() const { return follow != Follow::nothing; }
    bool follows_temperature() const { return follow == Follow::temperature || follow == Follow::both; }
    bool follows_displacement() const { return follow == Follow::displacement || follow == Follow::both; }

    void parameters(Parameters &p);
  };
} // namespace Cautery
