// SPDX-License-Identifier: Apache-2.0
#include "visibility/ray_pairs.hpp"

#include <algorithm>

namespace jet {

void RayPairs::reserve(const OrderedMesh& mesh) {
  mesh_ = &mesh;
  const auto patches = static_cast<std::size_t>(mesh.patches);
  first_.resize(8 * patches + 8);
  second_.resize(8 * patches + 8);
  const std::size_t pairs = kManyPairs + 64 * patches + 8;  // eight rays and all elements
  for (auto* list : {&rays_, &elements_}) *list = std::make_unique_for_overwrite<int[]>(pairs);
  for (auto* bytes : {&blocked_, &pierced_, &apart_, &missed_}) bytes->resize(pairs / 8);
}

// Adds the pairs of the first rays of a list, at most eight. Returns the number of rays.
std::size_t RayPairs::add(const RayArrays& rays, bool to_targets, const PyramidView& boxes,
                          const int* patches) {
  int count = std::min(8, rays.count);
  const PairLists lists{&rays_[static_cast<std::size_t>(count_)],
                        &elements_[static_cast<std::size_t>(count_)], first_.data(), second_.data()};
  const auto find = [&] {
    return kernel_table().find_pairs({rays.targets, rays.half_long, rays.list, count}, kFarPlaces, to_targets,
                                     boxes, patches, lists);
  };
  int found = find();
  if (found < 0) {
    count = -found;
    found = find();
  }
  count_ += found;
  return static_cast<std::size_t>(count);
}

void RayPairs::test(const RayBundle& rays) {
  kernel_table().meet_pairs(
      {rays.projection().points().targets.data(), rays.projection().points().nodes.data(),
       rays.projection().points().half_long, mesh_->corner_rows.data(), rays_.get(), elements_.get(),
       blocked_.data(), pierced_.data(), apart_.data(), missed_.data()},
      count_);
}

}  // namespace jet
