// SPDX-License-Identifier: Apache-2.0
// Isotropic fabric that keeps a share of its stiffness in compression.
#pragma once

#include "membrane/material.hpp"

namespace membrane {

/// Constants of the law, in the form that the kernels use.
template <class T>
struct PartialConstants {
  T young_modulus;  // see IsotropicConstants
  T spherical;      // as above
  T deviator;       // as above
  T kept;           // [-] share in compression
};

/// The law: the mean, by that share, of fabric with compression and of fabric without (M.101).
struct Partial : LawDefaults {
  /// The share in compression.
  static constexpr LawConstant own_constants[] = {{"kept_compression", "", 0.0, 1.0}};
  /// What it is for.
  static constexpr LawTraits traits{.name = "partial", .own = own_constants, .own_count = 1};
  /// In the form that the kernels use.
  template <class T>
  using Constants = PartialConstants<T>;

  /// Of one element.
  static Constants<double> constants(const LawInput& fabric) {
    const auto c = isotropic_constants(fabric.moduli.young_modulus_warp, fabric.moduli.poisson);
    return {c.young_modulus, c.spherical, c.deviator, fabric.own[0]};
  }
  /// At a point.
  template <Compression, class T>
  static PlaneResponse<T> response(const PlaneStrain<T>& e, const Constants<T>& c, const Notes<T>&,
                                   const YarnCurves&) {
    const IsotropicConstants<T> fabric{c.young_modulus, c.spherical, c.deviator};
    const PlaneResponse<T> with = isotropic_response<Compression::linear>(e, fabric),
                           without = isotropic_response<Compression::none>(e, fabric);
    const auto mean = [&](T a, T b) { return c.kept * a + (T(1.0) - c.kept) * b; };
    return {mean(with.s11, without.s11),
            mean(with.s22, without.s22),
            mean(with.s12, without.s12),
            mean(with.energy_density, without.energy_density),
            mean(with.stress_1, without.stress_1),
            with.strain_1,
            with.tangent_factor};
  }
};

}  // namespace membrane
