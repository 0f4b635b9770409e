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

double least_of(const std::vector<double>& values) {
  double least[4] = {kInfinity, kInfinity, kInfinity, kInfinity};
  std::size_t i = 0;
  for (; i + 4 <= values.size(); i += 4)
    for (std::size_t strand = 0; strand < 4; ++strand)
      least[strand] = std::min(least[strand], values[i + strand]);
  for (; i < values.size(); ++i) least[0] = std::min(least[0], values[i]);
  return std::min(std::min(least[0], least[1]), std::min(least[2], least[3]));
}

void forget_gaps(ContactState& state) {
  std::fill(state.slack.begin(), state.slack.end(), -kInfinity);
  std::fill(state.group_slack.begin(), state.group_slack.end(), -kInfinity);
  state.displacement_bound = 0.0;
  state.nearest = 0;
}

// Largest motion of the skin past the sphere within a step, in radii. Ten times more would still be searched
// exactly.
static constexpr double most_radii = 1000.0;

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
      throw ContactError("contact: a node or the impactor's centre is not finite");
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
