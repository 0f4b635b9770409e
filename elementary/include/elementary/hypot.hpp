// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "elementary/wide.hpp"

namespace elementary {

/// sqrt(x) for x > 0, by Newton's iteration for 1/sqrt(x).
template <class Digits>
Wide<Digits> sqrt(const Wide<Digits>& x) {
  const int half = x.exponent >> 1;
  const Wide<Digits> part = x.times_power_of_two(-2 * half), three = Wide<Digits>::of(3.0);  // in [1, 4)
  Wide<Digits> inverse = Wide<Digits>::of(1.0 / std::sqrt(part.leading()));
  for (int right = 50; right < kDigits<Digits>; right *= 2)
    inverse = (inverse * (three - part * inverse * inverse)).times_power_of_two(-1);
  return (part * inverse).times_power_of_two(half);
}

/// sqrt(x^2 + y^2)
inline double hypot(double x, double y) {
  if (std::isinf(x) || std::isinf(y)) return HUGE_VAL;
  if (std::isnan(x) || std::isnan(y)) return NAN;
  if (x == 0.0 && y == 0.0) return 0.0;
  const auto root = [x, y](auto number) {
    const auto a = number.of(x), b = number.of(y);
    return sqrt(a * a + b * b);
  };
  const auto quick = root(Wide<Digits64>{});
  // The root of a sum of squares may lie exactly between two doubles.
  return quick.is_certain(kSlack) ? quick.rounded() : root(Wide<Digits128>{}).rounded(1 << 8);
}

}  // namespace elementary
