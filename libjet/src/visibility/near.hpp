// SPDX-License-Identifier: Apache-2.0
// Elements near the rays of a query, in patches of eight: the sides that they show to the sources, and which
// of them rays can meet. Each answer is certain or is marked as uncertain.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernel_table.hpp"
#include "visibility/mesh_order.hpp"
#include "visibility/pyramid.hpp"
#include "visibility/ray_pairs.hpp"
#include "visibility/rays.hpp"

namespace jet {

/// Sides that the elements near the rays show to the sources, as bits by patch of the mesh.
struct ShownSides {
  std::vector<std::uint8_t> inner;      // all these sources see the inner side, and the element's own rays
                                        // pierce it
  std::vector<std::uint8_t> not_inner;  // near, and may show its outer side to such sources

  static bool has(const std::vector<std::uint8_t>& set, int place) {
    return (set[static_cast<std::size_t>(place / 8)] >> place % 8 & 1) != 0;
  }
  void rule_out_outer(int place) {
    std::uint8_t& bits = not_inner[static_cast<std::size_t>(place / 8)];
    bits = static_cast<std::uint8_t>(bits & ~(1 << place % 8));
  }
};

/// The elements near the rays of a query, and which of them rays may touch.
class NearElements {
 public:
  void reserve(const OrderedMesh& mesh);

  /// Finds the patches that the rays or the winding ray can meet, the sides of their elements, and the rays'
  /// targets. Places are in the mesh's order.
  void find(RayBundle& rays);

  const ShownSides& sides() const { return sides_; }
  ShownSides& sides() { return sides_; }

  /// Elements near the rays that may show either side; may lie between two sources; may touch the winding
  /// ray. The last function lists the candidates whose rays are not certainly downstream.
  std::span<const int> uncertain() const { return first(uncertain_, found_.uncertain); }
  std::span<const int> between() const { return first(between_, found_.between); }
  std::span<const int> on_winding_ray() const { return first(on_winding_ray_, found_.on_winding_ray); }
  std::span<const int> upstream() const { return first(upstream_, found_.upstream); }

  const PatchesFound& found() const { return found_; }
  std::span<const int> patches() const { return first(patches_, found_.near); }

  /// Calls visit(ray, place, touch) for the listed rays and the elements that their lines may touch. Only
  /// near elements that may show their outer side are tested.
  template <class Visit>
  void for_each_touching(const RayBundle& rays, std::span<const int> list, Visit visit) {
    const int count =
        kernel_table().choose_boxes({boxes_.boxes(), patches_.data(), found_.near}, sides_.not_inner.data(),
                                    outer_boxes_.boxes(), outer_patches_.data());
    pairs_.for_each(rays, list, false, outer_boxes_, first(outer_patches_, count), visit);
  }

  /// The same for all near elements, except the ray's own, that it may touch before its target.
  template <class Visit>
  void for_each_before_target(const RayBundle& rays, std::span<const int> list, Visit visit) {
    pairs_.for_each(rays, list, true, boxes_, patches(), visit);
  }

 private:
  static std::span<const int> first(const std::vector<int>& list, int count) {
    return std::span(list).first(static_cast<std::size_t>(count));
  }
  const OrderedMesh* mesh_ = nullptr;
  /// Near patches; and near patches with elements whose inner side is not certain.
  std::vector<int> patches_, outer_patches_;
  ShownSides sides_;
  std::vector<int> uncertain_, between_, on_winding_ray_, upstream_;
  PatchesFound found_{};
  Pyramid boxes_, outer_boxes_;  // boxes of the elements of patches_ and of outer_patches_
  RayPairs pairs_;
};

}  // namespace jet
