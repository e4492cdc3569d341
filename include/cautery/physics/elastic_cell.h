// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/dilatation.h>
#include <cautery/scene/tissue.h>
#include <cautery/space/field.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace Cautery
{
  /**
   * What one cell gives to the balance of momentum (thesis Eqs. 4-9 to 4-15 and 4-25): matrices and vectors
   * of its unknowns.
   */
  template <int dim>
  class ElasticCellTerms
  {
  public:
    /** @p mean_dilatation: see Dilatation. */
    ElasticCellTerms(const Field<dim> &displacement, const Field<dim> &nodes, const bool mean_dilatation);

    /**
     * Goes to a cell, given as the vector field sees it, whose tissue has the @p temperature (with ghosts),
     * or nullptr for its reference temperature.
     */
    void reinit(const typename DoFHandler<dim>::active_cell_iterator &cell,
                const Tissue                                         &tissue,
                const Vector                                         *temperature);

    /** Fills `stiffness` (N/m), of a body that is stretched by heat in the form that the tissue asks for, and
     * `thermal_load` (N), with which heat drives it apart. */
    void add_stiffness(const Tissue &tissue);
    /** Fills `mass` (kg). */
    void add_mass(const Tissue &tissue);

    std::vector<types::global_dof_index> dofs;
    FullMatrix<double>                   stiffness, mass;
    dealii::Vector<double>               thermal_load;

  private:
    const FiniteElement<dim> &element;
    const Field<dim>         &nodes;
    FEValues<dim>             values;
    Dilatation<dim>           dilatation;
    std::vector<double>       temperatures; ///< at quadrature points, K
  };
} // namespace Cautery
