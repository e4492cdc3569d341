// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/dead_nodes.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace Cautery
{
  bool DeadNodes::update(const Vector &ln_damage)
  {
    const bool first = known.size() == 0;
    const bool died =
      first ||
      !std::equal(known.begin(), known.end(), ln_damage.begin(), [](const double before, const double now) {
        return (before >= 0.) == (now >= 0.);
      });
    if (Utilities::MPI::logical_or(died, ln_damage.get_mpi_communicator()))
      {
        known = ln_damage;
        return true;
      }
    return false;
  }

  void DeadNodes::archive(Archive &archive, const Vector &like)
  {
    bool is_known = known.size() > 0;
    archive.shared("dead nodes are known", is_known);
    if (is_known && archive.restores())
      known.reinit(like);
    archive.nodal("damage when a node last died", known);
  }
} // namespace Cautery
