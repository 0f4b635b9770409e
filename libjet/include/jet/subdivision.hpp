// SPDX-License-Identifier: Apache-2.0
// A surface with every element cut into n^2 equal triangles, its pieces. The jet's field and visibility are
// computed on the pieces and averaged over each element (J.8).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "jet/field.hpp"
#include "jet/views.hpp"

namespace jet {

/// Connectivity of the pieces. Element e has the pieces e n^2 ... (e + 1) n^2 - 1, with its own winding.
/// Neighbours share the nodes on their common edge, so the pieces of a closed surface form a closed surface.
/// Const after construction.
class Subdivision {
 public:
  /// A node of the pieces, as a weighted mean of nodes of the mesh.
  struct Node {
    std::array<int, 3> parent;     // nodes of the mesh
    std::array<double, 3> weight;  // [-] sum 1
  };

  /// `triangles` is 3 x M with node indices from 0. Throws std::invalid_argument for an empty mesh, an index
  /// outside [0, node_count), n outside 1 to 64, and more than 2^31 - 1 pieces.
  Subdivision(const Triangles& triangles, int node_count, int n);

  int pieces() const { return pieces_; }                              // pieces of one element, n^2
  int node_count() const { return static_cast<int>(nodes_.size()); }  // nodes of the pieces
  const Eigen::Matrix3Xi& triangles() const { return triangles_; }    // 3 x M n^2

  /// Pieces of the listed elements, in their order.
  std::vector<int> pieces_of(std::span<const int> elements) const;

  /// Interpolates values at the mesh's nodes linearly to the nodes of the pieces, 3 x node_count(). The
  /// mesh's own nodes come first and keep their bits. `result` already has that shape. Throws
  /// std::invalid_argument for a wrong shape.
  void interpolate(const Points& values, Eigen::Matrix3Xd& result) const;

  /// Area vectors of the pieces [m2], 3 x K n^2: the area vectors, 3 x K, of all or some elements divided by
  /// n^2. Throws as interpolate.
  void share_areas(const Points& area_vectors, Eigen::Matrix3Xd& result) const;

  /// Field of all or some elements from the field of their pieces. The overpressure is averaged; an element
  /// is a candidate if one of its pieces is. The restitution is that of the pieces. Throws
  /// std::invalid_argument unless there are n^2 pieces for each element.
  void average(const FieldState& pieces, FieldState& elements) const;

 private:
  int pieces_;
  std::vector<Node> nodes_;
  Eigen::Matrix3Xi triangles_;
};

/// Means of nodal values over the corners of each triangle, ((a + b) + c) / 3. `result` is 3 x M. Throws
/// std::invalid_argument for another shape, and for a corner without a value.
void corner_means(const Points& values, const Triangles& triangles, Eigen::Matrix3Xd& result);

}  // namespace jet
