// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/space/cell_number.h>

#include <deal.II/base/point.h>

#include <optional>
#include <string>

namespace Cautery
{
  /** A cell that a displacement turns inside out, or presses most. */
  struct InvertedCell
  {
    CellNumber cell;     ///< in the undistributed mesh
    Point<3>   place;    ///< centre of the undeformed cell, m
    double     jacobian; ///< the least J = det F in it

    /** "cell 3 at 0, 0, 0 m is turned inside out (J = -1)", or how far it is pressed. */
    std::string message() const;
  };

  /** Of those that the processes found, the worst. Collective. */
  std::optional<InvertedCell> worst_of_all(const std::optional<InvertedCell> &own,
                                           const MPI_Comm                     communicator);
} // namespace Cautery
