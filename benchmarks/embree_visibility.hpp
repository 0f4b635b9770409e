// SPDX-License-Identifier: Apache-2.0
// Embree as its users would take it for hidden elements: single precision, hierarchy refitted at every step.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "jet/visibility.hpp"

namespace benchmarks {

class EmbreeVisibility {
 public:
  /// Null and attachment elements are left out: they never block.
  EmbreeVisibility(const Eigen::Matrix3Xi& triangles, int node_count, const jet::SurfaceRoles& roles);
  ~EmbreeVisibility();
  EmbreeVisibility(const EmbreeVisibility&) = delete;
  EmbreeVisibility& operator=(const EmbreeVisibility&) = delete;

  void refit(const Eigen::Matrix3Xd& nodes);
  /// lit[k] = 1 where candidates[k] faces its source and nothing is hit between 1e-4 and 1 - 1e-4 of the way:
  /// single precision cannot tell a blocker from the target nearer than that.
  void query(const jet::RaySource& source, const Eigen::Matrix3Xd& area_vectors,
             const Eigen::Matrix3Xd& centroids, std::span<const int> candidates, std::span<std::uint8_t> lit);

 private:
  struct Impl;
  Impl* impl_;
};

}  // namespace benchmarks
