// SPDX-License-Identifier: Apache-2.0
#include "engine/bag_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "base/case_reader.hpp"
#include "membrane/bag_model.hpp"
#include "membrane/node_order.hpp"
#include "mesh/merge.hpp"
#include "mesh/refine.hpp"

namespace driver {

const OptionNames<mesh::PassengerBagOptions>& option_names(const mesh::PassengerBagOptions&) {
  using Options = mesh::PassengerBagOptions;
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

const OptionNames<mesh::DriverBagOptions>& option_names(const mesh::DriverBagOptions&) {
  using Options = mesh::DriverBagOptions;
  static const OptionNames<Options> names{{{"radius", &Options::radius},
                                           {"inflator_radius", &Options::inflator_radius},
                                           {"opening", &Options::opening}},
                                          {{"rings", &Options::rings},
                                           {"inflator_rings", &Options::inflator_rings},
                                           {"vents", &Options::vents},
                                           {"vent_ring", &Options::vent_ring}}};
  return names;
}

BagMesh generate(const mesh::PassengerBagOptions& options) {
  auto bag = mesh::passenger_bag(options);
  return {std::move(bag.mesh), std::nullopt, {bag.strap_anchors.begin(), bag.strap_anchors.end()}};
}

BagMesh generate(const mesh::DriverBagOptions& options) {
  auto bag = mesh::driver_bag(options);
  return {std::move(bag.mesh), std::move(bag.opened), {bag.tether_anchors.begin(), bag.tether_anchors.end()}};
}

std::vector<std::string> vent_panels(const mesh::Mesh& mesh) {
  std::vector<std::string> names;
  for (const std::string& name : mesh.panel_names)
    if (name.starts_with("vent")) names.push_back(name);
  return names;
}

std::vector<std::string> panels_of_node(const mesh::Mesh& mesh, int node) {
  std::set<int> panels;
  for (int e = 0; e < mesh.element_count(); ++e)
    if ((mesh.elements.col(e).array() == node).any()) panels.insert(mesh.panel[static_cast<std::size_t>(e)]);
  std::vector<std::string> names;
  for (const int panel : panels) names.push_back(mesh.panel_names[static_cast<std::size_t>(panel)]);
  return names;
}

std::optional<double> unlikely_extent(const mesh::Mesh& mesh) {
  const double extent = (mesh.nodes.rowwise().maxCoeff() - mesh.nodes.rowwise().minCoeff()).maxCoeff();
  if (extent >= smallest_bag && extent <= largest_bag) return {};
  return extent;
}

std::string place_of_element(const mesh::Mesh& mesh, const std::filesystem::path& file, int element) {
  if (mesh.line.empty()) return file.string();
  return fmt::format("{}:{}:1", file.string(), mesh.line[static_cast<std::size_t>(element)]);
}

void drop_collapsed(BagMesh& bag, const std::filesystem::path& file) {
  const int before = bag.mesh.node_count();
  mesh::Mesh numbered = bag.mesh;
  Eigen::Matrix3Xd number = Eigen::Matrix3Xd::Zero(3, before);
  number.row(0).setLinSpaced(before, 0.0, before - 1.0);
  bag.collapsed = mesh::drop_collapsed(bag.mesh, bag.initial ? &*bag.initial : nullptr);
  if (bag.mesh.node_count() < before) {
    mesh::drop_collapsed(numbered, &number);
    bag.node_of_file.assign(static_cast<std::size_t>(before), -1);
    for (int i = 0; i < number.cols(); ++i)
      bag.node_of_file[static_cast<std::size_t>(std::lround(number(0, i)))] = i;
  }
  if (bag.mesh.element_count() == 0)
    throw CaseError(fmt::format("{}: mesh: no element has an area: {}", file.string(), collapsed_text(bag)));
}

std::string collapsed_text(const BagMesh& bag) {
  if (bag.collapsed == 0) return "";
  return fmt::format("{} left out, two corners of which coincide",
                     bag.collapsed == 1 ? "1 element" : fmt::format("{} elements", bag.collapsed));
}

namespace {

std::string coordinates(const Eigen::Vector3d& x) {
  return fmt::format("({:.3g}, {:.3g}, {:.3g})", x.x(), x.y(), x.z());
}

// Why an element has no area: its corners lie on one line, or its lengths are beyond what a number can
// square.
std::string without_area(const Eigen::Matrix3d& corners, const Eigen::Vector3i& nodes) {
  const Eigen::Vector3d ab = corners.col(1) - corners.col(0), ac = corners.col(2) - corners.col(0);
  const double longest = std::max(ab.stableNorm(), ac.stableNorm());
  if (!std::isfinite(longest) || membrane::has_area(ab / longest, ac / longest))
    return fmt::format("has an area out of the range of numbers, with sides of {:.3g} m", longest);
  return fmt::format(
      "has no area: its nodes {}, {} and {} at {}, {} and {} m lie on one line; move one of them, or join "
      "those that nearly meet by gasjet mesh convert --merge DISTANCE",
      nodes[0], nodes[1], nodes[2], coordinates(corners.col(0)), coordinates(corners.col(1)),
      coordinates(corners.col(2)));
}

}  // namespace

void require_areas(const mesh::Mesh& mesh, const std::filesystem::path& file) {
  const bool was_read = !mesh.line.empty();  // such nodes count from 1
  for (int e = 0; e < mesh.element_count(); ++e) {
    const Eigen::Vector3i nodes = mesh.elements.col(e);
    const Eigen::Matrix3d x = mesh.nodes(Eigen::all, nodes);
    if (membrane::has_area(x.col(1) - x.col(0), x.col(2) - x.col(0))) continue;
    throw CaseError(fmt::format("{}: mesh: {} {}", place_of_element(mesh, file, e),
                                was_read ? "the element" : fmt::format("element {}", e),
                                without_area(x, (nodes.array() + (was_read ? 1 : 0)).matrix())));
  }
}

void check_refinement(int elements, int times) {
  const double fine = elements * std::ldexp(1.0, 2 * times);
  if (fine > mesh::kMostElements)
    throw std::invalid_argument(
        fmt::format("refine = {} makes up to {:.0f} elements of {}, allowed: at most {}", times, fine,
                    elements, mesh::kMostElements));
}

void refine(BagMesh& bag, int times, const std::vector<std::string>& null_panels) {
  check_refinement(bag.mesh.element_count(), times);
  for (int i = 0; i < times; ++i) {
    if (bag.initial) {
      mesh::Mesh shape = bag.mesh;
      shape.nodes = *bag.initial;
      bag.initial = mesh::refine(shape, null_panels).nodes;
    }
    bag.mesh = mesh::refine(bag.mesh, null_panels);
  }
}

void order_nodes(BagMesh& bag) {
  if (bag.mesh.element_count() <= membrane::kCachedElements) return;
  const auto order = membrane::node_order(bag.mesh.elements, bag.mesh.node_count());
  for (auto& anchors : bag.strap_anchors)
    for (int& node : anchors)
      node = static_cast<int>(std::find(order.begin(), order.end(), node) - order.begin());
  if (bag.initial) {
    const Eigen::Matrix3Xd initial = *bag.initial;
    *bag.initial = initial(Eigen::all, order);
  }
  bag.mesh = mesh::renumbered(bag.mesh, order);
  std::vector<int> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
  if (bag.node_of_file.empty())
    bag.node_of_file = place;
  else
    for (int& node : bag.node_of_file)
      if (node >= 0) node = place[static_cast<std::size_t>(node)];
}

namespace {

/// Sides of `count` elements, each as it is run; those that two have, once each way, are left out.
std::set<std::pair<int, int>> run_sides(const Eigen::Matrix3Xi& elements, Eigen::Index first,
                                        Eigen::Index count) {
  std::set<std::pair<int, int>> sides;
  for (Eigen::Index e = first; e < first + count; ++e)
    for (Eigen::Index i = 0; i < 3; ++i) {
      const int a = elements(i, e), b = elements((i + 1) % 3, e);
      if (sides.erase({b, a}) == 0) sides.emplace(a, b);
    }
  return sides;
}

/// Number of elements from `first` on that are one polygon of a file, cut in two ways; 0 if there is none. A
/// polygon is as many elements, one after the other, as it has corners, less two.
Eigen::Index same_polygon(const mesh::Mesh& a, const mesh::Mesh& b, Eigen::Index first) {
  const Eigen::Index most =
      std::min<Eigen::Index>(std::max(a.most_corners, b.most_corners) - 2, a.elements.cols() - first);
  for (Eigen::Index count = 2; count <= most; ++count)
    if (run_sides(a.elements, first, count) == run_sides(b.elements, first, count)) return count;
  return 0;
}

/// The first element that both meshes do not have.
std::optional<Eigen::Index> first_other(const mesh::Mesh& a, const mesh::Mesh& b) {
  for (Eigen::Index e = 0; e < a.elements.cols(); ++e) {
    if (a.elements.col(e) == b.elements.col(e)) continue;
    const Eigen::Index same = same_polygon(a, b, e);
    if (same == 0) return e;
    e += same - 1;
  }
  return {};
}

}  // namespace

void require_same_elements(const mesh::Mesh& design, const mesh::Mesh& shape) {
  constexpr const char* needed =
      "the initial shape needs the nodes and elements of the design shape in the same order: ";
  if (shape.node_count() != design.node_count() || shape.element_count() != design.element_count())
    throw std::invalid_argument(fmt::format("{}it has {} nodes and {} elements, the design shape {} and {}",
                                            needed, shape.node_count(), shape.element_count(),
                                            design.node_count(), design.element_count()));
  const auto other = first_other(design, shape);
  if (!other) return;
  const Eigen::Vector3i a = shape.elements.col(*other).array() + 1,
                        b = design.elements.col(*other).array() + 1;
  throw std::invalid_argument(
      fmt::format("{}element {} has the nodes {}, {}, {}, in the design shape {}, {}, {}", needed, *other + 1,
                  a[0], a[1], a[2], b[0], b[1], b[2]));
}

void set_initial(BagMesh& bag, const Eigen::Matrix3Xd& nodes) {
  constexpr double most = 100.0;  // a folded skin keeps its area, nearly
  const double design = mesh::element_areas(bag.mesh.nodes, bag.mesh.elements).sum(),
               initial = mesh::element_areas(nodes, bag.mesh.elements).sum();
  if (!std::isfinite(initial)) throw std::invalid_argument("the initial shape has no finite area");
  if (!(initial * most >= design && initial <= design * most))
    throw std::invalid_argument(
        fmt::format("the initial shape has {:.3g} m2 of skin, the design shape {:.3g} m2: length_unit is for "
                    "both files; gasjet mesh state writes metres",
                    initial, design));
  bag.initial = nodes;
}

}  // namespace driver
