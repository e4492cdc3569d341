// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/output/forecast.h>

#include <algorithm>

namespace Cautery
{
  namespace
  {
    double median(std::vector<double> values)
    {
      if (values.empty())
        return 0.;
      const auto middle = values.begin() + values.size() / 2;
      std::nth_element(values.begin(), middle, values.end());
      return *middle;
    }
  } // namespace

  void Forecast::add_step(const double length, const double seconds)
  {
    pace.push_back(seconds / length);
    spent += seconds;
  }

  void Forecast::make(const double time, const double passed, const double bytes)
  {
    const std::vector<double> later(pace.begin() + 2 * pace.size() / 3, pace.end());
    const unsigned int        outputs_left = n_outputs - std::min<unsigned int>(n_outputs, outputs.size());
    made = {passed + median(later) * (end - time) + median(outputs) * outputs_left,
            bytes,
            static_cast<unsigned int>(pace.size())};
  }
} // namespace Cautery
