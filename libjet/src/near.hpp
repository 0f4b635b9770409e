// SPDX-License-Identifier: Apache-2.0
// Elements near the rays of a query, in patches of eight: the sides that they show to the sources, and which
// of them rays can meet. What is said here is certain, or else left open.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "kernel_table.hpp"
#include "mesh_order.hpp"
#include "pyramid.hpp"
#include "rays.hpp"

namespace jet {

class NearElements {
 public:
  void reserve(const OrderedMesh& mesh);

  /// Patches that the rays or the way can meet, the sides of their elements, and the rays' targets. Places
  /// are those in the mesh's order.
  void find(RayBundle& rays);

  /// All sources whose rays can touch the element see its outer side.
  bool shows_outer_side(int place) const {
    return (outer_[static_cast<std::size_t>(place / 8)] >> place % 8 & 1) != 0;
  }
  /// The element is near, and may show its outer side to sources whose rays can touch it.
  bool may_show_outer_side(int place) const {
    return (not_inner_[static_cast<std::size_t>(place / 8)] >> place % 8 & 1) != 0;
  }

  /// Elements near the rays that may show either side, may lie between two sources, may touch the way; and
  /// those asked about whose rays are not certainly downstream.
  std::span<const int> uncertain() const { return first(uncertain_, found_.uncertain); }
  std::span<const int> between() const { return first(between_, found_.between); }
  std::span<const int> on_way() const { return first(on_way_, found_.on_way); }
  std::span<const int> aside() const { return first(aside_, found_.aside); }

  const PatchesFound& found() const { return found_; }
  std::span<const int> patches() const { return first(patches_, found_.near); }
  /// By patch: bits of the elements whose inner side all these sources see, and whose own rays pierce them.
  std::span<const std::uint8_t> inner() const { return inner_; }

  void rule_out_outer_side(int place) {
    std::uint8_t& bits = not_inner_[static_cast<std::size_t>(place / 8)];
    bits = static_cast<std::uint8_t>(bits & ~(1 << place % 8));
  }

  /// visit(ray, place, kind) for the rays listed and the elements near them that may show the outer side and
  /// that these may touch.
  template <class Visit>
  void for_each_touching(const RayBundle& rays, std::span<const int> list, Visit visit) {
    const int count =
        kernel_table().choose_boxes({boxes_.boxes(), patches_.data(), found_.near}, not_inner_.data(),
                                    outer_boxes_.boxes(), outer_patches_.data());
    for_each_hit(rays, list, false, outer_boxes_, first(outer_patches_, count), visit);
  }

  /// The same for all elements near the rays that these may touch before their targets, without their own.
  template <class Visit>
  void for_each_before_target(const RayBundle& rays, std::span<const int> list, Visit visit) {
    for_each_hit(rays, list, true, boxes_, patches(), visit);
  }

 private:
  /// Eight rays that follow each other in a list may have different parts of the surface in their way: they
  /// see many blocks then, most of them in vain. They part where their elements do, and if, in fine meshes,
  /// they still see too many. Both are measured.
  static constexpr int kFarPlaces = 64, kMostBlocks = 32, kNoLimit = std::numeric_limits<int>::max();

  static std::span<const int> first(const std::vector<int>& list, int count) {
    return std::span(list).first(static_cast<std::size_t>(count));
  }
  template <class Visit>
  void for_each_hit(const RayBundle& bundle, std::span<const int> all, bool to_targets, Pyramid& boxes,
                    std::span<const int> patches, Visit visit) {
    if (patches.empty()) return;
    boxes.build(static_cast<int>(patches.size()));
    const RayArrays rays = bundle.arrays(all);
    const ElementArrays elements{bundle.local(), mesh_->corner_rows.data(), patches.data()};
    const HitLists lists{hits_.data(), first_.data(), second_.data()};
    for (int begin = 0, count = 0; begin < rays.count; begin += count) {
      count = std::min(8, rays.count - begin);
      const int* const list = rays.list + begin;
      const auto meet = [&](int places, int blocks) {
        return kernel_table().meet({rays.targets, rays.half_long, list, count},
                                   {places, count > 1 ? blocks : kNoLimit}, to_targets, boxes.view(),
                                   elements, lists);
      };
      int hits = meet(kFarPlaces, kMostBlocks);
      if (-8 <= hits && hits < 0) {
        count = -hits;
        hits = meet(kNoLimit, kMostBlocks);
      }
      if (hits < 0) {
        count = -hits - 8;
        hits = meet(kNoLimit, kNoLimit);
      }
      for (int i = 0; i < hits; ++i) {
        const int hit = hits_[static_cast<std::size_t>(i)], pair = hit / kHitKinds;
        visit(list[pair % 8], pair / 8, hit % kHitKinds);
      }
    }
  }

  const OrderedMesh* mesh_ = nullptr;
  std::vector<int> patches_, outer_patches_;             // near; of these, those with elements not inner
  std::vector<std::uint8_t> inner_, outer_, not_inner_;  // of all patches of the mesh
  std::vector<int> uncertain_, between_, on_way_, aside_;
  PatchesFound found_{};
  Pyramid boxes_, outer_boxes_;  // of the patches' elements, of those not inner
  std::vector<int> hits_, first_, second_;
};

}  // namespace jet
