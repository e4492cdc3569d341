// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/laws/kinematics.h>
#include <cautery/laws/small_strain.h>

#include <cmath>

namespace Cautery
{
  /**
   * How the isotropic thermal stretch s follows from the thermal strain int alpha dT.
   */
  enum class StretchForm
  {
    none,
    linearised, ///< s = 1 + int alpha dT (thesis Eq. 7-17, page 116)
    exact       ///< s = exp(int alpha dT) (Eq. 7-11)
  };

  /** s - 1. */
  template <StretchForm form, typename Number>
  Number stretch_excess(const Number &thermal_strain)
  {
    using std::expm1;
    if constexpr (form == StretchForm::exact)
      return expm1(thermal_strain);
    else if constexpr (form == StretchForm::linearised)
      return thermal_strain;
    else
      return Number(0.);
  }

  /**
   * The elastic part F_e = F / s of a deformation of which s = 1 + @p excess is the thermal part (thesis Eqs.
   * 7-9 and 7-10): H_e = (H - (s - 1) I) / s.
   * So J_e = det F / s^3 and I_4 = a.Ca / s^2: the thesis's Eq. 7-15 divides by s only, a slip.
   */
  template <StretchForm form, typename Number>
  Deformation<Number> elastic_part(const Matrix3<Number> &gradient, const Number &excess)
  {
    if constexpr (form == StretchForm::none)
      return Deformation<Number>(gradient);
    const Number    inverse = 1. / (1. + excess);
    Matrix3<Number> elastic;
    for (int i = 0; i < 9; ++i)
      elastic.entries[i] = (i % 4 == 0 ? gradient.entries[i] - excess : gradient.entries[i]) * inverse;
    return Deformation<Number>(elastic);
  }

  /**
   * The stress at a point: P = factor times stress, in Pa.
   */
  template <typename Number>
  struct PointStress
  {
    Matrix3<Number> stress;
    Number          factor;
    Number          jacobian; ///< of the elastic part; the cell is inverted unless it is positive
  };

  /**
   * The stress of a law of large deformation with fibres: P = s^2 P_e(H_e), because S = s S_e (Eq. 7-13).
   * @p add_fibres adds their stress to that of @p law.
   */
  template <StretchForm form, typename Law, typename Number, typename AddFibres>
  PointStress<Number> point_stress(const Law             &law,
                                   const AddFibres       &add_fibres,
                                   const Matrix3<Number> &gradient,
                                   const Number          &thermal_strain)
  {
    const Number              excess = stretch_excess<form>(thermal_strain);
    const Deformation<Number> k      = elastic_part<form>(gradient, excess);
    PointStress<Number>       result = {law.stress(k), 1. + excess * (2. + excess), k.jacobian};
    add_fibres(k, result.stress);
    return result;
  }

  /**
   * Linear elasticity with heat, as for small deformation (see ThermalExpansion): linearised
   * sigma(eps) - 3 K (s - 1) I, exact sigma(eps) / s - 3/2 (s - 1/s) K I. Fibres it has none, and no cell is
   * inverted.
   */
  template <StretchForm form, typename Number, typename AddFibres>
  PointStress<Number> point_stress(const SmallStrain &law,
                                   const AddFibres &,
                                   const Matrix3<Number> &gradient,
                                   const Number          &thermal_strain)
  {
    const Number excess   = stretch_excess<form>(thermal_strain);
    Number       pressure = 3. * excess;
    Number       factor(1.);
    if constexpr (form == StretchForm::exact)
      {
        factor   = 1. / (1. + excess);
        pressure = 1.5 * excess * (2. + excess);
      }
    PointStress<Number> result = {law.stress(gradient), factor, Number(1.)};
    for (int i = 0; i < 3; ++i)
      result.stress(i, i) = result.stress(i, i) - law.bulk_modulus() * pressure;
    return result;
  }
} // namespace Cautery
