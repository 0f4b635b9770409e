// SPDX-License-Identifier: Apache-2.0
#include "mesh/mesh.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <elementary/trigonometric.hpp>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "checks.hpp"
#include "mesh_builder.hpp"
#include "mesh_text.hpp"
#include "node_sets.hpp"

namespace mesh {
namespace {

using Nodes = Eigen::Ref<const Eigen::Matrix3Xd>;
using Elements = Eigen::Ref<const Eigen::Matrix3Xi>;

std::array<Eigen::Vector3d, 3> corners(const Nodes& nodes, const Elements& elements, Eigen::Index e) {
  return {nodes.col(elements(0, e)), nodes.col(elements(1, e)), nodes.col(elements(2, e))};
}

struct ElementShape {
  double altitude;  // [m] smallest
  double angle;     // [rad] smallest
  double longest;   // [m] longest edge
  double area;      // [m2]
};

ElementShape element_shape(const std::array<Eigen::Vector3d, 3>& x) {
  const double twice_area = (x[1] - x[0]).cross(x[2] - x[0]).norm();
  const auto side = [&](std::size_t i) { return (x[(i + 2) % 3] - x[(i + 1) % 3]).norm(); };
  const std::array<double, 3> sides{side(0), side(1), side(2)};
  const double longest = std::ranges::max(sides);
  // The smallest angle is opposite the shortest side.
  const auto sharp = static_cast<std::size_t>(std::ranges::min_element(sides) - sides.begin());
  const double cosine = (x[(sharp + 1) % 3] - x[sharp]).dot(x[(sharp + 2) % 3] - x[sharp]);
  return {twice_area / longest, elementary::atan2(twice_area, cosine), longest, 0.5 * twice_area};
}

}  // namespace

void scale(Mesh& mesh, double factor) {
  mesh.nodes *= factor;
  if (mesh.start) *mesh.start *= factor;
}

Mesh renumbered(const Mesh& mesh, const std::vector<int>& order) {
  std::vector<int> place(order.size());
  Mesh result = mesh;
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
    result.nodes.col(static_cast<Eigen::Index>(i)) = mesh.nodes.col(order[i]);
    if (mesh.start) result.start->col(static_cast<Eigen::Index>(i)) = mesh.start->col(order[i]);
  }
  for (int& node : result.elements.reshaped()) node = place[static_cast<std::size_t>(node)];
  result.node_sets =
      renumbered_sets(mesh.node_sets, [&](int node) { return place[static_cast<std::size_t>(node)]; });
  return result;
}

int panel_index(const Mesh& mesh, std::string_view name) {
  const auto found = std::find(mesh.panel_names.begin(), mesh.panel_names.end(), name);
  if (found != mesh.panel_names.end()) return static_cast<int>(found - mesh.panel_names.begin());
  std::string message = "panel: \"" + std::string(name) + "\" does not exist; panels of this mesh:";
  for (const std::string& existing : mesh.panel_names) message += " \"" + existing + "\"";
  throw std::invalid_argument(message);
}

std::vector<int> panel_elements(const Mesh& mesh, std::string_view name) {
  const int index = panel_index(mesh, name);
  std::vector<int> result;
  for (std::size_t e = 0; e < mesh.panel.size(); ++e)
    if (mesh.panel[e] == index) result.push_back(static_cast<int>(e));
  return result;
}

Mesh only_panels(const Mesh& mesh, const std::vector<std::string>& names) {
  require_nodes("only_panels", mesh.elements, mesh.nodes.cols());
  require_panels("only_panels", mesh);
  for (const auto& name : names) panel_index(mesh, name);  // throws for an unknown one
  const auto panel_of = [&](int element) -> const std::string& {
    const auto panel = mesh.panel[static_cast<std::size_t>(element)];
    return mesh.panel_names[static_cast<std::size_t>(panel)];
  };
  std::vector<int> kept, number(static_cast<std::size_t>(mesh.node_count()), -1);
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (std::ranges::find(names, panel_of(e)) == names.end()) continue;
    kept.push_back(e);
    for (const int node : mesh.elements.col(e)) number[static_cast<std::size_t>(node)] = 0;
  }
  MeshBuilder builder;
  std::vector<int> nodes;
  for (std::size_t n = 0; n < number.size(); ++n) {
    if (number[n] < 0) continue;
    number[n] = builder.node_count();
    nodes.push_back(static_cast<int>(n));
    builder.add_node(mesh.nodes.col(nodes.back()));
  }
  for (const int e : kept) {
    std::vector<int> corners;
    for (const int node : mesh.elements.col(e)) corners.push_back(number[static_cast<std::size_t>(node)]);
    const int line = mesh.line.empty() ? 0 : mesh.line[static_cast<std::size_t>(e)];
    builder.add_polygon(corners, panel_of(e), static_cast<std::size_t>(line));
  }
  Mesh part = std::move(builder).finish();
  if (mesh.start) part.start = (*mesh.start)(Eigen::all, nodes);
  part.split_quads = mesh.split_quads;
  part.split_polygons = mesh.split_polygons;
  part.most_corners = mesh.most_corners;
  part.node_sets =
      renumbered_sets(mesh.node_sets, [&](int node) { return number[static_cast<std::size_t>(node)]; });
  part.other_elements = mesh.other_elements;
  part.skipped = mesh.skipped;
  part.neglected = mesh.neglected;
  part.included = mesh.included;
  return part;
}

