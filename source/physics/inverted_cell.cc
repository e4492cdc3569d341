// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/parameters.h>
#include <cautery/physics/inverted_cell.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <limits>

namespace Cautery
{
  std::string InvertedCell::message() const
  {
    return "cell " + std::to_string(cell) + " at " + to_short_text(place) +
           (jacobian > 0. ? " m is pressed to " + to_short_text(jacobian) + " of its volume" :
                            " m is turned inside out (J = " + to_short_text(jacobian) + ")");
  }

  std::optional<InvertedCell> worst_of_all(const std::optional<InvertedCell> &own,
                                           const MPI_Comm                     communicator)
  {
    const double none = std::numeric_limits<double>::infinity();
    // a J that is not a number is as bad as can be
    const double mine  = !own ? none : std::isnan(own->jacobian) ? -none : own->jacobian;
    const double least = Utilities::MPI::min(mine, communicator);
    if (least == none)
      return {};
    const CellNumber last = std::numeric_limits<CellNumber>::max();
    const CellNumber cell = Utilities::MPI::min(own && mine == least ? own->cell : last, communicator);
    InvertedCell     result{cell, Point<3>(), least};
    for (unsigned int d = 0; d < 3; ++d)
      result.place[d] = Utilities::MPI::min(own && own->cell == cell ? own->place[d] : none, communicator);
    return result;
  }
} // namespace Cautery
