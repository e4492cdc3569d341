// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cautery/base/archive.h>

#include <algorithm>

namespace Cautery
{
  /**
   * What the steps of an integrator err by, as it estimates it itself: for each step the largest error at any
   * free unknown that the step adds to where it begins, in the unit of the unknown.
   */
  struct TimeError
  {
    double largest = 0.; ///< of one step
    double sum     = 0.; ///< over all steps. Heat that obeys Fourier evens errors out, so that it bounds the
                         ///< error at the end, but for higher orders; elsewhere it is a guide.
    unsigned int steps = 0;

    /** Counts @p n_steps steps that err by @p error each. */
    void add(const double error, const unsigned int n_steps = 1)
    {
      largest = std::max(largest, error);
      sum += n_steps * error;
      steps += n_steps;
    }

    void archive(Archive &archive)
    {
      archive.shared("largest error of a step", largest);
      archive.shared("errors of all steps", sum);
      archive.shared("steps with an error", steps);
    }

    /** Counts the steps of another one too. */
    TimeError &operator+=(const TimeError &other)
    {
      largest = std::max(largest, other.largest);
      sum += other.sum;
      steps += other.steps;
      return *this;
    }
  };
} // namespace Cautery
