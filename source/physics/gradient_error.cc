// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/gradient_error.h>
#include <cautery/physics/gradient_sums.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace Cautery
{
  namespace
  {
    /// Relative to the field over the length of the body: gradients that rounding makes of a uniform field.
    constexpr double rounding = 1e-10;

    template <int dim>
    bool is_uniform(const Mesh<dim> &mesh, const Vector &x, const double gradient)
    {
      const auto  &corners = mesh.bounding_box().get_boundary_points();
      const double length  = corners.first.distance(corners.second);
      return gradient * length <= rounding * x.linfty_norm() * std::sqrt(mesh.volume());
    }
  } // namespace

  template <int dim>
  GradientError gradient_error(const Field<dim>     &nodes,
                               const TissueMap<dim> &tissues,
                               const Field<dim>     &field,
                               const Vector         &x)
  {
    GradientSums sums(nodes.mesh().triangulation().n_active_cells());
    if (nodes.element().degree == 1)
      add_linear_errors(nodes, tissues, field, x, sums);
    else
      add_quadratic_errors(nodes, tissues, field, x, sums);
    GradientError result;
    result.cells          = std::move(sums.cells);
    const double gradient = std::sqrt(Utilities::MPI::sum(sums.gradients, nodes.communicator()));
    if (is_uniform(nodes.mesh(), x, gradient))
      {
        result.cells = 0.;
        return result;
      }
    result.error    = std::sqrt(Utilities::MPI::sum(sums.errors, nodes.communicator()));
    result.gradient = gradient;
    return result;
  }

  template GradientError
  gradient_error(const Field<2> &, const TissueMap<2> &, const Field<2> &, const Vector &);
  template GradientError
  gradient_error(const Field<3> &, const TissueMap<3> &, const Field<3> &, const Vector &);
} // namespace Cautery
