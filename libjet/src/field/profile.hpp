// SPDX-License-Identifier: Apache-2.0
// The velocity profile in the outlet's frame, for one point (T = double) or for lanes of points. The
// pointwise functions and S6 share it.
#pragma once

#include <cmath>

#include "field/centreline_formulas.hpp"
#include "kernel_table.hpp"

namespace jet::profile {

using formulas::max;

/// Position in the outlet's frame.
template <class T>
struct Local {
  Vec3<T> d;        // [m] from the outlet's centre
  T z;              // [m] along the axis
  T along, across;  // [m] along the long and the short side; 0 for a round outlet
  /// [m2] Squared distance from the axis (round) or the long mid-plane (rectangular).
  T radius2;
};

template <class T>
[[gnu::always_inline]] inline T dot(const double* a, const Vec3<T>& b) {
  return a[0] * b.x + a[1] * b.y + a[2] * b.z;
}
template <class T>
[[gnu::always_inline]] inline T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// t a + b
template <class T>
[[gnu::always_inline]] inline Vec3<T> ahead(T t, const double* a, const Vec3<T>& b) {
  return {a[0] * t + b.x, a[1] * t + b.y, a[2] * t + b.z};
}

template <class T>
[[gnu::always_inline]] inline Local<T> local(const JetShape& jet, const Vec3<T>& point) {
  const Vec3<T> d = {point.x - jet.centre[0], point.y - jet.centre[1], point.z - jet.centre[2]};
  const T z = dot(jet.axis, d);
  if (jet.round) {
    const Vec3<T> r = ahead(-z, jet.axis, d);
    return {d, z, T(0.0), T(0.0), dot(r, r)};
  }
  const T across = dot(jet.across, d);
  return {d, z, dot(jet.along, d), across, across * across};
}

/// Distance of the cut-off from the axis or the long mid-plane [m].
template <class T>
[[gnu::always_inline]] inline T cut(const JetShape& jet, T z) {
  return max(T(jet.cut_core), jet.cut_origin + jet.cut_slope * z);
}
/// True if a point is not strictly downstream of the outlet's plane, or is beyond the cut-off.
template <class T>
[[gnu::always_inline]] inline auto outside(const JetShape& jet, T z, T radius2) {
  const T cut = profile::cut(jet, z);
  return (z <= T(0.0)) | (radius2 > cut * cut);
}

/// V_max / V0 and the width [m].
template <class T>
struct SectionOf {
  T decay, width;
};
template <class T>
[[gnu::always_inline]] inline SectionOf<T> section(const JetShape& jet, T z) {
  const T distance = z / jet.size;
  const T decay = jet.round ? formulas::round_decay(distance, jet.decay_coefficient)
                            : formulas::plane_decay(distance, jet.decay_coefficient);
  if (!jet.momentum) return {decay, jet.cone_width + jet.cone_slope * z};
  return {decay, jet.size * (jet.round ? formulas::round_momentum_width(decay)
                                       : formulas::plane_momentum_width(decay))};
}

/// V / V0 = decay e^exponent, that is V_max / V0 exp(-(r/R)^2).
template <class T>
struct Speed {
  T decay, exponent;
};
template <class T>
[[gnu::always_inline]] inline Speed<T> speed(const JetShape& jet, T z, T radius2) {
  const SectionOf<T> section = profile::section(jet, z);
  return {section.decay, -radius2 / (section.width * section.width)};
}

/// Component of a vector along the flow. For radial flow `along` must be divided by the distance from the
/// virtual origin.
template <class T>
struct Part {
  T along, distance2;
};
template <class T>
[[gnu::always_inline]] inline Part<T> part(const JetShape& jet, const Local<T>& x, const Vec3<T>& vector) {
  if (jet.axial) return {dot(jet.axis, vector), T(1.0)};
  const Vec3<T> straight = {x.across * T(jet.across[0]), x.across * T(jet.across[1]),
                            x.across * T(jet.across[2])};
  const T ahead_of_origin = jet.origin + x.z;
  const Vec3<T> away =
      jet.round ? ahead(T(jet.origin), jet.axis, x.d) : ahead(ahead_of_origin, jet.axis, straight);
  return {dot(away, vector), dot(away, away)};
}

/// For T = double. The kernels must not compile elementary::exp, because the linker would keep one copy of it
/// for all processors.
double exp(double x);

/// V . vector / V0
template <class T>
[[gnu::always_inline]] inline T velocity_along(const JetShape& jet, const Speed<T>& at,
                                               const Part<T>& vector) {
  using std::sqrt;
  const T speed = at.decay * exp(at.exponent);
  if (jet.axial) return speed * vector.along;
  return speed * vector.along / sqrt(vector.distance2);
}
template <class T>
[[gnu::always_inline]] inline T velocity_along(const JetShape& jet, const Local<T>& x,
                                               const Vec3<T>& vector) {
  return velocity_along(jet, speed(jet, x.z, x.radius2), part(jet, x, vector));
}

}  // namespace jet::profile
