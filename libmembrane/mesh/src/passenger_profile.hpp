// SPDX-License-Identifier: Apache-2.0
// Private to the passenger bag: the profile in the (x, z) plane and the grid of a side panel over it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "mesh/passenger_bag.hpp"

namespace mesh {

using ProfilePoint = Eigen::Vector2d;  // (x, z) [m]

/// Number of nodes round the profile, 2 (depth_cells + height_cells).
int rim_count(const PassengerBagOptions& options);

/// Arc length between neighbouring nodes of the profile [m].
double rim_step(const PassengerBagOptions& options);

/// Rim nodes of the profile, evenly spaced: up the back, forward along the top, down the front, back along
/// the bottom. The lower half mirrors the upper half bit for bit. Precondition: the options are checked.
std::vector<ProfilePoint> rim_points(const PassengerBagOptions& options);

/// Grid of a side panel, (depth_cells + 1) x (height_cells + 1) points. The rim is given. Each interior point
/// is the mean of its four neighbours, by Jacobi sweeps, which keep the mirror symmetry in z.
class SideGrid {
 public:
  explicit SideGrid(const PassengerBagOptions& options);

  /// Index along rim_points, or -1 in the interior.
  int rim_index(int i, int k) const;

  const ProfilePoint& operator()(int i, int k) const {
    return points_[static_cast<std::size_t>(i + k * (nx_ + 1))];
  }

  /// True if cell (i, k) takes the diagonal from (i, k) to (i + 1, k + 1). The diagonal with the larger
  /// smallest altitude is used; if both are nearly equal, diagonals alternate.
  bool rising_diagonal(int i, int k) const;

 private:
  ProfilePoint& at(int i, int k) { return points_[static_cast<std::size_t>(i + k * (nx_ + 1))]; }
  void smooth();

  int nx_, nz_;
  std::vector<ProfilePoint> points_;
};

}  // namespace mesh
