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
#include "visibility/mesh_order.hpp"
#include "visibility/projection.hpp"

namespace jet {

/// Ray from the source of a ray, moved, to a point outside the surface, within the rays' bounds.
struct WindingRay {
  blocking::Ray ray{};
  double u = 0.0, v = 0.0;  // its slopes, or slope across and place along the line
};

/// The rays of a query, their bounds, and the nodes projected for them.
class RayBundle {
 public:
  void reserve(const OrderedMesh& mesh, std::size_t node_count, Way way);

  /// Tells that the nodes may have moved. `displacement_bound`: see VisibilityQuery.
  void move_to(double displacement_bound);
  /// Makes one ray for each element that is asked about.
  void ask(const Surface& surface, const RaySource& source, std::span<const int> candidates);

  /// Project the nodes that rays in a frustum can come near to. The frustum is that for which the close set
  /// was chosen, or that of the rays' targets. False if it is not known, or if no frame contains the nodes.
  /// Throw std::invalid_argument for coordinates out of range where they are read, see VisibilityQuery.
  bool project_chosen();
  bool project_fresh();
  /// True if the elements examined include all that the rays can meet. Rays that are now in `upstream` are
  /// exempt, if they are not too many.
  bool accept(const PatchesFound& found, std::span<const int> patches, std::span<const int> not_downstream);
  /// Gives up bounds of the rays: only the `size` of the projection is known. Throws as project().
  void do_without();

  const AskedRays& asked() const { return asked_; }
  const WindingRay& winding() const { return winding_; }
  const Projection& projection() const { return projection_; }
  Projection& projection() { return projection_; }

  /// True if the element's nodes are projected. No ray can meet other elements.
  bool knows(int place) const {
    return !close_.range().any() || close_.has(static_cast<std::size_t>(place / 8));
  }

  /// Patches of the mesh, ascending, outside which rays and the winding ray meet nothing. `out` has room for
  /// all.
  std::span<const int> find_patches(const OrderedMesh& mesh, std::span<int> out) const;

  /// Places whose rays have no length or do not go the frame's way; they are not in the bounds.
  std::vector<int> upstream;

 private:
  /// Of the nodes [m]: the displacement bound, and its growth since the last query.
  struct Motion {
    double bound = kMotionUnknown, step = kMotionUnknown;
  };

  bool project_targets(bool rescaled);
  bool project_close(const Frustum& bounds);
  bool choose_close(const Frustum& wide, bool rescaled);

  AskedRays asked_;
  Projection projection_;
  Frustum bounds_{};  // of the rays
  WindingRay winding_;
  Motion motion_;
  CloseSet close_;
  bool fresh_ = false;
};

}  // namespace jet
