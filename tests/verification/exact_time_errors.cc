// SPDX-License-Identifier: LGPL-2.1-or-later
// The errors in time that a run tells of itself against the true ones.
#include "chain.h"

namespace Verification
{
  namespace
  {
    constexpr double capacity = 1000. * 4192., power = 7e6, perfusion = 50. * 3600., start = 310.;

    /// A body heated everywhere alike from 2 s to 6 s and cooled by blood.
    double exact_temperature(const double time)
    {
      const double decay  = perfusion / capacity;
      const double heated = std::clamp(time - 2., 0., 4.);
      return start +
             power / perfusion * -std::expm1(-decay * heated) * std::exp(-decay * std::max(time - 6., 0.));
    }

    std::vector<Override>
    uniform(const std::string &model, const double end, const std::vector<Override> &more)
    {
      std::vector<Override> result = {{"Effects/Heat", model},
                                      {"Effects/Perfusion", "on"},
                                      {"Tissues/tissue/Perfusion rate", "50"},
                                      {"Time/End", to_text(end)},
                                      {"Output/Times", to_text(0.5 * end)}};
      result.insert(result.end(), more.begin(), more.end());
      return result;
    }

    double of_steps(const Outcome &outcome, const std::string &entry, const std::string &balance = "heat")
    {
      return outcome.summary.at("errors").at("time").at(balance).at(entry);
    }

    /**
     * While heat is on all errors have one sign, and the sum is nearly the error at the end; the decay makes
     * it a little larger. After the switch they have the other sign: the sum is a bound.
     */
    void backward_euler(Checks &checks)
    {
      std::map<double, double> sums, largest;
      for (const double step : {0.5, 0.25, 0.125})
        {
          for (const double end : {6., 10.})
            {
              const Outcome outcome =
                run("switched", uniform("Fourier", end, {{"Time/Step", to_text(step)}}));
              const double error = std::abs(outcome.end("P", "temperature_K") - exact_temperature(end));
              const double sum   = of_steps(outcome, "sum_over_steps_K");
              const auto   label = "backward Euler, dt = " + to_text(step) + ", end = " + to_text(end);
              if (end == 6.)
                {
                  checks.near(label + ", sum of estimates over error", sum / error, 1.1, 0.1);
                  sums[step]    = sum;
                  largest[step] = of_steps(outcome, "largest_of_a_step_K");
                }
              else
                checks.below(label + ", error over sum of estimates", error / sum, 1.);
            }
        }
      checks.near("backward Euler, order of the sum", std::log2(sums[0.25] / sums[0.125]), 1., 0.05);
      checks.near("backward Euler, order of one step", std::log2(largest[0.25] / largest[0.125]), 2., 0.05);
    }

    /// Against IDA at a tolerance of 1e-9. The errors of rates carry on into temperatures, which the sum does
    /// not know.
    void non_fourier(Checks &checks)
    {
      const Outcome truth = run("switched", uniform("non-Fourier", 6., {{"Time/Integrator", "IDA"}}));
      for (const std::string step : {"0.25", "0.125"})
        {
          const Outcome outcome = run("switched", uniform("non-Fourier", 6., {{"Time/Step", step}}));
          const double  error = std::abs(outcome.end("P", "temperature_K") - truth.end("P", "temperature_K"));
          checks.near("non-Fourier, dt = " + step + ", sum of estimates over error, as its logarithm",
                      std::log(of_steps(outcome, "sum_over_steps_K") / error),
                      0.,
                      std::log(4.));
        }
    }

    void ida(Checks &checks)
    {
      for (const std::string tolerance : {"1e-4", "1e-6"})
        {
          const Outcome outcome = run("switched",
                                      uniform("Fourier",
                                              6.,
                                              {{"Time/Integrator", "IDA"},
                                               {"Time/Relative tolerance", tolerance},
                                               {"Time/Absolute tolerance", tolerance}}));
          const double  error   = std::abs(outcome.end("P", "temperature_K") - exact_temperature(6.));
          checks.near("IDA, tolerance " + tolerance + ", sum of estimates over error, as its logarithm",
                      std::log(of_steps(outcome, "sum_over_steps_K") / error),
                      0.,
                      std::log(10.));
        }
    }
  } // namespace

  void time_errors(Checks &checks)
  {
    backward_euler(checks);
    non_fourier(checks);
    ida(checks);
  }
} // namespace Verification
