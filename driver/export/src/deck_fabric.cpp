// SPDX-License-Identifier: Apache-2.0
#include "export/deck_fabric.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <elementary/exponential.hpp>

#include "membrane/law_table.hpp"

namespace driver {
namespace {

double green_lagrange_strain(double strain) {
  return strain + 0.5 * strain * strain;
}

// Error of stress in a strip if a program takes the converted curve for nominal stress over stretch minus 1:
// the largest difference [Pa] at the curve's own points.
double misread(const DeckCurve& nominal, const DeckCurve& converted) {
  double largest = 0.0;
  for (const auto& [strain, stress] : nominal)
    largest = std::max(largest, std::abs(stress - value_on(converted, strain)));
  return largest;
}

double steepest(const DeckCurve& curve) {
  double slope = 0.0;
  for (std::size_t k = 1; k < curve.size(); ++k)
    slope = std::max(slope, (curve[k][1] - curve[k - 1][1]) / (curve[k][0] - curve[k - 1][0]));
  return slope;
}

}  // namespace

DeckCurve green_lagrange(const DeckCurve& nominal, double share) {
  const double allowed = share * nominal.back()[1];
  DeckCurve points{nominal.front()};
  for (std::size_t k = 1; k < nominal.size(); ++k) {
    const auto [from, low] = nominal[k - 1];
    const auto [to, high] = nominal[k];
    const double slope = (high - low) / (to - from), stretch = 1.0 + from;
    // On the piece P = a + b lambda, d2S/dE2 is 3 a/lambda^5; the error of a chord is an eighth of it times
    // the square of its length.
    const double curvature = 3.0 * std::abs(low - slope * stretch) / elementary::pow(stretch, 5);
    const double length = green_lagrange_strain(to) - green_lagrange_strain(from);
    const double count = std::max(1.0, std::ceil(length * std::sqrt(curvature / (8.0 * allowed))));
    for (double i = 1.0; i <= count; ++i) {
      const double strain = i == count ? to : from + (to - from) * (i / count);
      const double stress = i == count ? high : low + slope * (strain - from);
      points.push_back({green_lagrange_strain(strain), stress / (1.0 + strain)});
    }
  }
  return points;
}

double value_on(const DeckCurve& curve, double x) {
  std::size_t k = 1;
  while (k + 1 < curve.size() && curve[k][0] < x) ++k;
  const auto [from, low] = curve[k - 1];
  const auto [to, high] = curve[k];
  return low + (high - low) * ((x - from) / (to - from));
}

void add_fabric(const BagPart& bag, Deck& deck) {
  const membrane::BagDescription& d = bag.model.description;
  if (!membrane::law_named(d.law).curves) return;
  constexpr double share = 1e-4;  // share of the last stress
  double stretched = 1.0;
  for (std::size_t i = 0; i < 2; ++i) {
    const membrane::StressCurve& curve = d.curves[i];
    const char* key = i == 0 ? "fabric.warp_curve" : "fabric.weft_curve";
    DeckCurve nominal;
    for (std::size_t k = 0; k < curve.strain.size(); ++k)
      nominal.push_back({curve.strain[k], curve.stress[k]});
    stretched *= 1.0 + curve.strain.back();
    const std::string beyond =
        fmt::format("beyond {:.4g}, where this program stops, it is extrapolated", curve.strain.back());
    if (deck.format == DeckFormat::radioss) {
      deck.threads[i] = {nominal, steepest(nominal)};
      deck.notes.push_back({key, fmt::format("all {} points; {}", nominal.size(), beyond)});
      continue;
    }
    deck.threads[i] = {green_lagrange(nominal, share), steepest(nominal)};
    deck.notes.push_back(
        {key, fmt::format("{} points as {}, within {:.0e} of the last stress; {}. A version that takes them "
                          "for nominal stress over stretch minus 1 has up to {:.2g} of the last stress less",
                          nominal.size(), deck.threads[i].curve.size(), share, beyond,
                          misread(nominal, deck.threads[i].curve) / nominal.back()[1])});
  }
  if (deck.format == DeckFormat::radioss)
    deck.notes.push_back({"fabric.weave.shear_modulus",
                          fmt::format("shear stress is G tan(angle), in the case this times both stretches: "
                                      "at the ends of both curves it is {:.2g} of the case's",
                                      1.0 / stretched)});
}

}  // namespace driver
