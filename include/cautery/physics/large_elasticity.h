// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/inverted_cell.h>
#include <cautery/physics/outer_load.h>
#include <cautery/physics/supports.h>
#include <cautery/physics/tissue_elasticity.h>
#include <cautery/space/state.h>

#include <optional>

namespace Cautery
{
  /**
   * All that acts on a body at one moment.
   */
  struct Loading
  {
    Vector force;        ///< dead loads, N
    Vector prescribed;   ///< displacements where they are prescribed, elsewhere 0; m
    Vector temperature;  ///< K; empty without thermal expansion
    double heating = 1.; ///< what the thermal strain is multiplied with

    /** What acts when @p share of the way from @p from to @p to is done. */
    static Loading between(const Loading &from, const Loading &to, const double share);
  };

  /**
   * Equilibrium of a body in large deformation, by finite elements on the undeformed body: the residual
   * int P:grad(v) - F.v with the first Piola-Kirchhoff stress P of each tissue's ElasticLaw, and its tangent.
   * In two dimensions the strain is plane.
   *
   * Tetrahedra and triangles of degree 1 have one point of integration, hexahedra of degree 1 eight, with the
   * fibres' directions of the cell's centre: then the forces are those of explicit dynamics.
   */
  template <int dim>
  class LargeElasticity
  {
  public:
    /** @p displacement is the vector field on the nodes of @p nodes. Arguments must live as long as it.
     * Errors: ExcInput where nothing holds the body, or its laws do not fit. */
    LargeElasticity(const Scene             &scene,
                    const Field<dim>        &displacement,
                    const Field<dim>        &nodes,
                    const TissueMap<dim>    &tissues,
                    const BoundaryMap<dim>  &boundaries,
                    const PointLocator<dim> &locator);

    /** What acts at the state's time and temperature. */
    Loading loading(const State &state) const;
    /** The body at rest: no forces, no prescribed displacements, no thermal strain. */
    Loading unloaded(const State &state) const;

    /**
     * @p residual = inner forces - outer forces at @p displacement, N, condensed. Collective.
     * @return the inverted cell of the least J, if any: then the residual is of no use
     */
    std::optional<InvertedCell>
    find_residual(const Vector &displacement, const Loading &loading, Vector &residual) const;

    /** Inner less outer forces, N per unknown, not condensed. Collective. */
    Vector unbalanced_forces(const Vector &displacement, const Loading &loading) const;

    /** The norm of the inner forces of the last residual, with those at the supports, N. */
    double inner_forces() const { return inner_force_norm; }

    /**
     * Assembles the tangent d(residual)/d(displacement), condensed, at a displacement without inverted cells;
     * sets @p forces (N, condensed) to how the residual would change with the displacement @p moves (m; no
     * entries: none).
     */
    const SparseMatrix &
    find_tangent(const Vector &displacement, const Loading &loading, const Vector &moves, Vector &forces);

    const Supports<dim> &supports() const { return held; }
    const Field<dim>    &field() const { return displacement; }

  private:
    std::optional<InvertedCell>
    add_inner_forces(const Vector &displacement, const Loading &loading, Vector &forces) const;

    /// A point of integration.
    struct MaterialPoint
    {
      ElasticLaw             law;
      ElasticLaw::Directions directions;
      Matrix3<double>        gradient; ///< H
      double                 thermal_strain;
      bool                   can_invert; ///< its law knows J
    };

    template <typename Work>
    void for_each_cell(const Vector &x, const Loading &loading, const Work &work) const;

    const Field<dim>             &displacement;
    const Field<dim>             &nodes;
    const TissueMap<dim>         &tissues;
    const bool                    expands;
    Quadrature<dim>               quadrature;
    std::vector<TissueElasticity> elasticities; ///< by tissue
    const Supports<dim>           held;
    const OuterLoad<dim>          outer_load;
    SparseMatrix                  tangent;
    mutable double                inner_force_norm = 0.;
  };
} // namespace Cautery
