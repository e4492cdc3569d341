// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/laws/fibres.h>
#include <cautery/laws/neo_hookean.h>
#include <cautery/laws/thermal_stretch.h>

#include <variant>
#include <vector>

namespace Cautery
{
  /// The one list of ground substances: a new one is added here, and beside NeoHookean in the explicit
  /// kernel.
  using GroundSubstance = std::variant<SmallStrain, NeoHookean>;

  /**
   * All of a tissue's elasticity in large deformation: ground substance, fibres and thermal stretch.
   *
   * At a point: @p gradient is H = F - I, @p directions the unit vector of each fibre family in the reference
   * body, @p thermal_strain is int alpha dT. Inverted points (J <= 0) give values that are not finite.
   */
  struct ElasticLaw
  {
    using Directions = std::vector<Vector3<double>>;

    GroundSubstance     ground;
    std::vector<Fibres> fibres; ///< none with SmallStrain
    StretchForm         stretch = StretchForm::none;

    /** W per reference volume, but for a function of temperature alone; J/m3. */
    double
    energy(const Matrix3<double> &gradient, const Directions &directions, const double thermal_strain) const;

    /** P = dW/dF, the first Piola-Kirchhoff stress, in Pa. */
    Matrix3<double>
    stress(const Matrix3<double> &gradient, const Directions &directions, const double thermal_strain) const;

    /** dP/dF : @p change, in Pa: a column of the tangent where @p change is 1 in one entry. */
    Matrix3<double> stress_change(const Matrix3<double> &gradient,
                                  const Directions      &directions,
                                  const double           thermal_strain,
                                  const Matrix3<double> &change) const;

    /** Throws ExcInput for Lamé parameters without stability and fibres that the ground cannot have. */
    void check() const;
  };
} // namespace Cautery
