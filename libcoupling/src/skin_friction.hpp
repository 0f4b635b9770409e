// SPDX-License-Identifier: Apache-2.0
// Friction between layers of a skin: (K.16) and (K.17) for nodes that touch elements.
#pragma once
#include <array>
#include <vector>

#include "skin_forces.hpp"

namespace coupling::detail {

/// What a node has on one of its sides.
struct Bristle {
  int triangle = -1;                                  // of the layer; -1: none
  Eigen::Vector3d stretch = Eigen::Vector3d::Zero();  // [m] tangential, of the node against the element
};

/// The bristles of a run, for each node one on each of its sides.
class SkinFriction {
 public:
  explicit SkinFriction(const SkinParts& parts);
  /// Adds the friction of one level. `now` and `before` (3 x N) [m] are the nodes of this level and the last.
  void add(const std::vector<Touch>& touches, const SkinParts& parts, const SkinLimits& limits,
           const Eigen::Matrix3Xd& now, const Eigen::Matrix3Xd& before, NodalForces& forces,
           SkinContactResult& result);
  /// Those of the last level, to be read and set.
  std::vector<SkinBristle> bristles() const;
  void set(const std::vector<SkinBristle>& bristles);

 private:
  using Sides = std::array<Bristle, 2>;
  Bristle take(int node, int triangle, const SkinParts& parts);
  void choose(const Touch& touch, const SkinParts& parts);
  Bristle hold(const Touch& touch, double depth, const SkinParts& parts, const Eigen::Matrix3Xd& now,
               const Eigen::Matrix3Xd& before, NodalForces& forces, SkinContactResult& result);
  double release(const SkinParts& parts);

  std::vector<Sides> now_, before_;                   // by node
  std::vector<std::array<const Touch*, 2>> closest_;  // by node; null between calls
  std::vector<int> held_, held_before_;               // nodes that have some
};

}  // namespace coupling::detail
