// SPDX-License-Identifier: Apache-2.0
#include "near.hpp"

#include <algorithm>

#include "bits.hpp"

namespace jet {

void NearElements::reserve(const OrderedMesh& mesh) {
  mesh_ = &mesh;
  const auto patches = static_cast<std::size_t>(mesh.patches);
  patches_.resize(patches);
  outer_patches_.resize(patches);
  for (auto* bytes : {&inner_, &outer_, &not_inner_}) bytes->resize(set_bytes(patches));
  for (auto* list : {&uncertain_, &between_, &on_way_, &aside_}) list->resize(8 * patches + 8);
  boxes_.reserve(patches);
  outer_boxes_.reserve(patches);
  hits_.resize(64 * patches);  // eight rays and all elements
  first_.resize(8 * patches + 8);
  second_.resize(8 * patches + 8);
}

void NearElements::find(RayBundle& rays) {
  const std::span<const int> patches = rays.find_patches(patches_);
  for (auto* bytes : {&inner_, &outer_, &not_inner_})
    std::fill(bytes->begin(), bytes->end(), std::uint8_t{0});
  found_ = kernel_table().look_at_patches({rays.local(),
                                           rays.half_long(),
                                           mesh_->corner_rows.data(),
                                           static_cast<int>(mesh_->rank.size()),
                                           patches.data(),
                                           static_cast<int>(patches.size()),
                                           rays.outside(),
                                           rays.asked().data(),
                                           rays.local_error(),
                                           rays.way_u(),
                                           rays.way_v(),
                                           patches_.data(),
                                           boxes_.boxes(),
                                           rays.targets(),
                                           inner_.data(),
                                           outer_.data(),
                                           not_inner_.data(),
                                           uncertain_.data(),
                                           between_.data(),
                                           on_way_.data(),
                                           aside_.data()});
}

}  // namespace jet
