// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

namespace Cautery
{
  /**
   * What a run is going to cost, foretold from its first steps: what has passed, and for what is left the
   * median of the last third of these steps and of the outputs so far. The first steps of a run are dearer
   * than the others, because first guesses and matrices are still to be made.
   */
  class Forecast
  {
  public:
    struct Result
    {
      double       seconds     = 0.; ///< of the whole run
      double       bytes       = 0.; ///< most memory, of all processes
      unsigned int after_steps = 0;  ///< made when so many had been taken
    };

    /** Of a run to @p end (s) with @p n_outputs, the one at the start included. */
    Forecast(const double end, const unsigned int n_outputs) : end(end), n_outputs(n_outputs) {}

    /** A run that goes on with @p n of its outputs still to come. */
    void resume(const unsigned int n) { n_outputs = n; }

    void add_output(const double seconds) { outputs.push_back(seconds); }

    /** A step over @p length (s) that took @p seconds. */
    void add_step(const double length, const double seconds);

    /** After 30 steps, by when first guesses are good; sooner where steps are slow. */
    bool knows_enough() const { return pace.size() >= enough_steps || spent >= most_seconds; }

    /** At @p time (s), when @p passed seconds have been spent and most memory was @p bytes; for good. */
    void make(const double time, const double passed, const double bytes);

    const std::optional<Result> &result() const { return made; }

  private:
    static constexpr unsigned int enough_steps = 30;
    static constexpr double       most_seconds = 20.;

    const double          end;
    unsigned int          n_outputs;
    std::vector<double>   outputs; ///< wall time of each, s
    std::vector<double>   pace;    ///< wall time per simulated time of each step
    double                spent = 0.;
    std::optional<Result> made;
  };
} // namespace Cautery
