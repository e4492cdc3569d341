// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/physics/balance.h>
#include <cautery/physics/time_error.h>

namespace Cautery
{
  /**
   * The local error of backward Euler, dt^2/2 x'' (or dt/2 (v - v_last) in equal steps), from the rates v of
   * two steps. The first step, and those next to a jump of the load, have no second rate to compare with:
   * they count as much as the step that follows them.
   */
  class RateDifference
  {
  public:
    /** @p rate is that of @p step. */
    void record(const Step &step, const Vector &rate, const Balance &balance);

    const TimeError &total() const { return sums; }

    /** @p like has the unknowns of the rate. */
    void archive(Archive &archive, const Vector &like);

  private:
    Step         last{0., 0.};
    Vector       last_rate;
    unsigned int waiting = 0; ///< steps without an estimate of their own
    TimeError    sums;
  };
} // namespace Cautery
