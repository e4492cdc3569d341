// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/space/nodal_transfer.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Cautery
{
  namespace
  {
    constexpr double rounding  = 1e-10; ///< in reference coordinates, and of shape functions
    constexpr double elsewhere = std::numeric_limits<double>::quiet_NaN();

    CellId without_last(const CellId &id)
    {
      const auto                      path = id.get_child_indices();
      const std::vector<std::uint8_t> parents(path.begin(), path.end() - 1);
      return CellId(id.get_coarse_cell_id(), parents);
    }

    CellId with(const CellId &id, const unsigned int child)
    {
      const auto                path = id.get_child_indices();
      std::vector<std::uint8_t> longer(path.begin(), path.end());
      longer.push_back(child);
      return CellId(id.get_coarse_cell_id(), longer);
    }

    /// The owners of all cells of the new mesh. Collective.
    template <int dim>
    std::map<CellId, unsigned int> owners(const Field<dim> &nodes)
    {
      std::vector<unsigned int> own;
      for (const auto &cell : nodes.mesh().triangulation().active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int word : cell->id().template to_binary<dim>())
            own.push_back(word);
      const auto                     all = Utilities::MPI::all_gather(nodes.communicator(), own);
      std::map<CellId, unsigned int> result;
      for (unsigned int process = 0; process < all.size(); ++process)
        for (std::size_t i = 0; i < all[process].size(); i += 4)
          result[CellId(CellId::binary_type{
            {all[process][i], all[process][i + 1], all[process][i + 2], all[process][i + 3]}})] = process;
      return result;
    }
  } // namespace

  template <int dim>
  NodalTransfer<dim>::NodalTransfer(const Field<dim> &from, const Field<dim> &to) : from(from), to(to)
  {
    make_rules();
    find_sources();
  }

  /// Rule 0: the same cell. 1 + c: the new cell is child c of the old one. 1 + n + c: the old one is child c.
  template <int dim>
  void NodalTransfer<dim>::make_rules()
  {
    const auto            &fe         = from.element();
    const auto            &places     = fe.get_unit_support_points();
    constexpr unsigned int n_children = GeometryInfo<dim>::max_children_per_cell;
    const auto             add        = [&](const auto &place_in_old) {
      Rule rule(places.size());
      for (unsigned int i = 0; i < places.size(); ++i)
        {
          const Point<dim> place = place_in_old(places[i]);
          if (!GeometryInfo<dim>::is_inside_unit_cell(place, rounding))
            continue;
          for (unsigned int j = 0; j < places.size(); ++j)
            if (const double weight = fe.shape_value(j, place); std::abs(weight) > rounding)
              rule[i].emplace_back(j, weight);
        }
      rules.push_back(rule);
    };
    add([](const Point<dim> &place) { return place; });
    for (unsigned int child = 0; child < n_children; ++child)
      add([child](const Point<dim> &place) {
        return GeometryInfo<dim>::child_to_cell_coordinates(place, child);
      });
    for (unsigned int child = 0; child < n_children; ++child)
      add([child](const Point<dim> &place) {
        return GeometryInfo<dim>::cell_to_child_coordinates(place, child);
      });
  }

  template <int dim>
  void NodalTransfer<dim>::find_sources()
  {
    constexpr unsigned int                      n_children = GeometryInfo<dim>::max_children_per_cell;
    const auto                                  owner      = owners(to);
    std::map<unsigned int, std::vector<CellId>> cells; // new ones, by receiving process
    for (const auto &cell : from.dof_handler().active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        const auto add = [&](const auto &found, const unsigned int rule) {
          sources[found->second].push_back({cell, rule});
          cells[found->second].push_back(found->first);
        };
        const CellId id = cell->id();
        if (const auto same = owner.find(id); same != owner.end())
          {
            add(same, 0);
            continue;
          }
        for (unsigned int child = 0; child < n_children; ++child)
          if (const auto part = owner.find(with(id, child)); part != owner.end())
            add(part, 1 + child);
        if (cell->level() > 0)
          if (const auto whole = owner.find(without_last(id)); whole != owner.end())
            add(whole, 1 + n_children + id.get_child_indices()[cell->level() - 1]);
      }
    find_targets(cells);
  }

  template <int dim>
  void NodalTransfer<dim>::find_targets(const std::map<unsigned int, std::vector<CellId>> &sent)
  {
    std::map<unsigned int, std::vector<unsigned int>> words;
    for (const auto &[process, ids] : sent)
      for (const CellId &id : ids)
        for (const unsigned int word : id.template to_binary<dim>())
          words[process].push_back(word);
    std::vector<types::global_dof_index> dofs(to.element().n_dofs_per_cell());
    for (const auto &[process, ids] : Utilities::MPI::some_to_some(to.communicator(), words))
      for (std::size_t i = 0; i < ids.size(); i += 4)
        {
          const CellId id(CellId::binary_type{{ids[i], ids[i + 1], ids[i + 2], ids[i + 3]}});
          const auto   cell = to.mesh().triangulation().create_cell_iterator(id);
          to.cell(typename Triangulation<dim>::active_cell_iterator(cell))->get_dof_indices(dofs);
          targets[process].push_back(dofs);
        }
  }

  namespace
  {
    /// Of one component; what is infinite at a node that counts is so here.
    double combine(const std::vector<std::pair<unsigned int, double>> &weights,
                   const std::vector<double>                          &of_cell,
                   const unsigned int                                  n_components,
                   const unsigned int                                  component)
    {
      double sum = 0.;
      for (const auto &[node, weight] : weights)
        {
          const double value = of_cell[node * n_components + component];
          if (!std::isfinite(value))
            return value;
          sum += weight * value;
        }
      return sum;
    }
  } // namespace

  template <int dim>
  Vector NodalTransfer<dim>::operator()(const Vector     &values,
                                        const Field<dim> &from_field,
                                        const Field<dim> &to_field) const
  {
    const unsigned int                   n       = to_field.n_components();
    const unsigned int                   n_nodes = from.element().n_dofs_per_cell();
    const Vector                         ghosted = from_field.ghosted(values);
    std::vector<types::global_dof_index> dofs(n_nodes);
    std::vector<double>                  of_cell(n_nodes * n);

    std::map<unsigned int, std::vector<double>> messages;
    for (const auto &[process, list] : sources)
      for (const Source &source : list)
        {
          source.cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < n_nodes; ++i)
            for (unsigned int c = 0; c < n; ++c)
              of_cell[i * n + c] = ghosted.begin()[from.relevant().index_within_set(dofs[i]) * n + c];
          for (const Weights &weights : rules[source.rule])
            for (unsigned int c = 0; c < n; ++c)
              messages[process].push_back(weights.empty() ? elsewhere : combine(weights, of_cell, n, c));
        }

    Vector result = to_field.vector();
    for (const auto &[process, numbers] : Utilities::MPI::some_to_some(to.communicator(), messages))
      {
        std::size_t next = 0;
        for (const auto &nodes : targets.at(process))
          for (const auto node : nodes)
            for (unsigned int c = 0; c < n; ++c, ++next)
              if (!std::isnan(numbers[next]) && to.owned().is_element(node))
                result.begin()[to.owned().index_within_set(node) * n + c] = numbers[next];
      }
    // what is infinite has no weighted mean
    Vector continuous = result;
    to_field.hanging().distribute(continuous);
    std::transform(continuous.begin(),
                   continuous.end(),
                   result.begin(),
                   result.begin(),
                   [](const double mean, const double own) { return std::isfinite(mean) ? mean : own; });
    return result;
  }

  template class NodalTransfer<2>;
  template class NodalTransfer<3>;
} // namespace Cautery
