// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/timer.h>

#include <map>
#include <string>
#include <type_traits>

namespace Cautery
{
  using namespace dealii;

  /**
   * The ledger: parts named "effect: work" ("heat: solve", "output: fields"), which never nest, so that they
   * add up to the run's time; and what is built to stay, with its memory.
   */
  class Cost
  {
  public:
    Cost();

    /** Until the returned scope ends, time counts for @p part. Scopes must not overlap. */
    [[nodiscard]] TimerOutput::Scope measure(const std::string &part) { return {timer, part}; }

    /** The result of @p make, whose time and memory count for @p part: of what is built once and stays.
     * Asking for the memory costs microseconds, too much for what is done in every step. */
    template <typename Make>
    std::invoke_result_t<Make> build(const std::string &part, const Make &make)
    {
      const Growth growth(bytes[effect_of(part)]);
      const auto   scope = measure(part);
      return make();
    }

    std::map<std::string, double> seconds_by_part() const; ///< s
    /** Parts summed over what stands before the colon. */
    std::map<std::string, double> seconds_by_effect() const; ///< s
    /** What has been built, on this process. */
    std::map<std::string, double> bytes_by_effect() const { return bytes; } ///< bytes
    double                        wall_seconds() const;                     ///< since construction, s
    static double                 peak_memory();                            ///< of this process, bytes

  private:
    /// Adds what the heap grows by as long as this lives.
    class Growth
    {
    public:
      explicit Growth(double &sum);
      ~Growth();

    private:
      double      &sum;
      const double before;
    };
    static std::string effect_of(const std::string &part) { return part.substr(0, part.find(':')); }

    mutable TimerOutput           timer;
    Timer                         total;
    std::map<std::string, double> bytes;
  };
} // namespace Cautery
