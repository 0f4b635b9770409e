// SPDX-License-Identifier: Apache-2.0
// Parts that run, and are likely to miss what they are there for.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <elementary/hypot.hpp>

#include "engine/bag_mesh.hpp"
#include "scene/plausibility.hpp"

namespace driver {
namespace {

// A ball that holds the skin, as long as it stretches by no more than half and stays where it is.
struct Reach {
  Eigen::Vector3d middle;
  double radius;  // [m]
};

Reach reach_of(const BagPart& bag) {
  const Eigen::Matrix3Xd &design = bag.mesh.nodes, &start = bag.initial_position;
  const Eigen::Vector3d middle = start.rowwise().mean();
  constexpr double stretch = 1.5;
  return {middle, stretch * std::max((design.colwise() - middle).colwise().norm().maxCoeff(),
                                     (start.colwise() - middle).colwise().norm().maxCoeff())};
}

// The impactor's path is a circle about the pivot.
void warn_of_path(const coupling::PendulumParameters& p, const BagPart& bag, Scene& scene) {
  const Reach reach = reach_of(bag);
  const Eigen::Vector3d arm = reach.middle - p.pivot;
  const double along = arm.dot(p.axis.normalized()),
               across = std::sqrt(std::max(0.0, arm.squaredNorm() - along * along));
  const double apart = elementary::hypot(along, across - p.impactor_distance);
  if (apart > reach.radius + p.impactor_radius)
    scene.warnings.push_back(
        fmt::format("{}.pivot = [{:g}, {:g}, {:g}] m and impactor_distance = {:g} m keep the impactor "
                    "at least {:.3g} m from the bag's middle: it cannot touch the bag",
                    scene.pendulum->path, p.pivot.x(), p.pivot.y(), p.pivot.z(), p.impactor_distance, apart));
}

void warn_of_upside_down(const coupling::PendulumParameters& p, Scene& scene) {
  constexpr double clearly = -0.5;
  if (scene.gravity.dot(p.rest_direction.normalized()) < clearly * scene.gravity.norm())
    scene.warnings.push_back(
        fmt::format("scene.gravity = [{:g}, {:g}, {:g}] m/s2 points from the impactor to the pivot, so the "
                    "pendulum is upside down: check its sign and that of {}.rest_direction",
                    scene.gravity.x(), scene.gravity.y(), scene.gravity.z(), scene.pendulum->path));
}

void warn_of_far_plates(const BagPart& bag, Scene& scene) {
  for (const membrane::Plate& plate : bag.model.description.plates) {
    const double gap =
        (plate.normal.normalized().transpose() * (bag.initial_position.colwise() - plate.point)).minCoeff();
    if (gap > largest_bag)
      scene.warnings.push_back(
          fmt::format("membrane.plate is {:.4g} m from the bag, usual are up to {:g} m: check its unit", gap,
                      largest_bag));
  }
}

void warn_of_far_target(const TargetPart& target, Scene& scene) {
  for (const JetPart& part : scene.jets) {
    const double gap = (target.nodes.colwise() - part.field.model().centre).colwise().norm().minCoeff();
    if (gap > largest_bag)
      scene.warnings.push_back(
          fmt::format("target is {:.4g} m from the outlet of {}, usual are up to {:g} m: check its unit", gap,
                      part.path, largest_bag));
  }
}

// A panel with an element that nothing holds is no plane of symmetry, and no part of a module.
bool hangs_free(const BagPart& bag, const std::vector<int>& elements) {
  const membrane::BagDescription& description = bag.model.description;
  std::vector<bool> held(static_cast<std::size_t>(bag.mesh.nodes.cols()), false);
  const auto hold = [&](const std::vector<int>& nodes) {
    for (const int node : nodes) held[static_cast<std::size_t>(node)] = true;
  };
  hold(description.fixed_nodes);
  for (const auto& nodes : description.held_nodes) hold(nodes);
  return std::ranges::any_of(elements, [&](int e) {
    const auto corners = bag.mesh.elements.col(e);
    return std::none_of(corners.begin(), corners.end(),
                        [&](int node) { return held[static_cast<std::size_t>(node)]; });
  });
}

void warn_of_closed_holes(const BagPart& bag, Scene& scene) {
  if (!scene.gas || !scene.gas->model.vents.empty()) return;
  const Eigen::VectorXd areas = mesh::panel_areas(bag.mesh);
  for (std::size_t i = 0; i < bag.mesh.panel_names.size(); ++i) {
    const std::vector<int> elements = mesh::panel_elements(bag.mesh, bag.mesh.panel_names[i]);
    const bool is_null = !elements.empty() && std::ranges::binary_search(bag.null_elements, elements.front());
    if (is_null && hangs_free(bag, elements))
      scene.warnings.push_back(
          fmt::format("membrane.null_panels: nothing flows through the hole \"{}\" of {:.3g} m2, and the "
                      "case has no [[vent]]: to let gas out, add one with this area",
                      bag.mesh.panel_names[i], areas(static_cast<Eigen::Index>(i))));
  }
}

// One row for the end alone is asked for with end_time itself.
void warn_of_few_rows(Scene& scene) {
  constexpr double fewest = 4.0;
  const double every = scene.output.history_every, end = scene.time.end;
  if (every * fewest > end && every != end)
    scene.warnings.push_back(
        fmt::format("output.history_every is {:.4g} s, the scene ends at {:.4g} s, so the history has {} "
                    "rows: check its unit",
                    every, end, 2 + static_cast<int>(std::ceil(end / every)) - 1));
}

}  // namespace

void warn_of_idle_parts(Scene& scene) {
  if (scene.pendulum) {
    const coupling::PendulumParameters& parameters = scene.pendulum->model.parameters();
    warn_of_upside_down(parameters, scene);
    if (scene.bag) warn_of_path(parameters, *scene.bag, scene);
  }
  if (scene.bag) {
    warn_of_far_plates(*scene.bag, scene);
    warn_of_closed_holes(*scene.bag, scene);
  }
  if (scene.target) warn_of_far_target(*scene.target, scene);
  warn_of_few_rows(scene);
}

}  // namespace driver
