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

// Lengths over a, tensions over E h, pressure q = p a/(E h).
struct Problem {
  double q, poisson_ratio;
  bool no_compression;
};
enum { kX, kPull, kZ, kDiscVolume, kSize };  // x, s T1 cos(phi), z, volume
using State = std::array<double, kSize>;

// The positive root of l^3 + c l = k > 0. The cubic is convex there and positive at the start, so Newton
// falls to the root.
double stretch_root(double c, double k) {
  double l = std::cbrt(k) + std::sqrt(std::abs(c));
  for (int round = 0; round < 200; ++round) {
    const double next = l - (l * l * l + c * l - k) / (3.0 * l * l + c);
    if (!(next < l)) break;
    l = next;
  }
  return l;
}

struct Hoop {
  double meridian_stretch, tension;  // l1, T2
};
Hoop hoop(const Problem& problem, double t1, double l2) {
  const double nu = problem.poisson_ratio;
  const double e2 = 0.5 * (l2 * l2 - 1.0);
  const double reciprocal = 1.0 - nu * nu;
  const double l1 = stretch_root(2.0 * nu * e2 - 1.0, 2.0 * reciprocal * t1);
  const double s2 = (e2 + nu * 0.5 * (l1 * l1 - 1.0)) / reciprocal;
  if (problem.no_compression && s2 < 0.0) return {stretch_root(-1.0, 2.0 * t1), 0.0};
  return {l1, l2 * s2};
}

int rates(double s, const double y[], double rate[], void* data) {
  const auto& problem = *static_cast<const Problem*>(data);
  const double push = 0.5 * problem.q * y[kX] * y[kX];  // -s T1 sin(phi)
  const double pull = std::hypot(y[kPull], push);
  const Hoop h = hoop(problem, pull / s, y[kX] / s);
  rate[kX] = h.meridian_stretch * y[kPull] / pull;
  rate[kZ] = -h.meridian_stretch * push / pull;
  rate[kPull] = h.tension + problem.q * y[kX] * rate[kZ];
  rate[kDiscVolume] = -pi * y[kX] * y[kX] * rate[kZ];
  return GSL_SUCCESS;
}

// From the centre, where both stretches are 1 + excess, to the edge. The start at s = 1e-4 by the leading
// terms leaves errors of its square in a solution that decays as 1/s^2.
State edge_state(Problem problem, double excess) {
  double s = 1e-4;
  const double l = 1.0 + excess;
  const double tension = l * excess * (1.0 + 0.5 * excess) / (1.0 - problem.poisson_ratio);
  State y{l * s, tension * s, -problem.q * l * l * l * s * s / (4.0 * tension), 0.0};
  gsl_odeiv2_system system{rates, nullptr, kSize, &problem};
  const std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver(
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-5, 1e-14, 1e-13),
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
  const double q = membrane.overpressure * a / (membrane.sheet.youngs_modulus * membrane.sheet.thickness);
  if (!(q >= 1e-6 && q <= 0.2))
    check::refuse("overpressure", membrane.overpressure, "p a/(E h) must lie in [1e-6, 0.2]");
  const Problem problem{q, membrane.sheet.poisson_ratio, sealed};
  const auto miss = [&](double excess) {
    const State edge = edge_state(problem, excess);
    return sealed ? edge[kPull] : edge[kX] - 1.0;
  };
  // Hencky's membrane has 0.30 q^(2/3) at the centre for nu = 0.3.
  const double excess = rising_root(miss, 0.2 * std::cbrt(q * q));
  const State edge = edge_state(problem, excess);
  return {1.0 + excess, -a * edge[kZ], a * edge[kX], a * a * a * edge[kDiscVolume]};
}

}  // namespace

InflatedDisc clamped_disc(const CircularMembrane& membrane) {
  return inflated_disc(membrane, false);
}

InflatedDisc sealed_disc(const CircularMembrane& membrane) {
  return inflated_disc(membrane, true);
}

}  // namespace closed_form
