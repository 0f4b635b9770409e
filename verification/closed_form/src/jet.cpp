// SPDX-License-Identifier: Apache-2.0
#include "closed_form/jet.hpp"

#include <cmath>
#include <numbers>

#include "check.hpp"

namespace closed_form {
namespace {

using std::numbers::ln2;
using std::numbers::pi;
using std::numbers::sqrt2;

// Width growth 2 sqrt(2/pi) of the plane jet.
constexpr double plane_width = 2.0 * sqrt2 * std::numbers::inv_sqrtpi;

void check_outlet(double spread, double velocity, double density) {
  check::positive("spread", spread);
  check::positive("outlet_velocity", velocity);
  check::positive("outlet_density", density);
}

}  // namespace

double round_centreline_ratio(double spread, double distance_over_radius) {
  check::positive("spread", spread);
  check::non_negative("distance_over_radius", distance_over_radius);
  return std::fmin(1.0, 0.96 / (spread * distance_over_radius + 0.29));
}

double plane_centreline_ratio(double spread, double distance_over_half_width) {
  check::positive("spread", spread);
  check::non_negative("distance_over_half_width", distance_over_half_width);
  return std::fmin(1.0, 1.2 / std::sqrt(spread * distance_over_half_width + 0.41));
}

double round_core_length(double spread) {
  return (0.96 - 0.29) / check::positive("spread", spread);
}

double plane_core_length(double spread) {
  return (1.44 - 0.41) / check::positive("spread", spread);
}

JetSection round_jet_section(const RoundJet& jet, double distance) {
  check::positive("radius", jet.radius);
  check_outlet(jet.spread, jet.outlet_velocity, jet.outlet_density);
  const double ratio = round_centreline_ratio(jet.spread, distance / jet.radius);
  const double momentum =
      jet.outlet_density * jet.outlet_velocity * jet.outlet_velocity * pi * jet.radius * jet.radius;
  return {ratio * jet.outlet_velocity, sqrt2 * jet.radius / ratio, momentum, 2.0 / ratio, 2.0 / 3.0 * ratio};
}

JetSection plane_jet_section(const PlaneJet& jet, double distance) {
  check::positive("half_width", jet.half_width);
  check::positive("length", jet.length);
  check_outlet(jet.spread, jet.outlet_velocity, jet.outlet_density);
  const double ratio = plane_centreline_ratio(jet.spread, distance / jet.half_width);
  const double momentum =
      jet.outlet_density * jet.outlet_velocity * jet.outlet_velocity * 2.0 * jet.half_width * jet.length;
  return {ratio * jet.outlet_velocity, plane_width * jet.half_width / (ratio * ratio), momentum,
          sqrt2 / ratio, std::sqrt(2.0 / 3.0) * ratio};
}

double round_jet_velocity(const RoundJet& jet, double distance, double r) {
  const JetSection section = round_jet_section(jet, distance);
  const double s = check::finite("r", r) / section.width;
  return section.centreline_velocity * std::exp(-s * s);
}

double plane_jet_velocity(const PlaneJet& jet, double distance, double r) {
  const JetSection section = plane_jet_section(jet, distance);
  const double s = check::finite("r", r) / section.width;
  return section.centreline_velocity * std::exp(-s * s);
}

RoundFarField round_far_field(double spread) {
  check::positive("spread", spread);
  return {0.48 / spread, std::sqrt(2.0 * ln2) * spread / 0.96, 4.0 * spread / 0.96};
}

PlaneFarField plane_far_field(double spread) {
  check::positive("spread", spread);
  return {2.0 * spread / 1.44, plane_width * std::sqrt(ln2) * spread / 1.44};
}

OutletState sonic_outlet(const SonicOutlet& outlet) {
  check::gas(outlet.gas);
  check::positive("temperature", outlet.temperature);
  check::positive("mass_flow", outlet.mass_flow);
  check::positive("area", outlet.area);
  const auto [R, gamma] = outlet.gas;
  const double static_temperature =
      outlet.stagnation ? 2.0 * outlet.temperature / (gamma + 1.0) : outlet.temperature;
  OutletState state;
  state.velocity = std::sqrt(gamma * R * static_temperature);
  state.density = outlet.mass_flow / (outlet.area * state.velocity);
  state.momentum_flux = outlet.mass_flow * state.velocity;
  state.static_pressure = state.density * R * static_temperature;
  return state;
}

}  // namespace closed_form
