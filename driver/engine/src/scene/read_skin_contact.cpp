// SPDX-License-Identifier: Apache-2.0
// [membrane.self_contact] -> SkinContactModel.
#include "scene/read_skin_contact.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/number_text.hpp"
#include "scene/contact_bounds.hpp"
#include "scene/read_fabric.hpp"

namespace driver {
namespace {

// Share of the fabric's own omega^2 that the contact adds where both sides touch, by default. Nodes of an
// undamped skin meet at 50 m/s and more; with half of it the energy of a folded bag drifts by 1e-3.
constexpr double default_skin_share = 20.0;

// Null panels close the volume; there is no fabric that could touch.
Eigen::Matrix3Xi fabric_elements(const BagPart& bag) {
  Eigen::Matrix3Xi elements(3, bag.mesh.elements.cols());
  Eigen::Index count = 0;
  for (Eigen::Index e = 0; e < elements.cols(); ++e)
    if (!bag.model.description.properties[static_cast<std::size_t>(e)].null_panel)
      elements.col(count++) = bag.mesh.elements.col(e);
  return elements.leftCols(count);
}

double smallest_altitude(const Eigen::Matrix3Xd& nodes, const Eigen::Vector3i& triangle) {
  const Eigen::Vector3d a = nodes.col(triangle[0]), b = nodes.col(triangle[1]), c = nodes.col(triangle[2]);
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  return (b - a).cross(c - a).norm() / longest;
}

std::string element_text(const mesh::Mesh& mesh, const Eigen::Vector3i& triangle) {
  for (Eigen::Index e = 0; e < mesh.elements.cols(); ++e)
    if (mesh.elements.col(e) == triangle)
      return mesh.line.empty()
                 ? fmt::format("element {} (from 0)", e)
                 : fmt::format("the element of line {}", mesh.line[static_cast<std::size_t>(e)]);
  return {};
}

// An element that is thinner than the layers would be pushed apart by itself.
void require_larger_elements(const TableReader& table, double thickness, const BagPart& bag,
                             const Eigen::Matrix3Xi& elements) {
  const auto& reference = bag.model.description.reference;
  Eigen::Index smallest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index e = 0; e < elements.cols(); ++e)
    if (const double altitude = smallest_altitude(reference, elements.col(e)); altitude < least) {
      least = altitude;
      smallest = e;
    }
  if (thickness <= least) return;
  table.fail("thickness", fmt::format("is {:.3g} m, allowed: up to {:.3g} m, the smallest altitude of {}; "
                                      "lower it, or use larger elements there",
                                      thickness, three_digits_below(least),
                                      element_text(bag.mesh, elements.col(smallest))));
}

// Friction stiffens, too (K.46), so that the share of both is the one that is given.
double stiffness_of(TableReader& table, double friction, Scene& scene) {
  if (table.has("stiffness") && table.has("stiffness_share"))
    table.fail("stiffness_share",
               "stands beside stiffness, allowed: one of them; leave out stiffness to follow the fabric, or "
               "stiffness_share to keep the pressure per metre");
  if (const auto stiffness = table.at("stiffness").optional_number(positive.in("N/m³"))) return *stiffness;
  scene.skin_contact_share = table.at("stiffness_share").number(contact_share, default_skin_share);
  const membrane::BagModel& model = scene.bag->model;
  return coupling::default_skin_stiffness(*scene.skin_contact_share / std::sqrt(1.0 + friction * friction),
                                          model.fabric_frequency, lightest_fabric(model.description));
}

}  // namespace

void read_skin_contact(TableReader& membrane, Scene& scene) {
  auto table = membrane.optional_table("self_contact");
  if (!table) return;
  const BagPart& bag = *scene.bag;
  const Eigen::Matrix3Xi elements = fabric_elements(bag);
  const double thickness = table->at("thickness").number(positive.in("m"));
  require_larger_elements(*table, thickness, bag, elements);
  const double friction = table->at("friction").number(contact_friction, 0.0);
  table->located("", [&] {
    const double stiffness = stiffness_of(*table, friction, scene);
    scene.skin_contact.emplace(elements, bag.model.description.reference, bag.model.node_mass,
                               coupling::SkinContactParameters{thickness, stiffness, friction});
  });
  table->finish();
}

}  // namespace driver
