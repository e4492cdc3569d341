// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/scene/scene.h>

#include <array>
#include <string>
#include <vector>

/**
 * Exact solutions that a scene can state: sources, boundary values and initial values are expressions. One
 * family serves all models. With the material of scenes/manufactured.prm and T_0 = T_b = 2, T = T_0 + s(x, y,
 * z) theta(t),   lap s = -lambda_s s, u = (m grad Phi) theta(t),       lap Phi = s,   m = beta / (lambda + 2
 * mu), is in equilibrium without body force, since div u = m (T - T_0); in the balance of heat the feedback
 * beta T_0 div u' then acts as if rho C were larger by beta T_0 m.
 */
namespace Verification
{
  using namespace Cautery;

  /// X(x) Y(y) Z(z) as text: factors[axis][n] is the n-th derivative of one factor.
  struct Product
  {
    std::array<std::vector<std::string>, 3> factors;

    std::string value() const { return derivative({}); }
    /** Differentiated along each axis of the list. */
    std::string derivative(const std::vector<unsigned int> &axes) const;
  };

  enum class Model
  {
    fourier,
    non_fourier,
    elastic,
    expansion, ///< Fourier, one way
    two_way_fourier,
    two_way_non_fourier
  };

  std::string name(const Model model);
  bool        has_heat(const Model model);
  bool        has_deformation(const Model model);

  /// What there is to compute, and what must come out.
  struct Manufactured
  {
    std::vector<Override>   scene; ///< to add to scenes/manufactured.prm
    std::vector<Expression> temperature;
    std::vector<Expression> displacement;
  };

  /**
   * Smooth in space, and in time exact for backward Euler (theta is a straight line): all that is wrong comes
   * from the mesh. In the non-Fourier model the source jumps at t = 0, which makes the rate of temperature
   * jump from zero.
   */
  Manufactured wave_in_space(const Model model);

  /** Exact in space from degree 2 on (heat alone: from 1 on), theta = sin(2 t): all that is wrong comes from
   * the steps in time. */
  Manufactured wave_in_time(const Model model);

  /** Exact in space as wave_in_time and in time as wave_in_space: nothing may be wrong, on any mesh. */
  Manufactured straight(const Model model);
} // namespace Verification
