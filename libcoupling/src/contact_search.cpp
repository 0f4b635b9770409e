// SPDX-License-Identifier: Apache-2.0
#include "contact_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "check.hpp"
#include "coupling/side.hpp"

namespace coupling::detail {

double largest_motion(const Nodes& nodes, const Eigen::Matrix3Xd& old) {
  // The maximum of each component gives a bound at most sqrt(3) above the largest length. The sums detect a
  // coordinate that is not finite, which a maximum ignores.
  Eigen::Array3d largest = Eigen::Array3d::Zero(), sum = Eigen::Array3d::Zero();
  for (Eigen::Index a = 0; a < nodes.cols(); ++a) {
    const Eigen::Array3d squared = (nodes.col(a) - old.col(a)).array().square();
    largest = largest.max(squared);
    sum += squared;
  }
  return std::isfinite(sum.sum()) ? std::sqrt(largest.sum()) : std::numeric_limits<double>::quiet_NaN();
}

namespace {

constexpr double kRounding = 1.0 + 1e-12;  // margin for elements that only round-off puts out of reach
constexpr double kUnknown = -std::numeric_limits<double>::infinity();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Share of the impactor's size; accumulated rounding of the positions stays far below it.
constexpr double kShare = 1e-9;
// A box is good enough if its gap is at least this share of its size.
constexpr double kWorthwhile = 0.05;

// Lower bound of the gap between the impactor and an object, and the size of that object [m].
struct Bound {
  double gap, size;
};

// Bound by the circle about an element's centroid through its farthest corner.
Bound circle_bound(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                   const Eigen::Vector3d& centre, const Impactor& impactor) {
  const Eigen::Vector3d first = b - a, second = c - a;
  const double f2 = first.squaredNorm(), fs = 2.0 * first.dot(second), s2 = second.squaredNorm();
  const double reach2 = std::max(f2 + s2 + fs, std::max(4.0 * f2 + s2 - 2.0 * fs, 4.0 * s2 + f2 - 2.0 * fs));
  const double circle = kRounding * std::sqrt(reach2) / 3.0;
  const Eigen::Vector3d middle = (a - centre) + (first + second) / 3.0;
  return {impactor.distance_to_ball(middle, circle), circle};
}

// Bound by the box around nodes.
Bound box_bound(const Nodes& nodes, const int* begin, const int* end, const Eigen::Vector3d& centre,
                const Impactor& impactor) {
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

// Minimum in four independent chains, which the processor can overlap.
double least_of(const std::vector<double>& values) {
  double least[4] = {kInfinity, kInfinity, kInfinity, kInfinity};
  std::size_t i = 0;
  for (; i + 4 <= values.size(); i += 4)
    for (std::size_t strand = 0; strand < 4; ++strand)
      least[strand] = std::min(least[strand], values[i + strand]);
  for (; i < values.size(); ++i) least[0] = std::min(least[0], values[i]);
  return std::min(std::min(least[0], least[1]), std::min(least[2], least[3]));
}

}  // namespace

void forget_gaps(ContactState& state) {
  std::fill(state.slack.begin(), state.slack.end(), kUnknown);
  std::fill(state.group_slack.begin(), state.group_slack.end(), kUnknown);
  state.displacement_bound = 0.0;
  state.nearest = 0;
}

double Search::exact_gap(int element) const {
  const auto corner = triangles.col(element);
  return impactor.distance_to_triangle(nodes.col(corner[0]) - state.centre,
                                       nodes.col(corner[1]) - state.centre,
                                       nodes.col(corner[2]) - state.centre) -
         kShare * impactor.size();
}

// Gap of the element: exact if it is less than the element's own size or `wanted`, otherwise a bound at a
// fifth of the cost.
double Search::look(int element, double wanted) {
  ++state.looks;
  const auto corner = triangles.col(element);
  const Bound bound =
      circle_bound(nodes.col(corner[0]), nodes.col(corner[1]), nodes.col(corner[2]), state.centre, impactor);
  return bound.gap > std::max(bound.size, wanted) ? bound.gap : exact_gap(element);
}

// Calls found(element, gap) for the examined elements: those that may be nearer than `wanted`.
template <class Found>
void Search::look_at_group(std::size_t g, double wanted, Found&& found) {
  const Bound box = box_bound(nodes, groups.nodes.data() + groups.first_node[g],
                              groups.nodes.data() + groups.first_node[g + 1], state.centre, impactor);
  if (!std::isfinite(box.gap)) throw ContactError("contact: a node or the sphere's centre is not finite");
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

void Search::find_near_elements() {
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

void Search::settle_gap() {
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

// Largest motion of the skin past the sphere within a step, in radii. Ten times more would still be searched
// exactly.
constexpr double most_radii = 1000.0;

void sweep_centre_path(const Eigen::Matrix3Xi& triangles, double radius, const Nodes& nodes,
                       const Eigen::Vector3d& next_centre, ContactState& state) {
  ++state.sweeps;
  for (Eigen::Index e = 0; e < triangles.cols(); ++e) {
    Eigen::Matrix3d start, end;
    for (int i = 0; i < 3; ++i) {
      start.col(i) = state.nodes.col(triangles(i, e)) - state.centre;
      end.col(i) = nodes.col(triangles(i, e)) - next_centre;
    }
    if (!start.allFinite() || !end.allFinite())
      throw ContactError("contact: a node or the sphere's centre is not finite");
    if (const double motion = (end - start).colwise().norm().maxCoeff(); !(motion <= most_radii * radius))
      throw ContactError("contact: element " + std::to_string(e) + " moves by " + text(motion) +
                         " m past the sphere's centre within one step, the limit is " +
                         text(most_radii * radius) + " m");
    // A centre this close to the skin is far beyond the allowed penetration, on either side.
    if (path_meets_triangle(start, end, 0.01 * radius))
      throw PenetrationError("contact: the sphere's centre crossed the skin at element " + std::to_string(e) +
                                 " within one step",
                             static_cast<int>(e));
  }
}

}  // namespace coupling::detail
