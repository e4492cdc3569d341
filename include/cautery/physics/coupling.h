// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/space/assignment.h>
#include <cautery/space/field.h>

namespace Cautery
{
  /**
   * Linear thermal expansion with constant coefficients: the force int beta (T - T_0) div v on the tissue,
   * beta = 3 K alpha (thesis Eq. 4-15).
   */
  template <int dim>
  class ThermalExpansionOperator
  {
  public:
    /** @p mean_dilatation: see Dilatation. */
    ThermalExpansionOperator(const Field<dim>     &displacement,
                             const Field<dim>     &nodes,
                             const TissueMap<dim> &tissues,
                             const bool            mean_dilatation = false);

    /** Adds the force (N per unknown) of @p temperature (K). */
    void add_force(const Vector &temperature, Vector &force) const;

    /** The force of a change of temperature. */
    void force_of_change(const Vector &temperature_change, Vector &force) const;

  private:
    SparseMatrix   matrix;
    const double   common_reference; ///< the first tissue's T_0, K
    Vector         reference;        ///< int beta (T_0 - common reference) div v
    mutable Vector excess, product;
  };

  /**
   * What deformation does to heat: int beta T_0 div(u') N is consumed (thesis Eq. 4-22), in the non-Fourier
   * model also tau times its rate (Eq. 6-8).
   */
  template <int dim>
  class ThermoelasticFeedback
  {
  public:
    ThermoelasticFeedback(const Field<dim>     &nodes,
                          const Field<dim>     &displacement,
                          const TissueMap<dim> &tissues,
                          const bool            non_fourier,
                          const bool            mean_dilatation = false);

    /** W per node, of the rate of displacement (m/s). */
    const SparseMatrix &matrix() const { return feedback; }
    /** The same times tau; empty for Fourier. */
    const SparseMatrix &relaxed_matrix() const { return relaxed; }
    bool                relaxes() const { return non_fourier; }

  private:
    const bool   non_fourier;
    SparseMatrix feedback;
    SparseMatrix relaxed;
  };
} // namespace Cautery
