// SPDX-License-Identifier: Apache-2.0
#include "closed_form/jet.hpp"

#include <gsl/gsl_sf_bessel.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "check.hpp"
#include "quadrature.hpp"

namespace closed_form {
namespace {

using std::numbers::ln2;
using std::numbers::pi;
using std::numbers::sqrt2;

// Width growth 2 sqrt(2/pi) of the plane jet.
constexpr double plane_width = 2.0 * sqrt2 * std::numbers::inv_sqrtpi;

void check_outlet(double spread, double velocity, double density) {
  check::positive("spread", spread, "outlet_velocity", velocity, "outlet_density", density);
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
  check::positive("half_width", jet.half_width, "length", jet.length);
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
  check::positive("temperature", outlet.temperature, "mass_flow", outlet.mass_flow, "area", outlet.area);
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

NotionalNozzle expanded_outlet(const ExpandedOutlet& outlet) {
  check::gas(outlet.gas);
  check::positive("stagnation_temperature", outlet.stagnation_temperature, "area", outlet.area,
                  "bag_pressure", outlet.bag_pressure);
  const double n = outlet.pressure_ratio;
  if (!(n >= 1.0 && std::isfinite(n))) check::refuse("pressure_ratio", n, "must be finite and >= 1");
  const auto [R, gamma] = outlet.gas;
  const double throat = 2.0 / (gamma + 1.0);                                   // T0/T_s
  const double faster = 1.0 + (1.0 - 1.0 / n) / gamma;                         // V/V0
  const double cooled = 1.0 - 0.5 * (gamma - 1.0) * throat * faster * faster;  // T/T_s
  const double sonic = std::sqrt(gamma * R * throat * outlet.stagnation_temperature);
  NotionalNozzle nozzle;
  nozzle.mass_flow = gamma * n * outlet.bag_pressure * outlet.area / sonic;
  nozzle.velocity = faster * sonic;
  nozzle.temperature = cooled * outlet.stagnation_temperature;
  nozzle.density = outlet.bag_pressure / (R * nozzle.temperature);
  nozzle.area_ratio = n * cooled / (throat * faster);
  nozzle.thrust = outlet.bag_pressure * outlet.area * (n * (1.0 + gamma) - 1.0);
  return nozzle;
}

double plate_load(const ExpandedOutlet& outlet, double restitution) {
  if (!(restitution >= -1.0 && std::isfinite(restitution)))
    check::refuse("restitution", restitution, "must be finite and >= -1");
  const double turned_back = outlet.gas.heat_capacity_ratio * outlet.pressure_ratio * outlet.bag_pressure *
                             outlet.area;  // mdot V0 = gamma pe A
  return expanded_outlet(outlet).thrust + restitution * turned_back;
}

double plate_force(double reflection, double momentum_flux) {
  check::within("reflection", reflection, 1.0, 2.0);
  return reflection * check::non_negative("momentum_flux", momentum_flux);
}

double inclined_plate_fraction(double theta) {
  if (!(std::abs(theta) < 0.5 * pi)) check::refuse("theta", theta, "must lie in (-pi/2, pi/2)");
  return std::cos(theta);
}

double inclined_plate_fraction(double theta, double width_slope, double extent) {
  const double cosine = inclined_plate_fraction(theta);
  check::non_negative("width_slope", width_slope);
  check::positive("extent", extent);
  const double s = width_slope * std::tan(theta);
  if (std::abs(s) * extent >= 1.0)
    check::refuse("width_slope", width_slope, "width_slope |tan theta| extent must be < 1");
  const auto integrand = [s](double w) { return std::exp(-2.0 * w * w) / (1.0 - s * w); };
  const double reach = std::min(extent, 20.0);  // beyond it the integrand is 0 in double precision
  const int panels = 8 + static_cast<int>(4.0 * reach);
  return cosine * std::sqrt(2.0 / pi) * quadrature::integrate(integrand, -reach, reach, panels);
}

double disc_fraction(double disc_radius, double width) {
  const double ratio = check::non_negative("disc_radius", disc_radius) / check::positive("width", width);
  return -std::expm1(-2.0 * ratio * ratio);
}

double square_fraction(double half_side, double width) {
  const double root =
      std::erf(sqrt2 * check::non_negative("half_side", half_side) / check::positive("width", width));
  return root * root;
}

double half_plane_fraction(double edge_distance, double width) {
  const double x = check::finite("edge_distance", edge_distance) / check::positive("width", width);
  // The tail takes each error of the argument some hundred times: no factor that is rounded already.
  return 0.5 * std::erfc(std::copysign(std::hypot(x, x), -x));
}

double off_axis_disc_fraction(double disc_radius, double offset, double width) {
  check::positive("disc_radius", disc_radius);
  check::non_negative("offset", offset);
  check::positive("width", width);
  // 1 - Q1 is int_0^rho (r/sigma^2) exp(-(r^2 + d^2)/(2 sigma^2)) I0(r d/sigma^2) dr, sigma = R/2.
  const double d = 2.0 * offset / width;
  const double end = std::fmin(2.0 * disc_radius / width, d + 9.0);  // the tail beyond is below 1e-17
  const double start = std::fmax(0.0, std::fmin(d, end) - 9.0);
  const auto density = [d](double r) {
    return r * std::exp(-0.5 * (r - d) * (r - d)) * gsl_sf_bessel_I0_scaled(r * d);
  };
  return quadrature::integrate(density, start, end, 24);
}

double lattice_quadrature_error(double spacing_over_width) {
  const double h = check::above_upto("spacing_over_width", spacing_over_width, 0.0, 10.0);
  // One direction: 1 + e = 1 + 2 sum (-1)^k exp(-k^2 pi^2 R^2/(2 h^2)) (Poisson summation).
  const double exponent = 0.5 * pi * pi / (h * h);
  double e = 0.0;
  for (int k = 200; k > 0; --k) e += (k % 2 == 0 ? 2.0 : -2.0) * std::exp(-exponent * k * k);
  return e * (2.0 + e);
}

}  // namespace closed_form
