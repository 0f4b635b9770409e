// SPDX-License-Identifier: Apache-2.0
// Woven fabric by measured curves: nominal stress over strain along the yarns of warp and weft.
#pragma once

#include <cmath>
#include <limits>

#include "membrane/material.hpp"

namespace membrane {

/// Most points of a curve of stress over strain.
inline constexpr int kMostCurvePoints = 64;

/// Nominal stress [Pa] along a yarn over its strain, as a sum of ramps (M.30).
struct YarnCurve {
  int count;                        // number of ramps
  double strain[kMostCurvePoints];  // [-] begin of each ramp
  double rise[kMostCurvePoints];    // [Pa] increase of the slope there
  double end;                       // [-] strain of the last point
  double steepest;                  // [Pa] largest slope
};

/// Curves of both directions.
struct YarnCurves {
  YarnCurve warp;  // along the first direction
  YarnCurve weft;  // along the second
};

/// Constants of a fabric by measured curves, in the form that the kernels use (M.30).
template <class T>
struct YarnConstants {
  T cosine;  // [-] cosine of twice the angle from the frame's first axis to the warp
  T sine;    // [-] sine of the same angle
  T shear;   // 2 G [Pa]
};

/// Stress of a yarn over its stretch, P / lambda, and its energy.
template <class T>
struct YarnResponse {
  T stress;          // second Piola-Kirchhoff [Pa]
  T energy_density;  // integral of P over the strain [J/m3]
  T strain;          // lambda - 1 [-], 0 in compression
};

/// Response of a yarn of Green-Lagrange strain `e` along it. The curve is a sum of ramps that begin at its
/// points. The response is zero in compression, where the yarn buckles.
template <class T>
[[gnu::always_inline]] inline YarnResponse<T> yarn_response(const YarnCurve& curve, T e) {
  using std::sqrt;
  const T zero(0.0), one(1.0), two(2.0), half(0.5);
  const T taut = select(e > zero, e, zero);
  const T stretch = sqrt(one + two * taut);
  const T strain = two * taut / (stretch + one);  // stretch - 1 without cancellation
  T stress = zero, energy = zero;
  for (int i = 0; i < curve.count; ++i) {
    const T beyond = strain - T(curve.strain[i]);
    const T part = select(beyond > zero, beyond, zero);
    const T ramp = T(curve.rise[i]) * part;
    stress = stress + ramp;
    energy = energy + half * ramp * part;
  }
  return {stress / stretch, energy, strain};
}

/// Stress, energy and principal values at a point (M.30), for T = double or a SIMD lane type. The stress is
/// the derivative of the energy. Past the end of a curve the factor of the tangent is infinite.
template <class T>
[[gnu::always_inline]] inline PlaneResponse<T> yarns_response(const PlaneStrain<T>& e,
                                                              const YarnConstants<T>& c,
                                                              const YarnCurves& curves) {
  using std::sqrt;
  const T half(0.5);
  const T mean = half * (e.e11 + e.e22), difference = half * (e.e11 - e.e22);
  const T strain_1 = mean + sqrt(difference * difference + e.e12 * e.e12);
  const T turned = difference * c.cosine + e.e12 * c.sine;
  const T shear = e.e12 * c.cosine - difference * c.sine;
  const YarnResponse<T> warp = yarn_response(curves.warp, mean + turned);
  const YarnResponse<T> weft = yarn_response(curves.weft, mean - turned);
  const T d = c.shear * shear;
  const T s_mean = half * (warp.stress + weft.stress), s_difference = half * (warp.stress - weft.stress);
  const T s_turned = s_difference * c.cosine - d * c.sine;
  const T infinite(std::numeric_limits<double>::max());
  T factor = stretch_factor(strain_1);
  factor = select(warp.strain > T(curves.warp.end), infinite, factor);
  factor = select(weft.strain > T(curves.weft.end), infinite, factor);
  return {s_mean + s_turned,
          s_mean - s_turned,
          s_difference * c.sine + d * c.cosine,
          warp.energy_density + weft.energy_density + d * shear,
          s_mean + sqrt(s_difference * s_difference + d * d),
          strain_1,
          factor};
}

/// The law by measured curves.
struct Yarns : LawDefaults {
  /// Traits of the law.
  static constexpr LawTraits traits{.name = "curve",
                                    .woven = true,
                                    .curves = true,
                                    .end = "is stretched beyond the last point of its curve"};
  /// Constants in the form that the kernels use.
  template <class T>
  using Constants = YarnConstants<T>;

  /// Constants of one element.
  static Constants<double> constants(const LawInput& fabric) {
    return {fabric.cosine, fabric.sine, 2.0 * fabric.moduli.shear};
  }
  /// Largest stiffness of the fabric (M.31).
  static Weave stiffness(const LawInput& fabric) {
    return {fabric.curves->warp.steepest, fabric.curves->weft.steepest, 0.0, fabric.moduli.shear};
  }
  /// Response at a point.
  template <Compression kCompression, class T>
  [[gnu::always_inline]] static PlaneResponse<T> response(const PlaneStrain<T>& e, const Constants<T>& c,
                                                          const Notes<T>&, const YarnCurves& curves) {
    return yarns_response(e, c, curves);
  }
};

}  // namespace membrane
