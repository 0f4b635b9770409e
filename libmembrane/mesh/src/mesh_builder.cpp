// SPDX-License-Identifier: Apache-2.0
#include "mesh_builder.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "mesh/fill.hpp"
#include "mesh/mesh_file.hpp"

namespace mesh {

void MeshBuilder::add_polygon(std::span<const int> corners, const std::string& panel, std::size_t line) {
  polygons_.push_back({corners_.size(), corners.size(), panel_index(panel), static_cast<int>(line)});
  corners_.insert(corners_.end(), corners.begin(), corners.end());
}

int MeshBuilder::panel_index(const std::string& panel) {
  const auto [entry, is_new] = panel_of_name_.try_emplace(panel, static_cast<int>(panel_names_.size()));
  if (is_new) panel_names_.push_back(panel);
  return entry->second;
}

/// One number for all nodes at one position, because both sides of a seam may have their own nodes.
std::vector<int> MeshBuilder::positions() const {
  std::vector<int> order(nodes_.size()), of(nodes_.size());
  std::iota(order.begin(), order.end(), 0);
  const auto at = [&](int node) {
    const Eigen::Vector3d& x = nodes_[static_cast<std::size_t>(node)];
    return std::tuple(x.x(), x.y(), x.z());
  };
  std::ranges::sort(order, {}, at);
  for (std::size_t i = 0; i < order.size(); ++i)
    of[static_cast<std::size_t>(order[i])] =
        i > 0 && at(order[i]) == at(order[i - 1]) ? of[static_cast<std::size_t>(order[i - 1])] : order[i];
  return of;
}

std::uint64_t MeshBuilder::key_of(int a, int b) const {
  a = position_[static_cast<std::size_t>(a)], b = position_[static_cast<std::size_t>(b)];
  const auto low = static_cast<std::uint64_t>(std::min(a, b)),
             high = static_cast<std::uint64_t>(std::max(a, b));
  return low << 32 | high;
}

/// Rotates the corners of a quad so that it is split from the first to the third.
void MeshBuilder::split_quad(const Polygon& polygon) {
  const std::span<int> c = corners_of(polygon);
  const auto distance = [&](int a, int b) {
    return (nodes_[static_cast<std::size_t>(a)] - nodes_[static_cast<std::size_t>(b)]).norm();
  };
  const auto add_diagonal = [&](bool second) {
    return sides_.insert(second ? key_of(c[1], c[3]) : key_of(c[0], c[2])).second;
  };
  bool second = distance(c[1], c[3]) < distance(c[0], c[2]);
  if (!add_diagonal(second) && add_diagonal(!second)) second = !second;
  if (second) std::rotate(c.begin(), c.begin() + 1, c.end());
}

std::string MeshBuilder::name_of(const Polygon& polygon) const {
  const std::string corners = " of " + std::to_string(polygon.size) + " corners ";
  if (polygon.line > 0) return "the polygon" + corners;
  return "polygon " + std::to_string(&polygon - polygons_.data()) + corners;
}

/// Fills a polygon of five corners or more.
void MeshBuilder::split_many(const Polygon& polygon, const std::string& file) {
  const std::span<int> c = corners_of(polygon);
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(c.size()));
  for (std::size_t i = 0; i < c.size(); ++i)
    points.col(static_cast<Eigen::Index>(i)) = nodes_[static_cast<std::size_t>(c[i])];
  const auto key = [&](int i, int j) {
    return key_of(c[static_cast<std::size_t>(i)], c[static_cast<std::size_t>(j)]);
  };
  Filling filling = fill(points, [&](int i, int j) { return sides_.contains(key(i, j)); });
  if (!filling.fault.empty()) {
    if (file.empty()) throw std::invalid_argument(name_of(polygon) + filling.fault);
    const auto line = static_cast<std::size_t>(polygon.line);
    throw MeshFileError(file, line, line > 0 ? 1 : 0, name_of(polygon) + filling.fault);
  }
  for (auto& triangle : filling.triangles) {
    for (std::size_t i = 0; i < 3; ++i) sides_.insert(key(triangle[i], triangle[(i + 1) % 3]));
    for (int& corner : triangle) corner = c[static_cast<std::size_t>(corner)];
  }
  parts_[polygon.begin] = std::move(filling.triangles);
}

void MeshBuilder::split_polygons(const std::string& file) {
  position_ = positions();
  for (const Polygon& polygon : polygons_) {
    const std::span<int> c = corners_of(polygon);
    for (std::size_t i = 0; i < c.size(); ++i) sides_.insert(key_of(c[i], c[(i + 1) % c.size()]));
  }
  for (const Polygon& polygon : polygons_) {
    if (polygon.size == 4) split_quad(polygon);
    if (polygon.size > 4) split_many(polygon, file);
  }
}

void MeshBuilder::add_elements(const Polygon& polygon, Mesh& mesh) {
  const auto add = [&](int a, int b, int c) {
    mesh.elements.col(static_cast<Eigen::Index>(mesh.panel.size())) << a, b, c;
    mesh.panel.push_back(polygon.panel);
    mesh.line.push_back(polygon.line);
  };
  if (polygon.size > 4) {
    for (const auto& [a, b, c] : parts_[polygon.begin]) add(a, b, c);
    return;
  }
  const std::span<int> c = corners_of(polygon);
  for (std::size_t i = 2; i < c.size(); ++i) add(c[0], c[i - 1], c[i]);
}

Mesh MeshBuilder::finish(const std::string& file) && {
  Mesh mesh;
  mesh.nodes.resize(3, static_cast<Eigen::Index>(nodes_.size()));
  for (std::size_t i = 0; i < nodes_.size(); ++i) mesh.nodes.col(static_cast<Eigen::Index>(i)) = nodes_[i];
  Eigen::Index elements = 0;
  for (const Polygon& polygon : polygons_) {
    elements += static_cast<Eigen::Index>(polygon.size) - 2;
    mesh.split_quads += polygon.size == 4 ? 1 : 0;
    mesh.split_polygons += polygon.size > 4 ? 1 : 0;
    mesh.most_corners = std::max(mesh.most_corners, static_cast<int>(polygon.size));
  }
  if (mesh.most_corners > 3) split_polygons(file);
  mesh.elements.resize(3, elements);
  for (const Polygon& polygon : polygons_) add_elements(polygon, mesh);
  if (!mesh.line.empty() && mesh.line.front() == 0) mesh.line.clear();  // the file has none
  mesh.panel_names = std::move(panel_names_);
  return mesh;
}

}  // namespace mesh
