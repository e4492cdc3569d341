// SPDX-License-Identifier: LGPL-2.1-or-later
// The line search by itself: where it stays, on balances that are met in different ways.
#include <cautery/time/line_search.h>

#include <functional>
#include <iostream>
#include <limits>
#include <string>

namespace
{
  using Balance = std::function<double(const double)>;

  /// Prints "ok" if it stays between these lengths.
  void expect(const std::string &what, const Balance &lack, const double least, const double most)
  {
    double length = 0.;
    Cautery::follow_to_balance(lack(0.), [&](const double at) {
      length = at;
      return lack(at);
    });
    std::cout << (length >= least && length <= most ? "  ok  " : "  BAD ") << what << std::endl;
  }
} // namespace

int main()
{
  constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinite  = std::numeric_limits<double>::infinity();
  expect(
    "balanced at the end: goes there", [](const double l) { return 1. - l; }, 1., 1.);
  expect(
    "overshot by less than half: goes there", [](const double l) { return 1. - 1.4 * l; }, 1., 1.);
  // half of what it lacked may be left over: 1/8 to 3/8
  expect(
    "overshot: stays where the balance is met", [](const double l) { return 1. - 4. * l; }, 0.125, 0.375);
  expect(
    "jumps: stays at the jump", [](const double l) { return l < 0.3 ? 1. : -5.; }, 0.29, 0.31);
  for (const double beyond : {no_number, infinite, -infinite})
    expect(
      "no number beyond 0.3: stays before that",
      [beyond](const double l) { return l < 0.3 ? 1. - 3. * l : beyond; },
      1. / 6.,
      0.3);
  return 0;
}
