// SPDX-License-Identifier: Apache-2.0
// Elements near the rays of a query, in patches of eight: the sides that they show to the sources, and which
// of them rays can meet. Each answer is certain, or says that it is not.
#pragma once

#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "kernel_table.hpp"
#include "visibility/mesh_order.hpp"
#include "visibility/pyramid.hpp"
#include "visibility/rays.hpp"

namespace jet {

/// What is certain of a ray and an element that it may touch: nothing; that the segment crosses the interior;
/// or that only its line touches, beyond one end of the segment.
enum class Touch { possible, blocked, beyond };

class NearElements {
 public:
  void reserve(const OrderedMesh& mesh);

  /// Finds the patches that the rays or the winding ray can meet, the sides of their elements, and the rays'
  /// targets. Places are those in the mesh's order.
  void find(RayBundle& rays);

  /// True if all sources whose rays can touch the element see its outer side.
  bool shows_outer_side(int place) const {
    return (outer_[static_cast<std::size_t>(place / 8)] >> place % 8 & 1) != 0;
  }
  /// True if the element is near and may show its outer side to sources whose rays can touch it.
  bool may_show_outer_side(int place) const {
    return (not_inner_[static_cast<std::size_t>(place / 8)] >> place % 8 & 1) != 0;
  }

  /// Elements near the rays that may show either side; that may lie between two sources; that may touch the
  /// winding ray. Last, the elements asked about whose rays are not certainly downstream.
  std::span<const int> uncertain() const { return first(uncertain_, found_.uncertain); }
  std::span<const int> between() const { return first(between_, found_.between); }
  std::span<const int> on_winding_ray() const { return first(on_winding_ray_, found_.on_winding_ray); }
  std::span<const int> upstream() const { return first(upstream_, found_.upstream); }

  const PatchesFound& found() const { return found_; }
  std::span<const int> patches() const { return first(patches_, found_.near); }
  /// By patch: bits of the elements whose inner side all these sources see and which their own rays pierce.
  std::span<const std::uint8_t> inner() const { return inner_; }

  void rule_out_outer_side(int place) {
    std::uint8_t& bits = not_inner_[static_cast<std::size_t>(place / 8)];
    bits = static_cast<std::uint8_t>(bits & ~(1 << place % 8));
  }

  /// Calls visit(ray, place, touch) for the listed rays and the elements that their lines may touch. Only
  /// near elements count that may show their outer side.
  template <class Visit>
  void for_each_touching(const RayBundle& rays, std::span<const int> list, Visit visit) {
    const int count =
        kernel_table().choose_boxes({boxes_.boxes(), patches_.data(), found_.near}, not_inner_.data(),
                                    outer_boxes_.boxes(), outer_patches_.data());
    for_each_touch(rays, list, false, outer_boxes_, first(outer_patches_, count), visit);
  }

  /// The same for all near elements, other than its own, that a ray may touch before its target.
  template <class Visit>
  void for_each_before_target(const RayBundle& rays, std::span<const int> list, Visit visit) {
    for_each_touch(rays, list, true, boxes_, patches(), visit);
  }

 private:
  /// Eight successive rays of a list may cross different parts of the surface. Their common box then meets
  /// many blocks that no single ray meets. So a list is cut where its elements are far apart and, in fine
  /// meshes, where the common box still meets too many blocks. Both limits are measured. At most so many
  /// pairs are tested together.
  static constexpr int kFarPlaces = 64, kMostBlocks = 32, kManyPairs = 512;

  static std::span<const int> first(const std::vector<int>& list, int count) {
    return std::span(list).first(static_cast<std::size_t>(count));
  }
  template <class Visit>
  void for_each_touch(const RayBundle& rays, std::span<const int> list, bool to_targets, Pyramid& boxes,
                      std::span<const int> patches, Visit visit) {
    if (patches.empty()) return;
    boxes.build(static_cast<int>(patches.size()));
    while (!list.empty()) {
      pairs_ = 0;
      while (!list.empty() && pairs_ < kManyPairs)
        list = list.subspan(add_pairs(rays.arrays(list), to_targets, boxes.view(), patches.data()));
      meet_pairs(rays);
      for (std::size_t begin = 0; begin < static_cast<std::size_t>(pairs_); begin += 8) {
        const std::size_t byte = begin / 8, count = static_cast<std::size_t>(pairs_) - begin;
        const unsigned blocked = blocked_[byte], beyond = unsigned{pierced_[byte]} & apart_[byte];
        unsigned left =
            ~unsigned{(to_targets ? apart_ : missed_)[byte]} & (count < 8 ? (1u << count) - 1u : 0xffu);
        for (; left != 0; left &= left - 1u) {
          const int i = std::countr_zero(left);
          const std::size_t pair = begin + static_cast<std::size_t>(i);
          visit(pair_rays_[pair], pair_elements_[pair],
                (blocked >> i & 1u) != 0  ? Touch::blocked
                : (beyond >> i & 1u) != 0 ? Touch::beyond
                                          : Touch::possible);
        }
      }
    }
  }
  std::size_t add_pairs(const RayArrays& rays, bool to_targets, const PyramidView& boxes, const int* patches);
  void meet_pairs(const RayBundle& rays);

  const OrderedMesh* mesh_ = nullptr;
  /// Near patches; and those of them that have elements not certain to show their inner side.
  std::vector<int> patches_, outer_patches_;
  std::vector<std::uint8_t> inner_, outer_, not_inner_;  // of all patches of the mesh
  std::vector<int> uncertain_, between_, on_winding_ray_, upstream_;
  PatchesFound found_{};
  Pyramid boxes_, outer_boxes_;  // of the elements of patches_ and of outer_patches_
  std::vector<int> first_, second_;
  // Rays whose boxes meet those of elements, and bytes of PairArrays. Room for all pairs, few of which are
  // ever used.
  std::unique_ptr<int[]> pair_rays_, pair_elements_;
  int pairs_ = 0;
  std::vector<std::uint8_t> blocked_, pierced_, apart_, missed_;
};

}  // namespace jet
