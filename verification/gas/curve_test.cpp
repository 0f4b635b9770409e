// SPDX-License-Identifier: Apache-2.0
#include "gas/curve.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "cases.hpp"

namespace {

using gas::Curve;
using gas::Outside;

const std::vector<Curve::Knot> kKnots{{1.0, 2.0}, {2.0, 4.0}, {4.0, 0.0}, {4.5, 1.0}};

TEST(curve, value_is_linear_between_knots) {
  const Curve flow(kKnots, Outside::zero), temperature(kKnots, Outside::held);
  // All numbers are short binary fractions: exact.
  for (const auto& [t, value] :
       std::vector<Curve::Knot>{{1.0, 2.0}, {1.5, 3.0}, {2.0, 4.0}, {3.0, 2.0}, {4.25, 0.5}, {4.5, 1.0}}) {
    EXPECT_EQ(flow.value(t), value);
    EXPECT_EQ(temperature.value(t), value);
  }
  EXPECT_EQ(flow.value(0.9), 0.0);
  EXPECT_EQ(flow.value(4.6), 0.0);
  EXPECT_EQ(temperature.value(0.9), 2.0);
  EXPECT_EQ(temperature.value(4.6), 1.0);
}

TEST(curve, integral_eq_trapezoids) {
  const Curve flow(kKnots, Outside::zero), temperature(kKnots, Outside::held);
  EXPECT_EQ(flow.integral(-10.0, 10.0), 3.0 + 4.0 + 0.25);
  EXPECT_EQ(temperature.integral(0.0, 5.0), 2.0 + 7.25 + 0.5);
  EXPECT_EQ(flow.integral(1.5, 3.0), 1.75 + 3.0);
  EXPECT_EQ(flow.integral(5.0, 6.0), 0.0);
}

TEST(curve, product_integral_eq_closed_form) {
  // f = t on [0, 3], zero outside; g = 1 + 2 t up to 2, held at 5: int = 2 + 16/3 + 5 (9 - 4)/2.
  const Curve f({{0.0, 0.0}, {3.0, 3.0}}, Outside::zero), g({{0.0, 1.0}, {2.0, 5.0}}, Outside::held);
  // Two pieces of some ten operations.
  EXPECT_LT(cases::relative(gas::product_integral(f, g, -1.0, 9.0), 2.0 + 16.0 / 3.0 + 12.5), 1e-15);
  EXPECT_LT(cases::relative(gas::product_integral(g, f, -1.0, 9.0), 2.0 + 16.0 / 3.0 + 12.5), 1e-15);
}

/// Two knots at one time: the first holds until then, the second from then on.
TEST(curve, jump_has_a_value_on_each_side) {
  const Curve step({{1.0, 2.0}, {2.0, 4.0}, {2.0, 1.0}, {4.0, 3.0}, {4.0, 0.5}}, Outside::held);
  const Curve last({{0.0, 0.0}, {0.0, 8.0}, {2.0, 4.0}, {2.0, 0.0}}, Outside::zero);
  EXPECT_EQ(step.value(2.0), 1.0);
  EXPECT_EQ(step.value(2.0, gas::Side::before), 4.0);
  EXPECT_EQ(step.value(1.5, gas::Side::before), step.value(1.5));
  EXPECT_EQ(step.value(4.0), 0.5);
  EXPECT_EQ(step.value(4.0, gas::Side::before), 3.0);
  EXPECT_EQ(step.value(3.0), 2.0);
  EXPECT_EQ(step.value(5.0), 0.5);
  EXPECT_EQ(last.value(0.0), 8.0);
  EXPECT_EQ(last.value(2.0), 0.0);
  EXPECT_EQ(last.value(-1.0), 0.0);
  EXPECT_EQ(step.piece(2.0).slope, 1.0);
  EXPECT_EQ(step.next_knot(1.0), 2.0);
  EXPECT_EQ(step.next_knot(2.0), 4.0);
  EXPECT_EQ(step.nearest_knot(2.1), 2.0);
  EXPECT_EQ(step.integral(1.0, 5.0), 3.0 + 4.0 + 0.5);
  EXPECT_EQ(step.integral(1.0, 2.0) + step.integral(2.0, 4.0), 7.0);
  // int 2 (8 - 2 t) on [0, 1] and (2 + 2 s)(6 - 2 s) on the next second.
  EXPECT_LT(cases::relative(gas::product_integral(step, last, 0.0, 9.0), 14.0 + 16.0 - 4.0 / 3.0), 1e-15);
  EXPECT_EQ(step.first_jump(), 2.0);
  EXPECT_FALSE(Curve(kKnots, Outside::held).first_jump());
}

TEST(curve, constant_has_no_knots_to_break_at) {
  const Curve constant = Curve::constant(7.0);
  EXPECT_EQ(constant.value(-1e9), 7.0);
  EXPECT_EQ(constant.next_knot(-1.0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(constant.integral(-2.0, 1.0), 21.0);
}

TEST(curve, bad_knots_are_refused) {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<std::vector<Curve::Knot>> bad{{},
                                                  {{0.0, 1.0}, {0.0, 2.0}, {0.0, 3.0}},
                                                  {{1.0, 1.0}, {0.0, 2.0}},
                                                  {{0.0, std::nan("")}, {1.0, 2.0}},
                                                  {{0.0, 1.0}, {infinity, 2.0}}};
  for (const auto& knots : bad) EXPECT_THROW(Curve(knots, Outside::held), std::invalid_argument);
  EXPECT_THROW(Curve({{0.0, 1.0}}, Outside::zero), std::invalid_argument);
}

}  // namespace
