// SPDX-License-Identifier: Apache-2.0
#include "forecast/jet_push.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/supply.hpp"
#include "forecast/jet_peak.hpp"
#include "mesh/mesh.hpp"

namespace driver {
namespace {

double sewn_volume(const Scene& scene) {
  return mesh::enclosed_volume(scene.bag->mesh.nodes, scene.bag->mesh.elements);
}

}  // namespace

JetPush jet_push(const Scene& scene, const JetPart& part) {
  const JetPeak peak = jet_peak(scene, part);
  const double ambient = scene.ambient.pressure, area = part.outlet.area;
  JetPush push;
  push.momentum = peak.mass_flow * peak.outlet.velocity * peak.outlet.reflected;
  push.pressure_ratio = peak.sonic_pressure / ambient;
  push.thrust = push.momentum + std::max(0.0, peak.sonic_pressure - ambient) * area;
  push.load = jet::momentum_flux(peak.outlet, area) + part.field.model().restitution * push.momentum;
  return push;
}

RestitutionRange restitution_range(const Scene& scene, const jet::JetModel& model) {
  const double depth = (model.axis.transpose() * (scene.bag->mesh.nodes.colwise() - model.centre)).maxCoeff();
  const double width = 2.0 * std::sqrt(sewn_volume(scene) / (std::numbers::pi * depth));
  RestitutionRange range;
  range.depth_over_width = depth / width;
  range.deep = range.depth_over_width > 1.0;
  range.low = -0.2;  // the first passes of the jet
  range.high = range.deep ? 0.45 : 1.0;
  return range;
}

MissingEnergy missing_energy(const Scene& scene, const JetPart& part) {
  const auto& inflow = scene.gas->model.inflows[part.inflator];
  const gas::InflatorPoint peak = inflator_peak(scene, part.inflator).point;
  const double heat =
      gas::product_integral(inflow.mass_flow, inflow.temperature, 0.0, duration(scene, inflow));
  MissingEnergy missing;
  missing.energy = 0.5 * peak.gamma * peak.gas_constant * heat;  // V0^2 = gamma R T
  missing.pressure = (peak.gamma - 1.0) * missing.energy / sewn_volume(scene);
  missing.temperature = 0.5 * (peak.gamma + 1.0) * peak.temperature;
  return missing;
}

}  // namespace driver
