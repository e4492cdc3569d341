// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/nodal_gradients.h>

#include <deal.II/fe/fe_values.h>

#include <map>

namespace Cautery
{
  template <int dim>
  NodalGradients<dim>::NodalGradients(const Field<dim> &nodes, const TissueMap<dim> &tissues)
    : nodes(nodes), per_cell(nodes.element().n_dofs_per_cell())
  {
    const Quadrature<dim>                at_nodes(nodes.element().get_unit_support_points());
    FEValues<dim>                        values(nodes.mapping(), nodes.element(), at_nodes, update_gradients);
    const bool                           constant = nodes.mesh().simplices() && nodes.element().degree == 1;
    std::vector<types::global_dof_index> dofs(per_cell);
    // the number of each (node, tissue), in the order of the map: sorted by node
    std::map<std::pair<unsigned int, unsigned int>, std::vector<std::pair<unsigned int, double>>> parts;

    for (const auto &cell : nodes.dof_handler().active_cell_iterators())
      {
        if (cell->is_artificial())
          continue;
        cell->get_dof_indices(dofs);
        const double       volume     = cell->measure();
        const unsigned int tissue     = tissues.index(cell->material_id());
        const unsigned int first_node = cell_nodes.size();
        bool               used       = false;
        for (unsigned int i = 0; i < per_cell; ++i)
          {
            if (!nodes.owned().is_element(dofs[i]))
              continue;
            if (!used)
              {
                values.reinit(cell);
                cell_nodes.insert(cell_nodes.end(), dofs.begin(), dofs.end());
              }
            if (!used || !constant) // on linear simplices one gradient serves all nodes
              for (unsigned int k = 0; k < per_cell; ++k)
                shape_gradients.push_back(values.shape_grad(k, i));
            used                    = true;
            const unsigned int node = nodes.owned().index_within_set(dofs[i]);
            parts[{node, tissue}].emplace_back(contributions.size(), volume);
            contributions.push_back(
              {0, first_node, static_cast<unsigned int>(shape_gradients.size()) - per_cell, volume});
          }
      }

    std::vector<double> node_volume(nodes.owned().n_elements(), 0.);
    for (const auto &[key, list] : parts)
      {
        double volume = 0.;
        for (const auto &[contribution, part] : list)
          volume += part;
        for (const auto &[contribution, part] : list)
          {
            contributions[contribution].piece  = all_pieces.size();
            contributions[contribution].weight = part / volume;
          }
        all_pieces.push_back({key.first, key.second, volume});
        node_volume[key.first] += volume;
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
    // values by node and component in the order of the ghosted vector's own memory
    std::vector<types::global_dof_index> indices;
    indices.reserve(cell_nodes.size() * n_components);
    for (const auto node : cell_nodes)
      for (unsigned int c = 0; c < n_components; ++c)
        indices.push_back(n_components * node + c);
    std::vector<double> values(indices.size());
    ghosted.extract_subvector_to(indices, values);

    for (const auto &part : contributions)
      for (unsigned int k = 0; k < per_cell; ++k)
        {
          const Tensor<1, dim> &gradient = shape_gradients[part.gradients + k];
          for (unsigned int c = 0; c < n_components; ++c)
            {
              const double value = part.weight * values[(part.cell + k) * n_components + c];
              for (unsigned int d = 0; d < dim; ++d)
                result[(part.piece * n_components + c) * dim + d] += value * gradient[d];
            }
        }
    return result;
  }

  template class NodalGradients<2>;
  template class NodalGradients<3>;
} // namespace Cautery
