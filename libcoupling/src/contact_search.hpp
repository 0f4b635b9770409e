// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "coupling/sphere_contact.hpp"

namespace coupling::detail {

// An upper bound (at most sqrt(3) times) of the largest distance [m] between columns of the two; NaN when a
// coordinate is not finite.
double largest_motion(const Nodes& nodes, const Eigen::Matrix3Xd& old);

// Forgets what is known of the gaps: the next search looks at every group.
void forget_gaps(ContactState& state);

// One level of a skin, and the sphere that searches it.
struct Search {
  const Eigen::Matrix3Xi& triangles;
  const ElementGroups& groups;
  const Nodes& nodes;
  double radius;
  ContactState& state;  // with the level's `centre` and `displacement_bound`

  // Looks at what the motion may have brought to the sphere and lists the elements that overlap it in
  // state.near, ascending; state.gap follows. Throws ContactError where a coordinate is not finite.
  void find_near_elements();
  // Makes state.gap, if it is less, more than state.ahead where so much is free, and at least half of what is
  // free.
  void settle_gap();

 private:
  double exact_gap(int element) const;
  double look(int element, double wanted);
  template <class Found>
  void look_at_group(std::size_t g, double wanted, Found&& found);
};

// (K.15) for the whole skin, from state.nodes to `nodes`. Throws ContactError.
void sweep_centre_path(const Eigen::Matrix3Xi& triangles, double radius, const Nodes& nodes,
                       const Eigen::Vector3d& next_centre, ContactState& state);

}  // namespace coupling::detail
