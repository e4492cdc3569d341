// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/space/assignment.h>
#include <cautery/space/field.h>

#include <deal.II/lac/affine_constraints.h>

namespace Cautery
{
  /**
   * Adds to @p constraints that nodes on surfaces with the condition "roller" do not move along the normal.
   * Where the faces around a node meet at a sharp edge each side of it counts, so that at the corner of a box
   * nothing moves; where they turn less, as on a curved surface, their mean normal counts. Nodes that are
   * constrained already are left alone.
   *
   * (VectorTools::compute_no_normal_flux_constraints tells an edge from a curve by whether one cell touches
   * both sides. On tetrahedra that often fails, and it takes the mean normal at the edges of a box.)
   */
  template <int dim>
  void constrain_rollers(const Field<dim>          &displacement,
                         const BoundaryMap<dim>    &boundaries,
                         AffineConstraints<double> &constraints);
} // namespace Cautery
