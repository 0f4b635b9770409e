// SPDX-License-Identifier: Apache-2.0
// Cached blockers: an element that blocked a ray at the last query often blocks it again, and one that opened
// it opens it again.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "kernel_table.hpp"
#include "visibility/mesh_order.hpp"
#include "visibility/rays.hpp"

namespace jet {

/// A ray and an element that is or may be on it, by their places in the mesh's order.
struct RayHit {
  int ray, element;
};

/// Rays with the element that blocked them, or that faced away and opened them, at this query and the last
/// one.
class HitCache {
 public:
  void reserve(std::size_t patches) {
    for (auto* hits : {&blockers_, &last_blockers_, &openers_, &last_openers_}) hits->reserve(8 * patches);
    for (auto* places : {&rays_, &elements_}) places->resize(16 * patches + 1);  // blockers, then openers
    for (auto* bytes : {&blocked_, &pierced_, &apart_, &missed_}) bytes->resize(2 * patches);
  }

  void add_blocker(int ray, int by) { blockers_.push_back({ray, by}); }
  void add_opener(int ray, int by) { openers_.push_back({ray, by}); }

  /// Begins a query: tests those hits of the last one for which the masks are 1. Calls blocked(ray, by,
  /// is_certain) for blockers that may block again, then opened(ray, by) for openers that may be on the ray.
  template <class BlockerMask, class OpenerMask, class Blocked, class Opened>
  void retest(const RayBundle& rays, const OrderedMesh& mesh, BlockerMask is_blocker, OpenerMask is_opener,
              Blocked blocked, Opened opened) {
    std::swap(blockers_, last_blockers_);
    std::swap(openers_, last_openers_);
    blockers_.clear();
    openers_.clear();
    std::size_t count = 0;
    const auto take_if = [&](int wanted, const RayHit& hit) {  // no branch to predict
      rays_[count] = hit.ray;
      elements_[count] = hit.element;
      count += static_cast<std::size_t>(wanted);
    };
    for (const RayHit& hit : last_blockers_) take_if(is_blocker(hit), hit);
    const std::size_t first_opener = count;
    for (const RayHit& hit : last_openers_) take_if(is_opener(hit), hit);
    kernel_table().meet_pairs(
        {rays.projection().points().targets.data(), rays.projection().points().nodes.data(),
         rays.projection().points().half_long, mesh.corner_rows.data(), rays_.data(), elements_.data(),
         blocked_.data(), pierced_.data(), apart_.data(), missed_.data()},
        static_cast<int>(count));
    const auto bit = [](const std::vector<std::uint8_t>& bits, std::size_t i) {
      return (bits[i / 8] >> i % 8 & 1u) != 0;
    };
    for (std::size_t i = 0; i < first_opener; ++i)
      if (bit(blocked_, i) || !bit(apart_, i)) blocked(rays_[i], elements_[i], bit(blocked_, i));
    for (std::size_t i = first_opener; i < count; ++i)
      if (!bit(missed_, i)) opened(rays_[i], elements_[i]);
  }

 private:
  std::vector<RayHit> blockers_, last_blockers_, openers_, last_openers_;
  std::vector<int> rays_, elements_;                              // workspace: the hits that are tested
  std::vector<std::uint8_t> blocked_, pierced_, apart_, missed_;  // see PairArrays
};

}  // namespace jet
