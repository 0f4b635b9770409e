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

  /// Elements near the rays that may not show their inner side, may lie between two sources, may touch the
  /// way; and those asked about whose rays are not certainly downstream.
  std::span<const int> not_inner() const { return first(not_inner_, found_.not_inner); }
  std::span<const int> between() const { return first(between_, found_.between); }
  std::span<const int> on_way() const { return first(on_way_, found_.on_way); }
  std::span<const int> aside() const { return first(aside_, found_.aside); }

  const PatchesFound& found() const { return found_; }
  std::span<const int> patches() const { return first(patches_, found_.near); }
  /// By patch: bits of the elements whose inner side all these sources see, and whose own rays pierce them.
  std::span<const std::uint8_t> inner() const { return inner_; }

  /// visit(ray, place, kind) for the rays listed and the elements of `places` that they may touch.
  template <class Visit>
  void for_each_touching(const RayBundle& rays, std::span<const int> list, std::span<const int> places,
                         Visit visit) {
    gather_elements(rays, places);
    for_each_hit(rays.arrays(list), false, own_boxes_, own_points_, [&](int ray, int slot, int kind) {
      visit(ray, places[static_cast<std::size_t>(slot)], kind);
    });
  }

  /// The same for elements near the rays that these may touch before their targets.
  template <class Visit>
  void for_each_before_target(const RayBundle& rays, std::span<const int> list, Visit visit) {
    make_boxes(rays);
    for_each_hit(rays.arrays(list), true, boxes_, points_, [&](int ray, int slot, int kind) {
      visit(ray, 8 * patches_[static_cast<std::size_t>(slot / 8)] + slot % 8, kind);
    });
  }

 private:
  /// Eight rays that follow each other in a list may have different parts of the surface in their way: in
  /// fine meshes they see many blocks then, most of them in vain. From there on (measured) they part.
  static constexpr int kMostBlocks = 64, kNoLimit = std::numeric_limits<int>::max();

  static std::span<const int> first(const std::vector<int>& list, int count) {
    return std::span(list).first(static_cast<std::size_t>(count));
  }
  template <class Visit>
  void for_each_hit(const RayArrays& rays, bool to_targets, const Pyramid& boxes,
                    const std::vector<float>& points, Visit visit) {
    const HitLists lists{hits_.data(), first_.data(), second_.data()};
    for (int begin = 0, count = 0; begin < rays.count; begin += count) {
      count = std::min(8, rays.count - begin);
      const int* const list = rays.list + begin;
      const auto meet = [&](int most_blocks) {
        return kernel_table().meet({rays.targets, rays.half_long, list, count}, most_blocks, to_targets,
                                   boxes.view(), points.data(), lists);
      };
      int hits = meet(count > 1 ? kMostBlocks : kNoLimit);
      if (hits < 0) {
        count = -hits;
        hits = meet(kNoLimit);
      }
      for (int i = 0; i < hits; ++i) {
        const int hit = hits_[static_cast<std::size_t>(i)], pair = hit / kHitKinds;
        visit(list[pair % 8], pair / 8, hit % kHitKinds);
      }
    }
  }
  void gather_elements(const RayBundle& rays, std::span<const int> places);
  void make_boxes(const RayBundle& rays);

  const OrderedMesh* mesh_ = nullptr;
  std::vector<int> patches_;
  std::vector<float> points_;                // of the patches, see PatchArrays
  std::vector<std::uint8_t> inner_, outer_;  // of all patches of the mesh
  std::vector<int> not_inner_, between_, on_way_, aside_;
  PatchesFound found_{};
  Pyramid boxes_;            // of the patches' elements
  std::vector<int> places_;  // of the elements that blocks are tested against, filled to a multiple of eight
  std::vector<float> own_points_;
  Pyramid own_boxes_;
  std::vector<int> hits_, first_, second_;
};

}  // namespace jet
