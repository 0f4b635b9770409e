// SPDX-License-Identifier: Apache-2.0
// Eight float lanes, like the four of lanes.hpp.
#pragma once

#include "lanes.hpp"

namespace jet::JET_KERNELS {

using Row = float __attribute__((vector_size(16)));
typedef float UnalignedRow __attribute__((vector_size(16), aligned(4), may_alias));
static_assert(alignof(UnalignedRow) == 4);

typedef std::int32_t UnalignedInts __attribute__((vector_size(32), aligned(4), may_alias));
static_assert(alignof(UnalignedInts) == 4);

struct Floats {
  using Values = float __attribute__((vector_size(32)));
  typedef float Unaligned __attribute__((vector_size(32), aligned(4), may_alias));
  static_assert(alignof(Unaligned) == 4);
  using Mask = decltype(Values{} < Values{});  // clang's integer of 32 bits may be long
  Values v{};

  Floats() = default;
  explicit Floats(float x) : v{x, x, x, x, x, x, x, x} {}
  explicit Floats(Values x) : v(x) {}
  static Floats load(const float* p) { return Floats(*reinterpret_cast<const Unaligned*>(p)); }
  void store(float* p) const { *reinterpret_cast<Unaligned*>(p) = v; }

  friend Floats operator+(Floats a, Floats b) { return Floats(a.v + b.v); }
  friend Floats operator-(Floats a, Floats b) { return Floats(a.v - b.v); }
  friend Floats operator*(Floats a, Floats b) { return Floats(a.v * b.v); }
  friend Floats operator/(float a, Floats b) { return Floats(a / b.v); }
  friend Floats operator*(float a, Floats b) { return Floats(a * b.v); }
  friend Floats operator+(Floats a, float b) { return Floats(a.v + b); }
  friend Floats operator-(Floats a) { return Floats(-a.v); }
  friend Mask operator<(Floats a, Floats b) { return a.v < b.v; }
  friend Mask operator>(Floats a, Floats b) { return a.v > b.v; }
  friend Mask operator<=(Floats a, Floats b) { return a.v <= b.v; }
  friend Mask operator>=(Floats a, Floats b) { return a.v >= b.v; }
  friend Floats select(Mask m, Floats a, Floats b) { return Floats(m ? a.v : b.v); }
  // b < a ? b : a and a < b ? b : a; gcc does not always find the single instruction.
  friend Floats min(Floats a, Floats b) {
#if defined(__AVX__)
    return Floats(reinterpret_cast<Values>(
        _mm256_min_ps(reinterpret_cast<__m256>(b.v), reinterpret_cast<__m256>(a.v))));
#else
    return select(b < a, b, a);
#endif
  }
  friend Floats max(Floats a, Floats b) {
#if defined(__AVX__)
    return Floats(reinterpret_cast<Values>(
        _mm256_max_ps(reinterpret_cast<__m256>(b.v), reinterpret_cast<__m256>(a.v))));
#else
    return select(a < b, b, a);
#endif
  }
  friend Floats abs(Floats a) {
    return Floats(reinterpret_cast<Values>(reinterpret_cast<Mask>(a.v) & INT32_MAX));
  }
};

/// One number in all lanes, by one instruction; GCC 12 needs two for Floats(*p).
inline Floats repeat(const float* p) {
#if defined(__AVX__)
  return Floats(reinterpret_cast<Floats::Values>(_mm256_broadcast_ss(p)));
#else
  return Floats(*p);
#endif
}

inline unsigned bits(Floats::Mask m) {
#if defined(__AVX__)
  return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(m)));
#else
  unsigned sum = 0;
  for (int i = 0; i < 8; ++i) sum |= static_cast<unsigned>(m[i] & 1) << i;
  return sum;
#endif
}

/// Reduces all lanes; the result is in each lane.
template <class Reduce>
[[gnu::always_inline]] inline Floats reduce(Floats a, Reduce better) {
  a = better(a, Floats(__builtin_shufflevector(a.v, a.v, 4, 5, 6, 7, 0, 1, 2, 3)));
  a = better(a, Floats(__builtin_shufflevector(a.v, a.v, 2, 3, 0, 1, 6, 7, 4, 5)));
  return better(a, Floats(__builtin_shufflevector(a.v, a.v, 1, 0, 3, 2, 5, 4, 7, 6)));
}
[[gnu::always_inline]] inline Floats least(Floats a) {
  return reduce(a, [](Floats x, Floats y) { return min(x, y); });
}
[[gnu::always_inline]] inline Floats greatest(Floats a) {
  return reduce(a, [](Floats x, Floats y) { return max(x, y); });
}

/// Places of the bits of a byte, in order.
struct BitPlaces {
  std::uint8_t at[256][8];
  constexpr BitPlaces() : at{} {
    for (int byte = 0; byte < 256; ++byte)
      for (int i = 0, count = 0; i < 8; ++i)
        if ((byte >> i & 1) != 0) at[byte][count++] = static_cast<std::uint8_t>(i);
  }
};
inline constexpr BitPlaces kBitPlaces;

