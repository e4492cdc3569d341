// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/laws/kinematics.h>

namespace Cautery
{
  /**
   * Linear elasticity as one of the laws of large deformation, for comparison: the strain is the symmetric
   * part of H, so rotations count as strain. W = lambda/2 (tr eps)^2 + mu eps:eps per reference volume, J/m3.
   */
  struct SmallStrain
  {
    double lambda = 0.; ///< Pa
    double mu     = 0.; ///< Pa

    double bulk_modulus() const { return lambda + 2. / 3. * mu; }

    template <typename Number>
    Number energy(const Matrix3<Number> &gradient) const
    {
      return 0.5 * double_dot(stress(gradient), gradient);
    }

    /** lambda tr(eps) I + 2 mu eps, in Pa; linear, so it is its own tangent too. */
    template <typename Number>
    Matrix3<Number> stress(const Matrix3<Number> &gradient) const
    {
      Matrix3<Number> result;
      const Number    volumetric = lambda * trace(gradient);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          result(i, j) = mu * (gradient(i, j) + gradient(j, i));
      for (int i = 0; i < 3; ++i)
        result(i, i) = result(i, i) + volumetric;
      return result;
    }
  };
} // namespace Cautery
