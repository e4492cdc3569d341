// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/timer.h>

#include <chrono>
#include <map>
#include <string>
#include <type_traits>

namespace Cautery
{
  using namespace dealii;

  /**
   * The ledger: parts named "effect: work" ("heat: solve", "output: fields"), which never nest, so that they
   * add up to the run's time; and what is built to stay, with its memory.
   *
   * deal.II's TimerOutput reduces over processes at the end of every section. That took as long as all else
   * in a step on a thousand nodes; here a scope costs two looks at the clock.
   */
  class Cost
  {
  public:
    /// Adds the time that it lives.
    class Scope
    {
    public:
      explicit Scope(double &sum) : sum(sum), start(Clock::now()) {}
      ~Scope() { sum += std::chrono::duration<double>(Clock::now() - start).count(); }
      Scope(const Scope &)            = delete;
      Scope &operator=(const Scope &) = delete;

    private:
      using Clock = std::chrono::steady_clock;
      double                 &sum;
      const Clock::time_point start;
    };

    /** Until the returned scope ends, time counts for @p part. Scopes must not overlap. */
    [[nodiscard]] Scope measure(const std::string &part) { return Scope(seconds[part]); }

    /** The result of @p make, whose time and memory count for @p part: of what is built once and stays.
     * Asking for the memory costs microseconds, too much for what is done in every step. */
    template <typename Make>
    std::invoke_result_t<Make> build(const std::string &part, const Make &make)
    {
      const Growth growth(bytes[effect_of(part)]);
      const auto   scope = measure(part);
      return make();
    }

    const std::map<std::string, double> &seconds_by_part() const { return seconds; } ///< s
    /** Parts summed over what stands before the colon. */
    std::map<std::string, double> seconds_by_effect() const; ///< s
    /** What has been built, on this process. */
    const std::map<std::string, double> &bytes_by_effect() const { return bytes; } ///< bytes
    double                               wall_seconds() const;                     ///< since construction, s
    double                               processor_seconds() const; ///< the same of this process
    static double                        peak_memory();             ///< of this process, bytes
    /** From now on `peak_memory` knows nothing of what was before, where the system allows that. */
    static void forget_peak_memory();

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

    std::map<std::string, double> seconds;
    std::map<std::string, double> bytes; ///< by effect
    Timer                         total;
  };
} // namespace Cautery
