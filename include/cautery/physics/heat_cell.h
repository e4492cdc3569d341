// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/scene/scene.h>
#include <cautery/space/assignment.h>
#include <cautery/space/field.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace Cautery
{
  /**
   * The terms of the heat balance on one cell, by shape function, and the state there that they depend on.
   */
  template <int dim>
  class HeatCellTerms
  {
  public:
    HeatCellTerms(const Scene &scene, const Field<dim> &field);

    /** Begins a cell: all terms are zero, the state is that of the vectors given (nullptr: not needed). */
    void reinit(const typename DoFHandler<dim>::active_cell_iterator &cell,
                const Vector                                         *before,
                const Vector                                         *now,
                const Vector                                         *ln_damage);

    void add_volume(const Tissue &tissue);
    void add_metabolism(const Tissue &tissue);
    void add_surfaces(const typename DoFHandler<dim>::active_cell_iterator &cell,
                      const BoundaryMap<dim>                               &boundaries);

    /** Row sums of capacity, its excess and exchange, on the diagonal. */
    void lump();

    std::vector<types::global_dof_index> dofs;
    FullMatrix<double>                   capacity;          ///< int rho C N N
    FullMatrix<double>                   capacity_excess;   ///< int rho (C(T) - mean C) N N
    FullMatrix<double>                   exchange;          ///< int w N N + int h N N
    FullMatrix<double>                   conduction;        ///< int k grad N grad N
    dealii::Vector<double>               blood_weights;     ///< int w N
    dealii::Vector<double>               blood_source;      ///< int w T_b N
    dealii::Vector<double>               surface_weights;   ///< int h N
    dealii::Vector<double>               metabolism;        ///< int Q_m N
    dealii::Vector<double>               metabolism_growth; ///< its change over the step

  private:
    double living_share(const unsigned int q) const;

    const Effects      &effects;
    FEValues<dim>       values;
    FEFaceValues<dim>   face_values;
    std::vector<double> temperature_before; ///< at the quadrature points, K
    std::vector<double> temperature_now;    ///< K
    std::vector<double> ln_damage;          ///< at the nodes
  };
} // namespace Cautery
