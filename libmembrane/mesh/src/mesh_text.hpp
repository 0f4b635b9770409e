// SPDX-License-Identifier: Apache-2.0
// Private to the mesh files: reading and writing of text and numbers, and a mesh under construction.
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "mesh/mesh.hpp"

namespace mesh {

/// The text in quotes, shortened and printable, for messages.
std::string shown(std::string_view text);

/// Reads a finite number; a leading + is allowed. Returns its fault; empty if there is none.
std::string number_fault(std::string_view text, double& value);

/// Appends the shortest text that reads back to the same bits.
void append_number(double value, std::string& text);

std::string read_text(const std::filesystem::path& path);                     // throws MeshFileError
void write_text(const std::filesystem::path& path, const std::string& text);  // throws MeshFileError

/// A panel's name from a file: blanks and # become _; "default" if there is none.
std::string panel_name(std::string_view text);

/// Throws std::invalid_argument unless all nodes are finite.
void require_finite_nodes(const Mesh& mesh);

/// Collects nodes, polygons and panels in the order of a file.
class MeshBuilder {
 public:
  int node_count() const { return static_cast<int>(nodes_.size()); }
  bool empty() const { return polygons_.empty(); }
  void add_node(const Eigen::Vector3d& position) { nodes_.push_back(position); }
  /// Adds a polygon of 3 or 4 corners, node numbers from 0. A node may occur twice: drop_collapsed() of
  /// merge.hpp removes elements without area.
  void add_polygon(std::span<const int> corners, const std::string& panel, std::size_t line);
  /// Splits each quad along its shorter diagonal (the first if equal) or, if that is already a side, as
  /// across the corner of two sheets, along the other one.
  Mesh finish() &&;

 private:
  struct Polygon {
    std::array<int, 4> corners;  // the last one is -1 for a triangle
    int panel, line;
    std::size_t size() const { return corners[3] < 0 ? 3 : 4; }
  };
  int panel_index(const std::string& panel);
  std::vector<int> positions() const;
  void split_quads();

  std::vector<Eigen::Vector3d> nodes_;
  std::vector<Polygon> polygons_;
  std::vector<std::string> panel_names_;
  std::unordered_map<std::string, int> panel_of_name_;
};

}  // namespace mesh
