// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/base/flush_denormals.h>
#include <cautery/time/backward_euler.h>
#include <cautery/time/central_difference.h>
#include <cautery/time/growth.h>

#include <algorithm>
#include <cmath>

namespace Cautery
{
  namespace
  {
    constexpr unsigned int dim = 3;
    /// Lengths of steps that differ by less, relative, differ by rounding.
    constexpr double same_length = 1e-9;
    /// A step of the scene is not divided into more: months of computing.
    constexpr double most_parts = 1e9;
  } // namespace

  template <typename Number>
  CentralDifference<Number>::CentralDifference(const Scene            &scene,
                                               const Field<3>         &field,
                                               TledBody<Number>       &body,
                                               TledNodes<Number>      &nodes,
                                               ExplicitMotion<Number> *motion,
                                               ExplicitHeat<Number>   *heat,
                                               Cost                   &cost)
    : scene(scene)
    , settings(scene.numerics.explicit_steps)
    , field(field)
    , body(body)
    , nodes(nodes)
    , motion(motion)
    , heat(heat)
    , cost(cost)
  {
    for (Records *records : {&values, &rates, &forces, &loads})
      *records = nodes.zero();
    if (motion != nullptr)
      {
        motion->fill_loads(loads);
        motion_limit = std::make_unique<MotionLimit<Number>>(settings, body, nodes, motion->masses());
        drift_keep   = nodes.zero();
        drift_gain   = nodes.zero();
        // the temperature goes on as it does
        for (std::size_t i = node_record - 1; i < drift_keep.size(); i += node_record)
          drift_keep[i] = 1.;
      }
    if (heat != nullptr)
      for (Records *records : {&keep, &gain, &exchange})
        *records = nodes.zero();
  }

  template <typename Number>
  void CentralDifference<Number>::start(const State &state)
  {
    if (scene.effects.has_heat())
      for (std::uint32_t node = 0; node < nodes.n_own(); ++node)
        values[node_record * node + dim] = state.temperature.begin()[node] - body.reference_temperature();
    nodes.update(values);
    if (heat != nullptr)
      {
        heat->start(state);
        find_heat_limit(state.time);
      }
    if (motion != nullptr)
      {
        motion_limit->find(values, state.time);
        motion_limit_seen = motion_limit->times_found();
      }
  }

  template <typename Number>
  void CentralDifference<Number>::find_heat_limit(const double time)
  {
    CriticalStep<Number> limit(body, nodes, Part::heat, heat->capacities());
    longest_heat = longest_step(settings,
                                settings.heat_step,
                                heat->stable_step(limit.largest_eigenvalue(values)),
                                settings.safety,
                                "Heat step",
                                time);
  }

  /** Conduction in the deformed body changes with it, about as fast as the limit of motion. */
  template <typename Number>
  void CentralDifference<Number>::renew_heat_limit(const double time)
  {
    if (scene.effects.conduction != Effects::Conduction::deformed_body ||
        motion_limit->times_found() == motion_limit_seen)
      return;
    const auto scope  = cost.measure("heat: stable step");
    motion_limit_seen = motion_limit->times_found();
    find_heat_limit(time);
  }

  template <typename Number>
  void CentralDifference<Number>::renew_limit_in_time(const double time)
  {
    if (motion_limit->steps_left() > 0)
      return;
    const auto scope = cost.measure("deformation: stable step");
    check_growth(nodes, values, far(), time);
    motion_limit->look(values, rates, time);
  }

  template <typename Number>
  unsigned int
  CentralDifference<Number>::n_parts(const double length, const double longest, const double time) const
  {
    const double parts = std::max(1., std::ceil(length / longest * (1. - 1e-9)));
    if (parts <= most_parts)
      return parts;
    // neo-Hookean tissue becomes the stiffer the more it is pressed
    const auto cell = motion != nullptr ? body.inverted(values, 0.5) : std::optional<InvertedCell>();
    AssertThrow(
      false,
      ExcRun((cell ? "at t = " + to_short_text(time) + " s " + cell->message() + ": " : std::string()) +
             "explicit steps of " + to_short_text(longest) + " s are too short: " + to_short_text(length) +
             " s take more than " + to_short_text(most_parts) + " of them; " +
             (cell ? "load the body more slowly or less, or refine the mesh there" :
                     "take softer or denser tissue, larger cells, or implicit steps")));
    return 0;
  }

