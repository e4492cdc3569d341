// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/time/backward_euler.h>

namespace Cautery
{
  Step next_step(const double time, const double length, const double stop)
  {
    return {time, time + length * (1. + 1e-9) >= stop ? stop : time + length};
  }

  BackwardEuler::BackwardEuler(const TimeSettings           &settings,
                               const Numerics               &numerics,
                               const std::vector<Balance *> &list,
                               Cost                         &cost)
    : settings(settings)
  {
    for (Balance *balance : list)
      balances.push_back(std::make_unique<BackwardEulerBalance>(*balance, numerics, cost));
  }

  void BackwardEuler::step(State &state, const double stop)
  {
    const Step step = next_step(state.time, settings.step, stop);
    for (auto &balance : balances)
      balance->advance(step, state);
    state.time = step.to;
    ++state.step;
  }

  void BackwardEuler::archive(Archive &archive, const State &state)
  {
    for (auto &balance : balances)
      archive.section(balance->name(), [&]() { balance->archive(archive, state); });
  }

  std::map<std::string, double> BackwardEuler::statistics() const
  {
    std::map<std::string, double> result;
    for (const auto &balance : balances)
      result["linear_iterations_" + balance->name()] = balance->iterations();
    return result;
  }

  std::map<std::string, TimeError> BackwardEuler::time_errors() const
  {
    std::map<std::string, TimeError> result;
    for (const auto &balance : balances)
      balance->add_time_error(result);
    return result;
  }
} // namespace Cautery
