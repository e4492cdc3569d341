// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/laws/kinematics.h>

#include <cmath>

namespace Cautery
{
  /**
   * One family of collagen fibres (thesis Eqs. 7-7 and 7-8, page 114):
   * W = k_1 / (2 k_2) (exp(k_2 (I_4 - 1)^2) - 1) per reference volume, in J/m3, with I_4 the square of the
   * stretch along the unit vector a of the reference body. The thesis's fibres resist compression too; real
   * ones buckle.
   */
  struct Fibres
  {
    double stiffness    = 2363.2; ///< k_1, Pa
    double stiffening   = 0.8393; ///< k_2
    bool   tension_only = true;

    template <typename Number>
    Number energy(const Deformation<Number> &k, const Vector3<Number> &a) const
    {
      using std::expm1;
      const Number x = stretch_excess(a, k.gradient * a);
      return 0.5 * stiffness / stiffening * expm1(stiffening * (x * x));
    }

    /** Adds P = 2 k_1 (I_4 - 1) exp(k_2 (I_4 - 1)^2) F a a^T (Eq. 7-12), in Pa. */
    template <typename Number>
    void add_stress(const Deformation<Number> &k, const Vector3<Number> &a, Matrix3<Number> &stress) const
    {
      using std::exp;
      const Vector3<Number> stretching = k.gradient * a;
      const Number          x          = stretch_excess(a, stretching);
      const Number          tension    = 2. * stiffness * x * exp(stiffening * (x * x));
      for (int i = 0; i < 3; ++i)
        {
          const Number along = tension * (a[i] + stretching[i]);
          for (int j = 0; j < 3; ++j)
            stress(i, j) = stress(i, j) + along * a[j];
        }
    }

    /** Adds dP/dH : @p change, in Pa. */
    template <typename Number>
    void add_stress_change(const Deformation<Number> &k,
                           const Vector3<Number>     &a,
                           const Matrix3<Number>     &change,
                           Matrix3<Number>           &stress) const
    {
      using std::exp;
      const Vector3<Number> stretching = k.gradient * a;
      const Vector3<Number> turning    = change * a;
      const Vector3<Number> fibre      = {{a[0] + stretching[0], a[1] + stretching[1], a[2] + stretching[2]}};
      const Number          x          = stretch_excess(a, stretching);
      const Number          growth     = 2. * stiffness * exp(stiffening * (x * x));
      const bool            slack      = tension_only && x <= 0.;
      const Number          tangent    = slack ? 0. : growth * (1. + 2. * stiffening * (x * x));
      const Number          rate       = tangent * 2. * dot(fibre, turning);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          stress(i, j) = stress(i, j) + (growth * x * turning[i] + rate * fibre[i]) * a[j];
    }

    /** I_4 - 1 = 2 a.Ha + |Ha|^2 from Ha, or 0 where the fibre is slack. */
    template <typename Number>
    Number stretch_excess(const Vector3<Number> &a, const Vector3<Number> &stretching) const
    {
      const Number bound(tension_only ? 0. : -1.); // I_4 is never negative
      return at_least(bound, 2. * dot(a, stretching) + dot(stretching, stretching));
    }
  };
} // namespace Cautery
