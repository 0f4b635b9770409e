// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "elementary/wide.hpp"

namespace elementary {

/// x = quadrant pi/2 + rest, |rest| <= pi/4; the quadrant is taken modulo 4.
template <class Digits>
struct Reduced {
  Wide<Digits> rest;
  unsigned quadrant;
};

/// Payne and Hanek's reduction. Only 256 digits of 2/pi affect x 2/pi modulo 4; it uses no others.
template <class Digits>
Reduced<Digits> reduced(double x) {
  using Number = Wide<Digits>;
  if (std::fabs(x) < 0.78) return {Number::of(x), 0};
  // 64 zeros and 1280 digits of 2/pi.
  static constexpr std::uint64_t two_over_pi[] = {0,
                                                  0xa2f9836e4e441529,
                                                  0xfc2757d1f534ddc0,
                                                  0xdb6295993c439041,
                                                  0xfe5163abdebbc561,
                                                  0xb7246e3a424dd2e0,
                                                  0x06492eea09d1921c,
                                                  0xfe1deb1cb129a73e,
                                                  0xe88235f52ebb4484,
                                                  0xe99c7026b45f7e41,
                                                  0x3991d639835339f4,
                                                  0x9c845f8bbdf9283b,
                                                  0x1ff897ffde05980f,
                                                  0xef2f118b5a0a6d1f,
                                                  0x6d367ecf27cb09b7,
                                                  0x4f463f669e5fea2d,
                                                  0x7527bac7ebe5f17b,
                                                  0x3d0739f78a5292ea,
                                                  0x6bfb5fb11f8d5d08,
                                                  0x56033046fc7b6bab,
                                                  0xf0cfbc209af4361d};
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t whole = (bits & 0xfffffffffffffu) | std::uint64_t{1} << 52;  // x = whole 2^scale
  const int scale = static_cast<int>(bits >> 52 & 0x7ff) - 1075;
  const int begin = scale - 2 + 64, word = begin / 64, shift = begin % 64;
  std::uint64_t turns[4];  // x 2/pi modulo 4, in units of 2^-254
  Digits128 carry = 0;
  for (int i = 3; i >= 0; --i) {
    const std::uint64_t* at = two_over_pi + word + i;
    const std::uint64_t window = shift == 0 ? at[0] : at[0] << shift | at[1] >> (64 - shift);
    carry += Digits128{window} * whole;
    turns[i] = static_cast<std::uint64_t>(carry);
    carry >>= 64;
  }
  auto quadrant = static_cast<unsigned>(turns[0] >> 62);
  const bool beyond = (turns[0] >> 61 & 1) != 0;  // the next quadrant is nearer
  if (beyond) {
    ++quadrant;
    for (auto& part : turns) part = ~part;  // the negative, less 2^-254
  }
  turns[0] &= ~std::uint64_t{0} >> 2;
  const auto part = [](std::uint64_t high, std::uint64_t low, int units) {
    return Wide<Digits128>::scaled(Digits128{high} << 64 | low, units);
  };
  const Wide<Digits128> turn = part(turns[0], turns[1], -126) + part(turns[2], turns[3], -254);
  Number rest =
      Number{static_cast<Digits>(turn.digits >> (128 - kDigits<Digits>)), turn.exponent} * Number::half_pi();
  rest.negative = beyond != (x < 0.0);
  return {rest, x < 0.0 ? 0u - quadrant : quadrant};
}

/// sin x for |x| <= pi/4. 10 terms leave 2^-72, 16 leave 2^-132.
template <class Digits>
Wide<Digits> small_sin(const Wide<Digits>& x) {
  static constexpr auto c = factorial_reciprocals < Digits, kDigits<Digits> == 64 ? 10 : 16 > (1, 2);
  return x * series(c, x * x, true);
}

/// cos x for |x| <= pi/4, with the same numbers of terms.
template <class Digits>
Wide<Digits> small_cos(const Wide<Digits>& x) {
  static constexpr auto c = factorial_reciprocals < Digits, kDigits<Digits> == 64 ? 10 : 16 > (2, 2);
  const Wide<Digits> square = x * x;
  return Wide<Digits>::one() - square * series(c, square, true);
}

/// sin((quadrant + ahead) pi/2 + rest)
template <class Digits>
Wide<Digits> sin(const Reduced<Digits>& x, unsigned ahead = 0) {
  const unsigned quadrant = x.quadrant + ahead;
  const Wide<Digits> value = quadrant % 2 == 0 ? small_sin(x.rest) : small_cos(x.rest);
  return quadrant % 4 < 2 ? value : -value;
}

template <class Digits>
Wide<Digits> tan(const Reduced<Digits>& x) {
  return sin(x) / sin(x, 1);
}

inline double sin(double x) {
  if (x == 0.0 || !std::isfinite(x)) return x == 0.0 ? x : NAN;
  return nearest([x]<class Digits>(Wide<Digits>) { return sin(reduced<Digits>(x)); });
}

inline double cos(double x) {
  if (!std::isfinite(x)) return NAN;
  return nearest([x]<class Digits>(Wide<Digits>) { return sin(reduced<Digits>(x), 1); });
}

inline double tan(double x) {
  if (x == 0.0 || !std::isfinite(x)) return x == 0.0 ? x : NAN;
  return nearest([x]<class Digits>(Wide<Digits>) { return tan(reduced<Digits>(x)); });
}

/// Angle of (x, y) to the first axis, both finite and >= 0, one of them not zero.
template <class Digits>
Wide<Digits> first_quadrant(double y, double x) {
  using Number = Wide<Digits>;
  if (y > x) return Number::half_pi() - first_quadrant<Digits>(x, y);
  // arctan(y/x) = arctan(k/8) + arctan((y - x k/8)/(x + y k/8)), the last at most 1/16.
  static constexpr auto c = odd_reciprocals < Digits, kDigits<Digits> == 64 ? 9 : 18 > ();
  static constexpr Number eighths[] = {{},
                                       Number::of(0xfeadd4d5617b6e32, 0xc897989f3e888ef8, -4),
                                       Number::of(0xfadbafc96406eb15, 0x6dc79ef5f7a217e6, -3),
                                       Number::of(0xb7b0ca0f26f78473, 0x8aa32122dcfe4483, -2),
                                       Number::of(0xed63382b0dda7b45, 0x6fe445ecbc3a8d03, -2),
                                       Number::of(0x8f005d5ef7f59f9b, 0x5c835e1665c43748, -1),
                                       Number::of(0xa4bc7d1934f70924, 0x19a87f2a457dac9f, -1),
                                       Number::of(0xb8053e2bc2319e73, 0xcb2da55210a4443d, -1),
                                       Number::of(0xc90fdaa22168c234, 0xc4c6628b80dc1cd1, -1)};
  const int k = static_cast<int>(8.0 * (y / x) + 0.5);
  const Number wy = Number::of(y), wx = Number::of(x), slope = Number::of(k / 8.0);
  const Number z = k == 0 ? wy / wx : (wy - slope * wx) / (wx + slope * wy);
  const Number ratio = series(c, z * z, true);
  // An arc is less than its tangent, even where the difference is below the last digit.
  return eighths[k] + z * (ratio - Number::scaled(1, 1 - kDigits<Digits>));
}

/// Angle of (x, y) to the first axis, in [-pi, pi].
inline double atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return NAN;
  double ay = std::fabs(y), ax = std::fabs(x);
  if (std::isinf(ay) || std::isinf(ax)) {
    ay = std::isinf(ay) ? 1.0 : 0.0;
    ax = std::isinf(ax) ? 1.0 : 0.0;
  }
  const double angle = nearest([=]<class Digits>(Wide<Digits> number) {
    const auto acute = ay == 0.0 ? number : first_quadrant<Digits>(ay, ax);
    return std::signbit(x) ? number.half_pi().times_power_of_two(1) - acute : acute;
  });
  return std::copysign(angle, y);
}

}  // namespace elementary
