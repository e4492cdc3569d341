// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests.h"

#include <algorithm>
#include <iostream>

namespace Cautery::Test
{
  namespace
  {
    unsigned int bad = 0;

    /// Of this section, with the number of items.
    std::vector<std::pair<std::string, unsigned int>> shown;

    void show(const std::string &what)
    {
      const auto known =
        std::find_if(shown.begin(), shown.end(), [&](const auto &entry) { return entry.first == what; });
      if (known == shown.end())
        shown.emplace_back(what, 1);
      else
        ++known->second;
    }
  } // namespace

  void holds(const std::string &item, const std::string &what, const bool truth)
  {
    bad += !truth;
    if (truth)
      show(what);
    else
      std::cout << "  BAD " << item << ": " << what << '\n';
  }

  void at_most(const std::string &item, const std::string &what, const double error, const double tolerance)
  {
    holds(item, what, error <= tolerance);
    if (!(error <= tolerance))
      std::cout << "      " << error << " is more than " << tolerance << '\n';
  }

  void section(const std::string &title, const std::function<void()> &test)
  {
    std::cout << title << '\n';
    shown.clear();
    test();
    for (const auto &entry : shown)
      std::cout << "  ok  " << entry.first
                << (entry.second == 1 ? "" : ", " + std::to_string(entry.second) + " times") << '\n';
  }

  bool all_good() { return bad == 0; }

  double difference(const Records &a, const Records &b)
  {
    double square = 0., scale = 0.;
    for (unsigned int i = 0; i < a.size(); ++i)
      {
        square += (a[i] - b[i]) * (a[i] - b[i]);
        scale += b[i] * b[i];
      }
    return std::sqrt(square / scale);
  }
} // namespace Cautery::Test
