// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

/// Elementary functions that have the same bits on every processor, with every compiler and every libm. Each
/// is computed in integers and rounded once, so the value is the double nearest to the exact result. 64
/// digits are computed first, and 128 if 64 do not decide the rounding.
namespace elementary {

using Digits64 = std::uint64_t;
__extension__ typedef unsigned __int128 Digits128;  // -Wpedantic

template <class Digits>
inline constexpr int kDigits = 8 * sizeof(Digits);

/// Upper half of the product.
[[gnu::always_inline]] inline Digits64 high_product(Digits64 a, Digits64 b) {
  return static_cast<Digits64>(Digits128{a} * b >> 64);
}
[[gnu::always_inline]] inline Digits128 high_product(Digits128 a, Digits128 b) {
  const auto low = [](Digits128 x) { return static_cast<Digits64>(x); };
  const Digits128 a1 = a >> 64, a0 = low(a), b1 = b >> 64, b0 = low(b);
  const Digits128 p10 = a1 * b0, p01 = a0 * b1;
  const Digits128 middle = (a0 * b0 >> 64) + low(p10) + low(p01);
  return a1 * b1 + (p10 >> 64) + (p01 >> 64) + (middle >> 64);
}

inline int leading_zeros(Digits64 x) {
  return std::countl_zero(x);
}
inline int leading_zeros(Digits128 x) {
  const auto high = static_cast<Digits64>(x >> 64);
  return high != 0 ? std::countl_zero(high) : 64 + std::countl_zero(static_cast<Digits64>(x));
}

/// A number of 64 or 128 binary digits: digits 2^(exponent + 1 - their count), the first digit set, or zero.
/// Each operation is exact, or wrong by a few last digits of its larger operand.
template <class Digits>
struct Wide {
  Digits digits = 0;
  int exponent = -1;
  bool negative = false;

  /// digits 2^scale
  static Wide scaled(Digits digits, int scale, bool negative = false) {
    if (digits == 0) return {};
    const int zeros = leading_zeros(digits);
    return {digits << zeros, scale + kDigits<Digits> - 1 - zeros, negative};
  }
  /// A finite number.
  static Wide of(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const int biased = static_cast<int>(bits >> 52 & 0x7ff);
    const std::uint64_t fraction = bits & 0xfffffffffffffu;
    if (biased == 0) return scaled(fraction, -1074, std::signbit(x));
    return {Digits{fraction | std::uint64_t{1} << 52} << (kDigits<Digits> - 53), biased - 1023,
            std::signbit(x)};
  }
  /// Two words of digits.
  static constexpr Wide of(std::uint64_t high, std::uint64_t low, int exponent) {
    return {static_cast<Digits>((Digits128{high} << 64 | low) >> (128 - kDigits<Digits>)), exponent};
  }
  static constexpr Wide one() { return of(std::uint64_t{1} << 63, 0, 0); }
  static constexpr Wide half_pi() { return of(0xc90fdaa22168c234, 0xc4c6628b80dc1cd1, 0); }

  /// 2^power of it
  [[nodiscard]] Wide times_power_of_two(int power) const { return {digits, exponent + power, negative}; }

  friend Wide operator-(const Wide& a) { return {a.digits, a.exponent, !a.negative}; }
  friend Wide operator*(const Wide& a, const Wide& b) {
    return scaled(high_product(a.digits, b.digits), a.exponent + b.exponent + 2 - kDigits<Digits>,
                  a.negative != b.negative);
  }
  friend Wide operator+(const Wide& a, const Wide& b) {
    if (a.digits == 0) return b;
    if (b.digits == 0) return a;
    if (a.exponent < b.exponent || (a.exponent == b.exponent && a.digits < b.digits)) return b + a;
    const int shift = a.exponent - b.exponent;
    const Digits smaller = shift < kDigits<Digits> ? b.digits >> shift : 0;
    if (a.negative != b.negative)
      return scaled(a.digits - smaller, a.exponent + 1 - kDigits<Digits>, a.negative);
    const Digits sum = a.digits + smaller;
    if (sum >= smaller) return {sum, a.exponent, a.negative};
    return {sum >> 1 | Digits{1} << (kDigits<Digits> - 1), a.exponent + 1, a.negative};
  }
  friend Wide operator-(const Wide& a, const Wide& b) { return a + -b; }
  /// b is not zero. Newton's iteration from the quotient of doubles.
  friend Wide operator/(const Wide& a, const Wide& b) {
    const Wide part{b.digits, 0}, two = of(2.0);
    Wide inverse = of(1.0 / part.leading());
    for (int right = 50; right < kDigits<Digits>; right *= 2) inverse = inverse * (two - part * inverse);
    return a * Wide{inverse.digits, inverse.exponent - b.exponent, b.negative};
  }

