// SPDX-License-Identifier: Apache-2.0
// The fast route for rays of all directions. Rays that run upstream, if they are many, are handled apart, in
// a reversed frame. A source on the surface is moved along the same axis in both, so the answers equal those
// of one query.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "visibility/fast.hpp"

namespace jet {

class BothWays {
 public:
  /// Allocates for downstream rays. The first query with many upstream rays allocates for these.
  void prepare(std::shared_ptr<const OrderedMesh> mesh, std::size_t node_count, bool closed);
  /// See FastRoute.
  void move_to(double displacement_bound);
  VisibilityCounters query(const Surface& surface, const RaySource& source, std::span<const int> candidates,
                           std::span<std::uint8_t> lit);

 private:
  /// Candidates of one direction, and their places among all candidates.
  struct Part {
    std::vector<int> elements;
    std::vector<std::size_t> places;
    std::vector<std::uint8_t> lit;
  };

  void split(const Surface& surface, const RaySource& source, std::span<const int> candidates);
  FastRoute& upstream_route();

  std::shared_ptr<const OrderedMesh> mesh_;
  std::size_t node_count_ = 0;
  bool closed_ = false;
  FastRoute downstream_;
  std::unique_ptr<FastRoute> upstream_;
  Part parts_[2];               // downstream, upstream
  std::vector<double> depths_;  // workspace
};

}  // namespace jet
