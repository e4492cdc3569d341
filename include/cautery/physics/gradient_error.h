// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/space/assignment.h>
#include <cautery/space/field.h>

#include <deal.II/lac/vector.h>

namespace Cautery
{
  /** How far the gradient of a field on a mesh is from the true one, by an indicator. */
  struct GradientError
  {
    dealii::Vector<float> cells;         ///< root mean square in each owned cell, in the field's unit per m
    double                error    = 0.; ///< its norm over the body, unit m^(dim/2 - 1)
    double                gradient = 0.; ///< that of the gradient itself

    double relative() const { return gradient > 0. ? error / gradient : 0.; }
  };

  /**
   * Estimates the error of the gradient of @p x on @p field, which has any number of components on @p nodes,
   * from a recovered one (Zienkiewicz and Zhu, Int. J. Numer. Methods Eng. 24, 1987): in each tissue by
   * itself, so that the gradient may jump where properties do. Collective.
   *
   * Degree 1: the gradient is averaged at the vertices over their cells by volume and interpolated; what it
   * differs by from the gradient in the cell is the error. Degree 2: that average would see nothing, since
   * the leading error of quadratic elements is the same from both sides of a common node. So third
   * derivatives are found instead, as the slope of the second ones at the centres of the cells around; they
   * make a cubic, and what quadratic interpolation leaves of it is the error.
   *
   * Exact to leading order for smooth fields on regular meshes; elsewhere an indicator. Nothing where the
   * field is uniform but for rounding.
   */
  template <int dim>
  GradientError gradient_error(const Field<dim>     &nodes,
                               const TissueMap<dim> &tissues,
                               const Field<dim>     &field,
                               const Vector         &x);
} // namespace Cautery
