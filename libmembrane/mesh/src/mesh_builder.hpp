// SPDX-License-Identifier: Apache-2.0
// Private to the mesh files: a mesh under construction.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "mesh/mesh.hpp"

namespace mesh {

/// Collects nodes, polygons and panels in the order of a file.
class MeshBuilder {
 public:
  int node_count() const { return static_cast<int>(nodes_.size()); }
  bool empty() const { return polygons_.empty(); }
  void add_node(const Eigen::Vector3d& position) { nodes_.push_back(position); }
  /// Adds a polygon of 3 or more corners, node numbers from 0. A node may occur twice: drop_collapsed() of
  /// merge.hpp removes elements without area. `line` is its line in the file, 0 if there are no lines.
  void add_polygon(std::span<const int> corners, const std::string& panel, std::size_t line);
  /// Splits each quad along its shorter diagonal (the first if equal) or, if that is already a side, as
  /// across the corner of two sheets, along the other one; and polygons of more corners by fill(). Throws
  /// MeshFileError for one that cannot be filled, std::invalid_argument if there is no `file`.
  Mesh finish(const std::string& file = {}) &&;

 private:
  struct Polygon {
    std::size_t begin, size;  // in corners_
    int panel, line;
  };
  std::span<int> corners_of(const Polygon& polygon) { return {&corners_[polygon.begin], polygon.size}; }
  int panel_index(const std::string& panel);
  std::vector<int> positions() const;
  std::uint64_t key_of(int a, int b) const;
  void split_polygons(const std::string& file);
  void split_quad(const Polygon& polygon);
  void split_many(const Polygon& polygon, const std::string& file);
  std::string name_of(const Polygon& polygon) const;
  void add_elements(const Polygon& polygon, Mesh& mesh);

  std::vector<Eigen::Vector3d> nodes_;
  std::vector<Polygon> polygons_;
  std::vector<int> corners_;  // of all polygons
  std::vector<std::string> panel_names_;
  std::unordered_map<std::string, int> panel_of_name_;
  std::vector<int> position_;                // one number for all nodes at one position
  std::unordered_set<std::uint64_t> sides_;  // of polygons and of their parts, by positions
  std::unordered_map<std::size_t, std::vector<std::array<int, 3>>> parts_;  // of polygons, by their `begin`
};

}  // namespace mesh
