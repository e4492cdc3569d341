// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/fe/fe_values.h>

#include <vector>

namespace Cautery
{
  using namespace dealii;

  /**
   * The gradients of shape functions that make the change of volume in a cell: their own or, as a cure for
   * locking, their means over the cell (Nagtegaal, Parks and Rice 1974; Hughes 1980). The pressure is then
   * one number in each cell, and only the mean change of volume is resisted as Poisson's ratio nears 0.5.
   */
  template <int dim>
  class Dilatation
  {
  public:
    explicit Dilatation(const bool of_mean) : of_mean(of_mean) {}

    /** Goes to the cell that @p values is on. */
    void reinit(const FEValues<dim> &values)
    {
      if (!of_mean)
        return;
      double volume = 0.;
      means.assign(values.dofs_per_cell, Tensor<1, dim>());
      for (const unsigned int q : values.quadrature_point_indices())
        {
          volume += values.JxW(q);
          for (const unsigned int node : values.dof_indices())
            means[node] += values.shape_grad(node, q) * values.JxW(q);
        }
      for (auto &mean : means)
        mean /= volume;
    }

    /** Of shape function @p node at quadrature point @p q, in 1/m. */
    const Tensor<1, dim> &
    gradient(const FEValues<dim> &values, const unsigned int node, const unsigned int q) const
    {
      return of_mean ? means[node] : values.shape_grad(node, q);
    }

  private:
    const bool                  of_mean;
    std::vector<Tensor<1, dim>> means;
  };
} // namespace Cautery
