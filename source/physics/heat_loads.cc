// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/heat_loads.h>

#include <algorithm>
#include <cmath>

namespace Cautery
{
  namespace
  {
    /// @p share: of the power of a source that is spread over all space, what falls on the body's nodes.
    void check_reaches_body(const HeatSource &source, const double share)
    {
      const bool spread = std::holds_alternative<GaussianSource>(source.source) ||
                          std::holds_alternative<MicrowaveAntenna>(source.source);
      AssertThrow(
        !spread || share > 1e-3,
        ExcInput("Heat sources/" + source.name + ": of 1 W only " + to_short_text(share) +
                 " W falls on the body; its Centre lies outside, or it is far narrower than the cells"));
      AssertThrow(
        !spread || share < 1.05,
        ExcInput("Heat sources/" + source.name + ": of 1 W " + to_short_text(share) +
                 " W would fall on the body: it is narrower than the cells; refine the mesh, or take a wider "
                 "source or one of type points"));
    }
  } // namespace

  template <int dim>
  HeatLoads<dim>::HeatLoads(const Scene             &scene,
                            const Field<dim>        &field,
                            const TissueMap<dim>    &tissues,
                            const BoundaryMap<dim>  &boundaries,
                            const PointLocator<dim> &locator)
    : field(field)
    , non_fourier(scene.effects.heat == Effects::Heat::non_fourier)
    , jumps(scene.effects.source_jumps == Effects::Jumps::consistent)
  {
    if (scene.effects.heat_sources)
      for (const auto &source : scene.heat_sources)
        {
          add_item(&source, false, source_distribution(source, field, tissues, locator));
          check_reaches_body(source, items.back().sum);
        }
    for (unsigned int b = 0; b < scene.boundaries.size(); ++b)
      {
        const Boundary &boundary   = scene.boundaries[b];
        const bool      convection = boundary.thermal == Boundary::Thermal::convection;
        if (boundary.thermal == Boundary::Thermal::flux || convection)
          add_item(
            nullptr, convection, surface_distribution(boundary, boundaries.surfaces(b), field, tissues));
      }
  }

  template <int dim>
  void HeatLoads<dim>::add_item(const HeatSource       *source,
                                const bool              convection,
                                const HeatDistribution &distribution)
  {
    Item item;
    item.source       = source;
    item.convection   = convection;
    item.distribution = distribution;
    item.load         = field.vector();
    if (non_fourier)
      item.relaxed = field.vector();
    assemble_now(item, 0., item.load, non_fourier ? &item.relaxed : nullptr);
    item.sum = item.load.mean_value() * item.load.size();
    if (non_fourier && item.sum != 0.)
      item.delay = item.relaxed.mean_value() * item.relaxed.size() / item.sum;
    items.push_back(std::move(item));
  }

  template <int dim>
  void HeatLoads<dim>::assemble_now(const Item &item, const double time, Vector &load, Vector *relaxed) const
  {
    load = 0.;
    if (relaxed != nullptr)
      *relaxed = 0.;
    item.distribution.assemble(time, load, relaxed);
    load.compress(VectorOperation::add);
    if (relaxed != nullptr)
      relaxed->compress(VectorOperation::add);
  }

  template <int dim>
  double HeatLoads<dim>::mean_amplitude(const Item &item, const Step &step) const
  {
    if (item.source == nullptr)
      return 1.;
    return item.source->amplitude(step.to) * item.source->schedule.share(step.from, step.to);
  }

  namespace
  {
    /// On until and including @p time: what holds just before a switch.
    bool active_before(const Schedule &schedule, const double time)
    {
      for (unsigned int i = 0; i < schedule.on.size(); ++i)
        if (schedule.on[i] < time && (i >= schedule.off.size() || time <= schedule.off[i]))
          return true;
      return false;
    }
  } // namespace

