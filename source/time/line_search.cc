// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/time/line_search.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Cautery
{
  void follow_to_balance(const double start, const std::function<double(const double)> &lack_at)
  {
    using namespace LineSearch;
    // where something overflows, the balance is overshot
    const auto lack_or_overshot = [&lack_at](const double length) {
      const double lack = lack_at(length);
      return std::isfinite(lack) ? lack : -std::numeric_limits<double>::max();
    };
    double near = 0., far = 1., lack_near = start, lack_far = lack_or_overshot(far);
    if (lack_far >= -flattened * start)
      return;
    for (unsigned int attempt = 0; attempt < most_attempts; ++attempt)
      {
        const double width  = far - near;
        const double secant = near + width * lack_near / (lack_near - lack_far);
        const double length = std::min(std::max(secant, near + 0.05 * width), far - 0.05 * width);
        const double lack   = lack_or_overshot(length);
        if (std::abs(lack) <= flattened * start)
          return;
        (lack > 0. ? near : far)           = length;
        (lack > 0. ? lack_near : lack_far) = lack;
        (lack > 0. ? lack_far : lack_near) *= 0.5;
      }
  }
} // namespace Cautery
