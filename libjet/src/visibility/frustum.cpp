// SPDX-License-Identifier: Apache-2.0
// The rays of one query, second part: half-spaces that hold them, the patches in these, and the winding ray
// between them.
#include <algorithm>
#include <cmath>

#include "visibility/rays.hpp"

namespace jet {
namespace {

constexpr double kMargin = 1e-6;  // 33 times the error of local coordinates
constexpr int kFloor = 0x80;      // bit of a code: not above the sources' own plane

}  // namespace

void RayBundle::set_side(int bit, double slope, double bound, double reach) {
  const bool steep = !(std::abs(slope) <= static_cast<double>(kSteepest));
  arrays_.slope[bit] = steep ? 0.0f : static_cast<float>(slope);
  arrays_.bound[bit] = steep ? HUGE_VALF
                             : static_cast<float>(bound + kMargin * (1.0 + std::abs(slope)) +
                                                  (reach > 0.0 ? reach * std::hypot(1.0, slope) : 0.0));
}

// Half-spaces that hold all rays downstream, beyond their targets, too, and what is within `reach` of them.
void RayBundle::set_sides(const Frustum& bounds, double reach) {
  set_side(0, bounds.low_u, 0.0, reach);
  set_side(1, bounds.high_u, 0.0, reach);
  set_side(2, frame_.line ? 0.0 : bounds.low_v, frame_.line ? -bounds.low_v : 0.0, reach);
  set_side(3, frame_.line ? 0.0 : bounds.high_v, frame_.line ? bounds.high_v : 0.0, reach);
  arrays_.bound[4] = static_cast<float>(kMargin + std::max(reach, 0.0));
  // What is not above the sources' own plane meets no ray: a source on it starts above, by eps.
  outside_ = kSides | (frame_.aligned() ? kFloor : 0);
}

std::span<const int> RayBundle::find_patches(std::span<int> out) const {
  if (close_.range().any()) return close_.patches();
  return out.first(static_cast<std::size_t>(find_patches(outside_, out.data())));
}

int RayBundle::find_patches(int all_outside, int* patches) const {
  const int *nodes = mesh_->patch_nodes.data(), *begin = mesh_->patch_begin.data();
  const std::int32_t* codes = codes_.data();
  int count = 0;
  for (int patch = 0; patch < mesh_->patches; ++patch) {
    int outside = all_outside;
    for (const int *node = nodes + begin[patch], *end = nodes + begin[patch + 1]; node < end && outside != 0;
         node += 4)
      outside &= codes[node[0]] & codes[node[1]] & codes[node[2]] & codes[node[3]];
    patches[count] = patch;  // kept if the next does not overwrite it: no branch to predict
    count += outside == 0;
  }
  return count;
}

// A general slope within the bounds: bags are symmetric about the axis. Local coordinates of the end are
// above 1.
void RayBundle::set_winding_ray() {
  winding_.v = 0.0;
  for (const int place : asked_.places()) {  // the first that goes downstream is within the bounds
    winding_.ray = asked_.ray(place);
    if (!frame_.line) break;
    const Eigen::Map<const Eigen::Vector3d> from(winding_.ray.source);
    winding_.v = scale_ * (from - source_->centre).dot(frame_.along);
    if (winding_.v >= bounds_.low_v && winding_.v <= bounds_.high_v) break;
  }
  winding_.ray.moved = blocking::Moved::yes;
  const auto within = [](float low, float high, double share) {
    const double a = std::clamp(low, -kSteepest, kSteepest), b = std::clamp(high, -kSteepest, kSteepest);
    return a + share * (b - a);
  };
  const double u = within(bounds_.low_u, bounds_.high_u, 0.382);
  const double v = frame_.line ? 0.0 : within(bounds_.low_v, bounds_.high_v, 0.618);
  for (int i = 0; i < 3; ++i)
    winding_.ray.target[i] = winding_.ray.source[i] +
                             2.0 / scale_ * (frame_.forward[i] + u * frame_.across[i] + v * frame_.along[i]);
  winding_.u = u;
  if (!frame_.line) winding_.v = v;
}

}  // namespace jet