  template <int dim>
  std::pair<double, double> HeatLoads<dim>::end_amplitudes(const Item &item, const Step &step) const
  {
    if (item.source == nullptr)
      return {1., 1.};
    const double share = item.source->schedule.share(step.from, step.to);
    // From the mean of one step to the mean of the next: so a switch inside a step acts as the share that the
    // load has there, and every jump counts once.
    return {item.source->amplitude(step.from) * (jumps ? item.last_share : share),
            item.source->amplitude(step.to) * share};
  }

  template <int dim>
  void HeatLoads<dim>::add_rate(const Item &item, const Step &step, Vector &force) const
  {
    const auto [start, end] = end_amplitudes(item, step);
    const double before     = start / step.length();
    const double after      = end / step.length();
    if (!item.distribution.changes)
      {
        if (after != before)
          force.add(after - before, item.relaxed);
        return;
      }
    Vector load    = field.vector();
    Vector relaxed = field.vector();
    assemble_now(item, step.to, load, &relaxed);
    force.add(after, relaxed);
    assemble_now(item, step.from, load, &relaxed);
    force.add(-before, relaxed);
  }

  template <int dim>
  void HeatLoads<dim>::add(const Step &step, Vector &force) const
  {
    for (const auto &item : items)
      {
        const double amplitude = mean_amplitude(item, step);
        if (item.distribution.changes)
          {
            Vector load = field.vector();
            assemble_now(item, step.to, load, nullptr);
            force.add(amplitude, load);
          }
        else if (amplitude != 0.)
          force.add(amplitude, item.load);
        if (non_fourier)
          add_rate(item, step, force);
      }
  }

  template <int dim>
  void HeatLoads<dim>::add_at(const double time, const double within, Vector &force) const
  {
    // central differences of a smooth amplitude: error 1e-10 relative, far below any tolerance in time
    const double h = 1e-5 * std::max(1., std::abs(time));
    for (const auto &item : items)
      {
        const bool active = item.source == nullptr || item.source->schedule.active(within);
        const auto value  = [&](const double t) {
          return item.source == nullptr ? 1. : item.source->amplitude(t);
        };
        if (!active)
          continue;
        if (!item.distribution.changes)
          {
            force.add(value(time), item.load);
            if (non_fourier)
              force.add((value(time + h) - value(time - h)) / (2. * h), item.relaxed);
            continue;
          }
        Vector load    = field.vector();
        Vector relaxed = non_fourier ? field.vector() : Vector();
        assemble_now(item, time, load, nullptr);
        force.add(value(time), load);
        for (const double side : {-1., 1.})
          if (non_fourier)
            {
              assemble_now(item, time + side * h, load, &relaxed);
              force.add(side * value(time + side * h) / (2. * h), relaxed);
            }
      }
  }

  template <int dim>
  void HeatLoads<dim>::add_last(const double time, Vector &force) const
  {
    Vector load = field.vector();
    for (const auto &item : items)
      {
        const double amplitude = item.source == nullptr ? 1. :
                                 jumps                  ? item.source->amplitude(time) * item.last_share :
                                                          item.effective;
        if (amplitude == 0.)
          continue;
        assemble_now(item, time, load, nullptr);
        force.add(amplitude, load);
      }
  }

  template <int dim>
  void HeatLoads<dim>::go_on(const HeatLoads &before)
  {
    for (unsigned int i = 0; i < items.size(); ++i)
      {
        items[i].last_share = before.items[i].last_share;
        items[i].effective  = before.items[i].effective;
      }
  }

  template <int dim>
  Vector HeatLoads<dim>::load_at(const Item &item, const double time) const
  {
    Vector load = item.load;
    if (item.distribution.changes)
      assemble_now(item, time, load, nullptr);
    return load;
  }

  template <int dim>
  void HeatLoads<dim>::add_convection_at(const double time, Vector &force) const
  {
    for (const auto &item : items)
      if (item.convection)
        force += load_at(item, time);
  }

  namespace
  {
    /// Of the largest load at a node: what shape functions leave at nodes where they are zero.
    constexpr double rounding = 1e-10;
  } // namespace

