// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/space/elimination.h>
#include <cautery/space/field.h>

#include <vector>

namespace Cautery
{
  /** The shifts along each axis, then the turns about each axis (in the plane: one), as displacements. */
  template <int dim>
  std::vector<Vector> rigid_motions(const Field<dim> &displacement);

  /** Of how many rigid motions nothing in @p constraints holds the body. Collective. */
  template <int dim>
  unsigned int n_free_rigid_motions(const Field<dim> &displacement, const Elimination &constraints);
} // namespace Cautery
