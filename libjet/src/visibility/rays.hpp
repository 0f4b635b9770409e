// SPDX-License-Identifier: Apache-2.0
// The rays of one query in the jet's frame, by the places of their elements in the mesh's order. Also the
// nodes near the rays. The rays' bounds are slopes against the axis (point source), or slope across and place
// along the line (line source). Their margins are far above rounding; they may cost work but never change an
// answer.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "kernel_table.hpp"
#include "visibility/asked_rays.hpp"
#include "visibility/blocking.hpp"
#include "visibility/close_set.hpp"
#include "visibility/mesh_order.hpp"
#include "visibility/projection.hpp"

namespace jet {

/// Ray from the moved source of a ray to a point outside the surface, within the rays' bounds.
struct WindingRay {
  blocking::Ray ray{};
  double u = 0.0, v = 0.0;  // its slopes, or slope across and place along the line
};

/// The rays of a query, their bounds, and the nodes projected for them.
class RayBundle {
 public:
  void reserve(const OrderedMesh& mesh, std::size_t node_count, Way way);

  /// Says that the nodes may have moved. `displacement_bound`: see VisibilityQuery.
  void move_to(double displacement_bound);
  /// Makes one ray for each candidate.
  void ask(const Surface& surface, const RaySource& source, std::span<const int> candidates);

  /// Project the nodes near a frustum: the one for which the close set was chosen, or the one of the rays'
  /// targets. False if it is not known, or if no frame contains the nodes. Throw std::invalid_argument if a
  /// coordinate that they read is out of range, see VisibilityQuery.
  bool project_chosen();
  bool project_fresh();
  /// True if the examined elements include all that the rays can meet. Rays now in `upstream` are exempt,
  /// unless there are too many.
  bool accept(const PatchesFound& found, std::span<const int> patches, std::span<const int> not_downstream);
  /// Works without bounds of the rays: only the `size` of the projection is known. Throws as project().
  void do_without();

  const AskedRays& asked() const { return asked_; }
  const WindingRay& winding() const { return winding_; }
  const Projection& projection() const { return projection_; }
  Projection& projection() { return projection_; }

  /// True if the element's nodes are projected. Rays cannot meet other elements.
  bool knows(int place) const {
    return !close_.range().any() || close_.has(static_cast<std::size_t>(place / 8));
  }

  /// Lists the patches, ascending, that rays or the winding ray can meet. `out` has room for all.
  std::span<const int> find_patches(const OrderedMesh& mesh, std::span<int> out) const;

  /// Places whose rays have no length or do not run downstream; they are not in the bounds.
  std::vector<int> upstream;

 private:
  /// Motion of the nodes [m]: the displacement bound, and its growth since the last query. And that of the
  /// frame, seen from which nodes move, since then.
  struct Motion {
    double bound = kMotionUnknown, step = kMotionUnknown, frame_step = 0.0;
  };
  /// The frame of the last query.
  struct Place {
    Frame frame;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double extent = 0.0;  // [m] of nodes from there
  };

  bool project_targets(bool rescaled);
  bool project_close(const Frustum& bounds);
  bool choose_close(const Frustum& wide, bool rescaled);

  AskedRays asked_;
  Projection projection_;
  Frustum bounds_{};  // of the rays
  WindingRay winding_;
  Motion motion_;
  std::optional<Place> last_;
  CloseSet close_;
  bool fresh_ = false;
};

}  // namespace jet
