// SPDX-License-Identifier: Apache-2.0
#include "visibility/near.hpp"

#include <algorithm>

#include "bits.hpp"

namespace jet {

void NearElements::reserve(const OrderedMesh& mesh) {
  mesh_ = &mesh;
  const auto patches = static_cast<std::size_t>(mesh.patches);
  patches_.resize(patches);
  outer_patches_.resize(patches);
  for (auto* bytes : {&sides_.inner, &sides_.not_inner}) bytes->resize(set_bytes(patches));
  for (auto* list : {&uncertain_, &between_, &on_winding_ray_, &upstream_}) list->resize(8 * patches + 8);
  boxes_.reserve(patches);
  outer_boxes_.reserve(patches);
  pairs_.reserve(mesh);
}

void NearElements::find(RayBundle& rays) {
  const std::span<const int> patches = rays.find_patches(*mesh_, patches_);
  for (auto* bytes : {&sides_.inner, &sides_.not_inner})
    std::fill(bytes->begin(), bytes->end(), std::uint8_t{0});
  found_ = kernel_table().classify_patches({rays.projection().points().nodes.data(),
                                            rays.projection().points().half_long,
                                            mesh_->corner_rows.data(),
                                            static_cast<int>(mesh_->rank.size()),
                                            patches.data(),
                                            static_cast<int>(patches.size()),
                                            rays.projection().outside(),
                                            rays.asked().bits().data(),
                                            rays.projection().points().error,
                                            static_cast<float>(rays.winding().u),
                                            static_cast<float>(rays.winding().v),
                                            patches_.data(),
                                            boxes_.boxes(),
                                            rays.projection().points().targets.data(),
                                            sides_.inner.data(),
                                            sides_.not_inner.data(),
                                            uncertain_.data(),
                                            between_.data(),
                                            on_winding_ray_.data(),
                                            upstream_.data()});
}

}  // namespace jet
