// SPDX-License-Identifier: Apache-2.0
// The functions of elementary/ against MPFR: equal bits, so that no tolerance is needed.
#include <gtest/gtest.h>

#include <cfenv>
#include <functional>
#include <vector>

#include "elementary/error_function.hpp"
#include "elementary/exponential.hpp"
#include "elementary/hypot.hpp"
#include "elementary/trigonometric.hpp"
#include "oracle.hpp"

namespace {

struct Function {
  const char* name;
  double (*value)(double);
  oracle::One exact;
  double low, high;  // where its results are neither constant nor out of range
  int count;
};

std::vector<Function> functions() {
  return {{"exp", elementary::exp, mpfr_exp, -750.0, 715.0, 5000},
          {"expm1", elementary::expm1, mpfr_expm1, -60.0, 715.0, 5000},
          {"log", elementary::log, mpfr_log, 0.0, 4.0, 5000},
          {"log1p", elementary::log1p, mpfr_log1p, -1.0, 3.0, 5000},
          {"sin", elementary::sin, mpfr_sin, -10.0, 10.0, 5000},
          {"cos", elementary::cos, mpfr_cos, -10.0, 10.0, 5000},
          {"tan", elementary::tan, mpfr_tan, -10.0, 10.0, 5000},
          {"erfc", elementary::erfc, mpfr_erfc, -7.0, 28.0, 300}};
}

void expect_exact(const Function& f, double x) {
  const double value = f.value(x), exact = oracle::value(f.exact, x);
  EXPECT_TRUE(oracle::same_bits(value, exact))
      << f.name << "(" << std::hexfloat << x << ") = " << value << ", exactly rounded " << exact;
}

struct FunctionOfTwo {
  const char* name;
  double (*value)(double, double);
  oracle::Two exact;
};
const FunctionOfTwo kPow{"pow", elementary::pow, mpfr_pow}, kAtan2{"atan2", elementary::atan2, mpfr_atan2},
    kHypot{"hypot", elementary::hypot, mpfr_hypot};

void expect_exact(const FunctionOfTwo& f, double x, double y) {
  const double value = f.value(x, y), exact = oracle::value(f.exact, x, y);
  EXPECT_TRUE(oracle::same_bits(value, exact))
      << f.name << "(" << std::hexfloat << x << ", " << y << ") = " << value << ", exactly rounded " << exact;
}

const std::vector<double> kSpecial{
    0.0,  -0.0, HUGE_VAL, -HUGE_VAL, NAN,  5e-324, -5e-324, 1e-310,   0x1p-1022, 1.0,    -1.0,    0.5,
    -0.5, 2.0,  -2.0,     3.0,       1e22, 1e308,  -1e308,  0x1p1023, 0x1p-1074, 0x1p53, 0x1p-53, 0x1p-54};

TEST(elementary, functions_of_one_number_eq_exact_ones_rounded) {
  oracle::Arguments arguments;
  for (const Function& f : functions())
    for (int i = 0; i < f.count; ++i) {
      expect_exact(f, arguments.between(f.low, f.high));
      expect_exact(f, arguments.any());
      expect_exact(f, arguments.sized(-60, 10));
      expect_exact(f, arguments.sized(-3, 2));
    }
}

TEST(elementary, functions_of_one_number_eq_exact_ones_at_special_arguments) {
  for (const Function& f : functions()) {
    for (const double x : kSpecial) expect_exact(f, x);
    // The ends of their ranges, from either side.
    for (const double x :
         {709.782712893384, -745.1332191019412, -708.3964185322641, 36.7, -37.4, 26.543, 27.226, -5.8})
      for (const double near : {std::nextafter(x, -1e9), x, std::nextafter(x, 1e9)}) expect_exact(f, near);
  }
}

// The double nearest to a multiple of pi/2, 2^-61 from it; arguments near middles between two results.
TEST(elementary, hard_arguments_are_rounded_too) {
  for (const Function& f : functions())
    for (const double x :
         {0x1.6ac5b262ca1ffp+849, 0x1.921fb54442d18p+0, 0x1.921fb54442d18p+1, 0x1.9e9cbbfd6080bp-31,
          0x1.62a88613629b5p+678, 0x1.598bae9e632f6p-7, 0x1.06b505550e6b2p-9, 0x1.50486b2f87014p-5,
          0x1.e0000000001c2p-20, 0x1.83d4bcdebb3f4p+2, 0x1.0000000000001p+0, 0x1.fffffffffffffp-1})
      expect_exact(f, x);
}

TEST(elementary, powers_eq_exact_ones_rounded) {
  oracle::Arguments a;
  for (int i = 0; i < 5000; ++i) {
    expect_exact(kPow, std::fabs(a.sized(-20, 20)), a.between(-60.0, 60.0));
    expect_exact(kPow, std::fabs(a.any()), a.any());
    expect_exact(kPow, a.between(0.0, 2.0), a.sized(-10, 10));
    expect_exact(kPow, 1.0 + a.sized(-50, -10), a.sized(0, 50));
  }
  for (const double x : kSpecial)
    for (const double y : kSpecial)
      if (!std::signbit(x)) expect_exact(kPow, x, y);
}

// Squares and cubes of whole numbers, and roots of squares: half of them are exact, or lie in the middle.
TEST(elementary, powers_in_the_middle_go_to_even) {
  oracle::Arguments a;
  for (int i = 0; i < 5000; ++i) {
    const double whole = a.whole(1 << 27);
    expect_exact(kPow, whole, a.whole(9) - 4);
    expect_exact(kPow, std::ldexp(whole, a.whole(1000) - 540), 2.0);
    expect_exact(kPow, std::pow(a.whole(1 << 26), 2.0), 0.5 * (1 + a.whole(4)));
    expect_exact(kPow, 2.0, a.whole(2200) - 1100);
  }
}

TEST(elementary, negative_numbers_have_no_powers) {
  EXPECT_TRUE(std::isnan(elementary::pow(-2.0, 2.0)));
  EXPECT_TRUE(std::isnan(elementary::pow(-HUGE_VAL, 1.0)));
  EXPECT_EQ(elementary::pow(-2.0, 0.0), 1.0);
}

TEST(elementary, angles_eq_exact_ones_rounded) {
  oracle::Arguments a;
  for (int i = 0; i < 5000; ++i) {
    expect_exact(kAtan2, a.any(), a.any());
    expect_exact(kAtan2, a.between(-1.0, 1.0), a.between(-1.0, 1.0));
    expect_exact(kAtan2, a.sized(-20, 20), a.sized(-20, 20));
    expect_exact(kAtan2, a.whole(1000) * 0x1p-1070, a.whole(64) + 1);  // subnormal, some in the middle
  }
  for (const double y : kSpecial)
    for (const double x : kSpecial) expect_exact(kAtan2, y, x);
}

TEST(elementary, lengths_eq_exact_ones_rounded) {
  oracle::Arguments a;
  for (int i = 0; i < 5000; ++i) {
    expect_exact(kHypot, a.any(), a.any());
    expect_exact(kHypot, a.between(-1.0, 1.0), a.between(-1.0, 1.0));
    const double m = a.whole(1 << 26), n = a.whole(1 << 26), x = a.sized(-5, 5);
    expect_exact(kHypot, m * m - n * n, 2.0 * m * n);  // some in the middle
    expect_exact(kHypot, x, x * a.sized(-60, -20));
    expect_exact(kHypot, a.whole(4000) * 0x1p-1074, a.whole(4000) * 0x1p-1074);
  }
  for (const double x : kSpecial)
    for (const double y : kSpecial) expect_exact(kHypot, x, y);
}

}  // namespace
