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
   * to find, so it is found anew now and then: the more seldom, the less it changes; and sooner the faster
   * the body moves and the more that has shortened it before.
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

    /** How many steps may be taken before the next look. */
    std::uint64_t steps_left() const { return next_look - n_steps; }

    void count_step() { ++n_steps; }

    std::uint64_t steps_taken() const { return n_steps; }

    unsigned int times_found() const { return n_found; }

    /** Finds it at @p values and @p time (s), which is for messages. Errors: see longest_step. Collective. */
    void find(const Records &values, const double time);

    /** Finds it anew if it is time, or if a motion as fast as @p rates has gone too far since. Collective. */
    void look(const Records &values, const Records &rates, const double time);

    void archive(Archive &archive);

  private:
    double largest_speed(const Records &rates) const;

    const ExplicitSettings  &settings;
    const TledNodes<Number> &nodes;
    CriticalStep<Number>     critical;
    double                   stable = 0.; ///< the bound that was found last, s
    double                   step   = std::numeric_limits<double>::max();
    std::uint64_t            interval; ///< after which it is found anew at the latest, steps
    std::uint64_t            n_steps = 0, next = 0;
    unsigned int             n_found   = 0;
    std::uint64_t            last_look = 0, next_look = 0;
    double                   may_move;   ///< how far a node may move until it is found anew, m
    double                   moved = 0.; ///< how far one may have moved since it was found, m
  };
} // namespace Cautery
