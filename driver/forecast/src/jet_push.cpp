// SPDX-License-Identifier: Apache-2.0
#include "forecast/jet_push.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/supply.hpp"
#include "forecast/jet_peak.hpp"
#include "mesh/mesh.hpp"

namespace driver {
namespace {

// Below this share of its size, or of the cube of that, a bag is flat as sewn.
constexpr double flat = 1e-3;

Range extent(const Eigen::Matrix3Xd& nodes, const Eigen::Vector3d& direction) {
  const Eigen::RowVectorXd along = direction.transpose() * nodes;
  return {along.minCoeff(), along.maxCoeff()};
}

// Of a closed surface, seen along the direction.
double projected_area(const mesh::Mesh& mesh, const Eigen::Vector3d& direction) {
  double twice = 0.0;
  for (Eigen::Index e = 0; e < mesh.elements.cols(); ++e) {
    const Eigen::Vector3d a = mesh.nodes.col(mesh.elements(0, e)), b = mesh.nodes.col(mesh.elements(1, e)),
                          c = mesh.nodes.col(mesh.elements(2, e));
    twice += 0.5 * std::abs((b - a).cross(c - a).dot(direction));
  }
  return 0.5 * twice;
}

}  // namespace

Range restitution(const JetPart& part) {
  Range range{part.field.model().restitution, part.field.model().restitution};
  if (part.restitution)
    for (const auto& knot : part.restitution->knots()) {
      range.low = std::min(range.low, knot.value);
      range.high = std::max(range.high, knot.value);
    }
  return range;
}

JetPush jet_push(const Scene& scene, const JetPart& part) {
  const JetPeak peak = jet_peak(scene, part);
  const gas::InflatorPoint gas = outlet_peak(scene, part).point;
  const double around = pressure_around(scene), area = part.outlet.area;
  const bool at_rest = part.outlet.temperature == jet::OutletTemperature::stagnation;
  JetPush push;
  push.rest_temperature = gas.temperature * (at_rest ? 1.0 : 0.5 * (gas.gamma + 1.0));
  const jet::OutletModel expanded{jet::OutletLaw::expanded, jet::OutletTemperature::stagnation, area};
  push.thrust = jet::momentum_flux(
      jet::outlet_state(expanded, {peak.mass_flow, push.rest_temperature, gas.cp, gas.gas_constant, around}),
      area);
  push.momentum = peak.mass_flow * peak.outlet.velocity * peak.outlet.reflected;
  push.pressure_ratio = peak.sonic_pressure / around;
  const Range e = restitution(part);
  push.load = jet::momentum_flux(peak.outlet, area) + e.low * push.momentum;
  push.most_load = push.load + (e.high - e.low) * push.momentum;
  return push;
}

std::optional<RestitutionRange> restitution_range(const Scene& scene, const jet::JetModel& model) {
  if (!scene.bag) return std::nullopt;
  const Eigen::Matrix3Xd& nodes = scene.bag->mesh.nodes;
  const Range along = extent(nodes, model.axis);
  const double width = 2.0 * std::sqrt(projected_area(scene.bag->mesh, model.axis) / std::numbers::pi);
  const double depth = along.high - model.axis.dot(model.centre);
  if (!(width > 0.0 && depth > 0.0 && along.high - along.low > flat * width)) return std::nullopt;
  RestitutionRange range;
  range.depth_over_width = depth / width;
  range.deep = range.depth_over_width > 1.0;
  range.low = range.deep ? -0.2 : -0.25;  // the first passes of the jet
  range.high = range.deep ? 0.45 : 1.0;
  return range;
}

MissingEnergy missing_energy(const Scene& scene, const JetPart& part) {
  const auto& inflow = scene.gas->model.inflows[part.inflator];
  const gas::InflatorPoint peak = outlet_peak(scene, part).point;
  const double heat =
      part.share * gas::product_integral(inflow.mass_flow, inflow.temperature, 0.0, duration(scene, inflow));
  MissingEnergy missing;
  missing.energy = 0.5 * peak.gamma * peak.gas_constant * heat;  // V0^2 = gamma R T
  if (!scene.bag) return missing;
  const Eigen::Matrix3Xd& nodes = scene.bag->mesh.nodes;
  const double volume = mesh::enclosed_volume(nodes, scene.bag->mesh.elements);
  const double size = (nodes.rowwise().maxCoeff() - nodes.rowwise().minCoeff()).maxCoeff();
  if (volume > flat * size * size * size) missing.pressure = (peak.gamma - 1.0) * missing.energy / volume;
  return missing;
}

}  // namespace driver
