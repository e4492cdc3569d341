// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

/**
 * @file
 * Large deformation at a point. The laws of large deformation include no more than this, because their one
 * text also runs in the lanes of the explicit kernel, which is compiled for several instruction sets: Number
 * is double or a group of lanes, of either precision, and is made from double.
 *
 * Everything is written with the displacement gradient H = F - I and never subtracts numbers near 1: in
 * single precision the textbook form of F'F - I loses four digits at strains of 1e-4.
 */

namespace Cautery
{
  /** A vector of three components. */
  template <typename Number>
  struct Vector3
  {
    Number  entries[3];
    Number &operator[](const int i) { return entries[i]; }
    Number  operator[](const int i) const { return entries[i]; }
  };

  /** A matrix of three rows and columns; `m(row, column)`. */
  template <typename Number>
  struct Matrix3
  {
    Number  entries[9];
    Number &operator()(const int row, const int column) { return entries[3 * row + column]; }
    Number  operator()(const int row, const int column) const { return entries[3 * row + column]; }
  };

  /** The larger of the two. */
  template <typename Number>
  Number at_least(const Number &bound, const Number &value)
  {
    return value > bound ? value : bound;
  }

  template <typename Number>
  Number dot(const Vector3<Number> &a, const Vector3<Number> &b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  template <typename Number>
  Vector3<Number> operator*(const Matrix3<Number> &m, const Vector3<Number> &v)
  {
    return {{m(0, 0) * v[0] + m(0, 1) * v[1] + m(0, 2) * v[2],
             m(1, 0) * v[0] + m(1, 1) * v[1] + m(1, 2) * v[2],
             m(2, 0) * v[0] + m(2, 1) * v[1] + m(2, 2) * v[2]}};
  }

  /** sum of a_ij b_ij. */
  template <typename Number>
  Number double_dot(const Matrix3<Number> &a, const Matrix3<Number> &b)
  {
    Number sum = a.entries[0] * b.entries[0];
    for (int i = 1; i < 9; ++i)
      sum = sum + a.entries[i] * b.entries[i];
    return sum;
  }

  template <typename Number>
  Number trace(const Matrix3<Number> &m)
  {
    return m(0, 0) + m(1, 1) + m(2, 2);
  }

  /** The matrix of cofactors, d det(m) / dm = det(m) m^-T. */
  template <typename Number>
  Matrix3<Number> cofactors(const Matrix3<Number> &m)
  {
    return {{m(1, 1) * m(2, 2) - m(1, 2) * m(2, 1),
             m(1, 2) * m(2, 0) - m(1, 0) * m(2, 2),
             m(1, 0) * m(2, 1) - m(1, 1) * m(2, 0),
             m(0, 2) * m(2, 1) - m(0, 1) * m(2, 2),
             m(0, 0) * m(2, 2) - m(0, 2) * m(2, 0),
             m(0, 1) * m(2, 0) - m(0, 0) * m(2, 1),
             m(0, 1) * m(1, 2) - m(0, 2) * m(1, 1),
             m(0, 2) * m(1, 0) - m(0, 0) * m(1, 2),
             m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0)}};
  }

  /**
   * What the laws need of the displacement gradient, computed once for all of them.
   */
  template <typename Number>
  struct Deformation
  {
    Matrix3<Number> gradient;      ///< H = F - I
    Matrix3<Number> cofactor;      ///< cof H
    Number          divergence;    ///< tr H
    Number          higher_order;  ///< J - 1 - tr H = tr cof H + det H
    Number          volume_change; ///< J - 1
    Number          jacobian;      ///< J = det F; an inverted body has J <= 0

    explicit Deformation(const Matrix3<Number> &h)
      : gradient(h)
      , cofactor(cofactors(h))
      , divergence(trace(h))
      , higher_order(trace(cofactor) + h(0, 0) * cofactor(0, 0) + h(0, 1) * cofactor(0, 1) +
                     h(0, 2) * cofactor(0, 2))
      , volume_change(divergence + higher_order)
      , jacobian(1. + volume_change)
    {
    }

    /** cof F = (1 + tr H) I - H^T + cof H, which turns areas: J F^-T. */
    Matrix3<Number> area_map() const
    {
      Matrix3<Number> result;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          result(i, j) = cofactor(i, j) - gradient(j, i);
      for (int i = 0; i < 3; ++i)
        result(i, i) = result(i, i) + (1. + divergence);
      return result;
    }
  };

  /**
   * J C^-1 v = A^T A v / J with A = J F^-T: times the conductivity of the deformed body, the flux per area of
   * the reference body (but for its sign) that belongs to the gradient @p v there of a temperature.
   */
  template <typename Number>
  Vector3<Number> flux_in_reference(const Deformation<Number> &deformation, const Vector3<Number> &v)
  {
    const Matrix3<Number> area    = deformation.area_map();
    const Vector3<Number> turned  = area * v;
    const Number          inverse = 1. / deformation.jacobian;
    Vector3<Number>       result;
    for (int i = 0; i < 3; ++i)
      result[i] = inverse * (area(0, i) * turned[0] + area(1, i) * turned[1] + area(2, i) * turned[2]);
    return result;
  }

  /**
   * The second Piola-Kirchhoff stress S = F^-1 P of a first one, P, in Pa.
   */
  template <typename Number>
  Matrix3<Number> second_piola_kirchhoff_stress(const Deformation<Number> &deformation,
                                                const Matrix3<Number>     &first)
  {
    const Matrix3<Number> area = deformation.area_map();
    Matrix3<Number>       result;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        result(i, j) = (area(0, i) * first(0, j) + area(1, i) * first(1, j) + area(2, i) * first(2, j)) /
                       deformation.jacobian;
    return result;
  }

  /**
   * The Cauchy stress P F^T / J of a first Piola-Kirchhoff stress P, in Pa.
   */
  template <typename Number>
  Matrix3<Number> cauchy_stress(const Deformation<Number> &deformation, const Matrix3<Number> &first)
  {
    const Matrix3<Number> &h = deformation.gradient;
    Matrix3<Number>        result;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        result(i, j) = (first(i, j) + first(i, 0) * h(j, 0) + first(i, 1) * h(j, 1) + first(i, 2) * h(j, 2)) /
                       deformation.jacobian;
    return result;
  }
} // namespace Cautery
