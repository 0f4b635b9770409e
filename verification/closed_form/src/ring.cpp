// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "check.hpp"
#include "closed_form/disc.hpp"

namespace closed_form {
namespace {

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
