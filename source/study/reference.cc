// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/study/reference.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Cautery
{
  namespace
  {
    /// Differences must shrink by so much from rung to rung to be extrapolated.
    constexpr double steady = 1.5;
    /// No method here is of a higher order in the length of cells or steps: what looks so is chance.
    constexpr double highest_order = 3.;

    /// a + factor (b - c); values that are infinite or missing on one side stay those of a.
    Series moved(const Series &a, const double factor, const Series &b, const Series &c)
    {
      Series result = a;
      for (unsigned int i = 0; i < a.values.size(); ++i)
        {
          const double change = factor * (b.values[i] - c.values[i]);
          if (std::isfinite(change))
            result.values[i] += change;
        }
      return result;
    }

    Limit from_three(const Series &first, const Series &second, const Series &third, const double ratio)
    {
      const double before = second.distance(first), after = third.distance(second);
      if (before > std::pow(ratio, highest_order + 0.5) * after && std::isfinite(before))
        return {third, before / (ratio * ratio), false}; // as from a method of order 2
      if (!(before > steady * after) || !std::isfinite(before))
        return {third, std::max(before, after), false};
      const Series limit = moved(third, 1. / (before / after - 1.), third, second);
      return {limit, limit.distance(third), true};
    }
  } // namespace

  Limit extrapolate(const std::vector<Series> &answers, const double ratio)
  {
    const unsigned int n = answers.size();
    Assert(n >= 2, ExcInternalError());
    const double last = answers[n - 1].distance(answers[n - 2]);
    if (last == 0. || n == 2)
      return {answers[n - 1], last, false};
    Limit limit = from_three(answers[n - 3], answers[n - 2], answers[n - 1], ratio);
    if (limit.extrapolated && n > 3)
      {
        const Limit earlier = from_three(answers[n - 4], answers[n - 3], answers[n - 2], ratio);
        limit.uncertainty   = std::min(limit.uncertainty, limit.answer.distance(earlier.answer));
      }
    return limit;
  }

  Reference richardson_reference(const Series                           &base,
                                 const std::vector<Ladder>              &ladders,
                                 const std::vector<std::vector<Series>> &answers)
  {
    using Error = LadderSettings::Error;
    Reference                reference{base, 0., ""};
    std::vector<std::string> used;
    for (const auto error : {Error::space, Error::time, Error::solver})
      {
        Limit       best;
        std::string name;
        best.uncertainty = std::numeric_limits<double>::infinity();
        for (unsigned int l = 0; l < ladders.size(); ++l)
          if (ladders[l].error == error && answers[l].size() >= 2)
            if (const Limit limit = extrapolate(answers[l], ladders[l].ratio);
                limit.uncertainty < best.uncertainty)
              {
                best = limit;
                name = ladders[l].name;
              }
        if (name.empty())
          continue;
        reference.answer = moved(reference.answer, 1., best.answer, base);
        reference.uncertainty += best.uncertainty;
        used.push_back(name + (best.extrapolated ? " (extrapolated)" : " (its last rung)"));
      }
    reference.origin =
      used.empty() ? "the scene as it is" : "the scene corrected by the ladders " + join(used);
    return reference;
  }

  Coarsening with_coarser_mesh(const Scene &scene)
  {
    const double share = 1. / (std::pow(2., scene.numerics.degree + 1.) - 1.);
    if (scene.mesh.refinements > 0)
      return {{{"Mesh/Refinements", std::to_string(scene.mesh.refinements - 1)}}, share};
    if (scene.mesh.shape == MeshSettings::Shape::file)
      return {};
    std::vector<std::string> numbers;
    for (const double number : scene.mesh.subdivisions)
      numbers.push_back(to_text(std::max(1., std::floor(number / 2.))));
    return {{{"Mesh/Subdivisions", join(numbers)}}, share};
  }

  Coarsening with_coarser_steps(const Scene &scene)
  {
    if (scene.time.integrator == TimeSettings::Integrator::ida)
      return {{{"Time/Relative tolerance", to_text(10. * scene.time.relative_tolerance)},
               {"Time/Absolute tolerance", to_text(10. * scene.time.absolute_tolerance)}},
              1. / 9.};
    return {{{"Time/Step", to_text(2. * scene.time.step)}}, 1.};
  }
} // namespace Cautery
