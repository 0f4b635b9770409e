// SPDX-License-Identifier: Apache-2.0
// Woven fabric: orthotropic St. Venant-Kirchhoff plane stress with or without compression.
#pragma once

#include <cmath>
#include <limits>

#include "membrane/material.hpp"

namespace membrane {

/// Elastic constants in the form that the kernels use (M.13). In the frame of warp and weft, the strain along
/// the warp is multiplied by `warp_scale` and the strain along the weft by its inverse; stresses are
/// multiplied by the inverses. This keeps S : E and the signs of both tensors, and makes warp and weft
/// equally stiff. The stiffness is then diagonal in mean, difference and shear.
template <class T>
struct OrthotropicConstants {
  /// [-] cosine of twice the angle from the frame's first axis to the warp.
  T cosine;
  T sine;  // [-] sine of the same angle
  /// [-] (C_11 / C_22)^(1/4). A divisor, so 1 for an element without stress.
  T warp_scale = T(1.0);
  /// [Pa] sqrt(C_11 C_22) + C_12: mean stress over mean strain.
  T spherical;
  /// [Pa] sqrt(C_11 C_22) - C_12: stress over strain, for half the differences between warp and weft.
  T deviator;
  /// [Pa] 2 G: shear stress over tensor shear strain.
  T shear;
  /// [Pa] 1 / (1 / spherical + 1 / deviator). This and the next two belong to the wrinkled branch (M.14); all
  /// are 0 for an element without stress.
  T series;
  /// [-] series * (1 / deviator - 1 / shear), 0 if isotropic in the scaled frame.
  T skew;
  /// [-] 1 + deviator / spherical, value of the root at the taut border.
  T taut;
};

/// Constants of a fabric; `cosine` and `sine` as above. Precondition: the stiffness is positive definite.
inline OrthotropicConstants<double> orthotropic_constants(const Weave& w, double cosine, double sine) {
  const double reciprocal = 1.0 - w.poisson * w.poisson * (w.young_modulus_weft / w.young_modulus_warp);
  const double c11 = w.young_modulus_warp / reciprocal, c22 = w.young_modulus_weft / reciprocal,
               c12 = w.poisson * c22;
  const double middle = std::sqrt(c11) * std::sqrt(c22);
  const double spherical = middle + c12, deviator = middle - c12, shear = 2.0 * w.shear;
  const double series = spherical * deviator / (spherical + deviator);
  return {cosine,
          sine,
          std::sqrt(std::sqrt(c11 / c22)),
          spherical,
          deviator,
          shear,
          series,
          series * (1.0 / deviator - 1.0 / shear),
          1.0 + deviator / spherical};
}

/// True if the value, or the value of any lane, is positive. SIMD lane types have their own overload, found
/// by argument-dependent lookup.
inline bool any_positive(double value) {
  return value > 0.0;
}

/// Root u [-] of (M.14), 0 at the slack border and `taut` at the taut one. `mean`, `difference` and `shear`
/// are the scaled strains. The function is concave (mean > 0) or convex, so Newton's method, started at the
/// border given by the mean's sign, approaches the root from one side. A lane that no longer advances is
/// done; further rounds for its neighbours do not change it. 12 rounds suffice for shear / deviator from 1e-4
/// to 100.
template <class T>
T wrinkle_root(T mean, T difference, T shear, const OrthotropicConstants<T>& c) {
  using std::sqrt;
  constexpr int most_rounds = 60;
  const T zero(0.0), one(1.0), rounding(0.5 * std::numeric_limits<double>::epsilon());
  const auto from_taut = mean > zero;
  T u = select(from_taut, c.taut, zero);
  for (int round = 0; round < most_rounds; ++round) {
    const T b = one - c.skew * u;
    const T db = difference * b;
    // The smallest normal number avoids 0/0; the step is then zero.
    const T inverse = one / (sqrt(db * db + shear * shear) + T(std::numeric_limits<double>::min()));
    const T t = shear * inverse;
    const T value = mean * b * inverse + (one - u);
    const T slope = mean * inverse * (c.skew * (t * t)) + one;
    // The slope is positive unless the start is beyond the root, that is, the state is taut or slack.
    const T step = value / select(slope > zero, slope, one);
    const T advance = select(from_taut, zero - step, step) - c.taut * rounding;
    if (!any_positive(advance)) break;
    u = select(advance > zero, u + step, u);
  }
  return u;
}

/// Stress, energy and principal values at a point (M.13, M.14), for T = double or a SIMD lane type. Without
/// compression, the energy is the minimum over all added wrinkle strains and the stress is its derivative.
/// The stress is positive semi-definite and continuous, and S : E / 2 = W everywhere.
template <Compression kCompression, class T>
PlaneResponse<T> orthotropic_response(const PlaneStrain<T>& e, const OrthotropicConstants<T>& c) {
  using std::sqrt;
  const T half(0.5);
  const T plain_mean = half * (e.e11 + e.e22), plain_difference = half * (e.e11 - e.e22);
  const T strain_1 = plain_mean + sqrt(plain_difference * plain_difference + e.e12 * e.e12);
  const T turned = plain_difference * c.cosine + e.e12 * c.sine;
  const T shear = e.e12 * c.cosine - plain_difference * c.sine;
  const T warp = c.warp_scale * (plain_mean + turned), weft = (plain_mean - turned) / c.warp_scale;
  const T mean = half * (warp + weft), difference = half * (warp - weft);

  T a = c.spherical * mean, b = c.deviator * difference, d = c.shear * shear;
  if constexpr (kCompression == Compression::none) {
    const T u = wrinkle_root(mean, difference, shear, c);
    b = c.series * u * difference;
    d = c.series * u * shear / (T(1.0) - c.skew * u);
    const T uniaxial = sqrt(b * b + d * d);
    a = select(a > uniaxial, a, uniaxial);
  }
  const T s_warp = c.warp_scale * (a + b), s_weft = (a - b) / c.warp_scale;
  const T s_mean = half * (s_warp + s_weft), s_difference = half * (s_warp - s_weft);
  const T s_turned = s_difference * c.cosine - d * c.sine;
  return {s_mean + s_turned,
          s_mean - s_turned,
          s_difference * c.sine + d * c.cosine,
          a * mean + b * difference + d * shear,
          s_mean + sqrt(s_difference * s_difference + d * d),
          strain_1,
          stretch_factor(strain_1)};
}

/// The same with the compression law chosen at run time.
inline PlaneResponse<double> orthotropic_response(Compression compression, const PlaneStrain<double>& e,
                                                  const OrthotropicConstants<double>& c) {
  return compression == Compression::none ? orthotropic_response<Compression::none>(e, c)
                                          : orthotropic_response<Compression::linear>(e, c);
}

/// The law of stress linear in Green-Lagrange strain (M.13, M.14), of woven fabric.
struct Orthotropic : LawDefaults {
  /// Traits of the law.
  static constexpr LawTraits traits{.name = "saint_venant_kirchhoff", .woven = true, .compression = true};
  /// Constants in the form that the kernels use.
  template <class T>
  using Constants = OrthotropicConstants<T>;

  /// Constants of one element.
  static Constants<double> constants(const LawInput& fabric) {
    return orthotropic_constants(fabric.moduli, fabric.cosine, fabric.sine);
  }
  /// Response at a point.
  template <Compression kCompression, class T>
  static PlaneResponse<T> response(const PlaneStrain<T>& e, const Constants<T>& c, const Notes<T>&,
                                   const YarnCurves&) {
    return orthotropic_response<kCompression>(e, c);
  }
};

}  // namespace membrane
