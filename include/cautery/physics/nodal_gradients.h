// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/space/assignment.h>
#include <cautery/space/field.h>

#include <vector>

namespace Cautery
{
  /**
   * Gradients at the nodes, averaged over each node's cells by volume, separately for each tissue that meets
   * there: so a law can be applied tissue by tissue where properties jump. The average over a node's tissues
   * is `average`.
   *
   * The gradients of the shape functions are kept, because damage may ask at every step.
   */
  template <int dim>
  class NodalGradients
  {
  public:
    /// A node together with one of its tissues.
    struct Piece
    {
      unsigned int node; ///< local number among the owned nodes
      unsigned int tissue;
      double       share; ///< of the node's volume, 0 to 1
    };

    NodalGradients(const Field<dim> &nodes, const TissueMap<dim> &tissues);

    /** The pieces of this process, sorted by node. */
    const std::vector<Piece> &pieces() const { return all_pieces; }

    /**
     * The gradients d(x_c)/d(x_d) of the field @p x (any number of components on the same nodes), one for
     * each piece, at
     * [(piece * n_components + c) * dim + d].
     */
    std::vector<double> evaluate(const Field<dim> &field, const Vector &x) const;

  private:
    /// What one cell gives to one of its nodes.
    struct Contribution
    {
      unsigned int piece;
      unsigned int cell;      ///< into `cell_nodes`
      unsigned int gradients; ///< into `shape_gradients`: of all shape functions at this node
      double       weight;    ///< share of the piece's volume
    };

    const Field<dim>                    &nodes;
    const unsigned int                   per_cell;
    std::vector<Piece>                   all_pieces;
    std::vector<Contribution>            contributions;
    std::vector<types::global_dof_index> cell_nodes;
    std::vector<Tensor<1, dim>>          shape_gradients;
  };
} // namespace Cautery
