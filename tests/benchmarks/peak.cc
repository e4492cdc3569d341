// SPDX-License-Identifier: LGPL-2.1-or-later
// Compiled for each instruction set: CAUTERY_PEAK_FLOAT and CAUTERY_PEAK_DOUBLE name the functions.
#include "peak.h"

namespace Cautery::Benchmark
{
  namespace
  {
    constexpr int chains = 12; // enough to hide the latency

    template <typename Number>
    double peak(const std::size_t n)
    {
      typedef Number Register __attribute__((vector_size(CAUTERY_LANE_BYTES)));
      Register       sums[chains];
      for (int c = 0; c < chains; ++c)
        sums[c] = Register{} + static_cast<Number>(c);
      Register factor = Register{} + static_cast<Number>(0.5);
      for (std::size_t i = 0; i < n; ++i)
        {
          __asm__ volatile("" : "+x"(factor)); // no round may be left out
          for (int c = 0; c < chains; ++c)
            sums[c] = sums[c] * factor + factor;
        }
      for (int c = 0; c < chains; ++c)
        __asm__ volatile("" : : "x"(sums[c]));
      return 2. * chains * n * (CAUTERY_LANE_BYTES / sizeof(Number));
    }
  } // namespace

  double CAUTERY_PEAK_FLOAT(const std::size_t n) { return peak<float>(n); }
  double CAUTERY_PEAK_DOUBLE(const std::size_t n) { return peak<double>(n); }
} // namespace Cautery::Benchmark
