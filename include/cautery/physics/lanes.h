// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <immintrin.h>
#include <type_traits>
#include <utility>

/**
 * @file
 * Numbers side by side in one register, by GCC's vector extensions. Only for source/physics/lanes/, which is
 * compiled for several instruction sets: all is in an anonymous namespace so that the linker cannot take a
 * function of one compilation for that of another.
 */

namespace Cautery
{
  namespace
  {
#define CAUTERY_INLINE inline __attribute__((always_inline))

    /**
     * @tparam width how many numbers: a multiple of four.
     */
    template <typename Number, int width>
    struct Lanes
    {
      using Bits = std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>;
      typedef Number Vector __attribute__((vector_size(width * sizeof(Number))));
      typedef Bits   BitVector __attribute__((vector_size(width * sizeof(Number))));
      typedef Number Record __attribute__((vector_size(4 * sizeof(Number))));

      Vector v;

      CAUTERY_INLINE Lanes() = default;
      CAUTERY_INLINE Lanes(const Vector &v) : v(v) {}
      CAUTERY_INLINE Lanes(const double number) : v(static_cast<Number>(number) - Vector{}) {}

      CAUTERY_INLINE static Lanes load(const Number *aligned)
      {
        return *reinterpret_cast<const Vector *>(aligned);
      }

      friend CAUTERY_INLINE Lanes operator+(const Lanes &a, const Lanes &b) { return a.v + b.v; }
      friend CAUTERY_INLINE Lanes operator-(const Lanes &a, const Lanes &b) { return a.v - b.v; }
      friend CAUTERY_INLINE Lanes operator*(const Lanes &a, const Lanes &b) { return a.v * b.v; }
      friend CAUTERY_INLINE Lanes operator/(const Lanes &a, const Lanes &b) { return a.v / b.v; }
      friend CAUTERY_INLINE Lanes operator-(const Lanes &a) { return -a.v; }

      friend CAUTERY_INLINE Lanes at_least(const Lanes &bound, const Lanes &value)
      {
        return value.v > bound.v ? value.v : bound.v;
      }
    };

    /** The bits of a floating-point type. */
    template <typename Number>
    struct Format;
    template <>
    struct Format<float>
    {
      static constexpr int           mantissa = 23, bias = 127;
      static constexpr double        to_integer = 12582912.; ///< 1.5 * 2^23: adding it rounds to an integer
      static constexpr double        largest_exponent  = 127.;
      static constexpr int           exponential_terms = 7, logarithm_terms = 5;
      static constexpr std::uint32_t root_half = 0x3f3504f3; ///< sqrt(1/2)
    };
    template <>
    struct Format<double>
    {
      static constexpr int           mantissa = 52, bias = 1023;
      static constexpr double        to_integer        = 6755399441055744.; ///< 1.5 * 2^52
      static constexpr double        largest_exponent  = 1023.;
      static constexpr int           exponential_terms = 13, logarithm_terms = 11;
      static constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcd;
    };

    /// 1 / (n + 1)!
    struct ReciprocalFactorials
    {
      static constexpr double coefficient(const int n) { return n == 0 ? 1. : coefficient(n - 1) / (n + 1); }
    };

    /// 2 / (2 n + 1)
    struct ReciprocalsOfOdds
    {
      static constexpr double coefficient(const int n) { return 2. / (2 * n + 1); }
    };

    /** The sum of coefficient(n) x^n for n = first, first + 2, ... < @p terms; @p square is that of x. */
    template <typename Series, int first, int terms, typename L>
    CAUTERY_INLINE L every_other_power(const L &square)
    {
      constexpr double coefficient = Series::coefficient(first);
      if constexpr (first + 2 < terms)
        return coefficient + square * every_other_power<Series, first + 2, terms>(square);
      else
        return L(coefficient);
    }

    /**
     * The sum of coefficient(n) x^n for n < @p terms: odd and even powers apart, because one sum that waits
     * for each product takes longer than all other arithmetic.
     */
    template <typename Series, int terms, typename L>
    CAUTERY_INLINE L polynomial(const L &x)
    {
      const L square = x * x;
      return every_other_power<Series, 0, terms>(square) + x * every_other_power<Series, 1, terms>(square);
    }

    /** exp(x) = scale (1 + remainder) with scale a power of two. */
    template <typename Lanes>
    struct Exponential
    {
      Lanes scale, remainder;
    };

