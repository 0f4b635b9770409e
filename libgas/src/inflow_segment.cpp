// SPDX-License-Identifier: Apache-2.0
#include "inflow_segment.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "limits.hpp"

namespace gas {
namespace {

/// Time after tau at which the temperature, on its piece around tau, passes 1000 K; infinity if it does not.
double joint_crossing(const Curve& temperature, double tau, double piece_end) {
  const Curve::Piece piece = temperature.piece(tau);
  if (piece.slope == 0.0) return kInfinity;
  const double crossing = piece.origin + (kJointTemperature - piece.value) / piece.slope;
  const double clearance = 8.0 * kEpsilon * (std::abs(crossing) + std::abs(tau));
  return crossing > tau + clearance && crossing < piece_end ? crossing : kInfinity;
}

/// Round-off of t - start.
double round_off(double start, double t) {
  return 2.0 * kEpsilon * std::max(std::abs(t), std::abs(start));
}

}  // namespace

double local_time(std::initializer_list<const Curve*> curves, double start, double t) {
  const double tau = t - start, rounding = round_off(start, t);
  if (!std::isfinite(tau)) return tau;
  if (std::abs(tau) <= rounding) return 0.0;
  for (const Curve* curve : curves)
    if (const double knot = curve->nearest_knot(tau); std::abs(tau - knot) <= rounding) return knot;
  return tau;
}

double local_time(const Inflow& inflow, double start, double t) {
  return local_time({&inflow.mass_flow, &inflow.temperature}, start, t);
}

double next_break(const Inflow& inflow, double start, bool constant_cp, double t) {
  const double tau = local_time(inflow, start, t);
  if (!(tau > -kInfinity)) return kInfinity;
  if (tau < 0.0) return std::max(start, std::nextafter(t, kInfinity));
  if (inflow.mass_flow.outside() == Outside::zero && tau >= inflow.mass_flow.knots().back().time)
    return kInfinity;
  const double knot = std::min(inflow.mass_flow.next_knot(tau), inflow.temperature.next_knot(tau));
  const double joint = constant_cp ? kInfinity : joint_crossing(inflow.temperature, tau, knot);
  return std::max(start + std::min(knot, joint), std::nextafter(t, kInfinity));
}

InflowSegment::InflowSegment(const Inflow& inflow, double start, const Mixture& gas, double a, double b)
    : gas_(&gas) {
  const double begin = local_time(inflow, start, a), end = local_time(inflow, start, b);
  if (!(begin >= 0.0)) return;
  // Because a and b are rounded, time since firing passes at a slightly different rate. This keeps the
  // delivery that the knots state.
  const double pace = (end - begin) / (b - a), middle = begin + 0.5 * (end - begin);
  const Curve::Piece flow = inflow.mass_flow.piece(middle), heat = inflow.temperature.piece(middle);
  mass_flow_ = pace * flow.at(begin);
  mass_flow_slope_ = pace * pace * flow.slope;
  temperature_ = heat.at(begin);
  temperature_slope_ = pace * heat.slope;
  enthalpy_ = gas.enthalpy(temperature_);
}

InflowSegment::Delivered InflowSegment::rate(double t) const {
  const auto [mass_flow, temperature] = flow(t);
  return {mass_flow, mass_flow * (temperature_slope_ == 0.0 ? enthalpy_ : gas_->enthalpy(temperature))};
}

InflowSegment::Delivered InflowSegment::rate_slope(double t) const {
  const auto [mass_flow, temperature] = flow(t);
  return {mass_flow_slope_, mass_flow_slope_ * gas_->enthalpy(temperature) +
                                mass_flow * temperature_slope_ * gas_->cp(temperature)};
}

InflowSegment::Delivered InflowSegment::delivered(double t0, double t1) const {
  if (is_idle()) return {0.0, 0.0};
  const double length = t1 - t0;
  const auto [mass_flow, temperature] = flow(0.5 * (t0 + t1));
  const double mass = length * mass_flow;
  if (temperature_slope_ == 0.0) return {mass, mass * enthalpy_};
  if (!gas_->constant_cp) return {mass, enthalpy_by_quadrature(t0, t1)};
  const double correlation = mass_flow_slope_ * temperature_slope_ * length * length / 12.0;
  return {mass, gas_->cp(temperature) * length * (mass_flow * temperature + correlation)};
}

double InflowSegment::enthalpy_by_quadrature(double from, double to) const {
  // Gauss-Legendre, 4 points, exact to degree 7. Abramowitz & Stegun, table 25.4.
  constexpr std::array<double, 2> kNodes{0.339981043584856264803, 0.861136311594052575224};
  constexpr std::array<double, 2> kWeights{0.652145154862546142627, 0.347854845137453857373};
  double sum = 0.0;
  for (std::size_t i = 0; i < kNodes.size(); ++i) {
    for (const double node : {-kNodes[i], kNodes[i]}) {
      const auto [mass_flow, temperature] = flow(0.5 * (from + to + (to - from) * node));
      sum += kWeights[i] * mass_flow * gas_->enthalpy(temperature);
    }
  }
  return 0.5 * (to - from) * sum;
}

}  // namespace gas
