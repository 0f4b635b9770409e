// SPDX-License-Identifier: Apache-2.0
#include "visibility/near.hpp"

#include <algorithm>
#include <limits>

#include "bits.hpp"

namespace jet {

void NearElements::reserve(const OrderedMesh& mesh) {
  mesh_ = &mesh;
  const auto patches = static_cast<std::size_t>(mesh.patches);
  patches_.resize(patches);
  outer_patches_.resize(patches);
  for (auto* bytes : {&inner_, &outer_, &not_inner_}) bytes->resize(set_bytes(patches));
  for (auto* list : {&uncertain_, &between_, &on_winding_ray_, &upstream_}) list->resize(8 * patches + 8);
  boxes_.reserve(patches);
  outer_boxes_.reserve(patches);
  first_.resize(8 * patches + 8);
  second_.resize(8 * patches + 8);
  const std::size_t pairs = kManyPairs + 64 * patches + 8;  // eight rays and all elements
  for (auto* list : {&pair_rays_, &pair_elements_}) *list = std::make_unique_for_overwrite<int[]>(pairs);
  for (auto* bytes : {&blocked_, &pierced_, &apart_, &missed_}) bytes->resize(pairs / 8);
}

void NearElements::find(RayBundle& rays) {
  const std::span<const int> patches = rays.find_patches(patches_);
  for (auto* bytes : {&inner_, &outer_, &not_inner_})
    std::fill(bytes->begin(), bytes->end(), std::uint8_t{0});
  found_ = kernel_table().classify_patches({rays.local(),
                                            rays.half_long(),
                                            mesh_->corner_rows.data(),
                                            static_cast<int>(mesh_->rank.size()),
                                            patches.data(),
                                            static_cast<int>(patches.size()),
                                            rays.outside(),
                                            rays.asked().data(),
                                            rays.local_error(),
                                            rays.winding_u(),
                                            rays.winding_v(),
                                            patches_.data(),
                                            boxes_.boxes(),
                                            rays.targets(),
                                            inner_.data(),
                                            outer_.data(),
                                            not_inner_.data(),
                                            uncertain_.data(),
                                            between_.data(),
                                            on_winding_ray_.data(),
                                            upstream_.data()});
}

// Of the first rays of a list, eight at most: their number.
std::size_t NearElements::add_pairs(const RayArrays& rays, bool to_targets, const PyramidView& boxes,
                                    const int* patches) {
  constexpr int no_limit = std::numeric_limits<int>::max();
  int count = std::min(8, rays.count);
  const PairLists lists{&pair_rays_[static_cast<std::size_t>(pairs_)],
                        &pair_elements_[static_cast<std::size_t>(pairs_)], first_.data(), second_.data()};
  const auto find = [&](int places, int blocks) {
    return kernel_table().find_pairs({rays.targets, rays.half_long, rays.list, count},
                                     {places, count > 1 ? blocks : no_limit}, to_targets, boxes, patches,
                                     lists);
  };
  int found = find(kFarPlaces, kMostBlocks);
  if (-8 <= found && found < 0) {
    count = -found;
    found = find(no_limit, kMostBlocks);
  }
  if (found < 0) {
    count = -found - 8;
    found = find(no_limit, no_limit);
  }
  pairs_ += found;
  return static_cast<std::size_t>(count);
}

void NearElements::meet_pairs(const RayBundle& rays) {
  kernel_table().meet_pairs(
      {rays.targets(), rays.local(), rays.half_long(), mesh_->corner_rows.data(), pair_rays_.get(),
       pair_elements_.get(), blocked_.data(), pierced_.data(), apart_.data(), missed_.data()},
      pairs_);
}

}  // namespace jet
