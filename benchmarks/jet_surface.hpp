// SPDX-License-Identifier: Apache-2.0
// The skin of the paper's scene with each element cut into n^2 pieces: the same shape with more elements.
#pragma once

#include <Eigen/Core>
#include <ctime>

#include "jet_states.hpp"
#include "membrane/bag_model.hpp"
#include "membrane/bag_state.hpp"

namespace benchmarks {

/// Microseconds of processor time that f() takes, of all threads: a machine that others use waits, too.
template <class F>
double microseconds(F&& f) {
  const auto now = [] {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e6 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_nsec);
  };
  const double start = now();
  f();
  return now() - start;
}

class JetSurface {
 public:
  JetSurface(const driver::Scene& scene, int n);

  /// Puts the nodes where the skin is at state.time + delay [s], at the velocity of the state.
  void place(const JetState& state, double delay);

  int element_count() const { return static_cast<int>(triangles().cols()); }
  const Eigen::Matrix3Xi& triangles() const { return pieces_.triangles(); }
  const jet::SurfaceRoles& roles() const { return roles_; }
  const Eigen::Matrix3Xd& nodes() const { return nodes_; }
  const Eigen::Matrix3Xd& area_vectors() const { return area_vectors_; }
  const Eigen::Matrix3Xd& centroids() const { return centroids_; }

 private:
  jet::Subdivision pieces_;
  jet::SurfaceRoles roles_;
  Eigen::Matrix3Xi coarse_;
  Eigen::Matrix3Xd nodes_, area_vectors_, centroids_;
};

/// Time of a step's stages in the bag alone [us], the smallest of some rounds.
struct BagTimes {
  double surface, forces, advance;
  double total() const { return surface + forces + advance; }
};

/// The skin's fabric on the surface's elements as they are placed; panels without fabric get it, too.
BagTimes time_bag(const driver::Scene& scene, const JetSurface& surface);

}  // namespace benchmarks
