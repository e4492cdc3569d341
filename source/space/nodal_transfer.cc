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

    using Readers = std::map<CellId, std::vector<unsigned int>>;

    /// The processes that know a cell of the new mesh, as their own or a ghost: the owner of a node hears
    /// from all cells around it. Collective.
    template <int dim>
    Readers readers(const Field<dim> &nodes)
    {
      std::vector<unsigned int> known;
      for (const auto &cell : nodes.mesh().triangulation().active_cell_iterators())
        if (!cell->is_artificial())
          for (const unsigned int word : cell->id().template to_binary<dim>())
            known.push_back(word);
      const auto all = Utilities::MPI::all_gather(nodes.communicator(), known);
      Readers    result;
      for (unsigned int process = 0; process < all.size(); ++process)
        for (std::size_t i = 0; i < all[process].size(); i += 4)
          result[CellId(CellId::binary_type{
                   {all[process][i], all[process][i + 1], all[process][i + 2], all[process][i + 3]}})]
            .push_back(process);
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
    constexpr unsigned int n_children = GeometryInfo<dim>::max_children_per_cell;
    const auto             known      = readers(to);
    for (const auto &cell : from.dof_handler().active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        const auto add = [&](const auto &found, const unsigned int rule) {
          for (const unsigned int process : found->second)
            sources[process].push_back({cell, found->first, rule});
        };
        const CellId id = cell->id();
        if (const auto same = known.find(id); same != known.end())
          {
            add(same, 0);
            continue;
          }
        for (unsigned int child = 0; child < n_children; ++child)
          if (const auto part = known.find(with(id, child)); part != known.end())
            add(part, 1 + child);
        if (cell->level() > 0)
          if (const auto whole = known.find(without_last(id)); whole != known.end())
            add(whole, 1 + n_children + id.get_child_indices()[cell->level() - 1]);
      }
    find_targets();
  }

  template <int dim>
  void NodalTransfer<dim>::find_targets()
  {
    std::map<unsigned int, std::vector<unsigned int>> words; // of cells, each followed by its rule
    for (const auto &[process, list] : sources)
      for (const Source &source : list)
        {
          for (const unsigned int word : source.target.template to_binary<dim>())
            words[process].push_back(word);
          words[process].push_back(source.rule);
        }
    std::vector<types::global_dof_index> dofs(to.element().n_dofs_per_cell());
    for (const auto &[process, ids] : Utilities::MPI::some_to_some(to.communicator(), words))
      for (std::size_t i = 0; i < ids.size(); i += 5)
        {
          const CellId id(CellId::binary_type{{ids[i], ids[i + 1], ids[i + 2], ids[i + 3]}});
          const auto   cell = to.mesh().triangulation().create_cell_iterator(id);
          to.cell(typename Triangulation<dim>::active_cell_iterator(cell))->get_dof_indices(dofs);
          targets[process].push_back({dofs, ids[i + 4]});
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
    receive(Utilities::MPI::some_to_some(to.communicator(), messages), to_field, result);
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

  /// @p messages: by sending process, the components at the nodes of its targets.
  template <int dim>
  void NodalTransfer<dim>::receive(const std::map<unsigned int, std::vector<double>> &messages,
                                   const Field<dim>                                  &to_field,
                                   Vector                                            &result) const
  {
    const unsigned int n = to_field.n_components();
    std::vector<bool>  known(to.owned().n_elements(), false); // at an old node
    for (const auto &[process, numbers] : messages)
      {
        auto number = numbers.begin();
        for (const Target &target : targets.at(process))
          for (unsigned int i = 0; i < target.nodes.size(); ++i, number += n)
            {
              if (std::isnan(*number) || !to.owned().is_element(target.nodes[i]))
                continue;
              const auto own = to.owned().index_within_set(target.nodes[i]);
              if (known[own])
                continue;
              known[own] = rules[target.rule][i].size() == 1;
              std::copy_n(number, n, result.begin() + own * n);
            }
      }
  }

  template class NodalTransfer<2>;
  template class NodalTransfer<3>;
} // namespace Cautery
