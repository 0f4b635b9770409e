// SPDX-License-Identifier: Apache-2.0
// Elements near the rays, and rays near elements.
#include <algorithm>

#include "rays.hpp"

namespace jet {

int RayBundle::collect(int* near) const {
  const std::uint8_t* codes = codes_.data();
  int count = 0;
  for (std::size_t patch = 0; patch + 1 < mesh_.patch_begin.size(); ++patch) {
    unsigned outside = outside_;
    for (int i = mesh_.patch_begin[patch]; i < mesh_.patch_begin[patch + 1]; ++i)
      outside &= codes[mesh_.patch_nodes[static_cast<std::size_t>(i)]];
    if (outside != 0) continue;
    for (std::size_t i = 8 * patch; i < std::min(8 * patch + 8, mesh_.triangles.size()); ++i) {
      const auto& t = mesh_.triangles[i];
      near[count] = mesh_.elements[i];  // kept if the next does not overwrite it: no branch to predict
      count += (codes[t[0]] & codes[t[1]] & codes[t[2]] & outside_) == 0;
    }
  }
  for (int i = count; i > 0 && i % 8 != 0; ++i) near[i] = near[count - 1];
  return count;
}

void RayBundle::element_boxes(const int* elements, int count, float* to, float* points, std::uint8_t* facing,
                              std::uint8_t* away) const {
  BoxArrays arrays = rays_;
  arrays.local = local_.data();
  arrays.boxes = to;
  arrays.points = points;
  arrays.elements = elements;
  arrays.triangles = surface_.triangles->data();
  arrays.error = static_cast<float>(2.5e-13 * (1.0 + scale_ * size));
  arrays.facing = facing;
  arrays.away = away;
  kernel_table().element_boxes(arrays, count);
}

int RayBundle::touching_rays(const Pyramid& elements, const float* points, int slot, int* out) const {
  Touch touch{};
  const float* p = points + kElementFloats * (slot / 8) + slot % 8;
  for (int i = 0; i < 9; ++i) touch.corner[i] = p[8 * i];
  const RayList list{list_boxes_.data(), list_blocks_.data(), list_count_, boxes.view().boxes,
                     points_.data()};
  return kernel_table().rays_touching(list, elements.box(slot).data(), touch, out);
}

void RayBundle::make_list(const Pyramid& elements, std::span<const int> slots) {
  float eight[32];
  for (std::size_t i = 0; i < 8; ++i) {
    const auto box = elements.box(slots[std::min(i, slots.size() - 1)]);
    for (std::size_t j = 0; j < 4; ++j) eight[8 * j + i] = box[j];
  }
  list_count_ = kernel_table().shortlist(boxes.view(), eight, list_boxes_.data(), list_blocks_.data());
}

int RayBundle::touching_elements(const Pyramid& elements, const float* points, std::size_t k,
                                 int* out) const {
  const float* p = points_.data() + kRayFloats * (k / 8) + k % 8;
  const Touch touch{{}, {p[0], p[8], p[16]}, p[24]};
  const auto box = boxes.box(static_cast<int>(k));
  return kernel_table().elements_touching(elements.view(), box.data(), points, touch, out);
}

}  // namespace jet