  template <typename Number>
  void CentralDifference<Number>::step(State &state, const double stop)
  {
    const FlushDenormals flush;
    const Step           whole = next_step(state.time, scene.time.step, stop);
    if (heat != nullptr && heat->refresh(state))
      heat_duration = 0.;
    if (heat == nullptr)
      move(whole);
    else
      {
        if (!heat->relaxes())
          heat->load(whole, values, loads);
        renew_heat_limit(whole.from);
        advance_all(whole);
      }
    state.time = whole.to;
    ++state.step;
    write(state);
  }

  template <typename Number>
  void CentralDifference<Number>::follow(const Step &step, State &state)
  {
    const FlushDenormals flush;
    for (std::uint32_t node = 0; node < nodes.n_own(); ++node)
      {
        const std::size_t entry = node_record * node + dim;
        rates[entry] =
          (state.temperature.begin()[node] - body.reference_temperature() - values[entry]) / step.length();
      }
    move(step);
    write(state);
  }

  /** The steps of heat, and of motion, from one end of @p whole to the other. */
  template <typename Number>
  void CentralDifference<Number>::advance_all(const Step &whole)
  {
    const unsigned int n    = n_parts(whole.length(), longest_heat, whole.from);
    const auto         part = [&](const unsigned int i) {
      const double length = whole.length() / n;
      return Step{i == 0 ? whole.from : whole.from + i * length,
                  i + 1 == n ? whole.to : whole.from + (i + 1) * length};
    };
    for (unsigned int i = 0; i < n;)
      {
        if (motion == nullptr || n_parts(whole.length() / n, motion_limit->longest(), whole.from) > 1)
          {
            advance(part(i++));
            continue;
          }
        // motion takes heat's steps too
        renew_limit_in_time(whole.from);
        const auto scope = cost.measure("deformation: explicit steps");
        do
          {
            begin_heat_step(part(i));
            move_once(part(i++), Part::both);
          }
        while (i < n && motion_limit->steps_left() > 0);
      }
  }

  template <typename Number>
  void CentralDifference<Number>::begin_heat_step(const Step &step)
  {
    if (heat->relaxes())
      heat->load(step, values, loads);
    set_heat_step(step.length());
    ++n_heat_steps;
  }

  /** A step of heat, and the steps of motion in it. */
  template <typename Number>
  void CentralDifference<Number>::advance(const Step &step)
  {
    begin_heat_step(step);
    {
      const auto scope = cost.measure("heat: explicit steps");
      body.add_forces(Part::heat, values, forces);
      nodes.collect(forces);
      heat->prescribe(step, values, forces, rates);
      // with motion, only the rate: the temperature follows during its steps
      take_step(motion == nullptr ? step.length() : 0., Part::heat, keep, gain);
    }
    if (motion != nullptr)
      move(step);
    else
      nodes.update(values);
    const auto scope = cost.measure("heat: explicit steps");
    heat->record(step.length(), values, rates);
  }

  /** The steps of motion from one end of @p step to the other. */
  template <typename Number>
  void CentralDifference<Number>::move(const Step &step)
  {
    double time = step.from;
    while (time < step.to)
      {
        renew_limit_in_time(time);
        const double longest = motion_limit->longest();
        const bool   go_on   = last_motion_step <= longest && last_motion_step > 0.9 * longest;
        const Step   rest    = {time, step.to};
        const auto   n       = n_parts(rest.length(), go_on ? last_motion_step : longest, rest.from);
        const auto   n_now   = std::min<std::uint64_t>(n, motion_limit->steps_left());
        const auto   scope   = cost.measure("deformation: explicit steps");
        for (unsigned int i = 0; i < n_now; ++i)
          {
            const double to = i + 1 == n ? step.to : rest.from + (i + 1) * rest.length() / n;
            move_once({time, to}, Part::motion);
            time = to;
          }
      }
  }

  /** One step of motion, with @p part = both also one of heat. */
  template <typename Number>
  void CentralDifference<Number>::move_once(const Step &step, const Part part)
  {
    const bool both = part == Part::both;
    set_motion_step(step.length());
    const bool healthy = body.add_forces(part, values, forces);
    check_healthy(healthy, step.from);
    motion->apply_changing_loads(step.from, forces);
    nodes.collect(forces);
    motion->release_rollers(forces);
    motion->prescribe(step.to, step.length(), values, rates);
    if (both)
      heat->prescribe(step, values, forces, rates);
    take_step(step.length(), part, both ? keep : drift_keep, both ? gain : drift_gain);
    nodes.update(values);
    if (both)
      heat->record(step.length(), values, rates);
    last_motion_step = step.length();
    motion_limit->count_step();
  }

