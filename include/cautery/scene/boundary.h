// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/parameters.h>

#include <string>
#include <vector>

namespace Cautery
{
  /**
   * What holds on some surfaces: exactly one thermal and one mechanical condition, of which only those count
   * whose balance the scene solves. A subsection of "Boundaries".
   */
  struct Boundary
  {
    enum class Thermal
    {
      missing,
      temperature,
      flux,
      convection,
      insulated
    };
    enum class Mechanical
    {
      missing,
      fixed,
      free,
      roller,       ///< no motion along the normal
      displacement, ///< prescribed
      traction
    };

    std::string              name;
    std::vector<std::string> surfaces = {"all"}; ///< physical groups, by number or name; "remaining"

    Thermal    thermal              = Thermal::missing;
    Expression temperature          = 310.; ///< K
    Expression flux                 = 0.;   ///< into the body, W/m2
    Expression transfer_coefficient = 5.;   ///< W/(m2 K); not of time
    Expression ambient_temperature  = 293.; ///< K

    Mechanical       mechanical = Mechanical::missing;
    VectorExpression displacement; ///< m
    VectorExpression traction;     ///< Pa

    void parameters(Parameters &p);
  };

  /**
   * A force at a point of the body: a subsection of "Loads".
   */
  struct PointLoad
  {
    std::string      name;
    Point<3>         place; ///< m
    VectorExpression force; ///< N (N/m in two dimensions)

    void parameters(Parameters &p);
  };

  /**
   * Forces: section "Loads".
   */
  struct Loads
  {
    Point<3>               gravity = {0., 0., -9.81}; ///< acceleration, m/s2
    std::vector<PointLoad> points;
  };
} // namespace Cautery
