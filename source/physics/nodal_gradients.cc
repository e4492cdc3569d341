// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/nodal_gradients.h>

#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <map>

namespace Cautery
{
  namespace
  {
    /// The average at a node over its cells of one tissue, while it is being summed up.
    template <int dim>
    struct Average
    {
      double                                               volume = 0.;
      std::vector<std::pair<unsigned int, Tensor<1, dim>>> weights; ///< of a node, times volume

      void add(const unsigned int node, const Tensor<1, dim> &weight)
      {
        const auto found = std::find_if(
          weights.begin(), weights.end(), [node](const auto &entry) { return entry.first == node; });
        if (found != weights.end())
          found->second += weight;
        else
          weights.emplace_back(node, weight);
      }
    };
  } // namespace

  template <int dim>
  NodalGradients<dim>::NodalGradients(const Field<dim> &nodes, const TissueMap<dim> &tissues)
  {
    const Quadrature<dim>                at_nodes(nodes.element().get_unit_support_points());
    FEValues<dim>                        values(nodes.mapping(), nodes.element(), at_nodes, update_gradients);
    const unsigned int                   per_cell = nodes.element().n_dofs_per_cell();
    std::vector<types::global_dof_index> dofs(per_cell);
    std::map<std::pair<unsigned int, unsigned int>, Average<dim>> averages; // by (node, tissue)

    for (const auto &cell : nodes.dof_handler().active_cell_iterators())
      {
        if (cell->is_artificial())
          continue;
        cell->get_dof_indices(dofs);
        if (std::none_of(
              dofs.begin(), dofs.end(), [&](const auto dof) { return nodes.owned().is_element(dof); }))
          continue;
        values.reinit(cell);
        const double       volume = cell->measure();
        const unsigned int tissue = tissues.index(cell->material_id());
        for (unsigned int i = 0; i < per_cell; ++i)
          if (nodes.owned().is_element(dofs[i]))
            {
              const unsigned int node    = nodes.owned().index_within_set(dofs[i]);
              auto              &average = averages[{node, tissue}];
              average.volume += volume;
              for (unsigned int k = 0; k < per_cell; ++k)
                average.add(nodes.relevant().index_within_set(dofs[k]), volume * values.shape_grad(k, i));
            }
      }

    std::vector<double> node_volume(nodes.owned().n_elements(), 0.);
    for (const auto &[key, average] : averages)
      {
        all_pieces.push_back({key.first, key.second, average.volume});
        node_volume[key.first] += average.volume;
        for (const auto &[node, weight] : average.weights)
          weights.push_back({node, weight / average.volume});
        starts.push_back(weights.size());
      }
    for (auto &piece : all_pieces)
      piece.share /= node_volume[piece.node];
  }

  template <int dim>
  std::vector<double> NodalGradients<dim>::evaluate(const Field<dim> &field, const Vector &x) const
  {
    const unsigned int  n_components = field.n_components();
    const Vector        ghosted      = field.ghosted(x);
    std::vector<double> result(all_pieces.size() * n_components * dim, 0.);
    for (unsigned int piece = 0; piece < all_pieces.size(); ++piece)
      for (std::size_t k = starts[piece]; k < starts[piece + 1]; ++k)
        {
          // a vector with ghosts keeps its entries in the order of the relevant unknowns
          const double *const value = ghosted.begin() + weights[k].node * n_components;
          for (unsigned int c = 0; c < n_components; ++c)
            for (unsigned int d = 0; d < dim; ++d)
              result[(piece * n_components + c) * dim + d] += value[c] * weights[k].gradient[d];
        }
    return result;
  }

  template class NodalGradients<2>;
  template class NodalGradients<3>;
} // namespace Cautery
