// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/linear_algebra.h>

#include <vector>

namespace Cautery
{
  /**
   * What lags behind makes the rounds of an iteration slow: with the last few of them, the direction is
   * combined that leaves the shortest one for the next (Anderson, J. ACM 12 (1965) 547-560).
   */
  class Acceleration
  {
  public:
    /** A new iteration begins. */
    void clear() { rounds.clear(); }

    /**
     * Changes the @p direction of a round that begins at @p iterate; where the combined one does not lead
     * down from the @p residual, it stays what it was. Collective.
     */
    void accelerate(const Vector &iterate, const Vector &residual, Vector &direction);

  private:
    struct Round
    {
      Vector iterate, direction;
    };
    std::vector<Round> rounds; ///< the last few
  };
} // namespace Cautery
