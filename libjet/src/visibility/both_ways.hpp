// SPDX-License-Identifier: Apache-2.0
// The fast route for rays of all directions: those that run downstream, and, if they are many, those that run
// upstream by themselves, in a frame turned round. The axis by which a source on the surface is moved stays
// the same, so the answers are those of one query.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "visibility/fast.hpp"

namespace jet {

class BothWays {
 public:
  /// Allocates for rays downstream. Those upstream allocate at the first query that has many.
  void prepare(std::shared_ptr<const OrderedMesh> mesh, std::size_t node_count, bool closed);
  /// See FastRoute.
  void move_to(double displacement_bound);
  VisibilityCounters query(const Surface& surface, const RaySource& source, std::span<const int> candidates,
                           std::span<std::uint8_t> lit);

 private:
  /// Candidates of one way, and their places among those of the query.
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
