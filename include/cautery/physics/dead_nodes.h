// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/archive.h>
#include <cautery/space/field.h>

namespace Cautery
{
  /**
   * Which nodes are dead (Omega >= 1) as far as perfusion has been told, where it stops in dead tissue.
   */
  class DeadNodes
  {
  public:
    /** Takes over the damage ln Omega of the process's own nodes. True if another node is dead now, on
     * whatever process. Collective. */
    bool update(const Vector &ln_damage);

    /** What update() was given when a node last died; empty before its first call. */
    const Vector &ln_damage() const { return known; }

    /** @p like has the layout of the nodes. Collective where it brings back. */
    void archive(Archive &archive, const Vector &like);

  private:
    Vector known;
  };
} // namespace Cautery
