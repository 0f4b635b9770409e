// SPDX-License-Identifier: Apache-2.0
// A surface in the frame of a jet: nodes as floats, each with a code of the half-spaces that it is outside
// of.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel_table.hpp"
#include "visibility/frame.hpp"
#include "visibility/mesh_order.hpp"
#include "visibility/surface.hpp"

namespace jet {

/// Steeper bounds exclude too little to be worth while.
inline constexpr float kSteepest = 1e3f;

/// Projected points, in the form that kernels take.
struct LocalPoints {
  std::vector<float> nodes, targets;  // rows of nodes, rows of elements
  std::vector<std::int32_t> codes;    // codes of nodes, if all were projected
  float half_long = 0.0f;             // half length of the line of sources; 0: a point
  float error = 0.0f;                 // absolute part of the error bound of an orientation

  RayArrays arrays(std::span<const int> list) const {
    return {targets.data(), half_long, list.data(), static_cast<int>(list.size())};
  }
};

/// Lists the patches, ascending, that reach into all half-spaces of `outside` (bits of a code). Returns their
/// number.
int find_patches(const OrderedMesh& mesh, const LocalPoints& points, int outside, int* patches);

/// The nodes and targets of one query, in the frame of its sources.
class Projection {
 public:
  /// `elements`: room for their targets.
  void reserve(std::size_t node_count, std::size_t elements, Way way);
  /// Builds the frame of the source, which may not be usable.
  void begin(const Surface& surface, const RaySource& source, std::span<const int> candidates);

  /// Chooses a scale that holds the nodes and sources. Throws std::invalid_argument for a node out of range.
  void rescale();
  /// Uses the scale of the last query, or the new one. One of the functions below must be called next.
  void set_arrays();
  /// [m] Largest distance of a node from the source's centre.
  double extent() const;
  /// Bounds of the rays to the candidates.
  Frustum bounds_of_candidates() const;
  /// The half-spaces of the codes contain all rays in the bounds and all points within `reach` [m] of them.
  /// The first function makes the codes of all nodes, the second projects all nodes, the third only those of
  /// `rows`. False if the scale does not fit, or a coordinate is out of range. `rescaled`: the scale was
  /// chosen for these nodes.
  bool code_nodes(const Frustum& bounds, double reach, bool rescaled);
  bool project_nodes(const Frustum& bounds, bool rescaled);
  bool project_rows(const Frustum& bounds, std::span<const std::uint32_t> rows);
  /// Sets `size`. True if the coordinates are in the range of the filters in double arithmetic.
  bool fits_range();

  const Frame& frame() const { return frame_; }
  double scale() const { return scale_; }   // [1/m]; 0 before the first query
  int outside() const { return outside_; }  // bits of a code that exclude an element
  const LocalPoints& points() const { return points_; }
  LocalPoints& points() { return points_; }

  double size = 0.0;  // [m] bound of the coordinates of nodes and sources

 private:
  void set_sides(const Frustum& bounds, double reach);

  Surface surface_;
  const RaySource* source_ = nullptr;
  std::span<const int> candidates_;
  Frame frame_;
  double scale_ = 0.0;  // power of two that brings local coordinates below 1
  ProjectArrays arrays_{};
  int outside_ = 0;
  LocalPoints points_;
};

}  // namespace jet
