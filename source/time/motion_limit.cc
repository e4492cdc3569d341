// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/time/motion_limit.h>

#include <algorithm>
#include <cmath>

namespace Cautery
{
  namespace
  {
    constexpr std::uint64_t first_interval = 20, shortest_interval = 10, longest_interval = 800;
    /// Relative changes from one look to the next. The safety factor must cover the larger one.
    constexpr double hardly = 0.01, much = 0.04;
  } // namespace

  double longest_step(const ExplicitSettings &settings,
                      const double            given,
                      const double            stable,
                      const double            share,
                      const std::string      &entry,
                      const double            time)
  {
    if (given == 0.)
      return share * stable;
    if (given <= stable || settings.unstable_steps)
      return given;
    const std::string message =
      "Numerics/Explicit/" + entry + " = " + to_text(given) + " s is longer than the " + to_text(stable) +
      " s that are known to be stable at t = " + to_text(time) +
      " s; take at most that, or 0 for the program's choice" + ", or set Unstable steps = on";
    AssertThrow(time > 0., ExcInput(message));
    AssertThrow(false, ExcRun(message));
    return given;
  }

  template <typename Number>
  MotionLimit<Number>::MotionLimit(const ExplicitSettings    &settings,
                                   TledBody<Number>          &body,
                                   TledNodes<Number>         &nodes,
                                   const std::vector<double> &masses)
    : settings(settings)
    , critical(body, nodes, TledBody<Number>::Part::motion, masses)
    , interval(first_interval)
  {
  }

  template <typename Number>
  void MotionLimit<Number>::find(const Records &values, const double time)
  {
    const double before = stable;
    stable              = 2. / std::sqrt(critical.largest_eigenvalue(values));
    const double share  = std::min(settings.safety, critical.steady_share());
    step                = longest_step(settings, settings.motion_step, stable, share, "Motion step", time);
    const double change = n_found > 0 ? std::abs(stable / before - 1.) : 0.5 * (hardly + much);
    if (change < hardly)
      interval = std::min(2 * interval, longest_interval);
    else if (change > much)
      interval = std::max(interval / 2, shortest_interval);
    next = n_steps + interval;
    ++n_found;
  }

  template <typename Number>
  void MotionLimit<Number>::archive(Archive &archive)
  {
    archive.shared("stable step", stable);
    archive.shared("longest step", step);
    archive.shared("steps between two looks", interval);
    archive.shared("steps taken", n_steps);
    archive.shared("next look", next);
    archive.shared("times found", n_found);
  }

  template class MotionLimit<float>;
  template class MotionLimit<double>;
} // namespace Cautery
