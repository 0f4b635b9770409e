// SPDX-License-Identifier: Apache-2.0
#include "visibility/rays.hpp"

#include <algorithm>
#include <cmath>

#include "bits.hpp"
#include "checks.hpp"

namespace jet {
namespace {

constexpr std::size_t kMostUpstream = 64;  // for more rays a tree is faster
constexpr double kStepsAhead = 6.0;        // close patches are chosen for this many steps of motion
constexpr double kFastest = 0.02;     // step of the frame, over 2 to 4 extents: a faster one is a new frame
constexpr float kCloseShare = 0.05f;  // bounds are widened by this share of their range

// The slope is general, not symmetric, because bags are symmetric about the axis. Local coordinates of the
// end are above 1.
WindingRay winding_ray(const Projection& projection, const AskedRays& asked, const Frustum& bounds) {
  WindingRay winding;
  const Frame& frame = projection.frame();
  winding.v = 0.0;
  for (const int place : asked.places()) {  // the first that goes downstream is within the bounds
    winding.ray = asked.ray(place);
    if (!frame.line) break;
    const Eigen::Map<const Eigen::Vector3d> from(winding.ray.source);
    winding.v = projection.scale() * (from - asked.source().centre).dot(frame.along);
    if (winding.v >= bounds.low_v && winding.v <= bounds.high_v) break;
  }
  winding.ray.moved = blocking::Moved::yes;
  const auto within = [](float low, float high, double share) {
    const double a = std::clamp(low, -kSteepest, kSteepest), b = std::clamp(high, -kSteepest, kSteepest);
    return a + share * (b - a);
  };
  const double u = within(bounds.low_u, bounds.high_u, 0.382);
  const double v = frame.line ? 0.0 : within(bounds.low_v, bounds.high_v, 0.618);
  for (int i = 0; i < 3; ++i)
    winding.ray.target[i] =
        winding.ray.source[i] +
        2.0 / projection.scale() * (frame.forward[i] + u * frame.across[i] + v * frame.along[i]);
  winding.u = u;
  if (!frame.line) winding.v = v;
  return winding;
}

}  // namespace

void RayBundle::reserve(const OrderedMesh& mesh, std::size_t node_count, Way way) {
  const std::size_t patches = set_bytes(static_cast<std::size_t>(mesh.patches)), elements = 8 * patches;
  projection_.reserve(node_count, elements, way);
  asked_.reserve(mesh, patches);
  upstream.reserve(elements + 8);
  close_.reserve(mesh, node_count);
}

void RayBundle::move_to(double displacement_bound) {
  motion_ = {displacement_bound, displacement_bound - motion_.bound, 0.0};
  if (!(motion_.step >= 0.0)) close_.forget();
}

void RayBundle::ask(const Surface& surface, const RaySource& source, std::span<const int> candidates) {
  asked_.ask(surface, source, candidates);
  projection_.begin(surface, source, candidates);
  const Frame& frame = projection_.frame();
  if (last_)
    motion_.frame_step = frame.motion_from(last_->frame, last_->centre, source.centre, last_->extent);
  if (last_ && motion_.frame_step > 0.0) last_->frame = frame, last_->centre = source.centre;
  upstream.clear();
}

bool RayBundle::project_chosen() {
  fresh_ = false;
  const CloseRange& range = close_.range();
  const RaySource& source = asked_.source();
  const Frame& frame = projection_.frame();
  if (!frame.usable || !range.fits(source, projection_.scale()) ||
      !range.holds(motion_.bound + frame.motion_from(range.frame, range.centre, source.centre, range.reach)))
    return false;
  projection_.set_arrays();
  return project_close(range.bounds) && projection_.fits_range();
}

bool RayBundle::project_fresh() {
  fresh_ = true;
  if (!projection_.frame().usable) return false;
  const bool kept = projection_.scale() != 0.0;
  if (kept) projection_.set_arrays();
  if (kept && project_targets(false)) return projection_.fits_range();
  close_.forget();
  projection_.rescale();
  projection_.set_arrays();
  return project_targets(true) && projection_.fits_range();
}

bool RayBundle::accept(const PatchesFound& found, std::span<const int> patches,
                       std::span<const int> not_downstream) {
  upstream.assign(not_downstream.begin(), not_downstream.end());
  if (!fresh_) {  // the bounds are not those of these rays
    const auto above = [](float x, float low) { return x >= low || low < -kSteepest; };
    const Frustum &b = bounds_, &r = found.bounds;
    if (found.asked < asked_.patches() || !above(r.low_u, b.low_u) || !above(-r.high_u, -b.high_u) ||
        !above(r.low_v, b.low_v) || !above(-r.high_v, -b.high_v))
      return false;
  } else if (found.asked < asked_.patches()) {  // they contain no ray of some patches
    const std::span<const int> more = asked_.list_outside(patches);
    upstream.insert(upstream.end(), more.begin(), more.end());
  }
  return upstream.empty() || (upstream.size() <= kMostUpstream && upstream.size() < asked_.count());
}

void RayBundle::do_without() {
  upstream.clear();
  const double reach = asked_.source().half_long == 0.0
                           ? 0.0
                           : asked_.source().half_long * asked_.source().long_direction.cwiseAbs().maxCoeff();
  projection_.size =
      std::max(check_nodes(asked_.surface()), asked_.source().centre.cwiseAbs().maxCoeff() + reach);
}

// Computes the frustum of the rays' targets and projects the nodes: all, or, if the motion is known, those
// close to the rays. False if the scale does not fit any more, or a coordinate is out of range.
bool RayBundle::project_targets(bool rescaled) {
  close_.forget();
  bounds_ = projection_.bounds_of_candidates();
  if (motion_.step >= 0.0 && motion_.frame_step <= kFastest / projection_.scale())
    return choose_close(CloseRange::widened(bounds_, kCloseShare), rescaled) && project_close(bounds_);
  winding_ = winding_ray(projection_, asked_, bounds_);
  return projection_.project_nodes(bounds_, rescaled);
}

// Chooses the patches that rays in these bounds can meet while nodes move by a reach.
bool RayBundle::choose_close(const Frustum& wide, bool rescaled) {
  const double reach = std::min(kStepsAhead * (motion_.step + motion_.frame_step),
                                1.0 / projection_.scale());  // no coordinate exceeds 2, see places()
  if (!projection_.code_nodes(wide, reach, rescaled)) return false;
  const RaySource& source = asked_.source();
  last_ = {projection_.frame(), source.centre, projection_.extent()};
  close_.choose({last_->frame, source.centre, source.half_long, projection_.scale(), last_->extent + reach,
                 wide, motion_.bound, motion_.bound + reach},
                [&](const OrderedMesh& mesh, int* patches) {
                  return jet::find_patches(mesh, projection_.points(), kSides, patches);
                });  // no floor: nodes may rise above it
  return true;
}

bool RayBundle::project_close(const Frustum& bounds) {
  bounds_ = bounds;
  winding_ = winding_ray(projection_, asked_, bounds_);
  return projection_.project_rows(bounds_, close_.rows());
}

std::span<const int> RayBundle::find_patches(const OrderedMesh& mesh, std::span<int> out) const {
  if (close_.range().any()) return close_.patches();
  return out.first(static_cast<std::size_t>(
      jet::find_patches(mesh, projection_.points(), projection_.outside(), out.data())));
}

}  // namespace jet
