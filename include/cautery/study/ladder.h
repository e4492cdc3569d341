// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/study/variant.h>

namespace Cautery
{
  /**
   * Variants from coarse to fine.
   */
  struct Ladder
  {
    std::string           name;
    LadderSettings::Error error = LadderSettings::Error::none; ///< that vanishes as the ladder goes on
    double                ratio = 2.;                          ///< of lengths from rung to rung
    std::vector<Variant>  rungs;
  };

  /**
   * The ladders that the scene names, or those standard ones that fit it: mesh, degree, step, IDA, solver,
   * ...
   * @p left_out gets a line for each standard ladder that does not fit.
   * Errors: ExcInput for one that is named and does not fit.
   */
  std::vector<Ladder>
  make_ladders(const Origin &origin, const Scene &scene, std::vector<std::string> &left_out);

  /** The names of the standard ladders. */
  std::vector<std::string> standard_ladder_names();
} // namespace Cautery
