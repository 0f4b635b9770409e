// SPDX-License-Identifier: Apache-2.0
// Plane stress linear in logarithmic (Hencky) strain, at constant thickness, without compression.
#pragma once

#include <cmath>
#include <limits>

#include "membrane/material.hpp"

namespace membrane {

/// Elastic constants of isotropic fabric under the Hencky law (M.25), in the form that the kernels use.
template <class T>
struct HenckyConstants {
  T spherical;   // K = E / (1 - nu) [Pa]
  T deviator;    // G = E / (1 + nu) [Pa]
  T curvature;   // 1 - nu^2 [-]
  T share;       // 1 / (1 - nu) [-]
  T compliance;  // 1 / E [1/Pa], 0 for an element without stress
};

/// Constants from E [Pa] and nu [-]. Preconditions: E > 0 and -1 < nu < 1.
inline HenckyConstants<double> hencky_constants(double young_modulus, double poisson) {
  return {young_modulus / (1.0 - poisson), young_modulus / (1.0 + poisson), (1.0 - poisson) * (1.0 + poisson),
          1.0 / (1.0 - poisson), 1.0 / young_modulus};
}

/// Euler's number [-].
inline constexpr double kEuler = 2.71828182845904523536;
/// Largest principal Green-Lagrange strain [-] of the law, at a stretch of exp(1/2) = 1.65. The factor of the
/// tangent is infinite beyond it.
inline constexpr double kHenckyStrainLimit = 0.5 * (kEuler - 1.0);

/// Logarithmic strain of a fabric, and the square of its largest stretch.
template <class T>
struct HenckyStrain {
  T strain_1;  // [-] max(ln(lambda_1), 0)
  T radius;    // [-] ln(lambda_1 / lambda_2) / 2, smaller if the fabric is far from taut
  T square_1;  // [-] max(lambda_1^2, 1)
};

/// State of the law: of the fabric itself if it is taut, otherwise of the narrowest shape without compression
/// (M.26). Its two stretches are e^(m + r) and e^(m - r).
template <class T>
struct HenckyState {
  T mean;    // m [-]
  T radius;  // r [-]
  T taut;    // 1, or 0 if wrinkled or slack
};

/// atanh(y) for |y| <= (e - 1) / (e + 1), with a relative error of 4e-17 before rounding: y + y z P(z), where
/// z = y^2 and P is the Chebyshev interpolation with 12 terms.
template <class T>
[[gnu::always_inline]] inline T atanh_series(T y) {
  const T z = y * y, z2 = z * z, z4 = z2 * z2;
  const T p0 = (T(0.3333333333333331879) + T(0.2000000000001960641) * z) +
               (T(0.1428571428135329412) + T(0.111111114898268898) * z) * z2;
  const T p1 = (T(0.09090892160460047752) + T(0.07692752299796506842) * z) +
               (T(0.06659307637825859966) + T(0.05961884751391089818) * z) * z2;
  const T p2 = (T(0.04696865889943796822) + T(0.07369488683896611706) * z) +
               (T(-0.02955289392868221069) + T(0.1454860760821660402) * z) * z2;
  return y + y * (z * (p0 + (p1 + p2 * z4) * z4));
}

/// Logarithmic strain from the mean and the radius of the Green-Lagrange strain: ln(lambda) is
/// atanh((lambda^2 - 1) / (lambda^2 + 1)). Squares of stretches are limited to 1/e (there the fabric has long
/// been wrinkled or slack) and e.
template <class T>
[[gnu::always_inline]] inline HenckyStrain<T> hencky_strain(T mean, T radius) {
  const T lowest(1.0 / kEuler - 1.0), highest(kEuler - 1.0), zero(0.0), two(2.0);
  const T sum = two * (mean + radius), difference = two * (mean - radius);
  const T cut_1 = select(sum < highest, sum, highest),
          cut_2 = select(difference < highest, difference, highest);
  const T growth_1 = select(cut_1 > zero, cut_1, zero), growth_2 = select(cut_2 > lowest, cut_2, lowest);
  const T below_1 = two + growth_1, below_2 = two + growth_2;
  const T inverse = T(1.0) / (below_1 * below_2);
  const T strain_1 = atanh_series(growth_1 * below_2 * inverse);
  const T strain_2 = atanh_series(growth_2 * below_1 * inverse);
  return {strain_1, T(0.5) * (strain_1 - strain_2), T(1.0) + growth_1};
}

/// State of the law (M.26): taut if the radius is below its value in tension along one axis,
/// r = (1 - sqrt(1 - (1 - nu^2) ln(lambda_1))) / (1 - nu).
template <class T>
[[gnu::always_inline]] inline HenckyState<T> hencky_state(const HenckyStrain<T>& e,
                                                          const HenckyConstants<T>& c) {
  using std::sqrt;
  const T one(1.0);
  const T natural = (one - sqrt(one - c.curvature * e.strain_1)) * c.share;
  const auto is_taut = e.radius < natural;
  const T r = select(is_taut, e.radius, natural);
  return {e.strain_1 - r, r, select(is_taut, one, T(0.0))};
}

/// Stress, energy and principal values (M.25) at the Green-Lagrange strain `e` with `mean` and `radius`, and
/// the state from the functions above.
template <class T>
[[gnu::always_inline]] inline PlaneResponse<T> hencky_stress(const PlaneStrain<T>& e, T mean, T radius,
                                                             T square_1, const HenckyState<T>& h,
                                                             const HenckyConstants<T>& c) {
  const T half(0.5), zero(0.0), one(1.0);
  const T m = h.mean, r = h.radius;
  // tanh(m) = m P(w) / Q(w), w = m^2, to 1e-19 for m <= 1/2; then J = exp(2 m) = (Q + m P) / (Q - m P).
  const T w = m * m, w2 = w * w;
  const T p = m * ((one + T(0.1281782168142291856) * w) +
                   (T(0.002794213858382641246) + T(7.371610486117116315e-6) * w) * w2);
  const T q = (one + T(0.4615115501475625185) * w) +
              (T(0.02329806390757027209) + T(0.0002067735282493054803) * w) * w2;
  const T above = q + p, below = q - p;
  // The smallest normal number avoids 0/0 (if no direction is principal) and changes no other quotient.
  const T safe_radius = radius + T(std::numeric_limits<double>::min());
  const T product = square_1 * safe_radius;
  const T inverse = one / ((above * below) * product);
  const T ratio = (above * above) * (product * inverse);      // J
  const T growth = ((p + p) * above) * (product * inverse);   // J - 1, without cancellation
  const T along = (above * above) * (safe_radius * inverse);  // J / lambda_1^2 = lambda_2 / lambda_1
  const T across = (below * below) * ((square_1 * product) * inverse);  // lambda_1 / lambda_2

  const T square = c.deviator * (r * r), shift = c.deviator * r;
  const T middle = c.spherical * m + square;
  const T stress_1 = along * (middle + shift), stress_2 = across * (middle - shift);
  const T a = half * (stress_1 + stress_2);
  const T b = half * ((stress_1 - stress_2) * ((above * below) * (square_1 * inverse)));

  // (M.27): tangent over stiffness at rest, apart from the largest stress.
  const T largest = select(stress_1 > stress_2, stress_1, stress_2);
  const T plane = half * (c.spherical + c.deviator);
  const T excess = (h.taut * c.compliance) * ((middle - plane) + across * (plane - shift) - largest);
  const T factor = one + select(excess > zero, excess, zero);
  const T strain_1 = mean + radius;
  const T difference = half * (e.e11 - e.e22);
  return {a + b * difference,
          a - b * difference,
          b * e.e12,
          half * c.spherical * ((m + m) * ratio - growth) + square * ratio,
          largest,
          strain_1,
          select(strain_1 > T(kHenckyStrainLimit), T(std::numeric_limits<double>::max()), factor)};
}

/// Stress, energy and principal values at a point (M.25, M.26), for T = double or a SIMD lane type. The
/// Cauchy stress has the mean K m + G r^2 and the deviator G r, and the thickness stays. The stress is the
/// derivative of the energy, continuous and positive semi-definite. `stress_1` is the largest principal
/// second Piola-Kirchhoff stress, `strain_1` the largest principal Green-Lagrange strain.
template <class T>
PlaneResponse<T> hencky_response(const PlaneStrain<T>& e, const HenckyConstants<T>& c) {
  using std::sqrt;
  const T mean = T(0.5) * (e.e11 + e.e22), difference = T(0.5) * (e.e11 - e.e22);
  const T radius = sqrt(difference * difference + e.e12 * e.e12);
  const HenckyStrain<T> logarithmic = hencky_strain(mean, radius);
  return hencky_stress(e, mean, radius, logarithmic.square_1, hencky_state(logarithmic, c), c);
}

/// The law of Cauchy stress linear in logarithmic strain. Its steps are the functions above.
struct Hencky : LawDefaults {
  /// Traits of the law.
  static constexpr LawTraits traits{
      .name = "hencky", .end = "is stretched by more than exp(1/2) = 1.65, where the Hencky law ends"};
  /// Constants in the form that the kernels use.
  template <class T>
  using Constants = HenckyConstants<T>;

