// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/parameters.h>

namespace Cautery
{
  /**
   * What grips the body: the nodes within a sphere follow its motion. A subsection of "Tools".
   */
  struct Tool
  {
    std::string      name;
    Point<3>         centre;        ///< of the undeformed body, m
    double           radius = 1e-3; ///< m
    VectorExpression displacement;  ///< m

    void parameters(Parameters &p);
  };
} // namespace Cautery
