// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "body.h"

#include <cmath>
#include <functional>
#include <limits>

namespace Cautery::Test
{
  /// Of hexahedra with one point, where it must change nothing.
  constexpr double hourglass = 0.1;

  /** Is it @p true that @p what, for @p item? Says so at once if not. */
  void holds(const std::string &item, const std::string &what, const bool truth);

  /** Is @p error, of the worst instruction set, at most @p tolerance? */
  void at_most(const std::string &item, const std::string &what, const double error, const double tolerance);

  /** Runs @p test, then lists what it has shown, each with the number of items. */
  void section(const std::string &title, const std::function<void()> &test);

  /** Has all held so far? */
  bool all_good();

  /** The largest of @p error(instruction set); not a number counts as infinite. */
  template <typename Error>
  double worst(const Error &error)
  {
    double result = 0.;
    for (const InstructionSet instruction_set : instruction_sets())
      {
        const double value = error(instruction_set);
        result = std::isnan(value) ? std::numeric_limits<double>::infinity() : std::max(result, value);
      }
    return result;
  }

  /** |a - b| / |b|. */
  double difference(const Records &a, const Records &b);

  void test_conduction();
  void test_deformed_conduction();
  void test_pressure();
  void test_step();
} // namespace Cautery::Test
