// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/cost.h>
#include <cautery/physics/explicit_heat.h>
#include <cautery/physics/explicit_motion.h>
#include <cautery/time/integrator.h>
#include <cautery/time/motion_limit.h>

#include <memory>

namespace Cautery
{
  /**
   * Central differences of motion and forward steps of heat, both without matrices (thesis 7.3.2). Motion and
   * heat take steps of their own lengths within a step of the scene: heat's divide it, motion's divide
   * heat's. While motion goes on, the temperature runs straight from one heat step to the next. Where both
   * lengths are the same, one sweep over the cells finds forces and heat flow.
   */
  template <typename Number>
  class CentralDifference : public Integrator
  {
  public:
    using Records = typename TledNodes<Number>::Records;

    /** @p motion, @p heat: nullptr where the scene has it not, or where another integrator does it. Arguments
     * must live as long as it. */
    CentralDifference(const Scene            &scene,
                      const Field<3>         &field,
                      TledBody<Number>       &body,
                      TledNodes<Number>      &nodes,
                      ExplicitMotion<Number> *motion,
                      ExplicitHeat<Number>   *heat,
                      Cost                   &cost);

    /** Begins at @p state; ExcInput for steps that are not stable. */
    void start(const State &state);

    /** A step of motion, heat or both, at most of the length Time/Step. */
    void step(State &state, const double stop) override;

    void archive(Archive &archive, const State &state) override;

    /** Motion alone over @p step, at the end of which @p state holds the temperature that another integrator
     * has found; its displacement is what was before. */
    void follow(const Step &step, State &state);

    std::map<std::string, double> statistics() const override;

  private:
    using Part = typename TledBody<Number>::Part;

    void advance_all(const Step &whole);
    void begin_heat_step(const Step &step);
    void advance(const Step &step);
    void move(const Step &step);
    void move_once(const Step &step, const Part part);
    void
    take_step(const double duration, const Part part, const Records &keep_share, const Records &gain_share);
    void set_motion_step(const double duration);
    void fill_motion();
    void set_heat_step(const double duration);
    void write(State &state) const;

    /// Further than any node should go, m.
    double far() const { return 1e3 * field.mesh().bounding_box().side_length(0); }

    void         find_heat_limit(const double time);
    void         renew_heat_limit(const double time);
    void         renew_limit_in_time(const double time);
    void         check_healthy(const bool healthy, const double time) const;
    unsigned int n_parts(const double length, const double longest, const double time) const;

    const Scene            &scene;
    const ExplicitSettings &settings;
    const Field<3>         &field;
    TledBody<Number>       &body;
    TledNodes<Number>      &nodes;
    ExplicitMotion<Number> *motion;
    ExplicitHeat<Number>   *heat;
    Cost                   &cost;

    std::unique_ptr<MotionLimit<Number>> motion_limit;

    Records values, rates, forces, loads, exchange;
    Records keep, gain;             ///< of a step of both
    Records drift_keep, drift_gain; ///< of a step of motion in which the temperature's rate stays

    double last_motion_step = 0.; ///< s
    double motion_mean      = 0.; ///< the duration that the coefficients are for, s
    double heat_duration    = 0.;
    double longest_heat     = std::numeric_limits<double>::max(); ///< s

    std::uint64_t n_heat_steps      = 0;
    unsigned int  motion_limit_seen = 0; ///< how often it had been found when that of heat was
  };
} // namespace Cautery