    /** By Taylor's series around the nearest multiple of ln 2; @p x is cut where its exponential overflows.
     */
    template <typename Number, int width>
    CAUTERY_INLINE Exponential<Lanes<Number, width>> exponential(const Lanes<Number, width> &argument)
    {
      using L               = Lanes<Number, width>;
      using F               = Format<Number>;
      const double ln2_high = 0.693145751953125, ln2_low = 1.4286068203094172e-06; // their sum is ln 2
      const double limit             = (F::largest_exponent - 1.) * (ln2_high + ln2_low);
      const L      x                 = -at_least(L(-limit), -at_least(L(-limit), argument));
      const L      shifted           = x * 1.4426950408889634 + F::to_integer;
      const L      k                 = shifted - F::to_integer;
      const L      r                 = (x - k * ln2_high) - k * ln2_low;
      const L      series            = polynomial<ReciprocalFactorials, F::exponential_terms>(r);
      typename L::BitVector exponent = reinterpret_cast<typename L::BitVector>(shifted.v) << F::mantissa;
      exponent += static_cast<typename L::Bits>(F::bias) << F::mantissa;
      return {L(reinterpret_cast<typename L::Vector>(exponent)), series * r};
    }

    template <typename Number, int width>
    CAUTERY_INLINE Lanes<Number, width> exp(const Lanes<Number, width> &x)
    {
      const auto e = exponential(x);
      return e.scale + e.scale * e.remainder;
    }

    template <typename Number, int width>
    CAUTERY_INLINE Lanes<Number, width> expm1(const Lanes<Number, width> &x)
    {
      const auto e = exponential(x);
      return (e.scale - 1.) + e.scale * e.remainder;
    }

    /**
     * ln(1 + x) = k ln 2 + 2 artanh(f / (2 + f)) with 1 + x = 2^k (1 + f) and 1 + f between sqrt(1/2) and
     * sqrt(2). Of no use where 1 + x <= 0: the caller looks for that.
     */
    template <typename Number, int width>
    CAUTERY_INLINE Lanes<Number, width> log1p(const Lanes<Number, width> &x)
    {
      using L              = Lanes<Number, width>;
      using F              = Format<Number>;
      using Bits           = typename L::BitVector;
      using Bit            = typename L::Bits;
      constexpr Bit one    = static_cast<Bit>(F::bias) << F::mantissa;
      const L       y      = 1. + x;
      const Bits    bits   = reinterpret_cast<Bits>(y.v);
      const Bits    biased = (bits + (one - F::root_half)) >> F::mantissa; // k + bias
      const L       m(reinterpret_cast<typename L::Vector>(bits - (biased << F::mantissa) + one));
      const double  power      = 2. * (1ull << (F::mantissa - 1)); // 2^mantissa; its last bit counts 1
      constexpr Bit power_bits = static_cast<Bit>(F::bias + F::mantissa) << F::mantissa;
      const L       k = L(reinterpret_cast<typename L::Vector>(biased | power_bits)) - (power + F::bias);
      // where k = 0, x itself has digits that 1 + x has lost
      const L f(biased == static_cast<Bit>(F::bias) ? x.v : (m - 1.).v);
      const L s      = f / (2. + f);
      const L square = s * s;
      const L series = polynomial<ReciprocalsOfOdds, F::logarithm_terms>(square);
      return k * 0.6931471805599453 + s * series;
    }

    /** The four numbers of a node's record, of one node in each lane. */
    template <typename Number, int width>
    struct NodeRecords
    {
      Lanes<Number, width> component[4];
    };

    /** The lanes of @p a and @p b in the order @p mask: constants, so one instruction. */
    template <typename Lanes, typename... Index>
    CAUTERY_INLINE Lanes shuffle(const Lanes &a, const Lanes &b, const Index... index)
    {
      typedef std::make_signed_t<typename Lanes::Bits> Mask
        __attribute__((vector_size(sizeof(typename Lanes::Vector))));
      return Lanes(__builtin_shuffle(a.v, b.v, Mask{index...}));
    }

    /**
     * Transposes each block of 4 x 4 numbers: component c of record j changes places with component j of
     * record c. Two rounds of shuffles, whose first stays within 128 bits.
     */
    template <typename Number, int width, int... I>
    CAUTERY_INLINE void transpose(NodeRecords<Number, width> &records, std::integer_sequence<int, I...>)
    {
      auto &r = records.component;
      if constexpr (sizeof(Number) == 4)
        {
          const auto low_01  = shuffle(r[0], r[1], (I / 4 * 4 + I % 4 / 2 + I % 2 * width)...);
          const auto low_23  = shuffle(r[2], r[3], (I / 4 * 4 + I % 4 / 2 + I % 2 * width)...);
          const auto high_01 = shuffle(r[0], r[1], (I / 4 * 4 + 2 + I % 4 / 2 + I % 2 * width)...);
          const auto high_23 = shuffle(r[2], r[3], (I / 4 * 4 + 2 + I % 4 / 2 + I % 2 * width)...);
          r[0]               = shuffle(low_01, low_23, (I / 4 * 4 + I % 2 + I % 4 / 2 * width)...);
          r[1]               = shuffle(low_01, low_23, (I / 4 * 4 + 2 + I % 2 + I % 4 / 2 * width)...);
          r[2]               = shuffle(high_01, high_23, (I / 4 * 4 + I % 2 + I % 4 / 2 * width)...);
          r[3]               = shuffle(high_01, high_23, (I / 4 * 4 + 2 + I % 2 + I % 4 / 2 * width)...);
        }
      else
        {
          const auto even_01 = shuffle(r[0], r[1], (I / 2 * 2 + I % 2 * width)...);
          const auto odd_01  = shuffle(r[0], r[1], (I / 2 * 2 + 1 + I % 2 * width)...);
          const auto even_23 = shuffle(r[2], r[3], (I / 2 * 2 + I % 2 * width)...);
          const auto odd_23  = shuffle(r[2], r[3], (I / 2 * 2 + 1 + I % 2 * width)...);
          r[0]               = shuffle(even_01, even_23, (I / 4 * 4 + I % 2 + I % 4 / 2 * width)...);
          r[1]               = shuffle(odd_01, odd_23, (I / 4 * 4 + I % 2 + I % 4 / 2 * width)...);
          r[2]               = shuffle(even_01, even_23, (I / 4 * 4 + 2 + I % 2 + I % 4 / 2 * width)...);
          r[3]               = shuffle(odd_01, odd_23, (I / 4 * 4 + 2 + I % 2 + I % 4 / 2 * width)...);
        }
    }

