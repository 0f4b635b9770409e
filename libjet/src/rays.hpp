// SPDX-License-Identifier: Apache-2.0
// The rays of one query in the jet's frame, as boxes of the two coordinates that do not change along a ray:
// the slopes against the axis (point source), or slope across and place along the line (line source). An
// element covers a range of each. Boxes carry margins far above rounding, so they cost work at worst, never
// an answer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "blocking.hpp"
#include "close_set.hpp"
#include "frame.hpp"
#include "kernel_table.hpp"
#include "mesh_order.hpp"
#include "pyramid.hpp"

namespace jet {

class RayBundle {
 public:
  void reserve(const OrderedMesh& mesh, std::size_t element_count, std::size_t node_count);

  /// Projects rays and nodes; allocates nothing. False if no frame holds them all but a few: nothing but
  /// `size` is known then. Throws std::invalid_argument for coordinates out of range.
  /// `travelled`: see VisibilityQuery.
  bool build(const Surface& surface, const RaySource& source, std::span<const int> as_given,
             double travelled);

  /// Ray of a candidate in the definition's arithmetic, made when first asked for.
  const blocking::Ray& ray(std::size_t k) const;

  /// From the source of a ray not aside, moved, to a point outside the surface, within the rays' bounds.
  struct Way {
    blocking::Ray ray;
    float line[3];  // of local coordinates, see PatchArrays
  };
  Way way() const;

  /// The element's nodes are projected; no ray can meet those of others.
  bool knows(int place) const { return !close_.any() || close_.has(static_cast<std::size_t>(place / 8)); }

  /// No ray can meet an element with these nodes. Precondition: they are projected.
  bool misses(const Triangle& t) const {
    const auto code = [&](int i) { return codes_[static_cast<std::size_t>(t[static_cast<std::size_t>(i)])]; };
    return (code(0) & code(1) & code(2) & outside_) != 0;
  }
  /// Patches of the mesh in order that rays or the way can meet; their number.
  int find_patches(int* patches) const;

  /// The ray is not asked about any more.
  void drop(std::size_t k) { boxes_.drop(static_cast<int>(k)); }

  const RayArrays& arrays() const { return rays_; }
  const float* local() const { return local_.data(); }
  float local_error() const { return static_cast<float>(2.5e-13 * (1.0 + scale_ * size)); }

  std::span<const int> candidates;   // in the mesh's order, in which all here is numbered
  std::vector<int> given;            // their places in the query
  double size = 0.0;                 // [m] bounds the magnitude of every coordinate of nodes and sources
  std::vector<std::uint32_t> aside;  // rays without length, or not downstream of the outlet: empty boxes

 private:
  void sort(std::span<const int> as_given);
  bool project();
  bool project_nodes();
  bool choose_close(double reach);
  int find_patches(std::span<const int> among, unsigned outside, int* patches) const;
  void rescale();
  void set_sides(const RayBounds& bounds, double reach = 0.0);
  void set_side(int bit, double slope, double bound, double reach);
  void find_aside(std::size_t count);

  Surface surface_;
  const RaySource* source_ = nullptr;
  const OrderedMesh* mesh_ = nullptr;
  std::vector<int> sorted_;
  std::vector<std::uint64_t> chosen_;  // bit i: the i-th element of the order is a candidate
  std::vector<int> given_at_;          // place of the i-th element in the query
  Frame frame_;
  double scale_ = 0.0;  // [1/m] power of two that brings local coordinates below 1; kept for the next query
  RayBounds bounds_{};
  ProjectArrays arrays_{};
  RayArrays rays_{};
  ProjectFlags flags_{};
  unsigned outside_ = 0;               // bits of a code that keep an element out
  double travelled_ = kMotionUnknown;  // [m] by the nodes
  double step_ = 0.0;                  // [m] of it since the last query
  CloseSet close_;
  std::vector<int> all_;              // patches
  std::vector<float> local_;          // 4 a node
  std::vector<float> local_targets_;  // 4 a ray
  Pyramid boxes_;                     // of the rays
  std::vector<std::uint8_t> codes_;   // of the nodes
  std::vector<std::uint8_t> aside_bits_;
  mutable std::vector<blocking::Ray> made_;
  mutable std::vector<std::uint8_t> is_made_;
};

}  // namespace jet
