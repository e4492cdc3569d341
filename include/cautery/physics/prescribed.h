// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/space/assignment.h>
#include <cautery/space/field.h>

#include <functional>
#include <map>
#include <vector>

namespace Cautery
{
  /**
   * The unknowns of a field whose values a scene prescribes on surfaces, one expression each. Where surfaces
   * with different values meet, the boundary that the scene names first holds. Hanging nodes follow.
   */
  template <int dim>
  class Prescribed
  {
  public:
    /** The expression for component @p component on @p boundary; nullptr: not prescribed there. */
    using Chooser = std::function<const Expression *(const Boundary &boundary, const unsigned int component)>;

    Prescribed(const Field<dim> &field, const BoundaryMap<dim> &boundaries, const Chooser &chooser);

    /** Prescribes the components of a displacement at the nodes within a sphere (m), but where a surface
     * does. Returns the number of nodes there, of all processes. Collective. */
    unsigned int
    add_within(const Point<3> &centre, const double radius, const VectorExpression &displacement);

    /** Adds a homogeneous constraint for each of them. */
    void constrain(AffineConstraints<double> &constraints) const;

    /** Sets the locally owned ones in @p x to their values at @p time (s), and hanging nodes to what follows.
     * Collective. */
    void set(const double time, Vector &x) const;

    bool contains(const types::global_dof_index unknown) const { return values.count(unknown) > 0; }

    /** Calls work(unknown, expression, place in m) for the locally owned ones. */
    template <typename Work>
    void for_each_owned(const Work &work) const
    {
      for (const auto &[unknown, value] : values)
        if (field.owned().is_element(unknown))
          work(unknown, *value.expression, value.place);
    }

    /** Are all of them zero at all times? */
    bool homogeneous() const;
    /** Does any of them change in time? */
    bool depends_on_time() const;

    /** Sum of @p x over the prescribed unknowns of all processes. */
    double sum(const Vector &x) const;

  private:
    struct Value
    {
      unsigned int      boundary;
      const Expression *expression;
      Point<3>          place; ///< m
    };

    const Field<dim>                        &field;
    std::map<types::global_dof_index, Value> values; ///< of the locally relevant unknowns
  };
} // namespace Cautery
