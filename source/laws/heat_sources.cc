// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/laws/heat_sources.h>

#include <algorithm>
#include <cmath>

namespace Cautery
{
  bool Schedule::active(const double time) const
  {
    for (unsigned int i = 0; i < on.size(); ++i)
      if (on[i] <= time && (i >= off.size() || time < off[i]))
        return true;
    return false;
  }

  double Schedule::share(const double from, const double to) const
  {
    double sum = 0.;
    for (unsigned int i = 0; i < on.size(); ++i)
      {
        const double end = i < off.size() ? std::min(off[i], to) : to;
        sum += std::max(0., end - std::max(on[i], from));
      }
    return sum / (to - from);
  }

  std::vector<double> Schedule::switching_times() const
  {
    std::vector<double> times = on;
    times.insert(times.end(), off.begin(), off.end());
    std::sort(times.begin(), times.end());
    return times;
  }

  void Schedule::parameters(Parameters &p)
  {
    p.entry("Switch on at", on, "s", "Times at which the source is switched on", Bounds::non_negative());
    p.entry(
      "Switch off at", off, "s", "Times at which it is switched off; none: never", Bounds::non_negative());
    if (!p.reading())
      return;
    if (off.size() != on.size() && off.size() + 1 != on.size())
      p.reject("Switch off at",
               std::to_string(off.size()) + " times",
               "there must be as many as in `Switch on at`, or one fewer");
    for (unsigned int i = 0; i < off.size(); ++i)
      if (off[i] <= on[i] || (i + 1 < on.size() && on[i + 1] < off[i]))
        p.reject("Switch off at", to_text(off[i]), "the times must alternate: on, off, on, off, ...");
  }

  namespace
  {
    void power_entry(Parameters &p, Expression &power, const std::string &unit, const std::string &what)
    {
      p.entry("Power", power, unit, what + "; a number or an expression in t");
    }
  } // namespace

  void PointSources::parameters(Parameters &p)
  {
    p.entry("Places", places, "m", "Points x, y, z; separated by semicolons");
    power_entry(p, power, "W", "Power at each of the points");
    if (p.reading() && places.empty())
      p.reject("Places", "", "a point source needs at least one place");
  }

  void UniformSource::parameters(Parameters &p)
  {
    p.entry("Regions", regions, "Regions, by number or name, that are heated; `all` for every one");
    power_entry(p, power, "W/m3", "Power per volume");
  }

  double GaussianSource::density(const Point<3> &place, const unsigned int dimension) const
  {
    const double variance = radius * radius;
    return std::exp(-place.distance_square(centre) / (2. * variance)) /
           std::pow(2. * numbers::PI * variance, 0.5 * dimension);
  }

  void GaussianSource::parameters(Parameters &p)
  {
    p.entry("Centre", centre, "m", "The hottest point");
    p.entry("Radius", radius, "m", "Standard deviation of the distribution", Bounds::positive());
    power_entry(p, power, "W", "Power over the whole space (per metre in two dimensions)");
  }

  double MicrowaveAntenna::density(const Point<3> &place, const unsigned int) const
  {
    const Tensor<1, 3> direction = axis / axis.norm();
    const Tensor<1, 3> offset    = place - centre;
    const double       z         = offset * direction;
    const double       distance  = std::max((offset - z * direction).norm(), inner_radius);
    const double       decay     = 2. * attenuation * distance;
    const double       r_mm      = 1e3 * distance;
    const double per_mm3 = scale * (decay + exponent - 2.) * std::exp(-decay) / std::pow(r_mm, exponent) *
                           std::exp(-z * z / (axial_distance * axial_distance));
    return 1e9 * per_mm3;
  }

  void MicrowaveAntenna::parameters(Parameters &p)
  {
    p.entry("Centre", centre, "m", "Point of the axis where the antenna heats most (z = 0)");
    p.entry("Axis", axis, "", "Direction of the antenna");
    p.entry(
      "Inner radius", inner_radius, "m", "Radius within which heating stays the same", Bounds::positive());
    p.entry("Scale", scale, "mm^(n-3)", "Scale constant C_t", Bounds::positive());
    p.entry("Attenuation", attenuation, "1/m", "Attenuation constant rho", Bounds::non_negative());
    p.entry("Exponent", exponent, "", "Exponential constant n", Bounds{2., 10., false, false});
    p.entry("Axial distance", axial_distance, "m", "Axial decay distance z_0", Bounds::positive());
    power_entry(p, power, "W", "Microwave power");
    if (p.reading() && axis.norm() == 0.)
      p.reject("Axis", "0, 0, 0", "a direction needs a length");
  }

  void ExpressionSource::parameters(Parameters &p)
  {
    p.entry("Distribution", distribution, "W/m3", "Heat per volume, an expression in x, y, z, t");
    power_entry(p, power, "", "Factor of the distribution");
  }

  double HeatSource::amplitude(const double time) const
  {
    return std::visit([time](const auto &shape) { return shape.power.value(Point<3>(), time); }, source);
  }

  void HeatSource::parameters(Parameters &p)
  {
    std::visit([&p](auto &shape) { shape.parameters(p); }, source);
    schedule.parameters(p);
  }

  namespace
  {
    /// Calls @p visit with a default-constructed source of every type.
    template <typename Visit, std::size_t... i>
    void for_each_type(const Visit &visit, std::index_sequence<i...>)
    {
      (visit(std::variant_alternative_t<i, AnyHeatSource>()), ...);
    }

    template <typename Visit>
    void for_each_type(const Visit &visit)
    {
      for_each_type(visit, std::make_index_sequence<std::variant_size_v<AnyHeatSource>>());
    }
  } // namespace

  std::vector<std::string> heat_source_types()
  {
    std::vector<std::string> types;
    for_each_type([&types](const auto &source) { types.emplace_back(source.type); });
    return types;
  }

  AnyHeatSource make_heat_source(const std::string &type)
  {
    AnyHeatSource chosen;
    bool          found = false;
    for_each_type([&](const auto &source) {
      if (type == source.type)
        {
          chosen = source;
          found  = true;
        }
    });
    AssertThrow(found,
                ExcInput("there is no heat source of type `" + type +
                         "`; choose one of: " + join(heat_source_types())));
    return chosen;
  }
} // namespace Cautery
