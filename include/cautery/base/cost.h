// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/timer.h>

#include <map>
#include <string>

namespace Cautery
{
  using namespace dealii;

  /**
   * The ledger of wall time: parts named "effect: work" ("heat: solve", "output: fields"), which never nest,
   * so that they add up to the run's time.
   */
  class Cost
  {
  public:
    Cost();

    /** Until the returned scope ends, time counts for @p part. Scopes must not overlap. */
    [[nodiscard]] TimerOutput::Scope measure(const std::string &part) { return {timer, part}; }

    std::map<std::string, double> seconds_by_part() const; ///< s
    /** Parts summed over what stands before the colon. */
    std::map<std::string, double> seconds_by_effect() const; ///< s
    double                        wall_seconds() const;      ///< since construction, s
    static double                 peak_memory();             ///< of this process, bytes

  private:
    mutable TimerOutput timer;
    Timer               total;
  };
} // namespace Cautery
