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
#include "visibility/blocking.hpp"
#include "visibility/close_set.hpp"
#include "visibility/frame.hpp"
#include "visibility/mesh_order.hpp"

namespace jet {

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

  /// Ray to an element in the definition's arithmetic, made at its first use.
  const blocking::Ray& ray(int place) const;

  /// Ray from the source of a ray, moved, to a point outside the surface, within the rays' bounds.
  const blocking::Ray& winding_ray() const { return winding_ray_; }
  /// Its slopes, or slope across and place along the line.
  float winding_u() const { return static_cast<float>(winding_u_); }
  float winding_v() const { return static_cast<float>(winding_v_); }

  /// True if the element's nodes are projected. No ray can meet other elements.
  bool knows(int place) const {
    return !close_.range().any() || close_.has(static_cast<std::size_t>(place / 8));
  }

  /// Patches of the mesh, ascending, outside which rays and the winding ray meet nothing. `out` has room for
  /// all.
  std::span<const int> find_patches(std::span<int> out) const;

  std::span<const int> places() const { return given_; }          // in the order of those asked about
  std::span<const std::uint8_t> asked() const { return asked_; }  // by patch: bits of the elements
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

  std::size_t count_asked() const;
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
  std::vector<int> given_;  // their places
  std::vector<std::uint8_t> asked_, asked_before_;
  std::vector<int> listed_;  // workspace: places, or elements there
  int asked_patches_ = 0;
  Frame frame_;
  bool has_frame_ = false;
  /// [1/m] Power of two that brings local coordinates below 1; kept for the next query.
  double scale_ = 0.0;
  Frustum bounds_{}, last_{}, before_{};
  blocking::Ray winding_ray_{};
  double winding_u_ = 0.0, winding_v_ = 0.0;
  ProjectArrays arrays_{};
  int outside_ = 0;
  double displacement_bound_ = kMotionUnknown;  // [m] of the nodes
  double step_ = kMotionUnknown;                // [m] its growth since the last query
  CloseSet close_;
  bool fresh_ = false;
  std::vector<float> local_;          // rows of nodes
  std::vector<std::int32_t> codes_;   // of nodes, if all were projected
  std::vector<float> local_targets_;  // rows of elements
  mutable std::vector<blocking::Ray> made_;
  mutable std::vector<std::uint8_t> is_made_;
  mutable std::vector<int> made_places_;
};

}  // namespace jet
