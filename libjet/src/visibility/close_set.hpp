// SPDX-License-Identifier: Apache-2.0
// Patches of a mesh that rays can come to meet while its nodes move by at most a reach and the rays stay
// within widened bounds. The other patches need not be examined for that long.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "bits.hpp"
#include "jet/visibility.hpp"
#include "kernel_table.hpp"
#include "visibility/mesh_order.hpp"

namespace jet {

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
  void forget() { until_ = from_ = kMotionUnknown; }

  /// The bounds, widened by a share of their range.
  static Frustum widened(const Frustum& rays, float share) {
    const float u = share * (rays.high_u - rays.low_u), v = share * (rays.high_v - rays.low_v);
    return {rays.low_u - u, rays.high_u + u, rays.low_v - v, rays.high_v + v};
  }

  /// True if it was chosen for the coordinates of these rays.
  bool fits(const RaySource& source, double scale) const {
    return any() && scale == scale_ && source.centre == source_.centre && source.axis == source_.axis &&
           source.long_direction == source_.long_direction && source.half_long == source_.half_long;
  }
  /// True if it still contains all that these rays can meet.
  bool holds(const Frustum& rays, double displacement_bound) const {
    return displacement_bound >= from_ && displacement_bound <= until_ && rays.low_u >= wide_.low_u &&
           rays.high_u <= wide_.high_u && rays.low_v >= wide_.low_v && rays.high_v <= wide_.high_v;
  }
  const Frustum& bounds() const { return wide_; }

  /// Takes the patches that `find` writes, for rays in the wider bounds and nodes within the reach.
  template <class Find>
  void choose(const RaySource& source, double scale, const Frustum& wide, double displacement_bound,
              double reach, Find find) {
    source_ = source;
    scale_ = scale;
    wide_ = wide;
    from_ = displacement_bound;
    until_ = displacement_bound + reach;
    std::fill(has_patch_.begin(), has_patch_.end(), std::uint8_t{0});
    patch_count_ = static_cast<std::size_t>(find(patches_.data()));
    list_nodes();
  }

  bool any() const { return until_ >= from_; }
  bool has(std::size_t patch) const { return has_patch_[patch] != 0; }
  std::span<const int> patches() const { return std::span(patches_).first(patch_count_); }
  /// Where the nodes' rows of four numbers begin, ascending; the last one repeated to a multiple of eight.
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
  RaySource source_;
  double scale_ = 0.0;
  Frustum wide_{};
  double from_ = kMotionUnknown, until_ = kMotionUnknown;  // [m] displacement_bound
  std::size_t patch_count_ = 0, row_count_ = 0;
  std::vector<int> patches_, nodes_;  // nodes_: workspace
  std::vector<std::uint32_t> rows_;
  std::vector<std::uint8_t> has_patch_, has_node_, node_bits_;
};

}  // namespace jet
