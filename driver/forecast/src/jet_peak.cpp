// SPDX-License-Identifier: Apache-2.0
#include "forecast/jet_peak.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "engine/supply.hpp"
#include "forecast/forecast.hpp"
#include "forecast/jet_push.hpp"

namespace driver {
namespace {

void warn_of_outlet(const Scene& scene, const JetPart& part, std::vector<std::string>& warnings) {
  const JetPeak peak = jet_peak(scene, part);
  const double ambient = scene.ambient.pressure;
  if (!(peak.mass_flow > 0.0))
    warnings.push_back(fmt::format("jet of inflator {}: no flow up to the end", part.name));
  else if (peak.outlet.pressure < ambient)
    warnings.push_back(
        fmt::format("jet of inflator {}: the outlet pressure is below ambient even at the peak of the mass "
                    "flow, so a sonic outlet of that area cannot blow into the bag; use outlet = "
                    "\"pressure_matched\" with temperature = \"stagnation\"",
                    part.name));
  else if (const double share = below_sonic_share(scene, part);
           part.outlet.law == jet::OutletLaw::sonic && share >= kMatters)
    warnings.push_back(
        fmt::format("jet of inflator {}: outlet = \"sonic\" (the paper's form) lets the outlet pressure fall "
                    "below ambient at less than {:.3g} kg/s, for {:.2g} of the gas; use a smaller outlet, or "
                    "outlet = \"pressure_matched\" with temperature = \"stagnation\"",
                    part.name, peak.mass_flow * ambient / peak.outlet.pressure, share));
}

jet::OutletModel sonic(jet::OutletModel model) {
  model.law = jet::OutletLaw::sonic;
  return model;
}

void warn_of_restitution(const JetPart& part, std::vector<std::string>& warnings) {
  const auto [low, high] = restitution(part);
  // The first passes of a jet have less than 0, which only a curve can tell from the later ones.
  const double later = part.restitution ? part.restitution->value(1.0) : low;
  if (later < 0.0 || high > 1.0)
    warnings.push_back(fmt::format(
        "jet of inflator {}: restitution is {}: a plate in free air has 0, the paper 1; values below 0 or "
        "above 1 were computed for closed bags only (docs/theory/jet_push.md)",
        part.name, low < high ? fmt::format("{:.3g} to {:.3g}", low, high) : fmt::format("{:.3g}", low)));
}

// Distance [m] that the jet has to cover.
double way(const Scene& scene, const jet::JetModel& model) {
  const auto along = [&](const Eigen::Matrix3Xd& nodes) {
    return (model.axis.transpose() * (nodes.colwise() - model.centre)).maxCoeff();
  };
  return scene.bag ? std::max(along(scene.bag->mesh.nodes), along(scene.bag->initial_position))
                   : along(scene.target->nodes);
}

// Warns of a cone with the edges at which textbooks draw a jet: it carries up to 2.6 times the momentum of a
// plane jet (cases/jet_slot_plate.toml), and 4 times that of a round one.
void warn_of_cone(const Scene& scene, const JetPart& part, std::vector<std::string>& warnings) {
  constexpr double most = 3.0;
  constexpr int pieces = 100;
  const jet::JetModel& model = part.field.model();
  if (model.spread != jet::Spread::cone) return;
  const double length = way(scene, model);
  if (!(length > 0.0)) return;  // all of it lies upstream
  double largest = 0.0, where = 0.0;
  for (int i = 1; i <= pieces; ++i) {
    const double z = length * i / pieces, gain = cone_gain(model, z);
    if (gain > largest) std::tie(largest, where) = std::pair(gain, z);
  }
  if (largest > most)
    warnings.push_back(
        fmt::format("jet of inflator {}: spread = \"cone\" has {:.2g} times the outlet's momentum at {:.2g} "
                    "m from it, so its force is too large by this factor; use a smaller cone_half_angle, or "
                    "spread = \"momentum\", which conserves it",
                    part.name, largest, where));
}

void warn_of_rays(const Scene& scene, const JetPart& part, std::vector<std::string>& warnings) {
  jet::VisibilityQuery query(scene.bag->mesh.elements, scene.bag->model.node_count);
  // Each source of a slot tests all elements. The sources lie on one segment, so a few hundred are enough.
  constexpr int most = 256;
  const int count = scene.bag->model.element_count, stride = 1 + (count - 1) / most;
  std::vector<int> some;
  for (int e = 0; e < count; e += stride) some.push_back(e);
  const auto windings =
      query.winding_numbers(scene.bag->initial_position, jet::ray_source(part.field.model()), some);
  const auto other = std::count_if(windings.begin(), windings.end(), [](const auto& w) { return w != 1; });
  if (other > 0)
    warnings.push_back(
        fmt::format("jet of inflator {}: {} of {} tested rays start where the winding number is not 1",
                    part.name, other, windings.size()));
}

// Warns that an outlet stays in place while its jet drives a free bag away.
void warn_of_free_bag(const Scene& scene, std::vector<std::string>& warnings) {
  const membrane::BagDescription& bag = scene.bag->model.description;
  const bool held = !bag.fixed_nodes.empty() ||
                    std::ranges::any_of(bag.held_nodes, [](const auto& n) { return !n.empty(); });
  Eigen::Vector3d thrust = Eigen::Vector3d::Zero();
  for (const JetPart& part : scene.jets) thrust += part.share * part.field.model().axis;
  if (!held && thrust.norm() > 0.1)
    warnings.emplace_back(
        "nothing holds the bag against its jet: it may fly off the outlet, which does not move; hold it by "
        "membrane.fixed_panels");
}

}  // namespace

double cone_gain(const jet::JetModel& cone, double distance) {
  jet::JetModel momentum = cone;
  momentum.spread = jet::Spread::momentum;
  const double ratio = jet::section(cone, distance).width / jet::section(momentum, distance).width;
  return cone.shape == jet::OutletShape::round ? ratio * ratio : ratio;
}

JetPeak jet_peak(const Scene& scene, const JetPart& part) {
  const auto [time, point] = outlet_peak(scene, part);
  const jet::OutletInput input{point.mass_flow, point.temperature, point.cp, point.gas_constant,
                               pressure_around(scene)};
  return {time, point.mass_flow, jet::outlet_state(part.outlet, input),
          jet::outlet_state(sonic(part.outlet), input).pressure};
}

double below_sonic_share(const Scene& scene, const JetPart& part) {
  const auto& inflow = scene.gas->model.inflows[part.inflator];
  constexpr int pieces = 4000;
  const double end =
      std::min(duration(scene, inflow),
               inflow.mass_flow.is_constant() ? INFINITY : inflow.mass_flow.knots().back().time);
  const jet::OutletModel outlet_model = sonic(part.outlet);
  double all = 0.0, below = 0.0;
  for (int i = 0; i < pieces && end > 0.0; ++i) {
    auto point =
        gas::inflator_point(scene.gas->model, part.inflator, inflow.start_time + end * (i + 0.5) / pieces);
    point.mass_flow *= part.share;
    if (!(point.mass_flow > 0.0)) continue;
    const auto outlet = jet::outlet_state(outlet_model, {point.mass_flow, point.temperature, point.cp,
                                                         point.gas_constant, scene.ambient.pressure});
    all += point.mass_flow;
    if (outlet.pressure < scene.ambient.pressure) below += point.mass_flow;
  }
  return all > 0.0 ? below / all : 0.0;
}

void add_jet_warnings(Scene& scene) {
  std::vector<std::string>& warnings = scene.warnings;
  for (const JetPart& part : scene.jets) {
    warn_of_outlet(scene, part, warnings);
    warn_of_cone(scene, part, warnings);
    warn_of_restitution(part, warnings);
    if (scene.bag) warn_of_rays(scene, part, warnings);
  }
  if (scene.bag && !scene.jets.empty()) warn_of_free_bag(scene, warnings);
}

}  // namespace driver
