// SPDX-License-Identifier: Apache-2.0
// A real number as midpoint and radius, with outward rounding: F. Johansson, "Arb: efficient
// arbitrary-precision midpoint-radius interval arithmetic", IEEE Trans. Comput. 66 (2017) 1281. What an
// operation returns contains its exact value for all numbers that its arguments contain (inclusion).
#pragma once

#include <arb.h>

#include <utility>
#include <vector>

namespace enclosure {

inline constexpr slong bits = 128;  // of midpoints

/// A number, known to lie within a ball.
class Ball {
 public:
  Ball() { arb_init(x_); }
  Ball(double value) : Ball() { arb_set_d(x_, value); }  // exact
  Ball(const Ball& other) : Ball() { arb_set(x_, other.x_); }
  Ball(Ball&& other) noexcept : Ball() { arb_swap(x_, other.x_); }
  Ball& operator=(Ball other) noexcept {
    arb_swap(x_, other.x_);
    return *this;
  }
  ~Ball() { arb_clear(x_); }

  arb_ptr get() { return x_; }
  arb_srcptr get() const { return x_; }
  double middle() const { return arf_get_d(arb_midref(x_), ARF_RND_NEAR); }
  double radius() const { return mag_get_d(arb_radref(x_)); }  // rounded up
  bool is_finite() const { return arb_is_finite(x_); }
  bool is_positive() const { return arb_is_positive(x_); }  // every number in it
  bool is_negative() const { return arb_is_negative(x_); }
  bool contains(const Ball& other) const {
    return is_finite() && other.is_finite() && arb_contains(x_, other.x_);
  }

 private:
  arb_t x_;
};

using Balls = std::vector<Ball>;

inline Ball operator+(const Ball& a, const Ball& b) {
  Ball c;
  arb_add(c.get(), a.get(), b.get(), bits);
  return c;
}
inline Ball operator-(const Ball& a, const Ball& b) {
  Ball c;
  arb_sub(c.get(), a.get(), b.get(), bits);
  return c;
}
inline Ball operator*(const Ball& a, const Ball& b) {
  Ball c;
  arb_mul(c.get(), a.get(), b.get(), bits);
  return c;
}
inline Ball operator/(const Ball& a, const Ball& b) {
  Ball c;
  arb_div(c.get(), a.get(), b.get(), bits);
  return c;
}
inline Ball exp(const Ball& a) {
  Ball c;
  arb_exp(c.get(), a.get(), bits);
  return c;
}
inline Ball log(const Ball& a) {
  Ball c;
  arb_log(c.get(), a.get(), bits);
  return c;
}
/// The smallest ball around both.
inline Ball hull(const Ball& a, const Ball& b) {
  Ball c;
  arb_union(c.get(), a.get(), b.get(), bits);
  return c;
}
/// Its midpoint, exact.
inline Ball midpoint(const Ball& a) {
  Ball c;
  arb_get_mid_arb(c.get(), a.get());
  return c;
}
/// [-r, r] around zero, r the radius.
inline Ball spread(const Ball& a) {
  Ball c;
  arb_get_rad_arb(c.get(), a.get());
  arb_neg(c.get(), c.get());
  Ball r;
  arb_get_rad_arb(r.get(), a.get());
  return hull(c, r);
}
/// The same ball, wider by `by` on each side.
inline Ball wider(Ball a, double by) {
  mag_t m;
  mag_init(m);
  mag_set_d(m, by);
  arb_add_error_mag(a.get(), m);
  mag_clear(m);
  return a;
}
/// Its lower and its upper end, as exact numbers.
inline Ball lower(const Ball& a) {
  Ball c;
  arb_get_lbound_arf(arb_midref(c.get()), a.get(), bits);
  return c;
}
inline Ball upper(const Ball& a) {
  Ball c;
  arb_get_ubound_arf(arb_midref(c.get()), a.get(), bits);
  return c;
}
/// Value of a polynomial; its coefficient of x^0 is first.
inline Ball polynomial(const Balls& c, const Ball& x) {
  Ball value;
  for (std::size_t j = c.size(); j-- > 0;) value = value * x + c[j];
  return value;
}
/// Sum of exact numbers, exact.
inline Ball exact_sum(const Ball& a, const Ball& b) {
  Ball c;
  arf_add(arb_midref(c.get()), arb_midref(a.get()), arb_midref(b.get()), ARF_PREC_EXACT, ARF_RND_DOWN);
  return c;
}

/// Difference of exact numbers, exact.
inline Ball exact_difference(const Ball& a, const Ball& b) {
  Ball c;
  arf_sub(arb_midref(c.get()), arb_midref(a.get()), arb_midref(b.get()), ARF_PREC_EXACT, ARF_RND_DOWN);
  return c;
}

/// Sum with an exact number, exact if the first is.
inline Ball later(const Ball& time, const Ball& by) {
  return arb_is_exact(time.get()) ? exact_sum(time, by) : time + by;
}
/// Order of exact numbers.
inline bool before(const Ball& a, const Ball& b) {
  return arf_cmp(arb_midref(a.get()), arb_midref(b.get())) < 0;
}

}  // namespace enclosure
