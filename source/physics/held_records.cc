// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cautery/physics/held_records.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace Cautery
{
  template <typename Number>
  HeldRecords<Number>::HeldRecords(std::vector<Held> all) : held(std::move(all))
  {
    // first those that may settle, and one after the other those that follow the same expression
    std::stable_sort(held.begin(), held.end(), [](const Held &a, const Held &b) {
      if (a.value->depends_on_time() != b.value->depends_on_time())
        return b.value->depends_on_time();
      return std::less<const Expression *>()(a.value, b.value);
    });
  }

  template <typename Number>
  void HeldRecords<Number>::keep_rates(Records &keep, Records &gain) const
  {
    for (const Held &number : held)
      {
        keep[number.entry] = 1.;
        gain[number.entry] = 0.;
      }
  }

  template <typename Number>
  void HeldRecords<Number>::set_rates(
    const double to, const double duration, const double zero, const Records &values, Records &rates)
  {
    const Expression *last  = nullptr;
    double            value = 0.;
    for (std::size_t i = settled; i < held.size(); ++i)
      {
        const Held &number = held[i];
        // NOLINTNEXTLINE(clang-analyzer-core.CallAndMessage): each held number has one
        if (number.value != last || number.value->depends_on_place())
          value = number.value->value(number.place, to) - zero;
        last                = number.value;
        rates[number.entry] = (value - values[number.entry]) / duration;
        if (settled == i && !last->depends_on_time() && rates[number.entry] == 0)
          ++settled;
      }
  }

  template class HeldRecords<float>;
  template class HeldRecords<double>;
} // namespace Cautery
