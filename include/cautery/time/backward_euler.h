// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/time/backward_euler_balance.h>
#include <cautery/time/integrator.h>

#include <memory>
#include <vector>

namespace Cautery
{
  /**
   * Fixed steps; balances that act on those after them only are advanced one after the other.
   */
  class BackwardEuler : public Integrator
  {
  public:
    /** @p balances in the order in which they act on each other: heat first. */
    BackwardEuler(const TimeSettings           &settings,
                  const Numerics               &numerics,
                  const std::vector<Balance *> &balances,
                  Cost                         &cost);

    void                             step(State &state, const double stop) override;
    void                             archive(Archive &archive, const State &state) override;
    std::map<std::string, double>    statistics() const override;
    std::map<std::string, TimeError> time_errors() const override;

  private:
    const TimeSettings                                &settings;
    std::vector<std::unique_ptr<BackwardEulerBalance>> balances;
  };

  /** The next step of a given length (s), lengthened by rounding only, or shortened to land on @p stop. */
  Step next_step(const double time, const double length, const double stop);
} // namespace Cautery