/// Packs the lowest bits of eight bytes of 0 or 1 into one byte: byte i moves to bit 56 + i.
[[gnu::always_inline]] inline unsigned first_bits(std::uint64_t bytes) {
  return static_cast<unsigned>(bytes * 0x0102040810204080u >> 56);
}

/// One bit for each of 32 bytes: set if the byte is not 0.
[[gnu::always_inline]] inline unsigned not_zero(const std::uint8_t* bytes) {
#if defined(__AVX2__)
  const __m256i x = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(bytes));
  return ~static_cast<unsigned>(_mm256_movemask_epi8(_mm256_cmpeq_epi8(x, _mm256_setzero_si256())));
#else
  unsigned all = 0;
  for (int i = 0; i < 4; ++i) {
    constexpr std::uint64_t low = 0x7f7f7f7f7f7f7f7fu;
    std::uint64_t x;
    __builtin_memcpy(&x, bytes + 8 * i, 8);
    all |= first_bits((((x & low) + low) | x) >> 7 & ~low >> 7) << 8 * i;
  }
  return all;
#endif
}

/// Appends first + i for each set bit i to `out`, which has room for eight; returns their number. Branchless.
[[gnu::always_inline]] inline int append_bits(unsigned bits, int first, int* out) {
  const std::uint8_t* places = kBitPlaces.at[bits];
#if defined(__AVX2__)  // gcc does not find this instruction by itself
  const auto wide = reinterpret_cast<Floats::Mask>(
      _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(places))));
#else
  using Bytes = std::uint8_t __attribute__((vector_size(8)));
  const auto wide = __builtin_convertvector(*reinterpret_cast<const Bytes*>(places), Floats::Mask);
#endif
  *reinterpret_cast<UnalignedInts*>(out) = wide + first;
  return __builtin_popcount(bits);
}

/// Appends the numbers whose bits are set, of eight, to `out`, which has room for eight; returns their count.
[[gnu::always_inline]] inline int append_chosen(unsigned bits, UnalignedInts numbers, int* out) {
  const std::uint8_t* places = kBitPlaces.at[bits];
#if defined(__AVX2__)
  const __m256i wide = _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(places)));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(out),
                      _mm256_permutevar8x32_epi32(reinterpret_cast<__m256i>(numbers), wide));
#else
  for (int i = 0; i < 8; ++i) out[i] = numbers[places[i]];
#endif
  return __builtin_popcount(bits);
}

/// Lists the non-zero bytes, 512 at a time, and then the places of their bits. The only branch skips 32 bytes
/// that are all zero.
inline int list_bits(const std::uint8_t* bytes, int count, int* places) {
  constexpr int most = 512;
  int some[most + 8];
  int found = 0;
  for (int begin = 0; begin < count; begin += most) {
    const int end = count - begin < most ? count : begin + most;
    int listed = 0;
    for (int i = begin; i < end; i += 32) {
      const unsigned has = not_zero(bytes + i);
      if (has == 0) continue;
      for (int j = 0; j < 32; j += 8) listed += append_bits(has >> j & 0xffu, i + j, some + listed);
    }
    for (int i = 0; i < listed; ++i) found += append_bits(bytes[some[i]], 8 * some[i], places + found);
  }
  return found;
}

/// Gathers rows of four floats, which begin at at(0) to at(7), into lanes.
struct FourFloats {
  Vec3<Floats> point;
  Floats fourth;
};
template <class At>
[[gnu::always_inline]] inline FourFloats gather_four(const float* rows, At at) {
  const auto pair = [&](int i) {
    const Row a = *reinterpret_cast<const UnalignedRow*>(rows + at(i));
    const Row b = *reinterpret_cast<const UnalignedRow*>(rows + at(i + 4));
    return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
  };
  const auto r0 = pair(0), r1 = pair(1), r2 = pair(2), r3 = pair(3);
  const auto xy01 = __builtin_shufflevector(r0, r1, 0, 8, 1, 9, 4, 12, 5, 13);
  const auto xy23 = __builtin_shufflevector(r2, r3, 0, 8, 1, 9, 4, 12, 5, 13);
  const auto z01 = __builtin_shufflevector(r0, r1, 2, 10, 3, 11, 6, 14, 7, 15);
  const auto z23 = __builtin_shufflevector(r2, r3, 2, 10, 3, 11, 6, 14, 7, 15);
  return {{Floats(__builtin_shufflevector(xy01, xy23, 0, 1, 8, 9, 4, 5, 12, 13)),
           Floats(__builtin_shufflevector(xy01, xy23, 2, 3, 10, 11, 6, 7, 14, 15)),
           Floats(__builtin_shufflevector(z01, z23, 0, 1, 8, 9, 4, 5, 12, 13))},
          Floats(__builtin_shufflevector(z01, z23, 2, 3, 10, 11, 6, 7, 14, 15))};
}
/// Gathers the first three floats of the rows index(0) to index(7).
template <class Index>
[[gnu::always_inline]] inline Vec3<Floats> gather_rows(const float* rows, Index index) {
  return gather_four(rows, [&](int i) { return 4 * std::ptrdiff_t{index(i)}; }).point;
}

}  // namespace jet::JET_KERNELS
