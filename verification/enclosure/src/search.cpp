// SPDX-License-Identifier: Apache-2.0
// Integrals and roots.
#include <acb_calc.h>
#include <arb_hypgeom.h>

#include "functions.hpp"

namespace enclosure {
namespace {

int integrand(acb_ptr out, const acb_t in, void* data, slong order, slong) {
  Complex x;
  acb_set(x.get(), in);
  const Complex y = (*static_cast<const Integrand*>(data))(x, order != 0);
  acb_set(out, y.get());
  return 0;
}

Complex real_interval(const Ball& low, const Ball& high) {
  Complex z;
  arb_set_interval_arf(z.real(), arb_midref(low.get()), arb_midref(high.get()), 4 * complex_bits);
  return z;
}

Complex point(const Ball& x) {
  Complex z;
  arb_set(z.real(), x.get());
  return z;
}

Ball middle(const Ball& low, const Ball& high) {
  Ball m = exact_sum(low, high);
  arb_mul_2exp_si(m.get(), m.get(), -1);
  return m;
}

/// 1, -1, or 0 if it is not certain.
int sign(const Complex& y) {
  if (!acb_is_finite(y.get())) return 0;
  return arb_is_positive(y.real()) ? 1 : arb_is_negative(y.real()) ? -1 : 0;
}

/// An interval with exact ends.
struct Piece {
  Ball low, high;
};

bool is_shorter(const Piece& piece, const Ball& length) {
  return !arb_gt(exact_difference(piece.high, piece.low).get(), length.get());
}

/// At the middle, and the radius to both sides: all derivatives of J lie between -1 and 1. The series would
/// swell by exp(x).
Complex bessel_j(long m, const Complex& x) {
  Complex z, order(static_cast<double>(m)), middle;
  arb_get_mid_arb(middle.real(), x.real());
  arb_hypgeom_bessel_j(z.real(), order.real(), middle.real(), complex_bits);
  arb_add_error_mag(z.real(), arb_radref(x.real()));
  return z;
}

Complex bessel_slope(long m, const Complex& x) {
  if (m == 0) return subtract(0.0, bessel_j(1, x));
  return divide(subtract(bessel_j(m - 1, x), bessel_j(m + 1, x)), 2.0);
}

}  // namespace

Complex integral(const Integrand& f, const Complex& a, const Complex& b) {
  Complex z;
  mag_t tolerance;
  mag_init(tolerance);
  mag_set_ui_2exp_si(tolerance, 1, -4 * complex_bits);
  acb_calc_integrate(z.get(), integrand, const_cast<Integrand*>(&f), a.get(), b.get(), complex_bits,
                     tolerance, nullptr, complex_bits);
  mag_clear(tolerance);
  return z;
}

Complex root(const std::function<Complex(const Complex&)>& f, const Complex& low, const Complex& high) {
  Ball from, to;
  arb_get_lbound_arf(arb_midref(from.get()), low.real(), complex_bits);
  arb_get_ubound_arf(arb_midref(to.get()), high.real(), complex_bits);
  Ball shortest = exact_difference(to, from), too_short;
  arb_mul_2exp_si(shortest.get(), shortest.get(), -complex_bits / 2);
  arb_mul_2exp_si(too_short.get(), shortest.get(), -10);
  std::vector<Piece> left{{from, to}};
  while (!left.empty() && left.size() < 2000 && !is_shorter({left.front().low, left.back().high}, shortest)) {
    // Parts far from each other do not join: none becomes shorter than that.
    if (is_shorter(left.front(), too_short)) return Complex::nothing_known();
    std::vector<Piece> halves;
    for (const Piece& piece : left) {
      const Ball half = middle(piece.low, piece.high);
      for (const Piece& part : {Piece{piece.low, half}, Piece{half, piece.high}})
        if (sign(f(real_interval(part.low, part.high))) == 0) halves.push_back(part);
    }
    left = std::move(halves);
  }
  if (left.empty() || left.size() >= 2000) return Complex::nothing_known();
  const Ball &first = left.front().low, &last = left.back().high;
  if (!acb_is_finite(f(real_interval(first, last)).get())) return Complex::nothing_known();  // a pole
  if (sign(f(point(first))) * sign(f(point(last))) != -1) return Complex::nothing_known();
  return real_interval(first, last);
}

Complex bessel_zero(long m, long order) {
  const auto j = [m](const Complex& x) { return bessel_j(m, x); };
  // No zero is below m (NIST DLMF 10.21.3), nor one of J_0 below 2, as J_0 > 1 - x^2/4.
  std::vector<Piece> open{{Ball(m > 0 ? static_cast<double>(m) : 2.0), Ball()}};
  open[0].high = exact_sum(open[0].low, Ball(0.25));
  for (long found = 0; found < order;) {
    const Piece piece = open.back();
    open.pop_back();
    const Complex x = real_interval(piece.low, piece.high);
    if (sign(j(x)) == 0) {
      if (sign(bessel_slope(m, x)) == 0) {
        const Ball half = middle(piece.low, piece.high);
        open.push_back({half, piece.high});
        open.push_back({piece.low, half});
        continue;
      }
      const int signs = sign(j(point(piece.low))) * sign(j(point(piece.high)));
      if (signs == 0) break;
      if (signs < 0 && ++found == order) return root(j, point(piece.low), point(piece.high));
    }
    if (open.empty()) open.push_back({piece.high, exact_sum(piece.high, Ball(0.25))});
  }
  return Complex::nothing_known();
}

}  // namespace enclosure
