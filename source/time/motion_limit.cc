// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/time/motion_limit.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Cautery
{
  namespace
  {
    constexpr std::uint64_t first_interval = 20, shortest_interval = 10, longest_interval = 800;
    /// Relative changes from one find to the next. The safety factor must cover the larger one.
    constexpr double hardly = 0.01, much = 0.04;
    /// Of the shortest edge, that a node may move between two finds.
    constexpr double at_first = 0.02, least = 1e-4;
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
    , nodes(nodes)
    , critical(body, nodes, TledBody<Number>::Part::motion, masses)
    , interval(first_interval)
    , may_move(at_first * nodes.shortest_edge())
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
    // where the way since the last find has shortened the step much, less of it next time
    const double shortened = n_found > 0 ? std::max(0., std::log(before / stable)) : 0.;
    if (shortened > much)
      may_move = std::max(moved * much / shortened, least * nodes.shortest_edge());
    else if (moved > may_move)
      may_move = moved * (2. * shortened > much ? much / shortened : 2.);
    ++n_found;
    moved     = 0.;
    last_look = n_steps;
    next_look = n_steps + 1;
  }

  template <typename Number>
  void MotionLimit<Number>::look(const Records &values, const Records &rates, const double time)
  {
    const std::uint64_t since = n_steps - last_look;
    const double        way   = largest_speed(rates) * step; // of a step
    moved += way * since;
    if (n_steps >= next || moved > may_move)
      {
        find(values, time);
        return;
      }
    // at half of the way that is left, and not much later than last time: bodies gather speed
    const double  half = 0.5 * (may_move - moved);
    std::uint64_t n    = 2 * since;
    if (half < way * n)
      n = std::max(1., half / way);
    last_look = n_steps;
    next_look = std::min(n_steps + n, next);
  }

  template <typename Number>
  double MotionLimit<Number>::largest_speed(const Records &rates) const
  {
    double largest = 0.;
    for (std::size_t i = 0; i < node_record * nodes.n_own(); ++i)
      if (i % node_record < node_record - 1) // not of temperature
        if (const double speed = std::abs(static_cast<double>(rates[i])); !(speed <= largest))
          largest = std::isfinite(speed) ? speed : std::numeric_limits<double>::infinity();
    return Utilities::MPI::max(largest, nodes.communicator());
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
    archive.shared("last look at speeds", last_look);
    archive.shared("next look at speeds", next_look);
    archive.shared("may move", may_move);
    archive.shared("moved since", moved);
  }

  template class MotionLimit<float>;
  template class MotionLimit<double>;
} // namespace Cautery
