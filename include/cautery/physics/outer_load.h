// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/space/assignment.h>
#include <cautery/space/field.h>
#include <cautery/space/points.h>

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

    /** The part that never changes, N per unknown. */
    const Vector &steady() const { return constant; }

    /**
     * Calls add(unknown, force), with the first of a node's unknowns and its force (N), for all that changes
     * in time and that this process has found, also for unknowns of other processes.
     */
    template <typename Add>
    void for_each_changing(const double time, const Add &add) const
    {
      for (const auto &load : changing)
        {
          Tensor<1, 3> value = load.density->value(load.places.front().place, time);
          for (const auto &place : load.places)
            {
              if (load.density->depends_on_place())
                value = load.density->value(place.place, time);
              for (const auto &[unknown, weight] : place.weights)
                add(unknown, weight * value);
            }
        }
    }

  private:
    using Weights = std::vector<std::pair<types::global_dof_index, double>>;
    struct Place
    {
      Point<3> place;   ///< m
      Weights  weights; ///< of the nodes, by their first unknowns: their shares of an area or of a force
    };
    /** An expression and where it acts. */
    struct Load
    {
      const VectorExpression *density; ///< Pa or N
      std::vector<Place>      places;
    };

    void add_gravity(const Point<3> &acceleration, const Field<dim> &nodes, const TissueMap<dim> &tissues);
    void add_traction(const Boundary                     &boundary,
                      const std::set<types::boundary_id> &surfaces,
                      const Field<dim>                   &nodes);
    void add_points(const std::vector<PointLoad> &loads, const PointLocator<dim> &locator);
    void add(Load load);
    static void gather(std::vector<Place> &places);

    const Field<dim> &displacement;
    Vector            constant; ///< N
    std::vector<Load> changing;
  };
} // namespace Cautery
