// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "coupling/sphere_contact.hpp"

namespace coupling::detail {

// Upper bound of the largest distance [m] between the columns of the two, at most sqrt(3) times that
// distance. NaN if a coordinate is not finite.
double largest_motion(const Nodes& nodes, const Eigen::Matrix3Xd& old);

// Forgets all gaps: the next search examines every group.
void forget_gaps(ContactState& state);

// One level of a skin, with the impactor that searches it.
struct Search {
  const Eigen::Matrix3Xi& triangles;
  const ElementGroups& groups;
  const Nodes& nodes;
  const Impactor& impactor;
  ContactState& state;  // centre and displacement_bound belong to this level

  // Examines the elements that the motion may have brought to the impactor. Lists the overlapping ones in
  // state.near, ascending, and sets state.gap. Throws ContactError if a coordinate is not finite.
  void find_near_elements();
  // Raises state.gap if possible: above state.ahead if the true gap allows, and to at least half of the true
  // gap.
  void settle_gap();

 private:
  double exact_gap(int element) const;
  double look(int element, double wanted);
  template <class Found>
  void look_at_group(std::size_t g, double wanted, Found&& found);
};

// Tests the centre's path against the whole skin (K.15), from state.nodes to `nodes`. Throws ContactError.
void sweep_centre_path(const Eigen::Matrix3Xi& triangles, double radius, const Nodes& nodes,
                       const Eigen::Vector3d& next_centre, ContactState& state);

}  // namespace coupling::detail
