// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "coupling/sphere_contact.hpp"

namespace coupling::detail {

// Copies `from` into `to` and returns an upper bound (at most sqrt(3) times) of the largest distance [m] of a
// column from that of `old`; NaN when a coordinate is not finite.
double copy_and_measure_motion(const Nodes& from, const Eigen::Matrix3Xd& old, Eigen::Matrix3Xd& to);

// No more than what is between a sphere of that radius about `point` and the element [m]: up to the circle
// about the centroid that holds the corners. Positive only if they do not touch.
double gap_bound(const Eigen::Matrix3Xi& triangles, const Eigen::Matrix3Xd& nodes, int element,
                 const Eigen::Vector3d& point, double radius);

// Rebuilds state.near and state.reach for state.nodes and state.centre: every element off the list is at
// least radius + reach away, reach >= 2 radius.
void search_near_elements(const Eigen::Matrix3Xi& triangles, double radius, ContactState& state);

// Motion since the search at which the sphere may first touch: exact distances to the elements on the list,
// state.reach for those off it.
double reach_of_gap(const Eigen::Matrix3Xi& triangles, double radius, const ContactState& state);

// (K.15) for the whole skin, from state.nodes to state.next_nodes. Throws ContactError.
void sweep_centre_path(const Eigen::Matrix3Xi& triangles, double radius, const Eigen::Vector3d& next_centre,
                       ContactState& state);

}  // namespace coupling::detail
