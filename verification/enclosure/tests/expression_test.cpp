// SPDX-License-Identifier: Apache-2.0
// Known answers for what formulas are made of.
#include "expression.hpp"

#include <gtest/gtest.h>

#include "functions.hpp"

namespace {

using namespace enclosure;

/// The last equation of the text, with x as given.
Complex value(const std::string& text, const Complex& x = {}) {
  Reader reader;
  const std::size_t slot = reader.declare("x");
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find('\n', from), text.size());
    reader.read(std::string_view(text).substr(from, to - from));
    from = to + 1;
  }
  Workspace w{std::vector<Complex>(reader.slots())};
  w.values[slot] = x;
  for (const Equation& equation : reader.equations()) w.values[equation.slot] = equation.value(w);
  return w.values[reader.equations().back().slot];
}

/// -1 to 1.
Complex around_zero() {
  Complex x;
  arb_add_error_2exp_si(x.real(), 0);
  return x;
}

/// Contains the difference 0 of two ways to write a number, and little else.
void expect_zero(const std::string& difference) {
  const Complex z = value("y = " + difference);
  EXPECT_TRUE(acb_contains_zero(z.get())) << difference;
  EXPECT_LT(mag_get_d(arb_radref(z.real())), 2e-27) << difference;
}

bool is_known(const std::string& text) {
  return acb_is_finite(value("y = " + text).get());
}

TEST(expression, arithmetic_binds_as_written) {
  expect_zero("2 + 3*4^2/8 - 2^-1 - (-2)^2 - 7/2");
  expect_zero("-2^2 + 4");
  expect_zero("2^3^2 - 512");
  expect_zero("1e-3*1000 - 1");
  const Complex z = value("f(a, b) = a - 2*b\ny = f(f(7, 1), f(3, 1)) - 3");
  EXPECT_TRUE(acb_is_zero(z.get()));
}

TEST(expression, decimals_are_no_doubles) {
  expect_zero("10*0.1 - 1");
  EXPECT_FALSE(arb_contains_si(subtract(value("y = 0.1"), 0.1).real(), 0));
}

TEST(expression, both_branches_count_if_balls_do_not_decide) {
  for (const char* text : {"y = if(x < 0, -3, 2)", "y = if(0 > x, -3, 2)"}) {
    const Complex z = value(text, around_zero());
    EXPECT_TRUE(arb_contains_si(z.real(), -3) && arb_contains_si(z.real(), 2)) << text;
  }
  EXPECT_TRUE(arb_equal_si(value("y = if(x < 1, 4, 5)", 1.0).real(), 5));
}

TEST(expression, errors_widen_to_both_sides) {
  const Complex z = value("y = 1 + error(-0.5)");
  for (const double x : {0.5, 1.5}) EXPECT_TRUE(arb_contains_arf(z.real(), arb_midref(Ball(x).get())));
}

TEST(expression, integrals_know_where_a_function_is_analytic) {
  expect_zero("integral(s, 0, 1, exp(s)) - exp(1) + 1");
  expect_zero("integral(s, 0, 1, sum(k, 0, 3, s^k)) - 1 - 1/2 - 1/3 - 1/4");
  // A branch point at an end, and inside; a jump.
  for (const char* text :
       {"y = integral(s, 0, 1, sqrt(s)) - 2/3", "y = integral(s, -1, 1, log((s - 0.3)^2)) - x",
        "y = integral(s, 0, 1, if(s < 0.3, 0, 1)) - 0.7"}) {
    // int log(s - a)^2 ds = 2 ((1 - a) log(1 - a) + (1 + a) log(1 + a) - 2)
    const Complex x = value("y = 2*(0.7*log(0.7) + 1.3*log(1.3) - 2)");
    EXPECT_TRUE(acb_contains_zero(value(text, x).get()) || !acb_is_finite(value(text, x).get())) << text;
  }
}

TEST(expression, roots_are_isolated_or_not_known) {
  expect_zero("root(s, 0, 2, s^2 - 2) - sqrt(2)");
  expect_zero("root(s, -0.1, 1, exp(s) - 1)");
  EXPECT_FALSE(is_known("root(s, -2, 2, s^2 - 2)"));                   // two
  EXPECT_FALSE(is_known("root(s, 0, 3, (s - 1)*(s - 1.1)*(s - 2))"));  // three
  EXPECT_FALSE(is_known("root(s, 0, 3, (s - 1)^2)"));                  // no change of sign
  EXPECT_FALSE(is_known("root(s, 2, 3, s^2 - 2)"));                    // none
  EXPECT_FALSE(is_known("root(s, 0, 1, 1/(s - 0.3))"));                // a pole
}

TEST(expression, zeros_of_bessel_functions_are_counted) {
  // mpmath.besseljzero
  expect_zero("besselj_zero(0, 1) - 2.40482555769577276862163187933 + error(1e-27)");
  expect_zero("besselj_zero(0, 2) - 5.52007811028631064959660411281 + error(1e-27)");
  expect_zero("besselj_zero(5, 3) - 15.700174079711671037587715595 + error(1e-27)");
  expect_zero("besselj_zero(10, 5) - 28.8873750635304570270564384783 + error(1e-27)");
}

TEST(expression, elliptic_functions_of_the_swing) {
  // sn^2 + cn^2 = 1; sn(K/2) = 1/sqrt(1 + k') (NIST DLMF table 22.5.2).
  expect_zero("sn(0.7, 0.3)^2 + cn(0.7, 0.3)^2 - 1");
  expect_zero("sn(ellipk(0.36)/2, 0.36) - 1/sqrt(1 + 0.8)");
  expect_zero("cn(ellipk(0.36), 0.36)");
}

TEST(expression, what_is_no_equation_is_refused) {
  for (const char* text : {"y = z", "y = 1 +", "y = f(1)", "y = sin(1, 2)", "x = 1", "y = (1", "y = 1 2"})
    EXPECT_THROW(value(text), std::logic_error) << text;
}

}  // namespace
