// SPDX-License-Identifier: Apache-2.0
#include "bag_fabric.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "weave_direction.hpp"

namespace driver::imported {

bool BagFabric::is_isotropic(double digits) const {
  const double isotropic = 0.5 * warp_modulus / (1.0 + poisson);
  return std::abs(weft_modulus / warp_modulus - 1.0) < digits && std::abs(shear / isotropic - 1.0) < digits;
}

void take_thread(BagDeck& bag, std::size_t thread, const Knots& knots, Place at, ImportReport& report) {
  Knots rising = as_stress_curve(knots, report);
  Knots& own = bag.threads[thread];
  if (!own.empty() && own != rising)
    throw DeckFault(
        at, "fabrics by different curves have no counterpart, allowed: one pair of curves for the whole bag");
  own = std::move(rising);
}

void take_elastic(BagFabric& fabric, double modulus, double poisson, const DeckCard& card,
                  ImportReport& report) {
  fabric.warp_modulus = fabric.weft_modulus = modulus;
  fabric.poisson = poisson;
  if (!(modulus > 0.0)) throw DeckFault(card.at, "E is needed, above 0");
  fabric.shear = 0.5 * modulus / (1.0 + poisson);
  report.became(card, {"fabric.law", "fabric.young_modulus", "fabric.density", "fabric.compression"},
                Mapping::approximated,
                "a membrane of St. Venant-Kirchhoff's law that carries compression: no bending");
}

void take_law(BagDeck& bag, const std::vector<std::string>& laws, const DeckCard& card,
              ImportReport& report) {
  if (laws.empty()) {
    if (!report.refused()) report.refuse(card, "no part of the control volume is of fabric");
    return;
  }
  const auto curves = static_cast<std::size_t>(std::ranges::count(laws, "curve"));
  if (curves > 0 && curves < laws.size())
    return report.refuse(card,
                         "parts with and without measured curves have no counterpart, allowed: one law for "
                         "the whole bag");
  const bool all_hencky = std::ranges::all_of(laws, [](const auto& law) { return law == "hencky"; });
  bag.law = curves > 0                               ? "curve"
            : all_hencky && !bag.carries_compression ? "hencky"
                                                     : "saint_venant_kirchhoff";
  if (curves > 0) bag.carries_compression = false;
}

void take_leak(BagDeck& bag, BagLeak law, const Knots& velocity, Place at) {
  if (bag.leak != BagLeak::none && (bag.leak != law || bag.leak_velocity != velocity))
    throw DeckFault(
        at, "parts with different laws of leakage have no counterpart, allowed: one law for the whole bag");
  bag.leak = law;
  bag.leak_velocity = velocity;
}

void take_orifice(BagDeck& bag, double area, const std::string& source, const std::string& law,
                  ImportReport& report) {
  BagVent vent;
  vent.area = area;
  vent.source = source;
  report.note(fmt::format(
      "{} leaks as an orifice of {:.3g} m2, its open area at the start, which does not grow with the fabric",
      law, area));
  bag.vents.push_back(std::move(vent));
}

}  // namespace driver::imported
