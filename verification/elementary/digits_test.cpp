// SPDX-License-Identifier: Apache-2.0
// What 64 digits leave open is decided by 128. So 64 must know how wrong they are.
#include <gtest/gtest.h>

#include <algorithm>
#include <elementary/exponential.hpp>
#include <elementary/hypot.hpp>
#include <elementary/trigonometric.hpp>

#include "oracle.hpp"

namespace {

using elementary::Digits128;
using elementary::Wide;

/// Error of f with 64 digits [last digits].
template <class Function>
double last_digits(const Function& f) {
  const auto quick = f(Wide<elementary::Digits64>{});
  const auto exact = f(Wide<Digits128>{});
  const auto error = Wide<Digits128>{Digits128{quick.digits} << 64, quick.exponent, quick.negative} - exact;
  if (error.digits == 0) return 0.0;
  return std::ldexp(static_cast<double>(error.digits >> 75) * 0x1p-52, error.exponent - exact.exponent + 63);
}

TEST(elementary, errors_of_64_digits_are_below_half_of_what_is_allowed_for) {
  oracle::Arguments a;
  double worst = 0.0, worst_power = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const double x = i % 2 == 0 ? a.sized(-8, 4) : a.sized(-60, 9), near = a.between(-0.99, 3.0);
    const double y = std::fabs(a.sized(-6, 6)), z = std::fabs(a.sized(-6, 6)), size = std::fabs(a.any());
    worst = std::max({
        worst,
        last_digits([&](auto n) { return exp(n.of(x)); }),
        last_digits([&](auto n) { return elementary::growing(n.of(x)); }),
        last_digits([&](auto n) { return log(n.of(size)); }),
        last_digits([&](auto n) { return elementary::log_of_one_and(n.of(near)); }),
        last_digits([&](auto n) { return elementary::log_of_one_and(n.of(x)); }),
        last_digits([&]<class D>(Wide<D>) { return sin(elementary::reduced<D>(x)); }),
        last_digits([&]<class D>(Wide<D>) { return sin(elementary::reduced<D>(x), 1); }),
        last_digits([&]<class D>(Wide<D>) { return elementary::tan(elementary::reduced<D>(x)); }),
        last_digits([&]<class D>(Wide<D>) { return elementary::first_quadrant<D>(y, z); }),
        last_digits([&](auto n) { return sqrt(n.of(y) * n.of(y) + n.of(z) * n.of(z)); }),
    });
    const double power = a.between(-4.0, 4.0) / std::max(0.01, std::fabs(std::log(y)));
    if (std::fabs(power * std::log(y)) < 4.0)
      worst_power =
          std::max(worst_power, last_digits([&](auto n) { return exp(n.of(power) * log(n.of(y))); }));
  }
  EXPECT_LT(worst, 0.5 * elementary::kSlack);
  EXPECT_LT(worst_power, 0.5 * elementary::kPowerSlack);
  EXPECT_GT(worst, 1.0);  // the test sees errors
}

}  // namespace
