// SPDX-License-Identifier: Apache-2.0
#include "pressure_volume.hpp"

#include <algorithm>
#include <cmath>

#include "require.hpp"

namespace gas {
namespace {

// Newton's steps below this share of T are followed by two more: one may end across a knot, the next is
// quadratic.
constexpr double kSmallStep = 1e-8;
constexpr int kSmallSteps = 3;
constexpr int kMostNewtonSteps = 100;
constexpr double kCurveEnd = 1e-12;  // products closer to the end of the curve, relative, are on it
// Of an energy, relative: some hundred operations. What is so close to an end of the range is there.
constexpr double kEnergyRoundOff = 2e-14;

/// The line of the curve on which p V is `product` [J]; within rounding of the last knot that below it.
VolumePiece find_piece(const Curve& curve, double ambient_pressure, double product) {
  const auto knots = curve.knots();
  const Curve::Knot& first = knots.front();
  VolumePiece piece{first.time, ambient_pressure + first.time, first.value, 0.0, 0.0, false};
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const double p = ambient_pressure + knots[i].time, grown = knots[i].value - piece.volume;
    piece.slope = i == 0 ? 0.0 : grown / (knots[i].time - knots[i - 1].time);
    const double rounding = i + 1 == knots.size() ? 1.0 + kCurveEnd : 1.0;
    if (product <= p * knots[i].value * rounding) return piece;
    piece = {knots[i].time, p, knots[i].value, 0.0, piece.work + 0.5 * grown * (piece.pressure + p), false};
  }
  piece.beyond = true;
  return piece;
}

}  // namespace

PressurePlace VolumePiece::place(double product) const {
  // (p + d)(v + slope d) = product, the root that does not cancel. Beyond its ends, too, p and V are
  // positive.
  const double b = volume + slope * pressure, c = product - pressure * volume;
  const double d = 2.0 * c / (b + std::sqrt(b * b + 4.0 * slope * c));
  return {slope == 0.0 ? product / volume : pressure + d,
          overpressure + d,
          volume + slope * d,
          slope,
          work + slope * d * (pressure + 0.5 * d),
          beyond};
}

PressurePlace PressureVolume::place(double product) const {
  return find_piece(curve_, ambient_, product).place(product);
}

double work_share(const PressurePlace& place) {
  const double taken = place.pressure * place.slope;
  return taken / (place.volume + taken);
}

double heat_capacity(const PressurePlace& place, double cv, double gas_constant_sum) {
  return cv + gas_constant_sum * work_share(place);
}

std::optional<double> PressureVolume::find_temperature(const Mixture& gas, double energy,
                                                       double guess) const noexcept {
  const double r = gas.gas_constant_sum;
  const double round_off = kEnergyRoundOff * (std::abs(energy) + r * guess);
  double t = guess;
  int small = 0, outside = 0;
  for (int i = 0; i < kMostNewtonSteps && outside < 2; ++i) {
    const PressurePlace at = place(r * t);
    const double capacity = heat_capacity(at, gas.cv(t), r);
    const double next = t - (gas.internal_energy(t) + at.work - energy) / capacity;
    if (!std::isfinite(next)) return {};
    const double kept = std::clamp(next, std::max(gas.minimum_temperature, 0.5 * t), gas.maximum_temperature);
    const bool inside = kept == 0.5 * t || std::abs(next - kept) * capacity <= round_off;
    outside = inside ? 0 : outside + 1;
    if (std::abs(kept - t) > kSmallStep * t)
      small = 0;
    else if (++small == kSmallSteps && inside)
      return kept;
    t = kept;
  }
  return {};
}

std::string beyond_text(const Curve& curve) {
  return "the overpressure passes " + to_text(curve.knots().back().time) +
         " Pa, where the curve of the volume ends";
}

}  // namespace gas
