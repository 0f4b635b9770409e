// SPDX-License-Identifier: Apache-2.0
// A surface with every element cut into n^2 equal triangles: the jet's field and its hidden-element test are
// asked on the pieces, and what they carry is averaged back (J.8).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "jet/field.hpp"
#include "jet/views.hpp"

namespace jet {

/// Connectivity of the pieces: those of element e are e n^2 ... (e + 1) n^2 - 1, wound as e. Nodes on an edge
/// are shared by the elements that share it, so the pieces of a closed surface close. Const after
/// construction.
class Subdivision {
 public:
  /// A node of the pieces between nodes of the mesh.
  struct Node {
    std::array<int, 3> parent;     // nodes of the mesh
    std::array<double, 3> weight;  // [-] their sum is 1
  };

  /// `triangles` 3 x M with node indices from 0. Throws std::invalid_argument for an empty mesh, an index
  /// outside [0, node_count), n outside 1 to 64, and more than 2^31 - 1 pieces.
  Subdivision(const Triangles& triangles, int node_count, int n);

  int pieces() const { return pieces_; }                              // of one element, n^2
  int node_count() const { return static_cast<int>(nodes_.size()); }  // of the pieces
  const Eigen::Matrix3Xi& triangles() const { return triangles_; }    // 3 x M n^2

  /// Pieces of the elements listed, in their order.
  std::vector<int> pieces_of(std::span<const int> elements) const;

  /// Values at the nodes of the pieces, 3 x node_count(), from those at the mesh's nodes by linear
  /// interpolation. The mesh's own nodes come first and keep their bits. Throws std::invalid_argument on a
  /// wrong shape.
  void interpolate(const Points& values, Eigen::Matrix3Xd& result) const;

  /// Area vectors of the pieces [m2], those of their elements over n^2. Shapes as above.
  void share_areas(const Points& area_vectors, Eigen::Matrix3Xd& result) const;

  /// Field of the elements from that of the pieces: overpressure averaged, a candidate is an element with a
  /// piece that is one. Throws std::invalid_argument if `elements` has another number of elements.
  void average(const FieldState& pieces, FieldState& elements) const;

 private:
  int pieces_;
  std::vector<Node> nodes_;
  Eigen::Matrix3Xi triangles_;
};

/// Means of nodal values over the corners of each triangle, ((a + b) + c) / 3; `result` 3 x M.
void corner_means(const Points& values, const Triangles& triangles, Eigen::Matrix3Xd& result);

}  // namespace jet
