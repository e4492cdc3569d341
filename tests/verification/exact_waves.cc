// SPDX-License-Identifier: LGPL-2.1-or-later
#include "chain.h"

namespace Verification
{
  namespace
  {
    // the thesis's tissue
    constexpr double capacity = 1000. * 4192., diffusivity = 0.613 / capacity, delay = 16.;

    /// tau a'' + a' + decay a = 0 from a = 1, a' = 0; an oscillation where 4 tau decay > 1.
    double telegraph(const double decay, const double time)
    {
      const double omega = std::sqrt(4. * delay * decay - 1.) / (2. * delay);
      return std::exp(-time / (2. * delay)) *
             (std::cos(omega * time) + std::sin(omega * time) / (2. * delay * omega));
    }

    /// The same by backward Euler.
    double telegraph_in_steps(const double decay, const double time, const double step)
    {
      double amplitude = 1., rate = 0.;
      for (long n = std::lround(time / step); n > 0; --n)
        {
          rate = (delay / step * rate - decay * amplitude) / (delay / step + 1. + decay * step);
          amplitude += step * rate;
        }
      return amplitude;
    }

    using Waves = std::vector<std::pair<unsigned int, double>>; ///< half waves along the slab, amplitude in K

    /**
     * Elements of degree 2 err by (kappa h)^4 / 1440 in the frequency, 7e-6 for two half waves in 20 cells:
     * 1e-4 K leaves room for the phase that adds up. IDA's own error is far smaller.
     */
    void telegraph_slab(Checks               &checks,
                        const std::string    &label,
                        const Waves          &waves,
                        std::vector<Override> overrides)
    {
      const bool   insulated = label == "insulated";
      const double width = 0.005, place = 0.001;
      const auto   exact = [&](const double time, const double step) {
        double sum = 310.;
        for (const auto &[n, height] : waves)
          {
            const double wave_number = n * numbers::PI / width;
            const double decay       = diffusivity * wave_number * wave_number;
            sum += height * (insulated ? std::cos(wave_number * place) : std::sin(wave_number * place)) *
                   (step > 0. ? telegraph_in_steps(decay, time, step) : telegraph(decay, time));
          }
        return sum;
      };
      const Outcome stepped = run("telegraph", overrides);
      overrides.push_back({"Time/Integrator", "IDA"});
      const Outcome ida = run("telegraph", overrides);
      for (const std::string time : {"5", "20", "40"})
        {
          const std::string what = "wave in a slab with " + label + " ends, " + time + " s, ";
          const double      t    = std::stod(time);
          checks.near(what + "IDA, K", ida.at(time, "P", "temperature_K"), exact(t, 0.), 1e-4);
          checks.near(what + "backward Euler against its own recurrence, K",
                      stepped.at(time, "P", "temperature_K"),
                      exact(t, 0.1),
                      1e-4);
        }
    }

    /// The rise by the source s(t) Q with tau s' + s = 1 while on, 0 while off: what the neglected jumps
    /// leave.
    double late_rise(const double per_second, const double time)
    {
      const auto charge = [](const double t) {
        return t <= 0. ? 0. : t - delay * (1. - std::exp(-t / delay));
      };
      return per_second * (charge(time - 2.) - charge(time - 6.));
    }

    /// The same by backward Euler from time 0, which is on or off in whole steps.
    double late_rise_in_steps(const double per_second, const double time, const double step)
    {
      double rise = 0., rate = 0.;
      for (long n = 1; n <= std::lround(time / step); ++n)
        {
          const double middle = (n - 0.5) * step;
          const double source = middle > 2. && middle < 6. ? per_second : 0.;
          rate                = (delay / step * rate + source) / (delay / step + 1.);
          rise += step * rate;
        }
      return rise;
    }

