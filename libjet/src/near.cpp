// SPDX-License-Identifier: Apache-2.0
#include "near.hpp"

#include <algorithm>

#include "bits.hpp"

namespace jet {

void NearElements::reserve(const OrderedMesh& mesh) {
  mesh_ = &mesh;
  const auto patches = static_cast<std::size_t>(mesh.patches);
  patches_.resize(patches);
  points_.resize(kElementFloats * patches);
  for (auto* bytes : {&inner_, &outer_}) bytes->resize(set_bytes(patches));
  for (auto* list : {&not_inner_, &between_, &on_way_, &aside_}) list->resize(8 * patches + 8);
  boxes_.reserve(8 * patches);
  own_boxes_.reserve(8 * patches);
  places_.resize(8 * patches);
  own_points_.resize(kElementFloats * patches);
  hits_.resize(64 * patches);  // eight rays and all elements
  first_.resize(8 * patches + 8);
  second_.resize(8 * patches + 8);
}

void NearElements::find(RayBundle& rays) {
  const std::span<const int> patches = rays.find_patches(patches_);
  std::fill(inner_.begin(), inner_.end(), std::uint8_t{0});
  std::fill(outer_.begin(), outer_.end(), std::uint8_t{0});
  found_ = kernel_table().look_at_patches(
      {rays.local(), rays.half_long(), mesh_->corner_rows.data(), static_cast<int>(mesh_->rank.size()),
       patches.data(), static_cast<int>(patches.size()), rays.outside(), rays.asked().data(),
       rays.local_error(), patches_.data(), points_.data(), rays.targets(), inner_.data(), outer_.data(),
       not_inner_.data(), between_.data(), on_way_.data(), aside_.data()});
}

void NearElements::make_boxes(const RayBundle& rays) {
  kernel_table().element_boxes(points_.data(), rays.half_long(), found_.near, boxes_.boxes());
  boxes_.build(8 * found_.near);
}

void NearElements::gather_elements(const RayBundle& rays, std::span<const int> places) {
  const std::size_t count = places.size();
  std::copy(places.begin(), places.end(), places_.begin());
  std::fill(places_.begin() + static_cast<std::ptrdiff_t>(count),
            places_.begin() + static_cast<std::ptrdiff_t>((count + 7) / 8 * 8), places.back());
  kernel_table().gather_elements({rays.local(), rays.half_long(), mesh_->triangles.front().data(),
                                  places_.data(), own_boxes_.boxes(), own_points_.data()},
                                 static_cast<int>(count));
  own_boxes_.build(static_cast<int>(count));
}

}  // namespace jet
