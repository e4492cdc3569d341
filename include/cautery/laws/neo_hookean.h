// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/laws/kinematics.h>

#include <cmath>

namespace Cautery
{
  /**
   * The isotropic compressible neo-Hookean law (thesis Eq. 7-6, page 113): per reference volume
   * W = mu/2 (I_1 - 3) - mu ln J + lambda/2 (ln J)^2, in J/m3.
   * Its limit for small strain is linear elasticity with the same Lamé parameters.
   */
  struct NeoHookean
  {
    double lambda = 0.; ///< Pa
    double mu     = 0.; ///< Pa

    template <typename Number>
    Number energy(const Deformation<Number> &k) const
    {
      using std::log1p;
      const Number logarithm = log1p(k.volume_change);
      // I_1 - 3 = 2 tr H + H:H
      return 0.5 * mu * (2. * k.divergence + double_dot(k.gradient, k.gradient)) - mu * logarithm +
             0.5 * lambda * logarithm * logarithm;
    }

    /** P = F S (Eq. 7-12): mu (F - F^-T) + lambda ln J F^-T, in Pa. */
    template <typename Number>
    Matrix3<Number> stress(const Deformation<Number> &k) const
    {
      using std::log1p;
      return stress(k, lambda * log1p(k.volume_change));
    }

    /** The same with lambda ln J, in Pa, given: averaged over a neighbourhood, against locking. */
    template <typename Number>
    Matrix3<Number> stress(const Deformation<Number> &k, const Number &kirchhoff_pressure) const
    {
      const Number          inverse  = 1. / k.jacobian;
      const Number          pressure = kirchhoff_pressure * inverse;
      const Number          shear    = mu * inverse;
      const Matrix3<Number> area     = k.area_map();
      Matrix3<Number>       result;
      // J (F - F^-T) = (J - 1 - tr H) I + J H + H^T - cof H
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          result(i, j) =
            pressure * area(i, j) + mu * k.gradient(i, j) + shear * (k.gradient(j, i) - k.cofactor(i, j));
      for (int i = 0; i < 3; ++i)
        result(i, i) = result(i, i) + shear * k.higher_order;
      return result;
    }

    /** How P changes with a small change of H, dP/dH : @p change, in Pa. */
    template <typename Number>
    Matrix3<Number> stress_change(const Deformation<Number> &k, const Matrix3<Number> &change) const
    {
      using std::log1p;
      const Number    inverse   = 1. / k.jacobian;
      Matrix3<Number> transpose = k.area_map(); // F^-T
      for (Number &entry : transpose.entries)
        entry = entry * inverse;
      const Number volumetric = lambda * double_dot(transpose, change);
      const Number deviatoric = mu - lambda * log1p(k.volume_change);

      // d(F^-T) = - F^-T change^T F^-T
      Matrix3<Number> result;
      for (int i = 0; i < 3; ++i)
        {
          Vector3<Number> row; // (F^-T change^T)_i
          for (int j = 0; j < 3; ++j)
            row[j] = transpose(i, 0) * change(j, 0) + transpose(i, 1) * change(j, 1) +
                     transpose(i, 2) * change(j, 2);
          for (int j = 0; j < 3; ++j)
            result(i, j) =
              mu * change(i, j) + volumetric * transpose(i, j) +
              deviatoric * (row[0] * transpose(0, j) + row[1] * transpose(1, j) + row[2] * transpose(2, j));
        }
      return result;
    }
  };
} // namespace Cautery