  template <typename Number>
  void CentralDifference<Number>::take_step(const double   duration,
                                            const Part     part,
                                            const Records &keep_share,
                                            const Records &gain_share)
  {
    auto step     = node_step(nodes.n_own(), values, rates, forces, loads, keep_share, gain_share, duration);
    step.exchange = part == Part::motion ? nullptr : exchange.data();
    step.motion   = part != Part::heat;
    body.kernel().step(step);
  }

  /** Between two rates that are @p duration and the last step apart, the mean of both counts. */
  template <typename Number>
  void CentralDifference<Number>::set_motion_step(const double duration)
  {
    const double mean = 0.5 * (last_motion_step + duration);
    if (std::abs(mean - motion_mean) <= same_length * mean)
      return;
    motion_mean = mean;
    fill_motion();
  }

  template <typename Number>
  void CentralDifference<Number>::fill_motion()
  {
    motion->fill(motion_mean, settings.damping, motion->masses(), drift_keep, drift_gain);
    if (heat != nullptr)
      motion->fill(motion_mean, settings.damping, motion->masses(), keep, gain);
  }

  template <typename Number>
  void CentralDifference<Number>::set_heat_step(const double duration)
  {
    if (std::abs(duration - heat_duration) <= same_length * duration)
      return;
    heat_duration = duration;
    heat->fill(duration, keep, gain, exchange);
  }

  template <typename Number>
  void CentralDifference<Number>::check_healthy(const bool healthy, const double time) const
  {
    const MPI_Comm communicator = nodes.communicator();
    if (Utilities::MPI::n_mpi_processes(communicator) == 1 ?
          healthy :
          Utilities::MPI::min(healthy ? 1 : 0, communicator) == 1)
      return;
    const auto cell = body.inverted(values);
    AssertThrow(false,
                ExcRun("at t = " + to_short_text(time) + " s " +
                       (cell ? cell->message() : std::string("a cell's deformation is not a number")) +
                       "; load the body more slowly or less, refine the mesh there, or lower "
                       "Numerics/Explicit/Safety factor"));
  }

  template <typename Number>
  void CentralDifference<Number>::write(State &state) const
  {
    check_growth(nodes, values, far(), state.time);
    if (motion != nullptr)
      {
        double *displacement = state.displacement.begin();
        for (std::uint32_t node = 0; node < nodes.n_own(); ++node)
          for (unsigned int c = 0; c < dim; ++c)
            displacement[dim * node + c] = values[node_record * node + c];
      }
    if (heat != nullptr)
      for (std::uint32_t node = 0; node < nodes.n_own(); ++node)
        {
          state.temperature.begin()[node] = body.reference_temperature() + values[node_record * node + dim];
          if (heat->relaxes())
            state.temperature_rate.begin()[node] = rates[node_record * node + dim];
        }
  }

  template <typename Number>
  void CentralDifference<Number>::archive(Archive &archive, const State &state)
  {
    archive.nodal("values", values.data(), node_record * nodes.n_own());
    archive.nodal("rates", rates.data(), node_record * nodes.n_own());
    archive.shared("last motion step", last_motion_step);
    archive.shared("motion coefficients", motion_mean);
    archive.shared("heat coefficients", heat_duration);
    archive.shared("longest heat step", longest_heat);
    archive.shared("heat steps", n_heat_steps);
    archive.shared("motion limit seen", motion_limit_seen);
    if (motion != nullptr)
      archive.section("stable step", [&]() { motion_limit->archive(archive); });
    if (heat != nullptr)
      archive.section("heat", [&]() { heat->archive(archive, state); });
    if (!archive.restores())
      return;
    nodes.update(values);
    if (motion_mean > 0.)
      fill_motion();
    if (heat_duration > 0.)
      heat->fill(heat_duration, keep, gain, exchange);
  }

  template <typename Number>
  std::map<std::string, double> CentralDifference<Number>::statistics() const
  {
    std::map<std::string, double> result;
    if (motion != nullptr)
      {
        result["motion_steps"]         = motion_limit->steps_taken();
        result["stable_motion_step_s"] = motion_limit->longest();
        result["kinetic_energy_J"]     = motion->kinetic_energy(rates);
      }
    if (heat != nullptr)
      result["heat_steps"] = n_heat_steps;
    return result;
  }

  template class CentralDifference<float>;
  template class CentralDifference<double>;
} // namespace Cautery
