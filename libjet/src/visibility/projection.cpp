// SPDX-License-Identifier: Apache-2.0
#include "visibility/projection.hpp"

#include <cmath>
#include <elementary/hypot.hpp>

#include "checks.hpp"

namespace jet {
namespace {

// Largest ratio of coordinates to extent. Sources and targets are off their exact places by at most 7e-16 of
// the coordinates: a quarter of 2^-25 of the extent, which the margins cover.
constexpr double kLargestRatio = 1e7;
constexpr double kMargin = 1e-6;  // 33 times the error of local coordinates
constexpr int kFloor = 0x80;      // bit of a code: not above the sources' own plane

double extent(const Surface& surface, const Eigen::Vector3d& centre) {
  double largest = 0.0;
  for (int i = 0; i < surface.node_count; ++i) {
    const double* x = surface.node(i);
    largest = std::max(largest, (Eigen::Vector3d(x[0], x[1], x[2]) - centre).squaredNorm());
  }
  return std::sqrt(largest);
}

// True if the scale fits the nodes. A small extent fits if the scale was chosen for these nodes and sources.
bool fits(const ProjectFlags& flags, bool rescaled) {
  return !flags.outside && !flags.tiny && (rescaled || !flags.small);
}

void set_side(ProjectArrays& arrays, int bit, double slope, double bound, double reach) {
  const bool steep = !(std::abs(slope) <= static_cast<double>(kSteepest));
  arrays.slope[bit] = steep ? 0.0f : static_cast<float>(slope);
  arrays.bound[bit] = steep ? HUGE_VALF
                            : static_cast<float>(bound + kMargin * (1.0 + std::abs(slope)) +
                                                 (reach > 0.0 ? reach * elementary::hypot(1.0, slope) : 0.0));
}

}  // namespace

void Projection::reserve(std::size_t node_count, std::size_t elements, Way way) {
  frame_.way = way;
  points_.nodes.resize(4 * (node_count + 8));
  points_.codes.resize(node_count + 8);
  points_.targets.resize(4 * elements);
}

void Projection::begin(const Surface& surface, const RaySource& source, std::span<const int> candidates) {
  surface_ = surface;
  source_ = &source;
  candidates_ = candidates;
  frame_.build(source);
}

// A scale that keeps the nodes and the sources within 1/2, with room to move. Here all nodes are read, also
// those whose range is not yet checked.
void Projection::rescale() {
  check_nodes(surface_);
  const double largest = std::max({extent(), source_->half_long, 1e-150});
  scale_ = std::ldexp(1.0, -std::ilogb(largest) - 2);
}

void Projection::set_arrays() {
  points_.half_long =
      source_->half_long == 0.0 ? 0.0f : std::max(static_cast<float>(scale_ * source_->half_long), 1e-30f);
  const int last = surface_.node_count - 1;
  const double* x = surface_.node(last);
  arrays_ = {{surface_.nodes, surface_.stride, last, {x[0], x[1], x[2], 0.0}},
             surface_.node_count,
             {},
             {},
             points_.nodes.data(),
             points_.codes.data(),
             surface_.triangles->data(),
             candidates_.data(),
             {},
             {},
             nullptr};
  for (int i = 0; i < 3; ++i) {
    arrays_.centre[i] = source_->centre[i];
    const Eigen::Vector3d* const axes[] = {&frame_.across, &frame_.along, &frame_.forward};
    for (int j = 0; j < 3; ++j) arrays_.column[i][j] = scale_ * (*axes[j])[i];
  }
}

double Projection::extent() const {
  return jet::extent(surface_, source_->centre);
}

Frustum Projection::bounds_of_candidates() const {
  return kernel_table().frustum_of(arrays_, points_.half_long, static_cast<int>(candidates_.size()));
}

bool Projection::code_nodes(const Frustum& bounds, double reach, bool rescaled) {
  set_sides(bounds, 1.001 * scale_ * reach);
  return fits(kernel_table().code_nodes(arrays_), rescaled);
}

bool Projection::project_nodes(const Frustum& bounds, bool rescaled) {
  set_sides(bounds, 0.0);
  return fits(kernel_table().project_nodes(arrays_), rescaled);
}

bool Projection::project_rows(const Frustum& bounds, std::span<const std::uint32_t> rows) {
  set_sides(bounds, 0.0);
  arrays_.listed = rows.data();
  return !kernel_table().project_listed(arrays_, static_cast<int>(rows.size())).outside;
}

bool Projection::fits_range() {
  size = source_->centre.cwiseAbs().maxCoeff() + 1.8 / scale_;  // sqrt(3), and the frame's roundings
  points_.error = static_cast<float>(2.5e-13 * (1.0 + scale_ * size));
  return size <= kLargest && size * scale_ <= kLargestRatio;
}

// Sets half-spaces that contain all downstream rays, extended beyond their targets, and all points within
// `reach` of them.
void Projection::set_sides(const Frustum& bounds, double reach) {
  set_side(arrays_, 0, bounds.low_u, 0.0, reach);
  set_side(arrays_, 1, bounds.high_u, 0.0, reach);
  set_side(arrays_, 2, frame_.line ? 0.0 : bounds.low_v, frame_.line ? -bounds.low_v : 0.0, reach);
  set_side(arrays_, 3, frame_.line ? 0.0 : bounds.high_v, frame_.line ? bounds.high_v : 0.0, reach);
  arrays_.bound[4] = static_cast<float>(kMargin + std::max(reach, 0.0));
  // Points that are not above the sources' own plane meet no ray: a source on the surface starts above it, by
  // eps.
  outside_ = kSides | (frame_.has_floor() ? kFloor : 0);
}

int find_patches(const OrderedMesh& mesh, const LocalPoints& points, int all_outside, int* patches) {
  const int *nodes = mesh.patch_nodes.data(), *begin = mesh.patch_begin.data();
  const std::int32_t* codes = points.codes.data();
  int count = 0;
  for (int patch = 0; patch < mesh.patches; ++patch) {
    int outside = all_outside;
    for (const int *node = nodes + begin[patch], *end = nodes + begin[patch + 1]; node < end && outside != 0;
         node += 4)
      outside &= codes[node[0]] & codes[node[1]] & codes[node[2]] & codes[node[3]];
    patches[count] = patch;  // without a branch: overwritten by the next patch if this one is outside
    count += outside == 0;
  }
  return count;
}

}  // namespace jet
