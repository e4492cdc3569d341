// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/space/field.h>

#include <map>
#include <vector>

namespace Cautery
{
  /**
   * Carries nodal values from a mesh to the one adapted from it (Mesh::Mesh), each cell of which is one of
   * the old cells, a part of one, or made of several. Where cells are divided the field stays what it was;
   * where they are merged it takes the old values at the nodes that remain. What is known at an old node
   * stays so there, also where the field jumps between cells of different sizes, as damage does, which
   * hanging nodes have of their own.
   *
   * The old cells' owners find the values for the new cells and send them to all who know these.
   */
  template <int dim>
  class NodalTransfer
  {
  public:
    /** Between scalar fields of the same degree, which must live as long as it. Collective. */
    NodalTransfer(const Field<dim> &from, const Field<dim> &to);

    /**
     * @p values on @p from_field, which has any number of components on the old nodes, for @p to_field on the
     * new ones. Where a value is infinite (no damage: -infinity), so is what is made of it. Hanging nodes
     * follow their larger neighbours. Collective.
     */
    Vector operator()(const Vector &values, const Field<dim> &from_field, const Field<dim> &to_field) const;

  private:
    using Weights = std::vector<std::pair<unsigned int, double>>; ///< of the nodes of a cell
    struct Source                                                 ///< of values for a new cell
    {
      typename DoFHandler<dim>::active_cell_iterator cell; ///< old
      CellId                                         target;
      unsigned int                                   rule; ///< in `rules`
    };
    /// What a node of the new cell is made of; empty: it lies in another old cell.
    using Rule = std::vector<Weights>;

    void make_rules();
    void find_sources();
    void find_targets();
    void receive(const std::map<unsigned int, std::vector<double>> &messages,
                 const Field<dim>                                  &to_field,
                 Vector                                            &result) const;

    const Field<dim>                           &from;
    const Field<dim>                           &to;
    std::vector<Rule>                           rules;   ///< same cell; parts 0, 1, ...; of which it is part
    std::map<unsigned int, std::vector<Source>> sources; ///< by receiving process
    struct Target                                        ///< a new cell
    {
      std::vector<types::global_dof_index> nodes;
      unsigned int                         rule; ///< by which its values were made
    };
    std::map<unsigned int, std::vector<Target>> targets; ///< by sending process, in its order
  };
} // namespace Cautery
