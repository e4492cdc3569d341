// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests.h"

#include <cmath>

namespace Cautery::Test
{
  namespace
  {
    /** Nodes that do not fill a register, one of which belongs to another material. */
    template <typename Number>
    double pressure_error(const InstructionSet set, const StretchForm stretch)
    {
      const unsigned int    n = 7;
      AlignedVector<Number> values(node_record * n), volumes(n), changes(n), pressures(n);
      SweepMaterial         material;
      material.lambda    = lambda;
      material.expansion = expansion;
      std::vector<double> expected;
      for (unsigned int i = 0; i < n; ++i)
        {
          const double heating = 10. * i, jacobian = 0.4 + 0.3 * i;
          const double s              = stretch == StretchForm::none       ? 1. :
                                        stretch == StretchForm::linearised ? 1. + expansion * heating :
                                                                             std::exp(expansion * heating);
          values[node_record * i + 3] = heating;
          volumes[i]                  = i == 5 ? 0. : 1e-9 * (i + 1.);
          changes[i]                  = volumes[i] * (jacobian - 1.) * s * s * s;
          expected.push_back(i == 5 ? 0. : lambda * std::log(jacobian) / jacobian);
        }
      tled_kernel<Number>(set).pressure(
        {n, values.data(), volumes.data(), changes.data(), pressures.data(), stretch, material});
      double error = 0.;
      for (unsigned int i = 0; i < n; ++i)
        error = std::max(error, std::abs(pressures[i] - expected[i]) / lambda + std::abs(changes[i]));
      return error;
    }

    /** One node: a spring in x, a load in y, a given rate in z, and cooling. */
    template <typename Number>
    double step_error(const InstructionSet set, const bool motion, const bool heat)
    {
      AlignedVector<Number> values(4), rates(4), forces(4), loads(4), keep(4), gain(4), exchange(4);
      const double          mass = 2., damping = 0.6, spring = 3., capacity = 5., cooling = 0.8, dt = 0.125;
      const double          sum = mass / dt + damping / 2.;
      for (int c = 0; c < 2; ++c)
        {
          keep[c] = (mass / dt - damping / 2.) / sum;
          gain[c] = 1. / sum;
        }
      keep[2]     = 1.;
      rates[2]    = 0.25;
      gain[3]     = dt / capacity / dt;
      exchange[0] = spring;
      exchange[3] = cooling;
      loads[1]    = 4.;
      values[0]   = 1.;
      values[3]   = 10.;

      auto step     = node_step(1, values, rates, forces, loads, keep, gain, dt);
      step.exchange = exchange.data();
      step.motion   = motion;
      step.heat     = heat;

      // Eq. 7-50 with x(-dt) from the initial rates, and Euler's forward step
      double       before[3] = {1., 0., -0.25 * dt}, now[3] = {1., 0., 0.}, temperature = 10.;
      const double k[2] = {spring, 0.}, load[2] = {0., 4.};
      for (int i = 0; i < 50; ++i)
        {
          forces[1] = 1.5; // an internal force
          tled_kernel<Number>(set).step(step);
          if (motion)
            {
              double next[3];
              for (int c = 0; c < 2; ++c)
                next[c] = (load[c] - (c == 1 ? 1.5 : 0.) - k[c] * now[c] + 2. * mass / (dt * dt) * now[c] -
                           (mass / (dt * dt) - damping / (2. * dt)) * before[c]) /
                          (mass / (dt * dt) + damping / (2. * dt));
              next[2] = 2. * now[2] - before[2];
              std::copy(now, now + 3, before);
              std::copy(next, next + 3, now);
            }
          if (heat)
            temperature -= dt * cooling / capacity * temperature;
        }
      double error = std::abs(values[3] - temperature);
      for (int c = 0; c < 3; ++c)
        error = std::max(error, std::abs(values[c] - now[c]));
      return error + std::abs(forces[1] - (motion ? 0. : 1.5));
    }
  } // namespace

  void test_pressure()
  {
    const std::vector<std::pair<std::string, StretchForm>> forms = {
      {"cold", StretchForm::none},
      {"linearised stretch", StretchForm::linearised},
      {"exact stretch", StretchForm::exact}};
    for (const auto &form : forms)
      {
        at_most(form.first,
                "pressure, double",
                worst([&](const auto set) { return pressure_error<double>(set, form.second); }),
                1e-15);
        at_most(form.first,
                "pressure, single",
                worst([&](const auto set) { return pressure_error<float>(set, form.second); }),
                1e-6);
      }
  }

  void test_step()
  {
    at_most("one node",
            "central differences and Euler's step",
            worst([](const auto set) { return step_error<double>(set, true, true); }),
            1e-12);
    at_most("one node",
            "in single precision",
            worst([](const auto set) { return step_error<float>(set, true, true); }),
            1e-4);
    at_most("one node",
            "motion only",
            worst([](const auto set) { return step_error<double>(set, true, false); }),
            1e-12);
    at_most("one node",
            "heat only",
            worst([](const auto set) { return step_error<double>(set, false, true); }),
            1e-12);
  }
} // namespace Cautery::Test