  /// The steps: strain, then state.
  static constexpr int kSteps = 2;
  /// Notes before each step: none, then those of the strain.
  static constexpr int kNotesBefore[] = {0, 5};
  /// Notes of the steps.
  template <class T>
  struct Notes {
    T mean;          // mean of the Green-Lagrange strain [-]
    T radius;        // radius of the same [-]
    T strain_1;      // of HenckyStrain
    T log_radius;    // of HenckyStrain
    T square_1;      // of HenckyStrain
    T state_mean;    // of HenckyState
    T state_radius;  // of HenckyState
    T taut;          // of HenckyState
  };

  /// Constants of one element.
  static Constants<double> constants(const LawInput& fabric) {
    return hencky_constants(fabric.moduli.young_modulus_warp, fabric.moduli.poisson);
  }
  /// One of the steps.
  template <int kStep, class T>
  [[gnu::always_inline]] static auto step(const PlaneStrain<T>& e, const Constants<T>& c, const Notes<T>& n) {
    using std::sqrt;
    if constexpr (kStep == 0) {
      const T mean = T(0.5) * (e.e11 + e.e22), difference = T(0.5) * (e.e11 - e.e22);
      const T radius = sqrt(difference * difference + e.e12 * e.e12);
      const HenckyStrain<T> h = hencky_strain(mean, radius);
      return Row<T, 5>{{mean, radius, h.strain_1, h.radius, h.square_1}};
    } else {
      const HenckyState<T> h = hencky_state(HenckyStrain<T>{n.strain_1, n.log_radius, n.square_1}, c);
      return Row<T, 3>{{h.mean, h.radius, h.taut}};
    }
  }
  /// Response at a point.
  template <Compression kCompression, class T>
  [[gnu::always_inline]] static PlaneResponse<T> response(const PlaneStrain<T>& e, const Constants<T>& c,
                                                          const Notes<T>& n, const YarnCurves&) {
    return hencky_stress(e, n.mean, n.radius, n.square_1,
                         HenckyState<T>{n.state_mean, n.state_radius, n.taut}, c);
  }
};

}  // namespace membrane