std::vector<int> panel_nodes(const Mesh& mesh, std::string_view name) {
  require_nodes("panel_nodes", mesh.elements, mesh.nodes.cols());
  require_panels("panel_nodes", mesh);
  std::vector<int> result;
  for (const int e : panel_elements(mesh, name))
    for (int a = 0; a < 3; ++a) result.push_back(mesh.elements(a, e));
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

int nearest_node(const Mesh& mesh, const Eigen::Vector3d& point) {
  if (mesh.node_count() == 0) throw std::invalid_argument("mesh: has no nodes; nearest_node needs one");
  if (!point.allFinite()) throw std::invalid_argument("point: must be finite");
  Eigen::Index nearest = 0;
  (mesh.nodes.colwise() - point).colwise().squaredNorm().minCoeff(&nearest);
  return static_cast<int>(nearest);
}

Eigen::VectorXd element_areas(const Nodes& nodes, const Elements& elements) {
  require_nodes("element_areas", elements, nodes.cols());
  Eigen::VectorXd areas(elements.cols());
  for (Eigen::Index e = 0; e < elements.cols(); ++e) {
    const auto x = corners(nodes, elements, e);
    areas(e) = 0.5 * (x[1] - x[0]).cross(x[2] - x[0]).norm();
  }
  return areas;
}

Eigen::VectorXd panel_areas(const Mesh& mesh) {
  const Eigen::VectorXd areas = element_areas(mesh.nodes, mesh.elements);
  require_panels("panel_areas", mesh);
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.panel_names.size()));
  for (Eigen::Index e = 0; e < areas.size(); ++e) sums(mesh.panel[static_cast<std::size_t>(e)]) += areas(e);
  return sums;
}

double enclosed_volume(const Nodes& nodes, const Elements& elements) {
  if (elements.cols() == 0) return 0.0;
  require_nodes("enclosed_volume", elements, nodes.cols());
  const Eigen::Vector3d origin = nodes.col(0);
  double six_volumes = 0.0;
  for (Eigen::Index e = 0; e < elements.cols(); ++e) {
    const auto x = corners(nodes, elements, e);
    six_volumes += (x[0] - origin).dot((x[1] - origin).cross(x[2] - origin));
  }
  return six_volumes / 6.0;
}

ElementQuality element_quality(const Nodes& nodes, const Elements& elements) {
  if (elements.cols() == 0) throw std::invalid_argument("elements: none; element quality needs at least one");
  require_nodes("element_quality", elements, nodes.cols());
  const double infinity = std::numeric_limits<double>::infinity();
  ElementQuality quality{infinity, infinity, 0.0, 0.0, infinity, 0.0};
  for (Eigen::Index e = 0; e < elements.cols(); ++e) {
    const ElementShape shape = element_shape(corners(nodes, elements, e));
    if (!(shape.altitude > 0.0 && std::isfinite(shape.area)))
      throw std::invalid_argument("element " + std::to_string(e) + ": its area is zero or not finite");
    quality.min_angle = std::min(quality.min_angle, shape.angle);
    quality.min_altitude = std::min(quality.min_altitude, shape.altitude);
    quality.mean_altitude += shape.altitude / static_cast<double>(elements.cols());
    quality.max_aspect = std::max(quality.max_aspect, shape.longest / shape.altitude);
    quality.min_area = std::min(quality.min_area, shape.area);
    quality.max_area = std::max(quality.max_area, shape.area);
  }
  return quality;
}

Eigen::Matrix3Xd flatten(const Mesh& mesh, double factor) {
  if (!(factor > 0.0 && factor <= 1.0)) reject("flatten", "factor", factor, "above 0 and at most 1");
  Eigen::Matrix3Xd nodes = mesh.nodes;
  nodes.row(0) *= factor;
  return nodes;
}

}  // namespace mesh