    /**
     * rho C (tau T'' + T') = Q + tau Q': with the impulses of Q' the temperature follows at once, T = Q t /
     * (rho C); each step of backward Euler is exact then. Without them T' follows with the delay tau.
     */
    void switched_source(Checks &checks)
    {
      const double per_second = 7e6 / capacity;
      const auto   prompt = [&](const double t) { return per_second * (std::min(t, 6.) - std::min(t, 2.)); };
      for (const std::string integrator : {"backward Euler", "IDA"})
        {
          const bool    ida        = integrator == "IDA";
          const Outcome consistent = run("switched", {{"Time/Integrator", integrator}});
          const Outcome neglected =
            run("switched", {{"Time/Integrator", integrator}, {"Effects/Heat source jumps", "neglected"}});
          for (const std::string time : {"2", "2.5", "4", "6", "6.5", "10"})
            {
              const double t = std::stod(time);
              checks.near("switched source, " + integrator + ", " + time + " s, K",
                          consistent.at(time, "P", "temperature_K") - 310.,
                          prompt(t),
                          ida ? 1e-6 : 1e-9);
              checks.near("the same, jumps neglected, K",
                          neglected.at(time, "P", "temperature_K") - 310.,
                          ida ? late_rise(per_second, t) : late_rise_in_steps(per_second, t, 0.5),
                          ida ? 1e-6 : 1e-9);
            }
        }
    }

    /// The non-Fourier model with tau = 0, or a tau far below the step, is Fourier's.
    void short_delay(Checks &checks)
    {
      const Outcome fourier = run("balance", {{"Effects/Heat", "Fourier"}});
      for (const std::string tau : {"0", "1e-10"})
        {
          const Outcome other =
            run("balance", {{"Effects/Heat", "non-Fourier"}, {"Tissues/tissue/Relaxation time", tau}});
          for (const auto &[place, row] : fourier.probes)
            checks.near("tau = " + tau + " s returns Fourier, " + place.first + " s, " + place.second + ", K",
                        other.at(place.first, place.second, "temperature_K"),
                        row.at("temperature_K"),
                        1e-8);
        }
    }

    /**
     * In a body without gradients no flux can lag: it is heated, dies all at once and is heated on without
     * its blood as in Fourier's model, step by step.
     */
    void even_body_that_dies(Checks &checks)
    {
      for (const std::string integrator : {"backward Euler", "explicit"})
        {
          const auto by = [&integrator](const std::string &model, const std::string &perfusion_stops) {
            return run("warm_block",
                       {{"Effects/Deformation", "off"},
                        {"Effects/Coupling", "off"},
                        {"Effects/Heat", model},
                        {"Effects/Perfusion", "on"},
                        {"Effects/Damage", "Arrhenius"},
                        {"Effects/Perfusion stops in dead tissue", perfusion_stops},
                        {"Initial state/Temperature", "310"},
                        {"Tissues/tissue/Perfusion rate", "50"},
                        {"Heat sources/Names", "glow"},
                        {"Heat sources/glow/Type", "uniform"},
                        {"Heat sources/glow/Power", "2e7"},
                        {"Time/Integrator", integrator},
                        {"Time/Step", "0.1"}})
              .end("inside", "temperature_K");
          };
          const double wanted = by("Fourier", "on");
          checks.holds("the end of perfusion is felt", wanted - by("Fourier", "off") > 0.5);
          checks.near(
            "even body that dies, non-Fourier, " + integrator + ", K", by("non-Fourier", "on"), wanted, 1e-8);
        }
    }
  } // namespace

  void waves(Checks &checks)
  {
    telegraph_slab(checks, "insulated", {{1, 10.}, {2, 4.}}, {});
    telegraph_slab(checks,
                   "fixed",
                   {{1, 10.}, {2, 4.}},
                   {{"Boundaries/ends/Thermal", "temperature"},
                    {"Initial state/Temperature", "310 + 10*sin(pi*x/0.005) + 4*sin(2*pi*x/0.005)"}});
    switched_source(checks);
    short_delay(checks);
    even_body_that_dies(checks);
  }
} // namespace Verification
