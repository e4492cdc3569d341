// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/space/assignment.h>
#include <cautery/space/field.h>

#include <deal.II/lac/vector.h>

#include <cmath>

namespace Cautery
{
  /**
   * What a GradientError is made of: squares over the owned cells, and the root mean square in each.
   */
  struct GradientSums
  {
    explicit GradientSums(const unsigned int n_cells) : cells(n_cells) {}

    void add(const unsigned int cell, const double volume, const double error, const double gradient)
    {
      cells(cell) = std::sqrt(error / volume);
      errors += error;
      gradients += gradient;
    }

    dealii::Vector<float> cells;
    double                errors = 0., gradients = 0.;
  };

  /** Adds the errors of the owned cells, of elements of degree 1: see gradient_error. Collective. */
  template <int dim>
  void add_linear_errors(const Field<dim>     &nodes,
                         const TissueMap<dim> &tissues,
                         const Field<dim>     &field,
                         const Vector         &x,
                         GradientSums         &sums);

  /** The same, of degree 2. */
  template <int dim>
  void add_quadratic_errors(const Field<dim>     &nodes,
                            const TissueMap<dim> &tissues,
                            const Field<dim>     &field,
                            const Vector         &x,
                            GradientSums         &sums);
} // namespace Cautery
