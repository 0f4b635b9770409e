// SPDX-License-Identifier: Apache-2.0
// The close set: the patches that rays can meet while no node moves farther than a reach and the rays stay
// within widened bounds. As long as that holds, queries skip the other patches.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "bits.hpp"
#include "jet/visibility.hpp"
#include "kernel_table.hpp"
#include "visibility/frame.hpp"
#include "visibility/mesh_order.hpp"

namespace jet {

/// Rays and motion for which a close set is valid.
struct CloseRange {
  Frame frame{};
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // [m] of the source
  double half_long = 0.0;                            // [m]
  double scale = 0.0;
  double reach = 0.0;                                    // [m] of the nodes from the centre, while it holds
  Frustum bounds{};                                      // bounds of the rays
  double from = kMotionUnknown, until = kMotionUnknown;  // [m] displacement_bound

  /// False if no set was chosen: everything is close.
  bool any() const { return until >= from; }
  /// True if it was chosen for a source that this one may be, moved since.
  bool fits(const RaySource& other, double other_scale) const {
    return any() && other_scale == scale && other.half_long == half_long;
  }
  /// True if it contains all elements that rays within the bounds can meet; the displacement bound counts the
  /// motion of the frame.
  bool holds(double displacement_bound) const {
    return displacement_bound >= from && displacement_bound <= until;
  }

  /// The bounds, widened by a share of their range.
  static Frustum widened(const Frustum& rays, float share) {
    const float u = share * (rays.high_u - rays.low_u), v = share * (rays.high_v - rays.low_v);
    return {rays.low_u - u, rays.high_u + u, rays.low_v - v, rays.high_v + v};
  }
};

class CloseSet {
 public:
  void reserve(const OrderedMesh& mesh, std::size_t node_count) {
    mesh_ = &mesh;
    patches_.resize(static_cast<std::size_t>(mesh.patches));
    nodes_.resize(node_count + 8);
    rows_.resize(node_count + 8);
    node_bits_.resize(set_bytes((node_count + 7) / 8));
    has_patch_.resize(static_cast<std::size_t>(mesh.patches));
    has_node_.resize(8 * node_bits_.size());
  }

  /// From now on everything is close.
  void forget() { range_ = {}; }

  const CloseRange& range() const { return range_; }

  /// Stores the patches that `find` returns.
  template <class Find>
  void choose(const CloseRange& range, Find find) {
    range_ = range;
    std::fill(has_patch_.begin(), has_patch_.end(), std::uint8_t{0});
    patch_count_ = static_cast<std::size_t>(find(*mesh_, patches_.data()));
    list_nodes();
  }

  bool has(std::size_t patch) const { return has_patch_[patch] != 0; }
  std::span<const int> patches() const { return std::span(patches_).first(patch_count_); }
  /// Begins of the nodes' rows of four numbers, ascending; the last one repeated to a multiple of eight.
  std::span<const std::uint32_t> rows() const { return std::span(rows_).first(row_count_); }

 private:
  void list_nodes() {
    // Copies, so that the stores of bytes cannot change them.
    const int *nodes = mesh_->patch_nodes.data(), *begin = mesh_->patch_begin.data();
    std::uint8_t* has = has_node_.data();
    std::fill(has_node_.begin(), has_node_.end(), std::uint8_t{0});
    for (const int patch : patches()) {
      has_patch_[static_cast<std::size_t>(patch)] = 1;
      for (const int *node = nodes + begin[patch], *end = nodes + begin[patch + 1]; node < end; node += 4)
        has[node[0]] = has[node[1]] = has[node[2]] = has[node[3]] = 1;
    }
    pack(has_node_, node_bits_);
    row_count_ = static_cast<std::size_t>(
        kernel_table().list_bits(node_bits_.data(), static_cast<int>(node_bits_.size()), nodes_.data()));
    for (std::size_t i = 0; i < row_count_; ++i) rows_[i] = 4 * static_cast<std::uint32_t>(nodes_[i]);
    for (; row_count_ % 8 != 0; ++row_count_) rows_[row_count_] = rows_[row_count_ - 1];
  }

  const OrderedMesh* mesh_ = nullptr;
  CloseRange range_;
  std::size_t patch_count_ = 0, row_count_ = 0;
  std::vector<int> patches_, nodes_;  // nodes_: workspace
  std::vector<std::uint32_t> rows_;
  std::vector<std::uint8_t> has_patch_, has_node_, node_bits_;
};

}  // namespace jet
