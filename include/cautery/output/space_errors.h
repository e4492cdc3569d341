// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/gradient_error.h>
#include <cautery/space/state.h>

#include <map>
#include <string>

namespace Cautery
{
  /** By the name of the field: temperature, displacement. */
  using GradientErrors = std::map<std::string, GradientError>;

  /** Of all that is on; @p displacement: nullptr where deformation is off. Collective. */
  template <int dim>
  GradientErrors gradient_errors(const Field<dim>     &nodes,
                                 const TissueMap<dim> &tissues,
                                 const Field<dim>     *displacement,
                                 const State          &state);

  /** The name of a column of cells, with its unit. */
  std::string error_column(const std::string &field);

  /**
   * The error of a gradient over the gradient, both in the mean square over the body: when it was last looked
   * at, and the largest of all.
   */
  struct SpaceError
  {
    double last    = 0.;
    double largest = 0.;
  };

  using SpaceErrors = std::map<std::string, SpaceError>;

  void observe(const GradientErrors &now, SpaceErrors &errors);
} // namespace Cautery
