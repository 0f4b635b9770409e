// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>

#include "membrane/law.hpp"

namespace membrane {

/// Compression law of the fabric. With `linear` it carries compression like any solid; with `none` it
/// wrinkles or goes slack instead (relaxed energy, M.3).
enum class Compression { linear, none };

/// Green-Lagrange strain in an orthonormal frame of the reference plane (M.1); e12 is the tensor component.
template <class T>
struct PlaneStrain {
  T e11;  // [-] along the first axis
  T e22;  // [-] along the second
  T e12;  // [-] half the shear angle
};

/// Elastic constants of isotropic St. Venant-Kirchhoff plane stress (M.2), in the form that the kernels use.
template <class T>
struct IsotropicConstants {
  T young_modulus;  // E [Pa]
  T spherical;      // E / (1 - nu) [Pa]: mean stress over mean strain
  T deviator;       // E / (1 + nu) [Pa]: deviatoric stress over deviatoric strain
};

/// Result of the pointwise law: second Piola-Kirchhoff stress and energy.
template <class T>
struct PlaneResponse {
  T s11;             // [Pa] along the first axis
  T s22;             // [Pa] along the second
  T s12;             // [Pa] shear
  T energy_density;  // [J/m3 of the reference volume]
  T stress_1;        // [Pa] largest principal second Piola-Kirchhoff stress
  T strain_1;        // [-] largest principal Green-Lagrange strain
  /// [-] the tangent is at most the stiffness at rest times this, plus the geometric stiffness of stress_1
  /// (M.10).
  T tangent_factor;
};

/// Constants from E [Pa] and nu [-]. Preconditions: E > 0 and -1 < nu < 1.
template <class T>
IsotropicConstants<T> isotropic_constants(T young_modulus, T poisson) {
  return {young_modulus, young_modulus / (T(1.0) - poisson), young_modulus / (T(1.0) + poisson)};
}

/// Lane-wise choice. SIMD lane types have their own overload, found by argument-dependent lookup.
inline double select(bool condition, double if_true, double if_false) {
  return condition ? if_true : if_false;
}

/// Factor of the tangent for stress linear in Green-Lagrange strain: max(1, lambda_max(C)) (M.10). The strain
/// operator is B(F) dx = B_0 (U dx), with U the right stretch of C = F^T F.
template <class T>
T stretch_factor(T strain_1) {
  const T zero(0.0);
  return T(1.0) + T(2.0) * select(strain_1 > zero, strain_1, zero);
}

/// Green-Lagrange strain E = (F^T F - 1) / 2 (M.1); f1, f2 are the columns of the deformation gradient F.
template <class T>
PlaneStrain<T> green_lagrange_strain(const T (&f1)[3], const T (&f2)[3]) {
  const T half(0.5);
  return {half * ((f1[0] * f1[0] + f1[1] * f1[1] + f1[2] * f1[2]) - T(1.0)),
          half * ((f2[0] * f2[0] + f2[1] * f2[1] + f2[2] * f2[2]) - T(1.0)),
          half * (f1[0] * f2[0] + f1[1] * f2[1] + f1[2] * f2[2])};
}

/// Stress, energy and principal values at a point (M.2, M.3), for T = double or a SIMD lane type.
///
/// Let m be the mean strain, D the deviatoric strain and r its radius; the principal strains are m +- r.
/// Every state has S = a 1 + b D, W = a m + b r^2 and S_1 = a + b r:
///   taut                       a = E m / (1 - nu),  b = E / (1 + nu)
///   wrinkled (S_2 would be < 0) a = E E_1 / 2,       b = E E_1 / (2 r)
///   slack (E_1 <= 0)           a = b = 0
///
/// Wrinkled and slack are one branch, because E_1 is limited to zero or more. The energy is C1 across all
/// borders and the stress is continuous. The relaxed energy is the minimum of the taut energy over all added
/// wrinkle strains (Pipkin 1986, IMA J. Appl. Math. 36, 85-99), so its tangent is never above the taut one.
template <Compression kCompression, class T>
PlaneResponse<T> isotropic_response(const PlaneStrain<T>& e, const IsotropicConstants<T>& c) {
  using std::sqrt;
  const T mean = T(0.5) * (e.e11 + e.e22);
  const T difference = T(0.5) * (e.e11 - e.e22);
  const T radius = sqrt(difference * difference + e.e12 * e.e12);
  const T strain_1 = mean + radius;
  T a = c.spherical * mean;
  T b = c.deviator;
  if constexpr (kCompression == Compression::none) {
    const auto not_taut = a - b * radius < T(0.0);
    const T half_tension = T(0.5) * (c.young_modulus * select(strain_1 > T(0.0), strain_1, T(0.0)));
    // The smallest normal number avoids 0/0 (no strain at all) and changes no other quotient.
    const T ratio = half_tension / (radius + T(std::numeric_limits<double>::min()));
    a = select(not_taut, half_tension, a);
    b = select(not_taut, ratio, b);
  }
  return {a + b * difference,
          a - b * difference,
          b * e.e12,
          a * mean + b * (radius * radius),
          a + b * radius,
          strain_1,
          stretch_factor(strain_1)};
}

/// The same with the compression law chosen at run time.
inline PlaneResponse<double> isotropic_response(Compression compression, const PlaneStrain<double>& e,
                                                const IsotropicConstants<double>& c) {
  return compression == Compression::none ? isotropic_response<Compression::none>(e, c)
                                          : isotropic_response<Compression::linear>(e, c);
}

/// The law of stress linear in Green-Lagrange strain (M.2, M.3), of isotropic fabric.
struct Isotropic : LawDefaults {
  /// Traits of the law.
  static constexpr LawTraits traits{.name = "saint_venant_kirchhoff", .compression = true};
  /// Constants in the form that the kernels use.
  template <class T>
  using Constants = IsotropicConstants<T>;

  /// Constants of one element.
  static Constants<double> constants(const LawInput& fabric) {
    return isotropic_constants(fabric.moduli.young_modulus_warp, fabric.moduli.poisson);
  }
  /// Response at a point.
  template <Compression kCompression, class T>
  static PlaneResponse<T> response(const PlaneStrain<T>& e, const Constants<T>& c, const Notes<T>&,
                                   const YarnCurves&) {
    return isotropic_response<kCompression>(e, c);
  }
};

}  // namespace membrane
