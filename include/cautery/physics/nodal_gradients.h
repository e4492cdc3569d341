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
   * Kept as a sparse matrix from nodal values to gradients, because damage may ask at every step.
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
    /// What the value at one node gives to a piece's gradient.
    struct Weight
    {
      unsigned int   node; ///< among the relevant ones
      Tensor<1, dim> gradient;
    };

    std::vector<Piece>       all_pieces;
    std::vector<std::size_t> starts = {0}; ///< of each piece in `weights`
    std::vector<Weight>      weights;
  };
} // namespace Cautery
