// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "elementary/wide.hpp"

namespace elementary {

/// (e^r - 1)/r for |r| <= 0.35: sum_k r^k/(k+1)!. 16 terms leave 2^-70, 27 leave 2^-132.
template <class Digits>
Wide<Digits> growth(const Wide<Digits>& r) {
  static constexpr auto c = factorial_reciprocals < Digits, kDigits<Digits> == 64 ? 16 : 27 > (1, 1);
  return series(c, r, r.negative);
}

/// e^x for |x| < 1024.
template <class Digits>
Wide<Digits> exp(const Wide<Digits>& x) {
  using Number = Wide<Digits>;
  int whole = 0;  // x/ln 2, rounded to an integer
  Number r = x;
  if (x.exponent >= -2) {
    whole = static_cast<int>(x.leading() * 1.4426950408889634 + 0.5);
    if (x.negative) whole = -whole;
    // ln 2 = high + low. The first product is exact.
    static constexpr Number high = Number::of(0xb17217f7d1cf7800, 0, -1),
                            low = Number::of(0xd5e4f1d9cc01f97b, 0x57a079a193394c5b, -56);
    const Number n = Number::of(static_cast<double>(whole));
    r = (x - n * high) - n * low;
  }
  return (Number::one() + r * growth(r)).times_power_of_two(whole);
}

/// e^x - 1
template <class Digits>
Wide<Digits> growing(const Wide<Digits>& x) {
  return x.exponent < -2 ? x * growth(x) : exp(x) - Wide<Digits>::one();
}

/// ln(1 + u) for |u| <= 0.42: 2 artanh(u/(2 + u)). 13 terms leave 2^-69, 26 leave 2^-135.
template <class Digits>
Wide<Digits> log_near_one(const Wide<Digits>& u) {
  static constexpr auto c = odd_reciprocals < Digits, kDigits<Digits> == 64 ? 13 : 26 > ();
  const Wide<Digits> s = u / (Wide<Digits>::of(2.0) + u);
  return (s * series(c, s * s, false)).times_power_of_two(1);
}

/// ln x for x > 0.
template <class Digits>
Wide<Digits> log(const Wide<Digits>& x) {
  using Number = Wide<Digits>;
  static constexpr Number ln_2 = Number::of(0xb17217f7d1cf79ab, 0xc9e3b39803f2f6af, -1);
  constexpr Digits root_of_two = Digits{0xb504f333u} << (kDigits<Digits> - 32);
  const int whole = x.exponent + (x.digits > root_of_two ? 1 : 0);
  const Number part{x.digits, x.exponent - whole};
  return Number::of(static_cast<double>(whole)) * ln_2 + log_near_one(part - Number::one());
}

/// ln(1 + u) for u > -1.
template <class Digits>
Wide<Digits> log_of_one_and(const Wide<Digits>& u) {
  return u.exponent < -2 ? log_near_one(u) : log(Wide<Digits>::one() + u);
}

/// e^x
inline double exp(double x) {
  if (std::isnan(x)) return x;
  if (x > 710.0) return HUGE_VAL;
  if (x < -746.0) return 0.0;
  return nearest([x](auto number) { return exp(number.of(x)); });
}

/// e^x - 1
inline double expm1(double x) {
  if (std::isnan(x) || x == 0.0) return x;
  if (x > 710.0) return HUGE_VAL;
  if (x < -100.0) return -1.0;
  return nearest([x](auto number) { return growing(number.of(x)); });
}

/// ln x
inline double log(double x) {
  if (std::isnan(x) || x == HUGE_VAL) return x;
  if (x == 0.0) return -HUGE_VAL;
  if (x < 0.0) return NAN;
  return nearest([x](auto number) { return log(number.of(x)); });
}

/// ln(1 + x)
inline double log1p(double x) {
  if (std::isnan(x) || x == HUGE_VAL || x == 0.0) return x;
  if (x == -1.0) return -HUGE_VAL;
  if (x < -1.0) return NAN;
  return nearest([x](auto number) { return log_of_one_and(number.of(x)); });
}

/// As kSlack, for powers computed with 64 digits.
inline constexpr std::uint64_t kPowerSlack = 128;

/// x^y for x >= 0; NaN for x < 0, unless y = 0.
inline double pow(double x, double y) {
  if (x == 1.0 || y == 0.0) return 1.0;
  if (std::isnan(x) || std::isnan(y) || x < 0.0) return NAN;
  const bool grows = (x > 1.0) == (y > 0.0);
  if (x == 0.0 || std::isinf(x) || std::isinf(y)) return grows ? HUGE_VAL : 0.0;
  const auto exponent = [x, y](auto number) { return number.of(y) * log(number.of(x)); };
  if (const auto power = exponent(Wide<Digits64>{}); power.exponent < 2) {
    const auto quick = exp(power);
    if (quick.is_certain(kPowerSlack)) return quick.rounded();
  }
  const auto power = exponent(Wide<Digits128>{});
  if (power.exponent > 9) return grows ? HUGE_VAL : 0.0;
  // Powers of whole numbers may lie exactly between two doubles. A result within 2^-111 (relative) of the
  // middle counts as the middle.
  return exp(power).rounded(1 << 16);
}

}  // namespace elementary
