// SPDX-License-Identifier: Apache-2.0
#include "engine/supply.hpp"

#include <algorithm>

namespace driver {
namespace {

// Piecewise linear flows: the largest sum stands at a corner of one of them, on either side of a jump.
double peak_flow(const Scene& scene) {
  double peak = 0.0;
  for (const auto& inflow : scene.gas->model.inflows)
    for (const auto& [time, side] : corners(scene, inflow))
      peak = std::max(peak, total_mass_flow(scene, time, side));
  return peak;
}

}  // namespace

double total_mass_flow(const Scene& scene, double time, gas::Side side) {
  double sum = 0.0;
  for (std::size_t i = 0; i < scene.gas->model.inflows.size(); ++i)
    sum += gas::inflator_point(scene.gas->model, i, time, side).mass_flow;
  return sum;
}

double duration(const Scene& scene, const gas::Inflow& inflow) {
  return std::max(0.0, scene.time.end - inflow.start_time);
}

std::vector<Corner> corners(const Scene& scene, const gas::Inflow& inflow) {
  const double length = duration(scene, inflow);
  if (!(length > 0.0)) return {};
  std::vector<Corner> corners;
  for (const auto& knot : inflow.mass_flow.knots()) {
    if (!(knot.time >= 0.0 && knot.time < length)) continue;
    const double time = inflow.start_time + knot.time;
    if (knot.time > 0.0) corners.push_back({time, gas::Side::before});
    corners.push_back({time, gas::Side::after});
  }
  corners.push_back({scene.time.end, gas::Side::before});
  return corners;
}

InflatorPeak inflator_peak(const Scene& scene, std::size_t inflator) {
  const gas::ControlVolumeModel& model = scene.gas->model;
  const gas::Inflow& inflow = model.inflows[inflator];
  InflatorPeak peak{inflow.start_time, gas::inflator_point(model, inflator, inflow.start_time)};
  if (duration(scene, inflow) <= 0.0) peak.point.mass_flow = 0.0;
  for (const auto& [time, side] : corners(scene, inflow)) {
    const auto other = gas::inflator_point(model, inflator, time, side);
    if (other.mass_flow > peak.point.mass_flow) peak = {time, other};
  }
  return peak;
}

InflatorPeak outlet_peak(const Scene& scene, const JetPart& part) {
  InflatorPeak peak = inflator_peak(scene, part.inflator);
  peak.point.mass_flow *= part.share;
  return peak;
}

double pressure_around(const Scene& scene) {
  return scene.ambient.pressure > 0.0 ? scene.ambient.pressure : scene.gas->initial_pressure;
}

Supply supply_of(const Scene& scene) {
  const auto& model = scene.gas->model;
  Supply s{0.0, peak_flow(scene), 0.0, std::vector<double>(model.thermo.size(), 0.0), 0.0};
  double mass_by_temperature = 0.0;
  for (const auto& inflow : model.inflows) {
    const double end = duration(scene, inflow), mass = inflow.mass_flow.integral(0.0, end);
    if (!(mass > 0.0)) continue;
    const double heat = gas::product_integral(inflow.mass_flow, inflow.temperature, 0.0, end);
    s.mass += mass;
    mass_by_temperature += heat;
    s.work += model.thermo.gamma(inflow.mass_fractions, heat / mass) *
              model.thermo.gas_constant(inflow.mass_fractions) * heat;
    for (std::size_t k = 0; k < s.mass_fractions.size(); ++k)
      s.mass_fractions[k] += mass * inflow.mass_fractions[k];
  }
  for (double& y : s.mass_fractions) y = s.mass > 0.0 ? y / s.mass : 0.0;
  if (s.mass > 0.0) s.temperature = mass_by_temperature / s.mass;
  return s;
}

}  // namespace driver