  /// The first 53 digits. Precondition: not negative, and in the range of normal doubles.
  [[nodiscard]] double leading() const {
    const auto first = static_cast<std::uint64_t>(digits >> (kDigits<Digits> - 53));
    return std::bit_cast<double>((static_cast<std::uint64_t>(exponent + 1022) << 52) + first);
  }
  /// The nearest double; a tie goes to the even one. A number within `slack` last digits of the middle counts
  /// as the middle.
  [[nodiscard]] double rounded(std::uint64_t slack = 0) const;
  /// True if the result is a normal double, and all numbers within `slack` last digits round to it.
  [[nodiscard]] bool is_certain(std::uint64_t slack) const {
    const Digits middle = Digits{1} << (kDigits<Digits> - 54), dropped = digits & (2 * middle - 1);
    return exponent >= -1022 && (dropped > middle ? dropped - middle : middle - dropped) > slack;
  }
};

template <class Digits>
double Wide<Digits>::rounded(std::uint64_t slack) const {
  const auto sign = std::uint64_t{negative} << 63;
  const int dropped_count = kDigits<Digits> - 53 + (exponent >= -1022 ? 0 : -1022 - exponent);
  if (digits == 0 || dropped_count > kDigits<Digits>) return std::bit_cast<double>(sign);
  if (exponent > 1023) return negative ? -HUGE_VAL : HUGE_VAL;
  const bool all_dropped = dropped_count == kDigits<Digits>;
  auto kept = all_dropped ? 0 : static_cast<std::uint64_t>(digits >> dropped_count);
  const Digits middle = Digits{1} << (dropped_count - 1),
               dropped = all_dropped ? digits : digits - (Digits{kept} << dropped_count);
  if ((dropped > middle ? dropped - middle : middle - dropped) <= slack)
    kept += kept & 1;
  else if (dropped > middle)
    ++kept;
  // The first digit of a normal number adds one to the exponent, and so does a carry, up to infinity.
  const auto biased = exponent >= -1022 ? static_cast<std::uint64_t>(exponent + 1022) : 0;
  return std::bit_cast<double>(sign | ((biased << 52) + kept));
}

/// Bound of the error of a function computed with 64 digits [last digits]. A test measures less than half of
/// it.
inline constexpr std::uint64_t kSlack = 32;

/// f(Wide<Digits64>), rounded, or f(Wide<Digits128>) if its error may matter. The type of f's argument
/// selects the type of its result.
template <class Function>
double nearest(const Function& f) {
  const Wide<Digits64> quick = f(Wide<Digits64>{});
  return quick.is_certain(kSlack) ? quick.rounded() : f(Wide<Digits128>{}).rounded();
}

/// c_0, c_1, ... of a series, in units of the last digit below 2.
template <class Digits, int count>
struct Coefficients {
  Digits at[count];
};
/// 1/1, 1/3, 1/5, ...
template <class Digits, int count>
constexpr Coefficients<Digits, count> odd_reciprocals() {
  Coefficients<Digits, count> c{};
  for (int k = 0; k < count; ++k)
    c.at[k] = (Digits{1} << (kDigits<Digits> - 1)) / static_cast<Digits>(2 * k + 1);
  return c;
}
/// 1/first!, 1/(first + step)!, ...
template <class Digits, int count>
constexpr Coefficients<Digits, count> factorial_reciprocals(int first, int step) {
  Coefficients<Digits, count> c{};
  Digits value = Digits{1} << (kDigits<Digits> - 1);
  for (int n = 1, k = 0; k < count; ++n) {
    value /= static_cast<Digits>(n);
    if (n == first + k * step) c.at[k++] = value;
  }
  return c;
}

/// sum_k c_k t^k, or with (-t)^k if `alternating`; 0 <= t < 1, sum < 2. Even and odd terms are summed apart,
/// so that both chains run in parallel.
template <class Digits, int count>
[[gnu::always_inline]] inline Wide<Digits> series(const Coefficients<Digits, count>& c, const Wide<Digits>& t,
                                                  bool alternating) {
  const int shift = -1 - t.exponent;
  const Digits x = shift < kDigits<Digits> ? t.digits >> shift : 0, square = high_product(x, x);
  Digits even = 0, odd = 0;
  for (int k = count - 1; k >= 0; --k)
    (k % 2 == 0 ? even : odd) = c.at[k] + high_product(square, k % 2 == 0 ? even : odd);
  const Digits rest = high_product(x, odd);
  return Wide<Digits>::scaled(alternating ? even - rest : even + rest, 1 - kDigits<Digits>);
}

}  // namespace elementary
