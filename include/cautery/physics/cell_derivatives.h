// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/space/assignment.h>
#include <cautery/space/field.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <vector>

namespace Cautery
{
  /// Derivatives of order @p rank of all components in a cell, at some places.
  template <int dim, int rank>
  class CellDerivatives
  {
  public:
    CellDerivatives(const Field<dim>      &nodes,
                    const Field<dim>      &field,
                    const Vector          &x,
                    const Quadrature<dim> &places)
      : nodes(nodes)
      , n_components(field.n_components())
      , ghosted(field.ghosted(x))
      , at(nodes.mapping(), nodes.element(), places, rank == 1 ? update_gradients : update_hessians)
      , dofs(nodes.element().n_dofs_per_cell())
      , of_nodes(dofs.size() * n_components)
      , derivatives(places.size() * n_components)
    {
    }

    void reinit(const typename DoFHandler<dim>::active_cell_iterator &cell)
    {
      at.reinit(cell);
      cell->get_dof_indices(dofs);
      for (unsigned int i = 0; i < dofs.size(); ++i)
        {
          // a vector with ghosts keeps its entries in the order of the relevant unknowns
          const auto node = nodes.relevant().index_within_set(dofs[i]);
          for (unsigned int c = 0; c < n_components; ++c)
            of_nodes[i * n_components + c] = ghosted.begin()[node * n_components + c];
        }
      for (const unsigned int q : at.quadrature_point_indices())
        for (unsigned int c = 0; c < n_components; ++c)
          {
            Tensor<rank, dim> &sum = derivatives[q * n_components + c];
            sum                    = 0.;
            for (unsigned int i = 0; i < dofs.size(); ++i)
              if constexpr (rank == 1)
                sum += of_nodes[i * n_components + c] * at.shape_grad(i, q);
              else
                sum += of_nodes[i * n_components + c] * at.shape_hessian(i, q);
          }
    }

    const Tensor<rank, dim> &operator()(const unsigned int place, const unsigned int component) const
    {
      return derivatives[place * n_components + component];
    }

  private:
    const Field<dim>                    &nodes;
    const unsigned int                   n_components;
    const Vector                         ghosted;
    FEValues<dim>                        at;
    std::vector<types::global_dof_index> dofs;
    std::vector<double>                  of_nodes;
    std::vector<Tensor<rank, dim>>       derivatives;
  };

  /** One point, at the centre of a cell. */
  template <int dim>
  Quadrature<dim> cell_centre(const Mesh<dim> &mesh)
  {
    if (mesh.simplices())
      return QGaussSimplex<dim>(1);
    return QGauss<dim>(1);
  }

  /// The place of a vertex and the tissue of a cell in arrays of all of these.
  template <int dim>
  std::size_t vertex_slot(const Field<dim>                                     &nodes,
                          const TissueMap<dim>                                 &tissues,
                          const typename DoFHandler<dim>::active_cell_iterator &cell,
                          const unsigned int                                    v)
  {
    return nodes.relevant().index_within_set(cell->vertex_dof_index(v, 0)) * tissues.size() +
           tissues.index(cell->material_id());
  }
} // namespace Cautery
