// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/prescribed.h>
#include <cautery/space/elimination.h>

namespace Cautery
{
  /**
   * What holds a body: prescribed displacements (zero on fixed surfaces, those of tools within) and rollers,
   * along the normals of the undeformed surface.
   */
  template <int dim>
  class Supports
  {
  public:
    /** Errors: ExcInput for a tool that holds no node. Collective. */
    Supports(const Scene &scene, const Field<dim> &displacement, const BoundaryMap<dim> &boundaries);

    /** Homogeneous. */
    const AffineConstraints<double> &constraints() const { return fixed; }
    const Elimination               &elimination() const { return eliminated; }

    const Prescribed<dim> &prescribed_displacements() const { return prescribed; }

    /** Sets the prescribed entries of @p x (m) to their values at @p time (s). */
    void prescribe(const double time, Vector &x) const { prescribed.set(time, x); }
    /** Do these values change in time? */
    bool prescription_changes() const { return prescribed.depends_on_time(); }
    /** Are there prescribed displacements other than zero? */
    bool move() const { return !prescribed.homogeneous(); }

    /** Errors: ExcInput where the body may shift or turn as a whole, so that it has no equilibrium.
     * Collective. */
    void check_held(const Scene &scene) const;

  private:
    const Field<dim>         &displacement;
    Prescribed<dim>           prescribed;
    AffineConstraints<double> fixed;
    Elimination               eliminated;
  };
} // namespace Cautery
