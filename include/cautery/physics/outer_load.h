// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/space/assignment.h>
#include <cautery/space/field.h>
#include <cautery/space/points.h>

#include <optional>
#include <vector>

namespace Cautery
{
  /**
   * The forces that act on a body from outside: gravity, tractions on surfaces, forces at points. All of them
   * are dead: in large deformation they keep their direction and act on the areas of the undeformed body.
   */
  template <int dim>
  class OuterLoad
  {
  public:
    /** Arguments must live as long as it. Errors: ExcInput for a force at a point outside the body. */
    OuterLoad(const Scene             &scene,
              const Field<dim>        &displacement,
              const Field<dim>        &nodes,
              const TissueMap<dim>    &tissues,
              const BoundaryMap<dim>  &boundaries,
              const PointLocator<dim> &locator);

    /** Sets @p force (N per unknown) to the load at @p time (s). */
    void at(const double time, Vector &force) const;

  private:
    void assemble(const double time, Vector &force) const;
    void add_point_loads(const double time, Vector &force) const;

    const Scene                                                     &scene;
    const Field<dim>                                                &displacement;
    const Field<dim>                                                &nodes;
    const TissueMap<dim>                                            &tissues;
    const BoundaryMap<dim>                                          &boundaries;
    bool                                                             changes = false;
    Vector                                                           at_start; ///< at t = 0, N
    std::vector<std::optional<typename PointLocator<dim>::Location>> places;
  };
} // namespace Cautery
