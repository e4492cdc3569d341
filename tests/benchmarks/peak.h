// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

namespace Cautery::Benchmark
{
  /// Does @p n rounds of multiplications and additions in registers and returns how many operations.
  using Peak = double (*)(const std::size_t n);

  // one pair for each instruction set
  double peak_float_x86_64(const std::size_t n);
  double peak_double_x86_64(const std::size_t n);
  double peak_float_x86_64_v3(const std::size_t n);
  double peak_double_x86_64_v3(const std::size_t n);
  double peak_float_x86_64_v4(const std::size_t n);
  double peak_double_x86_64_v4(const std::size_t n);
} // namespace Cautery::Benchmark
