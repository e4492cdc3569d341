// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/scene/adaptive_settings.h>
#include <cautery/space/mesh.h>

#include <deal.II/lac/vector.h>

#include <vector>

namespace Cautery
{
  /** What a mesh is adapted to: the error of a gradient of a field of some degree. */
  struct IndicatedError
  {
    const dealii::Vector<float> &cells;    ///< root mean square in each owned cell
    double                       gradient; ///< norm of the gradient over the body
  };

  /**
   * Which cells are divided and which are merged, so that the error comes to the target with few cells. Where
   * the target is missed, the worst cells are divided: as few as it takes, and no more than hold four fifths
   * of the square of the error. The best ones are merged, as far as the error that they should have then
   * leaves some distance to the target. One entry for each active cell of the process; empty if nothing
   * changes on any. The same for any number of processes. Collective.
   */
  template <int dim>
  std::vector<CellChange> cell_changes(const Mesh<dim>                   &mesh,
                                       const unsigned int                 degree,
                                       const std::vector<IndicatedError> &errors,
                                       const AdaptiveSettings            &settings);
} // namespace Cautery