    template <typename Number>
    CAUTERY_INLINE auto &record(Number *values, const std::uint32_t offset)
    {
      using Record = typename Lanes<std::remove_const_t<Number>, 4>::Record;
      using Result = std::conditional_t<std::is_const_v<Number>, const Record, Record>;
      return *reinterpret_cast<Result *>(values + offset);
    }

    // Halves of registers: GCC 12 makes two or three times as many shuffles of its own vectors as needed.
#ifdef __AVX__
    CAUTERY_INLINE __m256 join(const __m128 low, const __m128 high)
    {
      return _mm256_insertf128_ps(_mm256_castps128_ps256(low), high, 1);
    }
    CAUTERY_INLINE __m128 low(const __m256 v) { return _mm256_castps256_ps128(v); }
    CAUTERY_INLINE __m128 high(const __m256 v) { return _mm256_extractf128_ps(v, 1); }
#endif
#ifdef __AVX512DQ__
    CAUTERY_INLINE __m512 join(const __m256 low, const __m256 high)
    {
      return _mm512_insertf32x8(_mm512_castps256_ps512(low), high, 1);
    }
    CAUTERY_INLINE __m256  low(const __m512 v) { return _mm512_castps512_ps256(v); }
    CAUTERY_INLINE __m256  high(const __m512 v) { return _mm512_extractf32x8_ps(v, 1); }
    CAUTERY_INLINE __m512d join(const __m256d low, const __m256d high)
    {
      return _mm512_insertf64x4(_mm512_castpd256_pd512(low), high, 1);
    }
    CAUTERY_INLINE __m256d low(const __m512d v) { return _mm512_castpd512_pd256(v); }
    CAUTERY_INLINE __m256d high(const __m512d v) { return _mm512_extractf64x4_pd(v, 1); }
#endif

    /** Asks memory for @p count numbers that are needed soon; @p numbers may lie past the end of an array. */
    template <int count, typename Number>
    CAUTERY_INLINE void prefetch(const Number *numbers)
    {
      constexpr int in_cache_line = 64 / sizeof(Number);
      for (int i = 0; i < count; i += in_cache_line)
        __builtin_prefetch(numbers + i);
    }

    /** Reads a record for each lane. */
    template <typename Number, int width>
    CAUTERY_INLINE void
    gather(const Number *values, const std::uint32_t *offsets, NodeRecords<Number, width> &records)
    {
      for (int j = 0; j < 4; ++j)
        {
          const auto at = [&](const int block) { return record(values, offsets[4 * block + j]); };
          if constexpr (width == 4)
            records.component[j].v = at(0);
          else if constexpr (width == 8)
            records.component[j].v = join(at(0), at(1));
          else
            records.component[j].v = join(join(at(0), at(1)), join(at(2), at(3)));
        }
      transpose(records, std::make_integer_sequence<int, width>());
    }

    /** Adds a record for each lane, one after the other: lanes may share a node. */
    template <typename Number, int width>
    CAUTERY_INLINE void
    scatter_add(NodeRecords<Number, width> records, const std::uint32_t *offsets, Number *forces)
    {
      transpose(records, std::make_integer_sequence<int, width>());
      for (int j = 0; j < 4; ++j)
        {
          const auto add = [&](const int block, const auto part) {
            record(forces, offsets[4 * block + j]) += part;
          };
          const auto v = records.component[j].v;
          if constexpr (width == 4)
            add(0, v);
          else if constexpr (width == 8)
            {
              add(0, low(v));
              add(1, high(v));
            }
          else
            {
              add(0, low(low(v)));
              add(1, high(low(v)));
              add(2, low(high(v)));
              add(3, high(high(v)));
            }
        }
    }
  } // namespace
} // namespace Cautery
