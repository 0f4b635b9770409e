// SPDX-License-Identifier: Apache-2.0
#include "forecast/jet_push.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

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
  const double ambient = scene.ambient.pressure, area = part.outlet.area;
  const Range e = restitution(part);
  JetPush push;
  push.momentum = peak.mass_flow * peak.outlet.velocity * peak.outlet.reflected;
  push.pressure_ratio = peak.sonic_pressure / ambient;
  push.thrust = push.momentum + std::max(0.0, peak.sonic_pressure - ambient) * area;
  push.load = jet::momentum_flux(peak.outlet, area) + e.low * push.momentum;
  push.most_load = push.load + (e.high - e.low) * push.momentum;
  return push;
}

std::optional<RestitutionRange> restitution_range(const Scene& scene, const jet::JetModel& model) {
  if (!scene.bag) return std::nullopt;
  const Eigen::Matrix3Xd& nodes = scene.bag->mesh.nodes;
  const Eigen::Vector3d across = model.axis.unitOrthogonal(), other = model.axis.cross(across);
  const Range along = extent(nodes, model.axis), a = extent(nodes, across), b = extent(nodes, other);
  const double width = std::sqrt((a.high - a.low) * (b.high - b.low));
  const double depth = along.high - model.axis.dot(model.centre);
  if (!(width > 0.0 && depth > 0.0 && along.high - along.low > flat * width)) return std::nullopt;
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
  const Eigen::Matrix3Xd& nodes = scene.bag->mesh.nodes;
  const double volume = mesh::enclosed_volume(nodes, scene.bag->mesh.elements);
  const double size = (nodes.rowwise().maxCoeff() - nodes.rowwise().minCoeff()).maxCoeff();
  MissingEnergy missing;
  missing.energy = 0.5 * peak.gamma * peak.gas_constant * heat;  // V0^2 = gamma R T
  if (volume > flat * size * size * size) missing.pressure = (peak.gamma - 1.0) * missing.energy / volume;
  missing.temperature = 0.5 * (peak.gamma + 1.0) * peak.temperature;
  return missing;
}

}  // namespace driver
