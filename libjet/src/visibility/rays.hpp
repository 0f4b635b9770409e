// SPDX-License-Identifier: Apache-2.0
// The rays of one query in the jet's frame, by the places of their elements in the mesh's order. Also the
// nodes that the rays can come near to. The bounds of the rays are slopes against the axis (point source), or
// slope across and place along the line (line source). Their margins are far above rounding. A margin costs
// work at worst; it never changes an answer.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel_table.hpp"
#include "visibility/asked_rays.hpp"
#include "visibility/blocking.hpp"
#include "visibility/close_set.hpp"
#include "visibility/frame.hpp"
#include "visibility/mesh_order.hpp"

namespace jet {

/// Ray from the source of a ray, moved, to a point outside the surface, within the rays' bounds.
struct WindingRay {
  blocking::Ray ray{};
  double u = 0.0, v = 0.0;  // its slopes, or slope across and place along the line
};

/// The rays of a query, their bounds, and the nodes projected for them.
class RayBundle {
 public:
  void reserve(const OrderedMesh& mesh, std::size_t node_count);

  /// Tells that the nodes may have moved. `displacement_bound`: see VisibilityQuery.
  void move_to(double displacement_bound);
  /// Makes one ray for each element that is asked about.
  void ask(const Surface& surface, const RaySource& source, std::span<const int> candidates);

  /// Project the nodes that rays in a frustum can come near to. The frustum is that expected from the last
  /// two queries; that for which the close set was chosen; or that of the rays' targets. False if it is not
  /// known, or if no frame contains the nodes. Throw std::invalid_argument for coordinates out of range where
  /// they are read, see VisibilityQuery.
  bool project_expected();
  bool project_chosen();
  bool project_fresh();
  /// True if the elements examined include all that the rays can meet. Rays that are now in `upstream` are
  /// exempt, if they are not too many.
  bool accept(const PatchesFound& found, std::span<const int> patches, std::span<const int> not_downstream);
  /// Gives up bounds of the rays: only `size` is known. Throws as project().
  void do_without();

  const AskedRays& asked() const { return asked_; }
  const WindingRay& winding() const { return winding_; }

  /// True if the element's nodes are projected. No ray can meet other elements.
  bool knows(int place) const {
    return !close_.range().any() || close_.has(static_cast<std::size_t>(place / 8));
  }

  /// Patches of the mesh, ascending, outside which rays and the winding ray meet nothing. `out` has room for
  /// all.
  std::span<const int> find_patches(std::span<int> out) const;

  RayArrays arrays(std::span<const int> list) const {
    return {local_targets_.data(), half_long(), list.data(), static_cast<int>(list.size())};
  }
  const float* local() const { return local_.data(); }
  float* targets() { return local_targets_.data(); }
  const float* targets() const { return local_targets_.data(); }
  float half_long() const {  // above 0 for every line, as the frame has it
    return source_->half_long == 0.0 ? 0.0f
                                     : std::max(static_cast<float>(scale_ * source_->half_long), 1e-30f);
  }
  float local_error() const { return static_cast<float>(2.5e-13 * (1.0 + scale_ * size)); }
  int outside() const { return outside_; }  // bits of a code that exclude an element

  double size = 0.0;  // [m] bound of the coordinates of nodes and sources
  /// Places whose rays have no length or do not go downstream; they are not in the bounds.
  std::vector<int> upstream;

 private:
  /// Steeper bounds exclude too little to be worth their margin.
  static constexpr float kSteepest = 1e3f;

  Frustum with_new(const Frustum& before);
  bool fits_range();
  bool project_targets(bool rescaled);
  static bool fits(const ProjectFlags& flags, bool rescaled);
  bool project_close(const Frustum& bounds);
  bool choose_close(const Frustum& wide, bool rescaled);
  void rescale();
  void set_arrays();
  void set_winding_ray();
  void set_sides(const Frustum& bounds, double reach);
  void set_side(int bit, double slope, double bound, double reach);
  int find_patches(int outside, int* patches) const;

  Surface surface_;
  const RaySource* source_ = nullptr;
  const OrderedMesh* mesh_ = nullptr;
  std::span<const int> candidates_;
  AskedRays asked_;
  Frame frame_;
  bool has_frame_ = false;
  /// [1/m] Power of two that brings local coordinates below 1; kept for the next query.
  double scale_ = 0.0;
  Frustum bounds_{}, last_{}, before_{};
  WindingRay winding_;
  ProjectArrays arrays_{};
  int outside_ = 0;
  double displacement_bound_ = kMotionUnknown;  // [m] of the nodes
  double step_ = kMotionUnknown;                // [m] its growth since the last query
  CloseSet close_;
  bool fresh_ = false;
  std::vector<float> local_;          // rows of nodes
  std::vector<std::int32_t> codes_;   // of nodes, if all were projected
  std::vector<float> local_targets_;  // rows of elements
};

}  // namespace jet
