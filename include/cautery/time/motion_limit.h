// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/archive.h>
#include <cautery/physics/critical_step.h>
#include <cautery/scene/explicit_settings.h>

#include <cstdint>
#include <limits>
#include <string>

namespace Cautery
{
  /**
   * The longest step that is to be taken, s: what the scene has @p given in @p entry, or if that is 0 the @p
   * share of what is @p stable. Throws where it is longer than that and the scene does not insist: ExcInput
   * at the start, ExcRun later.
   */
  double longest_step(const ExplicitSettings &settings,
                      const double            given,
                      const double            stable,
                      const double            share,
                      const std::string      &entry,
                      const double            time);

  /**
   * How long steps of motion may be. It changes as fibres stiffen and cells shrink, and costs some 25 steps
   * to find, so it is found anew now and then: the more seldom, the less it changes.
   */
  template <typename Number>
  class MotionLimit
  {
  public:
    using Records = typename TledNodes<Number>::Records;

    /** @p masses of the process's own nodes, kg. Arguments but these must live as long as it. */
    MotionLimit(const ExplicitSettings    &settings,
                TledBody<Number>          &body,
                TledNodes<Number>         &nodes,
                const std::vector<double> &masses);

    double longest() const { return step; } ///< s

    /** How many steps may be taken before it must be found anew. */
    std::uint64_t steps_left() const { return next - n_steps; }

    void count_step() { ++n_steps; }

    std::uint64_t steps_taken() const { return n_steps; }

    unsigned int times_found() const { return n_found; }

    /** Finds it at @p values and @p time (s), which is for messages. Errors: see longest_step. Collective. */
    void find(const Records &values, const double time);

    void archive(Archive &archive);

  private:
    const ExplicitSettings &settings;
    CriticalStep<Number>    critical;
    double                  stable = 0.; ///< the bound that was found last, s
    double                  step   = std::numeric_limits<double>::max();
    std::uint64_t           interval; ///< between two looks, steps
    std::uint64_t           n_steps = 0, next = 0;
    unsigned int            n_found = 0;
  };
} // namespace Cautery
