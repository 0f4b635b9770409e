// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "check.hpp"
#include "closed_form/jet.hpp"

namespace closed_form {
namespace {

constexpr double kCore = 0.70;

// 2 kappa/sqrt(density_ratio), what t + 0.70 gains a diameter.
double growth(const CompressibleJet& jet) {
  check::within("mach", jet.mach, 0.0, 1.0);
  check::positive("density_ratio", jet.density_ratio);
  const double kappa = 0.08 * (1.0 - 0.16 * jet.mach) * std::pow(jet.density_ratio, 0.22);
  return 2.0 * kappa / std::sqrt(jet.density_ratio);
}

}  // namespace

double witze_centreline_ratio(const CompressibleJet& jet, double distance_over_diameter) {
  check::non_negative("distance_over_diameter", distance_over_diameter);
  const double t = growth(jet) * distance_over_diameter - kCore;
  return t > 0.0 ? -std::expm1(-1.0 / t) : 1.0;
}

double witze_core_length(const CompressibleJet& jet) {
  return kCore / growth(jet);
}

double witze_decay_constant(const CompressibleJet& jet) {
  return 1.0 / growth(jet);
}

}  // namespace closed_form
