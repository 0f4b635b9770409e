// SPDX-License-Identifier: Apache-2.0
#include "uniform_gas.hpp"

#include <algorithm>
#include <cmath>

#include "limits.hpp"
#include "require.hpp"

namespace gas {
namespace {

// After a Newton step below this share of T two more follow: one may pass a knot, the next is quadratic.
constexpr double kSmallStep = 1e-8;
constexpr int kSmallSteps = 3;
constexpr int kMostNewtonSteps = 100;
constexpr double kCurveEnd = 1e-12;  // relative: products this close to the end of the curve are on it

/// The line of the curve on which p V is `product` [J], from its lower knot; the last line within rounding of
/// the last knot. Below the first knot the volume is rigid.
PressureVolume find_line(const Curve& curve, double ambient_pressure, double product) {
  const auto knots = curve.knots();
  const Curve::Knot& first = knots.front();
  PressureVolume line{ambient_pressure + first.time, first.time, first.value, 0.0, 0.0, false};
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const double p = ambient_pressure + knots[i].time, grown = knots[i].value - line.volume;
    line.volume_slope = i == 0 ? 0.0 : grown / (knots[i].time - knots[i - 1].time);
    const double rounding = i + 1 == knots.size() ? 1.0 + kCurveEnd : 1.0;
    if (product <= p * knots[i].value * rounding) return line;
    line = {p, knots[i].time, knots[i].value, 0.0, line.work + 0.5 * grown * (line.pressure + p), false};
  }
  line.beyond = true;
  return line;
}

/// The point at which p V of the gas is `product` [J].
PressureVolume place(const ControlVolumeModel& model, double product, double volume) {
  const double ambient = model.ambient.pressure;
  if (const auto& curve = model.volume_of_overpressure)
    return find_line(*curve, ambient, product).at(product);
  const double pressure = product / volume;
  return {pressure, pressure - ambient, volume, 0.0, 0.0, false};
}

/// Newton's method in a volume that follows p. The heat capacity lies between cv and cp, so each step removes
/// most of the error.
std::optional<double> find_temperature(const ControlVolumeModel& model, const Mixture& gas, double energy,
                                       double guess) noexcept {
  if (!model.volume_of_overpressure) return gas.find_temperature(energy, guess);
  const double r = gas.gas_constant_sum;
  const double round_off = kEnergyRoundOff * (std::abs(energy) + r * guess);
  double t = guess;
  int small = 0, outside = 0;
  for (int i = 0; i < kMostNewtonSteps && outside < 2; ++i) {
    const PressureVolume at = place(model, r * t, 0.0);
    const double capacity = gas.cv(t) + r * at.work_share();
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

}  // namespace

PressureVolume PressureVolume::at(double product) const {
  // Solves (p + d)(V + V' d) = product for d, without cancellation. p and V are positive beyond the line's
  // ends, too.
  const double b = volume + volume_slope * pressure, c = product - pressure * volume;
  const double d = 2.0 * c / (b + std::sqrt(b * b + 4.0 * volume_slope * c));
  return {volume_slope == 0.0 ? product / volume : pressure + d,
          overpressure + d,
          volume + volume_slope * d,
          volume_slope,
          work + volume_slope * d * (pressure + 0.5 * d),
          beyond};
}

bool locate(const ControlVolumeModel& model, const Mixture& mixture, double energy, double volume,
            UniformGas& gas) {
  if (mixture.mass == 0.0) {
    gas = {place(model, 0.0, volume), 0.0, gas.temperature};
    return true;
  }
  const auto temperature = find_temperature(model, mixture, energy, gas.temperature);
  if (!temperature) return false;
  const double t = *temperature, r = mixture.gas_constant_sum, cp = mixture.cp(t);
  const PressureVolume at = place(model, r * t, volume);
  gas = {at,  // all at once: reading back single members is slow
         mixture.mass,
         t,
         r / mixture.mass,
         cp / mixture.mass,
         cp / (cp - r),
         (energy - at.work + r * t) / mixture.mass,
         cp - r + r * at.work_share()};
  return true;
}

double work_at(const ControlVolumeModel& model, const Mixture& mixture, double temperature) {
  return place(model, mixture.gas_constant_sum * temperature, 1.0).work;
}

double stored_work(const ControlVolumeModel& model, const ControlVolumeState& state) {
  if (!model.volume_of_overpressure) return 0.0;
  const Mixture mixture = model.thermo.mixture(state.masses);
  if (mixture.mass == 0.0) return 0.0;
  return work_at(model, mixture, mixture.temperature(state.internal_energy, state.temperature));
}

std::string beyond_text(const ControlVolumeModel& model) {
  return "the overpressure passes " + to_text(model.volume_of_overpressure->knots().back().time) +
         " Pa, the end of the volume's curve";
}

std::string range_text(const ControlVolumeModel& model) {
  return "the gas leaves its temperature range, " + to_text(model.thermo.minimum_temperature()) + " to " +
         to_text(model.thermo.maximum_temperature()) + " K, ";
}

}  // namespace gas
