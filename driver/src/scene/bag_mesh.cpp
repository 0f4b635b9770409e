// SPDX-License-Identifier: Apache-2.0
#include "scene/bag_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "driver/case_reader.hpp"
#include "membrane/node_order.hpp"
#include "membrane/refine.hpp"

namespace driver {

const OptionNames<membrane::PassengerBagOptions>& option_names(const membrane::PassengerBagOptions&) {
  using Options = membrane::PassengerBagOptions;
  static const OptionNames<Options> names{{{"depth", &Options::depth},
                                           {"width", &Options::width},
                                           {"height", &Options::height},
                                           {"back_radius", &Options::back_radius},
                                           {"front_radius", &Options::front_radius}},
                                          {{"depth_cells", &Options::depth_cells},
                                           {"width_cells", &Options::width_cells},
                                           {"height_cells", &Options::height_cells},
                                           {"attachment_width_cells", &Options::attachment_width_cells},
                                           {"attachment_height_cells", &Options::attachment_height_cells},
                                           {"vent_depth_cell", &Options::vent_depth_cell},
                                           {"vent_height_cell", &Options::vent_height_cell}}};
  return names;
}

const OptionNames<membrane::DriverBagOptions>& option_names(const membrane::DriverBagOptions&) {
  using Options = membrane::DriverBagOptions;
  static const OptionNames<Options> names{{{"radius", &Options::radius},
                                           {"inflator_radius", &Options::inflator_radius},
                                           {"opening", &Options::opening}},
                                          {{"rings", &Options::rings},
                                           {"inflator_rings", &Options::inflator_rings},
                                           {"vents", &Options::vents},
                                           {"vent_ring", &Options::vent_ring}}};
  return names;
}

BagMesh generate(const membrane::PassengerBagOptions& options) {
  auto bag = membrane::passenger_bag(options);
  return {std::move(bag.mesh), std::nullopt, {bag.strap_anchors.begin(), bag.strap_anchors.end()}};
}

BagMesh generate(const membrane::DriverBagOptions& options) {
  auto bag = membrane::driver_bag(options);
  return {std::move(bag.mesh), std::move(bag.opened), {bag.tether_anchors.begin(), bag.tether_anchors.end()}};
}

std::vector<std::string> vent_panels(const membrane::Mesh& mesh) {
  std::vector<std::string> names;
  for (const std::string& name : mesh.panel_names)
    if (name.starts_with("vent")) names.push_back(name);
  return names;
}

std::vector<std::string> panels_of_node(const membrane::Mesh& mesh, int node) {
  std::set<int> panels;
  for (int e = 0; e < mesh.element_count(); ++e)
    if ((mesh.elements.col(e).array() == node).any()) panels.insert(mesh.panel[static_cast<std::size_t>(e)]);
  std::vector<std::string> names;
  for (const int panel : panels) names.push_back(mesh.panel_names[static_cast<std::size_t>(panel)]);
  return names;
}

std::optional<double> unlikely_extent(const membrane::Mesh& mesh) {
  const double extent = (mesh.nodes.rowwise().maxCoeff() - mesh.nodes.rowwise().minCoeff()).maxCoeff();
  if (extent >= smallest_bag && extent <= largest_bag) return {};
  return extent;
}

std::string place_of_element(const membrane::Mesh& mesh, const std::filesystem::path& file, int element) {
  if (mesh.line.empty()) return file.string();
  return fmt::format("{}:{}:1", file.string(), mesh.line[static_cast<std::size_t>(element)]);
}

void require_areas(const membrane::Mesh& mesh, const std::filesystem::path& file) {
  for (Eigen::Index e = 0; e < mesh.elements.cols(); ++e) {
    const Eigen::Vector3d a = mesh.nodes.col(mesh.elements(0, e));
    if (membrane::has_area(mesh.nodes.col(mesh.elements(1, e)) - a, mesh.nodes.col(mesh.elements(2, e)) - a))
      continue;
    throw CaseError(
        fmt::format("{}: mesh: {} has no area that a number holds, corners off one line are allowed",
                    place_of_element(mesh, file, static_cast<int>(e)),
                    mesh.line.empty() ? fmt::format("element {}", e) : "the element"));
  }
}

void check_refinement(int elements, int times) {
  const double fine = elements * std::pow(4.0, times);
  if (fine > membrane::kMostElements)
    throw std::invalid_argument(
        fmt::format("refine = {} makes up to {:.0f} elements of {}, at most {} are allowed", times, fine,
                    elements, membrane::kMostElements));
}

void refine(BagMesh& bag, int times, const std::vector<std::string>& null_panels) {
  check_refinement(bag.mesh.element_count(), times);
  for (int i = 0; i < times; ++i) {
    if (bag.initial) {
      membrane::Mesh shape = bag.mesh;
      shape.nodes = *bag.initial;
      bag.initial = membrane::refine(shape, null_panels).nodes;
    }
    bag.mesh = membrane::refine(bag.mesh, null_panels);
  }
}

void order_nodes(BagMesh& bag) {
  if (bag.mesh.element_count() <= membrane::kCachedElements) return;
  const auto order = membrane::node_order(bag.mesh);
  for (auto& anchors : bag.strap_anchors)
    for (int& node : anchors)
      node = static_cast<int>(std::find(order.begin(), order.end(), node) - order.begin());
  if (bag.initial) {
    const Eigen::Matrix3Xd initial = *bag.initial;
    *bag.initial = initial(Eigen::all, order);
  }
  bag.mesh = membrane::renumbered(bag.mesh, order);
}

void set_initial(BagMesh& bag, const membrane::Mesh& shape) {
  if (shape.nodes.cols() != bag.mesh.nodes.cols() || shape.elements.cols() != bag.mesh.elements.cols() ||
      shape.elements != bag.mesh.elements)
    throw std::invalid_argument(
        "the initial shape needs the nodes and elements of the design shape in the same order");
  constexpr double most = 100.0;  // a folded skin keeps its area, nearly
  const double design = membrane::element_areas(bag.mesh.nodes, bag.mesh.elements).sum(),
               initial = membrane::element_areas(shape.nodes, shape.elements).sum();
  if (!std::isfinite(initial)) throw std::invalid_argument("the initial shape has no finite area");
  if (!(initial * most >= design && initial <= design * most))
    throw std::invalid_argument(fmt::format(
        "the initial shape has {:.3g} m2 of skin, the design shape {:.3g} m2: length_unit is that "
        "of both files; gasjet mesh state writes metres",
        initial, design));
  bag.initial = shape.nodes;
}

}  // namespace driver
