// SPDX-License-Identifier: Apache-2.0
// The same bits whatever the processor's rounding mode: the functions are integer arithmetic.
#include <gtest/gtest.h>

#include <cfenv>
#include <vector>

#include "elementary/error_function.hpp"
#include "elementary/exponential.hpp"
#include "elementary/trigonometric.hpp"
#include "oracle.hpp"

namespace {

std::vector<double> values(const std::vector<double>& arguments) {
  std::vector<double> all;
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const double x = std::fabs(arguments[i - 1]), y = arguments[i];
    all.insert(all.end(), {elementary::exp(y), elementary::expm1(y), elementary::log(x), elementary::log1p(x),
                           elementary::sin(y), elementary::cos(y), elementary::tan(y), elementary::pow(x, y),
                           elementary::atan2(y, x)});
    if (i % 20 == 0) all.push_back(elementary::erfc(y));
  }
  return all;
}

TEST(elementary, rounding_mode_changes_no_bit) {
  oracle::Arguments a;
  std::vector<double> arguments(2000);
  for (double& x : arguments) x = a.sized(-4, 6);
  const auto nearest = values(arguments);
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const auto other = values(arguments);
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(nearest, other) << "mode " << mode;
  }
}

}  // namespace
