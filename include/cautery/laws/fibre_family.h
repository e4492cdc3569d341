// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/parameters.h>
#include <cautery/laws/fibres.h>

namespace Cautery
{
  /**
   * Fibres as a scene describes them: their law and where they run.
   */
  struct FibreFamily
  {
    Fibres law;
    /// of the reference body, any length; expressions in x, y, z
    VectorExpression direction{std::array<Expression, 3>{{1., 0., 0.}}};

    /** The unit vector at @p place (m); ExcInput where the expressions give no direction. */
    Vector3<double> unit_direction(const Point<3> &place) const;

    void parameters(Parameters &p);
  };
} // namespace Cautery
