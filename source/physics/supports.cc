// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/rigid_motions.h>
#include <cautery/physics/rollers.h>
#include <cautery/physics/supports.h>

namespace Cautery
{
  namespace
  {
    const Expression no_displacement(0.);

    const Expression *prescribed_displacement(const Boundary &boundary, const unsigned int component)
    {
      if (boundary.mechanical == Boundary::Mechanical::fixed)
        return &no_displacement;
      return boundary.mechanical == Boundary::Mechanical::displacement ? &boundary.displacement[component] :
                                                                         nullptr;
    }
  } // namespace

  template <int dim>
  Supports<dim>::Supports(const Scene            &scene,
                          const Field<dim>       &displacement,
                          const BoundaryMap<dim> &boundaries)
    : displacement(displacement), prescribed(displacement, boundaries, prescribed_displacement)
  {
    for (const Tool &tool : scene.tools)
      AssertThrow(prescribed.add_within(tool.centre, tool.radius, tool.displacement) > 0,
                  ExcInput("Tools/" + tool.name + ": no node of the body lies within " +
                           to_text(tool.radius) + " m of its Centre; move it, or take a larger Radius"));
    fixed.reinit(displacement.relevant());
    prescribed.constrain(fixed);
    fixed.merge(displacement.hanging_nodes());
    constrain_rollers(displacement, boundaries, fixed);
    fixed.close();
    eliminated.reinit(fixed, displacement.owned(), displacement.communicator());
  }

  /// Of what holds a body, a fixed surface holds it altogether; rollers may leave it a shift or a turn.
  template <int dim>
  void Supports<dim>::check_held(const Scene &scene) const
  {
    if (!scene.tools.empty())
      return;
    for (const auto &boundary : scene.boundaries)
      if (boundary.mechanical == Boundary::Mechanical::fixed ||
          boundary.mechanical == Boundary::Mechanical::displacement)
        return;
    const unsigned int n_free = n_free_rigid_motions(displacement, eliminated);
    AssertThrow(n_free == 0,
                ExcInput("Boundaries: the rollers leave the body " + std::to_string(n_free) +
                         " shifts or turns as a whole, so it has no equilibrium; hold them with Mechanical = "
                         "fixed, displacement or more rollers, or set Effects/Deformation = inertia"));
  }

  template class Supports<2>;
  template class Supports<3>;
} // namespace Cautery
