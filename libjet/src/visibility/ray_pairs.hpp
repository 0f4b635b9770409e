// SPDX-License-Identifier: Apache-2.0
// Pairs of a ray and an element whose boxes meet, with certain results where possible. Many pairs are tested
// together.
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

/// Result for a ray and an element that it may touch: not certain; the segment certainly crosses the
/// interior; or only its line touches, beyond one end of the segment.
enum class Touch { possible, blocked, beyond };

/// Finds and tests the pairs of rays and elements of a mesh. Places are those in the mesh's order.
class RayPairs {
 public:
  void reserve(const OrderedMesh& mesh);

  /// Calls visit(ray, place, touch) for the listed rays and the elements of `patches` that their lines may
  /// touch. If `to_targets`, only for elements that a ray may touch before its target, other than its own.
  /// `boxes` are the boxes of the elements.
  template <class Visit>
  void for_each(const RayBundle& rays, std::span<const int> list, bool to_targets, Pyramid& boxes,
                std::span<const int> patches, Visit visit) {
    if (patches.empty()) return;
    boxes.build(static_cast<int>(patches.size()));
    while (!list.empty()) {
      count_ = 0;
      while (!list.empty() && count_ < kManyPairs)
        list = list.subspan(
            add(rays.projection().points().arrays(list), to_targets, boxes.view(), patches.data()));
      test(rays);
      for (std::size_t begin = 0; begin < static_cast<std::size_t>(count_); begin += 8) {
        const std::size_t byte = begin / 8, count = static_cast<std::size_t>(count_) - begin;
        const unsigned blocked = blocked_[byte], beyond = unsigned{pierced_[byte]} & apart_[byte];
        unsigned left =
            ~unsigned{(to_targets ? apart_ : missed_)[byte]} & (count < 8 ? (1u << count) - 1u : 0xffu);
        for (; left != 0; left &= left - 1u) {
          const int i = std::countr_zero(left);
          const std::size_t pair = begin + static_cast<std::size_t>(i);
          visit(rays_[pair], elements_[pair],
                (blocked >> i & 1u) != 0  ? Touch::blocked
                : (beyond >> i & 1u) != 0 ? Touch::beyond
                                          : Touch::possible);
        }
      }
    }
  }

 private:
  /// Eight successive rays may cross different parts of the surface; their common box then meets many blocks
  /// that no single ray meets. So a list is split where its elements are farther apart than kFarPlaces, which
  /// was found by measurement. At most kManyPairs pairs are tested together.
  static constexpr int kFarPlaces = 64, kManyPairs = 512;

  std::size_t add(const RayArrays& rays, bool to_targets, const PyramidView& boxes, const int* patches);
  void test(const RayBundle& rays);

  const OrderedMesh* mesh_ = nullptr;
  std::vector<int> first_, second_;  // workspace of the search
  // Room for all pairs, although few are used, and their results, see PairArrays.
  std::unique_ptr<int[]> rays_, elements_;
  int count_ = 0;
  std::vector<std::uint8_t> blocked_, pierced_, apart_, missed_;
};

}  // namespace jet
