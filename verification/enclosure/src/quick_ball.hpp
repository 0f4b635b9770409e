// SPDX-License-Identifier: Apache-2.0
// A ball of two doubles: a tenth of the cost of Arb's, for what a proof needs to few digits. The midpoint is
// rounded to nearest, off by at most 2^-53 of it (IEEE 754); the radius takes that, and is computed a little
// too large because it is rounded itself. It is at least `least`, and smaller midpoints are 0: nothing
// underflows.
#pragma once

#include <cmath>

#include "ball.hpp"

namespace enclosure {

/// All numbers within `radius` of `middle`. A radius that is not finite: nothing is known.
struct QuickBall {
  double middle = 0.0, radius = 0.0;
};

inline constexpr double two_roundings = 0x1p-52;

inline constexpr double least = 0x1p-340;

/// The radius beside a rounded midpoint.
inline QuickBall rounded(double middle, double radius) {
  const double size = std::abs(middle);
  return {size < least ? 0.0 : middle, (radius + two_roundings * size) * (1.0 + 0x1p-40) + 2.0 * least};
}

/// The same numbers as a ball of Arb.
inline Ball exact(const Ball& a) {
  return a;
}
inline Ball exact(const QuickBall& a) {
  if (std::isfinite(a.middle) && std::isfinite(a.radius)) return wider(Ball(a.middle), a.radius);
  Ball unknown;
  arb_indeterminate(unknown.get());
  return unknown;
}

/// Operations; the first argument receives the result.
namespace into {

inline void assign(Ball& c, const Ball& a) {
  c = a;
}
inline void assign(QuickBall& c, const Ball& a) {
  const double middle = a.middle();
  c = rounded(middle, a.radius());
  if (!std::isfinite(middle)) c.radius = HUGE_VAL;
}
inline void add(Ball& c, const Ball& a, const Ball& b) {
  arb_add(c.get(), a.get(), b.get(), bits);
}
inline void add(QuickBall& c, const QuickBall& a, const QuickBall& b) {
  c = rounded(a.middle + b.middle, a.radius + b.radius);
}
inline void subtract(Ball& c, const Ball& a, const Ball& b) {
  arb_sub(c.get(), a.get(), b.get(), bits);
}
inline void subtract(QuickBall& c, const QuickBall& a, const QuickBall& b) {
  c = rounded(a.middle - b.middle, a.radius + b.radius);
}
inline void multiply(Ball& c, const Ball& a, const Ball& b) {
  arb_mul(c.get(), a.get(), b.get(), bits);
}
inline void multiply(QuickBall& c, const QuickBall& a, const QuickBall& b) {
  c = rounded(a.middle * b.middle,
              std::abs(a.middle) * b.radius + a.radius * (std::abs(b.middle) + b.radius));
}
inline void divide(Ball& c, const Ball& a, const Ball& b) {
  arb_div(c.get(), a.get(), b.get(), bits);
}
/// |a/b - m_a/m_b| <= (r_a + |m_a/m_b| r_b)/(|m_b| - r_b).
inline void divide(QuickBall& c, const QuickBall& a, const QuickBall& b) {
  const double q = a.middle / b.middle, smallest = (std::abs(b.middle) - b.radius) * (1.0 - two_roundings);
  c = rounded(q, smallest > 0.0 ? (a.radius + std::abs(q) * b.radius) / smallest : HUGE_VAL);
}
/// a times an integer.
inline void times(Ball& c, const Ball& a, slong k) {
  arb_mul_si(c.get(), a.get(), k, bits);
}
inline void times(QuickBall& c, const QuickBall& a, slong k) {
  multiply(c, a, {static_cast<double>(k), 0.0});
}
inline void over(Ball& c, const Ball& a, slong k) {
  arb_div_si(c.get(), a.get(), k, bits);
}
inline void over(QuickBall& c, const QuickBall& a, slong k) {
  divide(c, a, {static_cast<double>(k), 0.0});
}
/// a times 2^e.
inline void shift(Ball& c, const Ball& a, slong e) {
  arb_mul_2exp_si(c.get(), a.get(), e);
}
inline void shift(QuickBall& c, const QuickBall& a, slong e) {
  const int power = static_cast<int>(e);
  c = rounded(std::ldexp(a.middle, power), std::ldexp(a.radius, power));
}
inline void root(Ball& c, const Ball& a) {
  arb_sqrt(c.get(), a.get(), bits);
}
/// |sqrt(x) - sqrt(m)| = |x - m|/(sqrt(x) + sqrt(m)).
inline void root(QuickBall& c, const QuickBall& a) {
  const double s = std::sqrt(a.middle);
  c = rounded(s, a.middle > a.radius ? a.radius / s : HUGE_VAL);
}
inline void exponential(Ball& c, const Ball& a) {
  arb_exp(c.get(), a.get(), bits);
}
inline void exponential(QuickBall& c, const QuickBall& a) {
  assign(c, exp(exact(a)));
}
inline void logarithm(Ball& c, const Ball& a) {
  arb_log(c.get(), a.get(), bits);
}
inline void logarithm(QuickBall& c, const QuickBall& a) {
  assign(c, log(exact(a)));
}

/// start + (or -) (x_0 y_{n-1} + ... + x_{n-1} y_0), in which y_0 is the last of the array.
inline void convolve(Ball& c, const Ball* start, bool negative, const Ball* x, const Ball* y, slong n) {
  arb_dot(c.get(), start ? start->get() : nullptr, negative, n > 0 ? x->get() : nullptr, 1,
          n > 0 ? y->get() : nullptr, -1, n, bits);
}
/// The sum of n <= 50 rounded products is off by at most (n + 1) 2^-53 of the sum of their sizes (N. J.
/// Higham, "Accuracy and Stability of Numerical Algorithms", 2nd ed. 2002, (3.5)).
inline void convolve(QuickBall& c, const QuickBall* start, bool negative, const QuickBall* x,
                     const QuickBall* y, slong n) {
  double sum = 0.0, size = 0.0, radius = 0.0;
  for (slong i = 0; i < n; ++i) {
    const QuickBall &a = x[i], &b = *(y - i);
    const double product = a.middle * b.middle;
    sum += product;
    size += std::abs(product);
    radius += std::abs(a.middle) * b.radius + a.radius * (std::abs(b.middle) + b.radius);
  }
  const double from = start ? start->middle : 0.0;
  c = rounded(negative ? from - sum : from + sum,
              (start ? start->radius : 0.0) + radius + 0x1p-47 * (size + std::abs(from)));
}

}  // namespace into

}  // namespace enclosure
