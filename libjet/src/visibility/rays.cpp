// SPDX-License-Identifier: Apache-2.0
#include "visibility/rays.hpp"

#include <algorithm>
#include <cmath>

#include "bits.hpp"
#include "checks.hpp"

namespace jet {
namespace {

constexpr std::size_t kMostUpstream = 64;  // more of them are quicker in a tree
// Coordinates over extent. Sources and targets lie beside their exact places by 7e-16 of it at most: a
// quarter of 2^-25, which the margins hold.
constexpr double kLargestRatio = 1e7;
constexpr double kStepsAhead = 6.0;  // motion that the choice of close patches is made for
constexpr float kCloseShare = 0.05f, kLastShare = 0.02f;  // of the rays' range, by which bounds are widened

double extent(const Surface& surface, const Eigen::Vector3d& centre) {
  double largest = 0.0;
  for (int i = 0; i < surface.node_count; ++i) {
    const double* x = surface.node(i);
    largest = std::max(largest, (Eigen::Vector3d(x[0], x[1], x[2]) - centre).squaredNorm());
  }
  return std::sqrt(largest);
}

}  // namespace

void RayBundle::reserve(const OrderedMesh& mesh, std::size_t node_count) {
  mesh_ = &mesh;
  const std::size_t patches = set_bytes(static_cast<std::size_t>(mesh.patches)), elements = 8 * patches;
  local_.resize(4 * (node_count + 8));
  codes_.resize(node_count + 8);
  local_targets_.resize(4 * elements);
  asked_.reserve(mesh, patches);
  upstream.reserve(elements + 8);
  close_.reserve(mesh, node_count);
}

void RayBundle::move_to(double displacement_bound) {
  step_ = displacement_bound - displacement_bound_;
  displacement_bound_ = displacement_bound;
  if (!(step_ >= 0.0)) close_.forget();
}

void RayBundle::ask(const Surface& surface, const RaySource& source, std::span<const int> candidates) {
  surface_ = surface;
  source_ = &source;
  candidates_ = candidates;
  asked_.ask(surface, source, candidates);
  has_frame_ = frame_.build(source);
}

bool RayBundle::project_expected() {
  fresh_ = false;
  if (!has_frame_ || !(step_ >= 0.0) || !close_.range().fits(*source_, scale_)) return false;
  set_arrays();
  const auto on = [](float before, float last) { return last + (last - before); };
  const Frustum &b = before_, &l = last_;
  const Frustum next{std::min(l.low_u, on(b.low_u, l.low_u)), std::max(l.high_u, on(b.high_u, l.high_u)),
                     std::min(l.low_v, on(b.low_v, l.low_v)), std::max(l.high_v, on(b.high_v, l.high_v))};
  const Frustum expected = CloseRange::widened(with_new(next), kLastShare);
  if (!close_.range().holds(expected, displacement_bound_) &&
      !choose_close(CloseRange::widened(expected, kCloseShare), false))
    return false;
  return project_close(expected) && fits_range();
}

bool RayBundle::project_chosen() {
  fresh_ = false;
  if (!has_frame_ || !(step_ >= 0.0) || !close_.range().fits(*source_, scale_)) return false;
  set_arrays();
  return close_.range().holds(close_.range().bounds, displacement_bound_) &&
         project_close(close_.range().bounds) && fits_range();
}

bool RayBundle::project_fresh() {
  fresh_ = true;
  if (!has_frame_) return false;
  const bool kept = scale_ != 0.0;
  if (kept) set_arrays();
  if (kept && project_targets(false)) return fits_range();
  rescale();
  set_arrays();
  return project_targets(true) && fits_range();
}

/// Sets `size`; whether coordinates are in the range that double arithmetic serves.
bool RayBundle::fits_range() {
  size = source_->centre.cwiseAbs().maxCoeff() + 1.8 / scale_;  // root of 3, and the frame's roundings
  return size <= kLargest && size * scale_ <= kLargestRatio;
}

// The bounds of rays asked about before and of those that were not.
Frustum RayBundle::with_new(const Frustum& before) {
  const std::span<const int> elements = asked_.list_new();
  if (elements.empty()) return before;
  arrays_.elements = elements.data();
  const Frustum now = kernel_table().frustum_of(arrays_, half_long(), static_cast<int>(elements.size()));
  return {std::min(before.low_u, now.low_u), std::max(before.high_u, now.high_u),
          std::min(before.low_v, now.low_v), std::max(before.high_v, now.high_v)};
}

bool RayBundle::accept(const PatchesFound& found, std::span<const int> patches,
                       std::span<const int> not_downstream) {
  upstream.assign(not_downstream.begin(), not_downstream.end());
  if (!fresh_) {  // the bounds are not made of these rays
    const auto above = [](float x, float low) { return x >= low || low < -kSteepest; };
    const Frustum &b = bounds_, &r = found.bounds;
    if (found.asked < asked_.patches() || !above(r.low_u, b.low_u) || !above(-r.high_u, -b.high_u) ||
        !above(r.low_v, b.low_v) || !above(-r.high_v, -b.high_v))
      return false;
  } else if (found.asked < asked_.patches()) {  // they hold no ray of these patches
    const std::span<const int> more = asked_.list_outside(patches);
    upstream.insert(upstream.end(), more.begin(), more.end());
  }
  before_ = fresh_ ? found.bounds : last_;
  last_ = found.bounds;
  return upstream.empty() || (upstream.size() <= kMostUpstream && upstream.size() < asked_.count());
}

void RayBundle::do_without() {
  upstream.clear();
  const double reach =
      source_->half_long == 0.0 ? 0.0 : source_->half_long * source_->long_direction.cwiseAbs().maxCoeff();
  size = std::max(check_nodes(surface_), source_->centre.cwiseAbs().maxCoeff() + reach);
}

// A scale that keeps the nodes and the sources within 1/2, with room to move. The magnitude of a refused node
// is not known, so this is where all of them are looked at.
void RayBundle::rescale() {
  close_.forget();
  check_nodes(surface_);
  const double largest = std::max({extent(surface_, source_->centre), source_->half_long, 1e-150});
  scale_ = std::ldexp(1.0, -std::ilogb(largest) - 2);
}

void RayBundle::set_arrays() {
  const int last = surface_.node_count - 1;
  const double* x = surface_.node(last);
  arrays_ = {{surface_.nodes, surface_.stride, last, {x[0], x[1], x[2], 0.0}},
             surface_.node_count,
             {},
             {},
             local_.data(),
             codes_.data(),
             surface_.triangles->data(),
             candidates_.data(),
             {},
             {},
             nullptr,
             true,
             {}};
  for (int i = 0; i < 3; ++i) {
    arrays_.centre[i] = source_->centre[i];
    const Eigen::Vector3d* const axes[] = {&frame_.across, &frame_.along, &frame_.forward};
    for (int j = 0; j < 3; ++j) arrays_.column[i][j] = scale_ * (*axes[j])[i];
  }
  for (int j = 0; j < 3; ++j) {
    int columns = 0;
    for (int i = 0; i < 3; ++i) {
      if (arrays_.column[i][j] == 0.0) continue;
      arrays_.axis[j] = i;
      ++columns;
    }
    arrays_.aligned = arrays_.aligned && columns == 1;
  }
}

// The frustum of the rays' targets, and nodes: all, or where the motion is known those close to the rays.
// False where the scale does not fit them any more, or one of them is to be refused.
bool RayBundle::project_targets(bool rescaled) {
  close_.forget();
  bounds_ = kernel_table().frustum_of(arrays_, half_long(), static_cast<int>(candidates_.size()));
  if (step_ >= 0.0)
    return choose_close(CloseRange::widened(bounds_, kCloseShare), rescaled) && project_close(bounds_);
  set_sides(bounds_, 0.0);
  set_winding_ray();
  return fits(kernel_table().project_nodes(arrays_), rescaled);
}

// The scale holds the nodes. A small extent does fit if the scale is of these very nodes and sources.
bool RayBundle::fits(const ProjectFlags& flags, bool rescaled) {
  return !flags.outside && !flags.tiny && (rescaled || !flags.small);
}

// Patches that can come between rays in these bounds while nodes move by a reach.
bool RayBundle::choose_close(const Frustum& wide, bool rescaled) {
  const double reach =
      std::min(kStepsAhead * step_, 1.0 / scale_);  // no coordinate gets above 2, see places()
  set_sides(wide, 1.001 * scale_ * reach);
  if (!fits(kernel_table().code_nodes(arrays_), rescaled)) return false;
  close_.choose(*source_, scale_, wide, displacement_bound_, reach,
                [&](int* patches) { return find_patches(kSides, patches); });  // no floor: they may rise
  return true;
}

bool RayBundle::project_close(const Frustum& bounds) {
  bounds_ = bounds;
  set_sides(bounds_, 0.0);
  set_winding_ray();
  arrays_.listed = close_.rows().data();
  return !kernel_table().project_listed(arrays_, static_cast<int>(close_.rows().size())).outside;
}

}  // namespace jet
