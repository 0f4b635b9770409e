// SPDX-License-Identifier: Apache-2.0
// The jet of *AIRBAG_HYBRID_JETTING.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gas/species.hpp"
#include "lsdyna_context.hpp"

namespace driver::imported {

// The outlet's size is not in the deck: that through which the largest flow is sonic at ambient pressure.
void map_jet(LsDynaContext& c, const LsDynaEntry& card) {
  const auto real = [&](std::size_t field, const char* name) { return c.real(card, 0, field, name); };
  const Eigen::Vector3d focus(real(0, "XJFP"), real(1, "YJFP"), real(2, "ZJFP"));
  const Eigen::Vector3d head(real(3, "XJVH"), real(4, "YJVH"), real(5, "ZJVH"));
  if (!((head - focus).norm() > 0.0))
    throw DeckFault(c.airbag.at, "the jet's focus and head are at one place");
  for (BagInflator& inflator : c.bag.inflators) {
    double largest = 0.0, hottest = 0.0;
    for (const auto& knot : inflator.mass_flow) largest = std::max(largest, knot[1]);
    for (const auto& knot : inflator.temperature) hottest = std::max(hottest, knot[1]);
    if (!(largest > 0.0)) continue;
    const BagGas& gas = c.bag.gases[inflator.gas.shares.front().first];
    const double constant = gas::kMolarGasConstant / gas.molar_mass;
    const double sound = std::sqrt(gas.cp[0] / (gas.cp[0] - constant) * constant * hottest);
    const double area = largest * constant * hottest / (c.bag.ambient_pressure * sound);
    inflator.jet = {focus * c.units.length, (head - focus).normalized(), std::sqrt(area / std::numbers::pi),
                    real(6, "CA")};
    c.report.note(fmt::format(
        "jet: the deck has a cone of half angle CA = {:.3g} rad and an efficiency BETA = {:.3g}; here "
        "a round jet of radius {:.3g} m, sonic at its largest flow, spreads by its momentum",
        real(6, "CA"), real(7, "BETA"), inflator.jet->radius));
  }
}

}  // namespace driver::imported
