// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>

namespace Cautery
{
  namespace LineSearch
  {
    /// Of what is left over along a direction at the start, beyond the goal at the end.
    constexpr double       flattened     = 0.5;
    constexpr unsigned int most_attempts = 12;
  } // namespace LineSearch

  /**
   * Goes along a direction to its end, or, if the balance along it is overshot by more than half of what it
   * lacked, to about the place where it is met: by false position (Illinois), as at a peak of the capacity it
   * falls suddenly. @p lack_at goes to a length, from 0 to 1, and tells what the balance lacks there; it is
   * called last for the length to stay at. @p start: what it lacks at 0.
   */
  void follow_to_balance(const double start, const std::function<double(const double length)> &lack_at);
} // namespace Cautery