  template <int dim>
  bool HeatLoads<dim>::take_heat(const Step &step) const
  {
    for (const auto &item : items)
      if (!item.convection)
        {
          const double amplitude = mean_amplitude(item, step);
          const Vector load      = load_at(item, step.to);
          const double least     = amplitude > 0. ? load.min() : load.max();
          if (amplitude * least < -rounding * std::abs(amplitude) * load.linfty_norm())
            return true;
        }
    return false;
  }

  template <int dim>
  void HeatLoads<dim>::add_jump(const double time, Vector &force) const
  {
    if (!non_fourier || !jumps)
      return;
    for (const auto &item : items)
      if (item.source != nullptr)
        {
          const double jump = item.source->amplitude(time) * (item.source->schedule.active(time) -
                                                              active_before(item.source->schedule, time));
          if (jump == 0.)
            continue;
          if (!item.distribution.changes)
            {
              force.add(jump, item.relaxed);
              continue;
            }
          Vector load    = field.vector();
          Vector relaxed = field.vector();
          assemble_now(item, time, load, &relaxed);
          force.add(jump, relaxed);
        }
  }

  template <int dim>
  bool HeatLoads<dim>::jumps_within(const double from, const double to) const
  {
    // steps end at switches but for rounding
    const double rounding = 1e-9 * (to - from);
    const auto   within   = [&](const double time) { return time > from + rounding && time < to - rounding; };
    return std::any_of(items.begin(), items.end(), [&](const Item &item) {
      return item.source != nullptr &&
             (std::any_of(item.source->schedule.on.begin(), item.source->schedule.on.end(), within) ||
              std::any_of(item.source->schedule.off.begin(), item.source->schedule.off.end(), within));
    });
  }

  template <int dim>
  std::vector<double> HeatLoads<dim>::switching_times(const double end) const
  {
    std::vector<double> times;
    for (const auto &item : items)
      if (item.source != nullptr)
        for (const double time : item.source->schedule.switching_times())
          if (time > 0. && time < end)
            times.push_back(time);
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
  }

  template <int dim>
  void HeatLoads<dim>::record(const Step &step, const bool trapezoid, Vector &nodal_heat, Received &received)
  {
    using End = std::pair<double, double>; // its time, and its part of the step
    const std::vector<End> ends =
      trapezoid ? std::vector<End>{{step.from, 0.5}, {step.to, 0.5}} : std::vector<End>{{step.to, 1.}};
    for (auto &item : items)
      {
        const bool delayed = item.source != nullptr && non_fourier && !jumps;
        if (delayed)
          {
            // A source without its jumps acts as s with tau s' + s = a + tau a'.
            const auto [before, after] = end_amplitudes(item, step);
            const double decay         = item.delay / step.length();
            item.effective =
              (decay * (item.effective + after - before) + mean_amplitude(item, step)) / (1. + decay);
          }
        if (item.source != nullptr)
          item.last_share = item.source->schedule.share(step.from, step.to);
        for (const auto &[time, part] : ends)
          {
            const double amplitude = delayed                ? item.effective :
                                     item.source == nullptr ? 1. :
                                                              item.source->amplitude(time) * item.last_share;
            book(item, time, amplitude * part * step.length(), nodal_heat, received);
          }
      }
  }

  template <int dim>
  void HeatLoads<dim>::book(
    const Item &item, const double time, const double seconds, Vector &nodal_heat, Received &received) const
  {
    double heat = seconds * item.sum;
    if (item.distribution.changes)
      {
        Vector load = field.vector();
        assemble_now(item, time, load, nullptr);
        nodal_heat.add(seconds, load);
        heat = seconds * load.mean_value() * load.size();
      }
    else
      nodal_heat.add(seconds, item.load);
    (item.source != nullptr ? received.sources : received.surfaces) += heat;
  }

  template <int dim>
  void HeatLoads<dim>::archive(Archive &archive)
  {
    for (unsigned int i = 0; i < items.size(); ++i)
      archive.section("load " + std::to_string(i), [&]() {
        archive.shared("last share", items[i].last_share);
        archive.shared("effective amplitude", items[i].effective);
      });
  }

  template class HeatLoads<2>;
  template class HeatLoads<3>;
} // namespace Cautery
