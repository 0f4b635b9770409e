// SPDX-License-Identifier: Apache-2.0
// Elements near the rays of a query, in patches of eight: the sides that they show to the sources, and which
// of them rays can meet. What is said here is certain, or else left open.
#pragma once

#include <cstdint>
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

  /// Patches that the rays or the way can meet, and the sides of their elements. Places are those in the
  /// mesh's order.
  void find(const RayBundle& rays, const RayBundle::Way& way);

  /// All sources whose rays can touch the element see its inner side, and its own ray pierces it; or all see
  /// its outer side.
  bool shows_inner_side(int place) const { return bit(inner_, place); }
  bool shows_outer_side(int place) const { return bit(outer_, place); }

  /// visit(place) for the elements near the rays that may not show their inner side, may lie between two
  /// sources, and may touch the way.
  template <class Visit>
  void for_each_not_inner(Visit visit) const {
    for_each([&](std::size_t k) { return ~unsigned{inner_[static_cast<std::size_t>(patches_[k])]} & 0xffu; },
             visit);
  }
  template <class Visit>
  void for_each_between(Visit visit) const {
    for_each([&](std::size_t k) { return unsigned{between_[k]}; }, visit);
  }
  template <class Visit>
  void for_each_on_way(Visit visit) const {
    for_each([&](std::size_t k) { return unsigned{on_way_[k]}; }, visit);
  }

  /// visit(ray, place, kind) for rays with a bit in `alive`, a byte for eight, and the elements of `places`
  /// that they may touch.
  template <class Visit>
  void for_each_touching(const RayBundle& rays, std::span<const std::uint8_t> alive,
                         std::span<const int> places, Visit visit) {
    gather_elements(rays, places);
    for (std::size_t block = 0; block < alive.size(); ++block) {
      if (alive[block] == 0) continue;
      const int count = kernel_table().meet_blocks(rays.arrays(), static_cast<int>(block), alive[block],
                                                   own_boxes_.view(), own_points_.data(), lists());
      for (int i = 0; i < count; ++i) {
        const int hit = hits_[static_cast<std::size_t>(i)], pair = hit / kHitKinds;
        visit(8 * block + static_cast<std::size_t>(pair % 8), places[static_cast<std::size_t>(pair / 8)],
              hit % kHitKinds);
      }
    }
  }

  /// visit(place, kind) for elements near the rays that ray k may touch before its target, until it says
  /// true.
  template <class Visit>
  bool any_before_target(const RayBundle& rays, std::size_t k, Visit visit) {
    if (!has_boxes_) make_boxes(rays);
    const int count = kernel_table().meet_elements(rays.arrays(), static_cast<int>(k), boxes_.view(),
                                                   points_.data(), lists());
    for (int i = 0; i < count; ++i) {
      const int hit = hits_[static_cast<std::size_t>(i)], slot = hit / kHitKinds;
      if (visit(8 * patches_[static_cast<std::size_t>(slot / 8)] + slot % 8, hit % kHitKinds)) return true;
    }
    return false;
  }

 private:
  static bool bit(const std::vector<std::uint8_t>& bytes, int place) {
    return (bytes[static_cast<std::size_t>(place / 8)] >> (place % 8) & 1u) != 0;
  }
  template <class Bits, class Visit>
  void for_each(Bits bits, Visit visit) const {
    for (std::size_t k = 0; k < static_cast<std::size_t>(count_); ++k) {
      for (unsigned rest = bits(k); rest != 0; rest &= rest - 1u) {
        const int place = 8 * patches_[k] + __builtin_ctz(rest);
        if (!rays_->misses(mesh_->triangles[static_cast<std::size_t>(place)])) visit(place);
      }
    }
  }
  void gather_elements(const RayBundle& rays, std::span<const int> places);
  void make_boxes(const RayBundle& rays);

  const OrderedMesh* mesh_ = nullptr;
  const RayBundle* rays_ = nullptr;
  std::vector<int> patches_;
  int count_ = 0;
  std::vector<float> points_;                   // of the patches, see PatchArrays
  std::vector<std::uint8_t> inner_, outer_;     // of all patches of the mesh
  std::vector<std::uint8_t> between_, on_way_;  // of those found
  Pyramid boxes_;                               // of the patches' elements
  bool has_boxes_ = false;
  std::vector<int> places_;  // of the elements that blocks are tested against, filled to a multiple of eight
  std::vector<float> own_points_;
  Pyramid own_boxes_;
  HitLists lists() { return {hits_.data(), first_.data(), second_.data()}; }

  std::vector<int> hits_, first_, second_;
};

}  // namespace jet
