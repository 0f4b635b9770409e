// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "bodies.hpp"
#include "coupling/sphere_contact.hpp"

namespace coupling::detail {

inline constexpr double kRounding = 1.0 + 1e-12;  // margin for elements that only round-off puts out of reach
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Share of the impactor's size; accumulated rounding of the positions stays far below it.
inline constexpr double kShare = 1e-9;
// A box is good enough if its gap is at least this share of its size.
inline constexpr double kWorthwhile = 0.05;

// Lower bound of the gap between the impactor and an object, and the size of that object [m].
struct Bound {
  double gap, size;
};

// Bound by the circle about an element's centroid through its farthest corner.
template <class Body>
Bound circle_bound(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                   const Eigen::Vector3d& centre, const Body& impactor) {
  const Eigen::Vector3d first = b - a, second = c - a;
  const double f2 = first.squaredNorm(), fs = 2.0 * first.dot(second), s2 = second.squaredNorm();
  const double reach2 = std::max(f2 + s2 + fs, std::max(4.0 * f2 + s2 - 2.0 * fs, 4.0 * s2 + f2 - 2.0 * fs));
  const double circle = kRounding * std::sqrt(reach2) / 3.0;
  const Eigen::Vector3d middle = (a - centre) + (first + second) / 3.0;
  return {impactor.distance_to_ball(middle, circle), circle};
}

// Bound by the box around nodes.
template <class Body>
Bound box_bound(const Nodes& nodes, const int* begin, const int* end, const Eigen::Vector3d& centre,
                const Body& impactor) {
  Eigen::Array3d low = Eigen::Array3d::Constant(kInfinity), high = -low, sum = Eigen::Array3d::Zero();
  for (const int* node = begin; node != end; ++node) {
    const Eigen::Array3d x = nodes.col(*node);
    low = low.min(x);
    high = high.max(x);
    sum += x;
  }
  // A minimum ignores NaN, a sum does not.
  if (!std::isfinite(sum.sum())) return {std::numeric_limits<double>::quiet_NaN(), 0.0};
  const double gap = impactor.distance_to_box(low - centre.array(), high - centre.array());
  return {gap - kShare * impactor.size(), (high - low).maxCoeff()};
}

// Upper bound of the largest distance [m] between the columns of the two, at most sqrt(3) times that
// distance. NaN if a coordinate is not finite.
double largest_motion(const Nodes& nodes, const Eigen::Matrix3Xd& old);

// Forgets all gaps: the next search examines every group.
void forget_gaps(ContactState& state);

// Least of the values, in four independent chains, which the processor can overlap.
double least_of(const std::vector<double>& values);

// One level of a skin, with the impactor that searches it.
template <class Body>
struct Search {
  const Eigen::Matrix3Xi& triangles;
  const ElementGroups& groups;
  const Nodes& nodes;
  const Body& impactor;
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

template <class Body>
double Search<Body>::exact_gap(int element) const {
  const auto corner = triangles.col(element);
  Eigen::Matrix3d corners;
  for (int i = 0; i < 3; ++i) corners.col(i) = nodes.col(corner[i]) - state.centre;
  return impactor.distance_to_triangle(corners) - kShare * impactor.size();
}

// Gap of the element: exact if it is less than the element's own size or `wanted`, otherwise a bound at a
// fifth of the cost.
template <class Body>
double Search<Body>::look(int element, double wanted) {
  ++state.looks;
  const auto corner = triangles.col(element);
  const Bound bound =
      circle_bound(nodes.col(corner[0]), nodes.col(corner[1]), nodes.col(corner[2]), state.centre, impactor);
  return bound.gap > std::max(bound.size, wanted) ? bound.gap : exact_gap(element);
}

// Calls found(element, gap) for the examined elements: those that may be nearer than `wanted`.
template <class Body>
template <class Found>
void Search<Body>::look_at_group(std::size_t g, double wanted, Found&& found) {
  const Bound box = box_bound(nodes, groups.nodes.data() + groups.first_node[g],
                              groups.nodes.data() + groups.first_node[g + 1], state.centre, impactor);
  if (!std::isfinite(box.gap)) throw ContactError("contact: a node or the impactor's centre is not finite");
  state.group_slack[g] = state.displacement_bound + box.gap;
  if (box.gap > std::max(kWorthwhile * box.size, wanted)) return;
  const std::size_t first = g * ElementGroups::kSize,
                    last = std::min(first + ElementGroups::kSize, state.slack.size());
  const double needed = state.displacement_bound + wanted;
  double least = kInfinity;
  for (std::size_t k = first; k < last; ++k) {
    if (!(needed < state.slack[k])) {
      const double gap = look(groups.elements[k], wanted);
      state.slack[k] = state.displacement_bound + gap;
      found(groups.elements[k], gap);
    }
    least = std::min(least, state.slack[k]);
  }
  state.group_slack[g] = std::max(state.group_slack[g], least);
}

template <class Body>
void Search<Body>::find_near_elements() {
  state.near.clear();
  const double displacement_bound = state.displacement_bound;
  for (std::size_t g = 0; g < groups.count(); ++g)
    if (!(displacement_bound < state.group_slack[g]))
      look_at_group(g, 0.0, [&](int element, double gap) {
        if (!(gap > 0.0)) state.near.push_back(element);
      });
  std::sort(state.near.begin(), state.near.end());
  state.gap = least_of(state.group_slack);
}

template <class Body>
void Search<Body>::settle_gap() {
  if (!state.near.empty()) return;
  // While an element is within the motion ahead, every level needs a search. Usually it is the element of the
  // last level.
  double least = exact_gap(state.nearest);
  const auto take = [&](int element, double gap) {
    if (!(gap < least)) return;
    const double exact = exact_gap(element);  // the gap may be a lower bound
    if (exact < least) state.nearest = element;
    least = std::min(least, exact);
  };
  const auto enough = [&](double slack) {
    return !(least > state.ahead) || state.displacement_bound + std::max(state.ahead, 0.5 * least) < slack;
  };
  if (enough(state.gap)) return;
  // The group that seems nearest limits the search in the others.
  const auto first = std::min_element(state.group_slack.begin(), state.group_slack.end());
  look_at_group(static_cast<std::size_t>(first - state.group_slack.begin()), state.ahead, take);
  for (std::size_t g = 0; g < groups.count(); ++g)
    if (!enough(state.group_slack[g])) look_at_group(g, std::max(state.ahead, 0.5 * least), take);
  state.gap = least_of(state.group_slack);
}

}  // namespace coupling::detail
