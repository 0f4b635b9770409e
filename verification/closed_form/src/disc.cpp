// SPDX-License-Identifier: Apache-2.0
#include "closed_form/disc.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "check.hpp"

namespace closed_form {
namespace {

using std::numbers::pi;

// Lengths over a, tensions over E h, pressure q = p a/(E h). Stretches are kept as what they exceed 1 by:
// small strains keep their digits.
struct Problem {
  double q, poisson_ratio;
  bool no_compression;
};
enum { kHoop, kPull, kZ, kDiscVolume, kSize };  // x/s - 1, T1 cos(phi), z, volume
using State = std::array<double, kSize>;

double strain(double excess) {
  return excess * (1.0 + 0.5 * excess);
}

// The root of (1 + u)(strain(u) + c) = k > 0. The cubic is convex there and above the root at the start, so
// Newton falls to it.
double excess_root(double c, double k) {
  double u = std::cbrt(2.0 * k) + std::sqrt(std::abs(2.0 * c - 1.0)) - 1.0;
  for (int round = 0; round < 200; ++round) {
    const double stress = strain(u) + c;
    const double next = u - ((1.0 + u) * stress - k) / (stress + (1.0 + u) * (1.0 + u));
    if (!(next < u)) break;
    u = next;
  }
  return u;
}

struct Hoop {
  double meridian_excess, tension;  // l1 - 1, T2
};
Hoop hoop(const Problem& problem, double t1, double hoop_excess) {
  const double nu = problem.poisson_ratio;
  const double e2 = strain(hoop_excess);
  const double reciprocal = 1.0 - nu * nu;
  const double u1 = excess_root(nu * e2, reciprocal * t1);
  const double s2 = (e2 + nu * strain(u1)) / reciprocal;
  if (problem.no_compression && s2 < 0.0) return {excess_root(0.0, t1), 0.0};
  return {u1, (1.0 + hoop_excess) * s2};
}

int rates(double s, const double y[], double rate[], void* data) {
  const auto& problem = *static_cast<const Problem*>(data);
  const double x = s * (1.0 + y[kHoop]), pull = y[kPull];
  const double push = 0.5 * problem.q * x * x / s;  // -T1 sin(phi)
  const double t1 = std::hypot(pull, push);
  const Hoop h = hoop(problem, t1, y[kHoop]);
  const double turn = pull > 0.0 ? -push * push / (t1 * (t1 + pull)) : pull / t1 - 1.0;  // cos(phi) - 1
  rate[kZ] = -(1.0 + h.meridian_excess) * push / t1;
  rate[kHoop] = (h.meridian_excess * pull / t1 + turn - y[kHoop]) / s;
  rate[kPull] = (h.tension + problem.q * x * rate[kZ] - pull) / s;
  rate[kDiscVolume] = -pi * x * x * rate[kZ];
  return GSL_SUCCESS;
}

// Next to the centre, where both stretches are l = 1 + excess and both tensions t, in s^2: l1 = l + m s^2, l2
// = l + n s^2, T1 = t + (c m + d n) s^2, T2 = t + (c n + d m) s^2, sin(phi) = -k s. The start takes these
// terms where they are 1e-6 of the strain, so what it leaves out is some 1e-12 of it.
double start(const Problem& problem, double excess, State& y) {
  const double nu = problem.poisson_ratio, l = 1.0 + excess;
  const double stress = strain(excess) / (1.0 - nu), t = l * stress;
  const double k = 0.5 * problem.q * l * l / t, k2 = k * k;
  const double c = stress + l * l / (1.0 - nu * nu), d = nu * l * l / (1.0 - nu * nu);
  const double n = -k2 * (t + (3.0 * c - d) * l) / (16.0 * c), m = 3.0 * n + 0.5 * l * k2;
  const double s = 1e-3 * std::min(1.0, std::sqrt(excess) / k), s2 = s * s;
  y = {excess + n * s2, t + (c * m + d * n - 0.5 * t * k2) * s2, -0.5 * l * k * s2, 0.0};
  return s;
}

// From the centre to the edge.
State edge_state(Problem problem, double excess) {
  State y;
  double s = start(problem, excess, y);
  gsl_odeiv2_system system{rates, nullptr, kSize, &problem};
  const std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver(
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 0.1 * s, 1e-14 * excess, 1e-13),
      &gsl_odeiv2_driver_free);
  gsl_odeiv2_driver_set_nmax(driver.get(), 100000);
  if (gsl_odeiv2_driver_apply(driver.get(), &s, 1.0, y.data()) != GSL_SUCCESS)
    check::refuse("overpressure", problem.q, "p a/(E h) at which the disc has no smooth equilibrium");
  return y;
}

// The root > 0 of a function that rises through zero: bracketed by steps of 30 %, then by false position with
// the Illinois weight.
double rising_root(const std::function<double(double)>& f, double start) {
  double low = start, high = start, f_low = f(start), f_high = f_low;
  while (f_high < 0.0) {
    low = high, f_low = f_high;
    high *= 1.3;
    f_high = f(high);
  }
  while (f_low > 0.0) {
    high = low, f_high = f_low;
    low /= 1.3;
    f_low = f(low);
  }
  for (int round = 0; round < 100 && high - low > 1e-15 * high; ++round) {
    const double middle = std::clamp(high - f_high * (high - low) / (f_high - f_low), low, high);
    const double value = f(middle);
    if (value == 0.0) return middle;
    if (value > 0.0) {
      high = middle, f_high = value;
      f_low *= 0.5;
    } else {
      low = middle, f_low = value;
      f_high *= 0.5;
    }
  }
  return 0.5 * (low + high);
}

InflatedDisc inflated_disc(const CircularMembrane& membrane, bool sealed) {
  check::sheet(membrane.sheet, false);
  check::within("poisson_ratio", membrane.sheet.poisson_ratio, 0.0, 0.5);
  const double a = check::positive("radius", membrane.radius);
  check::positive("overpressure", membrane.overpressure);
  const double q = membrane.overpressure * a / (membrane.sheet.young_modulus * membrane.sheet.thickness);
  if (!(q >= 1e-6 && q <= 0.2))
    check::refuse("overpressure", membrane.overpressure, "p a/(E h) must lie in [1e-6, 0.2]");
  const Problem problem{q, membrane.sheet.poisson_ratio, sealed};
  const auto miss = [&](double excess) {
    const State edge = edge_state(problem, excess);
    return sealed ? edge[kPull] : edge[kHoop];
  };
  // Hencky's membrane has 0.30 q^(2/3) at the centre for nu = 0.3.
  const double excess = rising_root(miss, 0.2 * std::cbrt(q * q));
  const State edge = edge_state(problem, excess);
  return {1.0 + excess, -a * edge[kZ], a * (1.0 + edge[kHoop]), a * a * a * edge[kDiscVolume]};
}

// With the radii over a, x = c^2 and ratio = b^2.
double twice_l(double ratio, double x) {
  return std::log1p((ratio - 1.0) / (1.0 - x));
}

// c^2 of the stiffest rays, by halving: below it 2 L is the greater side of the condition.
double stiffest_rays(double ratio) {
  double low = 0.0, high = 1.0;
  for (double x = 0.5; x > low && x < high; x = 0.5 * (low + high)) {
    const double right = x * (ratio - 1.0) / ((1.0 - x) * (ratio - x));
    (twice_l(ratio, x) > right ? low : high) = x;
  }
  return low;
}

}  // namespace

InflatedDisc clamped_disc(const CircularMembrane& membrane) {
  return inflated_disc(membrane, false);
}

InflatedDisc sealed_disc(const CircularMembrane& membrane) {
  return inflated_disc(membrane, true);
}

RingTwist twisted_ring(const TwistedRing& ring, double angle) {
  check::sheet(ring.sheet, false);
  const double a = check::positive("inner_radius", ring.inner_radius);
  const double b = check::positive("outer_radius", ring.outer_radius);
  if (!(b > a)) check::refuse("outer_radius", b, "must be greater than inner_radius");
  check::within("angle", angle, -0.1, 0.1);
  const double ratio = (b / a) * (b / a), x = stiffest_rays(ratio);
  const double margin = x / (ratio - x) - ring.sheet.poisson_ratio;
  if (margin < 0.0)
    check::refuse("outer_radius", b, "so wide that the ring is not wrinkled at its outer edge");
  const double stiffness = 4.0 * std::numbers::pi * a * a * x * ring.sheet.young_modulus *
                           ring.sheet.thickness / twice_l(ratio, x);
  return {a * std::sqrt(x), stiffness * angle, 0.5 * stiffness * angle * angle, margin};
}

}  // namespace closed_form
