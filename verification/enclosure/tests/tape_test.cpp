// SPDX-License-Identifier: Apache-2.0
// Taylor coefficients and their partials of equations with elementary solutions.
#include <array>

#include "known.hpp"
#include "series.hpp"

namespace {

using namespace test;
using enclosure::Series;
using enclosure::Tape;

constexpr slong order = 12;

// Expects the coefficients of unknown 0 to contain those of `series` and, as partials, of `slope`; in units
// of half a second they are 2^k smaller.
template <class Number, class F, class G>
void expect_coefficients(const Tape& tape, int rate, double start, F&& series, G&& slope, double widest) {
  enclosure::SeriesOf<Number> s(tape, {rate}, {}, order, std::vector<int>{});
  const Ball x = enclosure::wider(Ball(start), 1e-20);
  s.run({x}, {Ball(0.0), Ball(0.0)}, order, enclosure::Mode::series, -1);
  s.run_partials(order);
  Ball scale(1.0);
  for (slong k = 0; k <= order; ++k, scale = scale * Ball(0.5)) {
    EXPECT_TRUE(arb_overlaps(s.value(s.state(0), k).get(), (scale * series(k)).get()))
        << k << ' ' << text(s.value(s.state(0), k));
    EXPECT_TRUE(arb_overlaps(s.partial(s.state(0), 0, k).get(), (scale * slope(k)).get()))
        << k << ' ' << text(slope(k));
    EXPECT_LT(s.value(s.state(0), k).radius(), widest);
  }
}

template <class F, class G>
void expect_series(const Tape& tape, int rate, double start, F&& series, G&& slope) {
  expect_coefficients<Ball>(tape, rate, start, series, slope, 1e-15);
  expect_coefficients<enclosure::QuickBall>(tape, rate, start, series, slope, 1e-12);
}

// Coefficient k of (1 + q t)^e.
Ball binomial(const Ball& e, const Ball& q, slong k) {
  Ball c(1.0);
  for (slong j = 0; j < k; ++j)
    c = c * (e - Ball(static_cast<double>(j))) / Ball(static_cast<double>(j + 1)) * q;
  return c;
}

Ball number(slong k) {
  return Ball(static_cast<double>(k));
}

// x' = x^2: x0/(1 - x0 t), coefficients x0^(k+1), slopes (k+1) x0^k.
TEST(tape, product) {
  Tape tape;
  const auto x = tape.state(0);
  expect_series(
      tape, (x * x).id, 0.75, [](slong k) { return pow(Ball(0.75), number(k + 1)); },
      [](slong k) { return number(k + 1) * pow(Ball(0.75), number(k)); });
}

// x' = 1/x: sqrt(x0^2 + 2 t) = x0 (1 + 2 t/x0^2)^(1/2).
TEST(tape, quotient) {
  Tape tape;
  const auto x = tape.state(0);
  expect_series(
      tape, (Ball(1.0) / x).id, 2.0, [](slong k) { return Ball(2.0) * binomial(Ball(0.5), Ball(0.5), k); },
      [](slong k) { return binomial(Ball(0.5), Ball(0.5), k) * (Ball(1.0) - Ball(2.0) * number(k)); });
}

// x' = sqrt(x): (sqrt(x0) + t/2)^2.
TEST(tape, root) {
  Tape tape;
  const auto x = tape.state(0);
  expect_series(
      tape, sqrt(x).id, 4.0,
      [](slong k) {
        return Ball(k == 0 ? 4.0 : k == 1 ? 2.0 : k == 2 ? 0.25 : 0.0);
      },
      [](slong k) {
        return Ball(k == 0 ? 1.0 : k == 1 ? 0.25 : 0.0);
      });
}

// x' = exp(-x): log(exp(x0) + t), with exp(x0) = 2.
TEST(tape, exponential) {
  Tape tape;
  const auto x = tape.state(0);
  const double start = std::log(2.0);
  const Ball base = exp(Ball(start));
  expect_series(
      tape, exp(Ball(0.0) - x).id, start,
      [&](slong k) {
        if (k == 0) return Ball(start);
        return pow(Ball(-1.0), number(k + 1)) / (number(k) * pow(base, number(k)));
      },
      [&](slong k) { return k == 0 ? Ball(1.0) : pow(Ball(-1.0), number(k)) / pow(base, number(k)); });
}

// x' = x log(x): exp(log(x0) e^t); with x0 = e the logarithm's coefficients are 1/k!.
TEST(tape, logarithm) {
  Tape tape;
  const auto x = tape.state(0), logarithm = log(x), rate = x * logarithm;
  const Ball e = exp(Ball(1.0));
  Series series(tape, {rate.id}, {}, order);
  series.run({e}, {Ball(0.0), Ball(0.0)}, order);
  Ball factorial(1.0);
  for (slong k = 0; k < order; ++k) {
    if (k > 0) factorial = factorial * number(k);
    EXPECT_TRUE(arb_overlaps(series.value(logarithm.id, k).get(), (Ball(1.0) / factorial).get())) << k;
    EXPECT_LT(series.value(logarithm.id, k).radius(), 1e-30);
  }
}

// What an operation gives holds all that it makes of the ends of its operands, wide or as thin as a rounding.
TEST(tape, quick_balls_hold_what_their_ends_give) {
  using enclosure::QuickBall;
  namespace into = enclosure::into;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    Draw draw(seed);
    const double share = std::array{0.0, 1e-17, 1e-3, 0.4}[seed % 4];
    std::array<QuickBall, 4> q;
    for (std::size_t i = 0; i < 4; ++i) {
      const double middle = std::exp(draw(-5.0, 5.0)) * (i > 1 && seed % 3 == 0 ? -1.0 : 1.0);
      q.at(i) = {middle, share * std::abs(middle)};
    }
    QuickBall sum, difference, product, quotient, root, dot;
    into::add(sum, q[0], q[2]);
    into::subtract(difference, q[0], q[2]);
    into::multiply(product, q[0], q[2]);
    into::divide(quotient, q[0], q[2]);
    into::root(root, q[0]);
    into::convolve(dot, &q[0], seed % 2 == 0, &q[0], &q[3], 2);  // q0 +- (q0 q3 + q1 q2)
    for (unsigned ends = 0; ends < 16; ++ends) {
      std::array<Ball, 4> x;
      for (std::size_t i = 0; i < 4; ++i)
        x.at(i) = Ball(q.at(i).middle) + Ball(ends >> i & 1U ? q.at(i).radius : -q.at(i).radius);
      EXPECT_TRUE(exact(sum).contains(x[0] + x[2])) << seed;
      EXPECT_TRUE(exact(difference).contains(x[0] - x[2])) << seed;
      EXPECT_TRUE(exact(product).contains(x[0] * x[2])) << seed;
      EXPECT_TRUE(exact(quotient).contains(x[0] / x[2])) << seed;
      EXPECT_TRUE(exact(root).contains(test::sqrt(x[0]))) << seed;
      const Ball terms = x[0] * x[3] + x[1] * x[2];
      EXPECT_TRUE(exact(dot).contains(seed % 2 == 0 ? x[0] - terms : x[0] + terms)) << seed;
    }
  }
}

}  // namespace
