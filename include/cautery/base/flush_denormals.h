// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <xmmintrin.h>

namespace Cautery
{
  /**
   * While one lives, numbers too small for full precision count as zero on this thread: a wave that has just
   * begun to spread is full of them in single precision, and each costs over a hundred cycles.
   */
  class FlushDenormals
  {
  public:
    FlushDenormals() : before(_mm_getcsr()) { _mm_setcsr(before | flush_to_zero | denormals_are_zero); }
    ~FlushDenormals() { _mm_setcsr(before); }
    FlushDenormals(const FlushDenormals &)            = delete;
    FlushDenormals &operator=(const FlushDenormals &) = delete;

  private:
    static constexpr unsigned int flush_to_zero = 0x8000, denormals_are_zero = 0x40;
    const unsigned int            before;
  };
} // namespace Cautery
