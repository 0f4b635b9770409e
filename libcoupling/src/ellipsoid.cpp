// SPDX-License-Identifier: Apache-2.0
#include "bodies.hpp"

namespace coupling::detail {
namespace {

using Eigen::Array3d;

struct Slope {
  double value, derivative;
};

// (K.50) sum_i (a_i p_i / (s + e_i))^2 - 1, falling and convex for s > 0; terms without a numerator are 0.
Slope residual(const Array3d& scaled, const Array3d& excess, double s) {
  Slope sum{-1.0, 0.0};
  for (int i = 0; i < 3; ++i) {
    if (!(scaled[i] > 0.0)) continue;
    const double term = scaled[i] / (s + excess[i]);
    sum.value += term * term;
    sum.derivative -= 2.0 * term * term / (s + excess[i]);
  }
  return sum;
}

}  // namespace

SignedDistance EllipsoidBody::signed_distance(const Eigen::Vector3d& point) const {
  Eigen::Index shortest = 0;
  const double c = half_axes.minCoeff(&shortest);
  const Array3d excess = (half_axes - c) * (half_axes + c), scaled = half_axes * point.array().abs();
  // Newton from below: each term alone gives a lower bound of the root, and the iterates only grow.
  double s = std::max(0.0, (scaled - excess).maxCoeff());
  Slope f = residual(scaled, excess, s);
  constexpr int kMostSteps = 100;  // seen: 10
  for (int step = 0; step < kMostSteps && f.value > 0.0; ++step) {
    const double next = s - f.value / f.derivative;
    if (!(next > s)) break;
    s = next;
    f = residual(scaled, excess, s);
  }
  // The closest point is half_axes^2 times the gradient of the ellipsoid's equation there.
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
    if (scaled[i] > 0.0) gradient[i] = point[i] / (s + excess[i]);
  if (!(s > 0.0)) {  // in the middle plane, closer to both sides than to its rim
    const double rest = 1.0 - (half_axes * gradient.array()).square().sum();
    gradient[shortest] = std::sqrt(std::max(rest, 0.0)) / c;
  }
  const double length = gradient.norm();
  return {(s - c * c) * length, gradient / length};
}

}  // namespace coupling::detail
