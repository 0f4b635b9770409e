// SPDX-License-Identifier: Apache-2.0
// Looks at parts of a skin: their distance, and whether they met in the last step.
#pragma once
#include <vector>

#include "skin_boxes.hpp"
#include "skin_gaps.hpp"
#include "skin_pair.hpp"

namespace coupling::detail {

/// Two parts closer than the reach of their kind.
struct Touch {
  PartPair pair;
  Closest closest;
  double ahead;  // [m] distance after kAhead steps like the last one
};

/// Steps like the last one that are looked ahead.
inline constexpr double kAhead = 1.5;

/// The looks of one run.
class SkinLooks {
 public:
  explicit SkinLooks(const SkinParts& parts);

  /// Goes on to the next level, without touches.
  void advance(const Nodes& nodes);
  /// A lower bound of the distance [m] of the parts of two groups, in these boxes. If they are the paths of
  /// the last step, it looks at all parts that may touch after a motion by `ahead` [m].
  double least_distance(const SkinParts& parts, SkinBoxes& boxes, int first, int second, double ahead);
  /// Looks at each pair of parts that are no neighbours, in the same order.
  void look_at_all(const SkinParts& parts);

  SkinBoxes paths;             // to the last level from the one before
  std::vector<Touch> touches;  // of the last level
  double approach = 0.0;       // [-] as in SkinContactResult
  long level = -1;             // the last one
  long looks = 0, sweeps = 0;  // distances computed, paths tested

 private:
  double look(const SkinParts& parts, const PartPair& pair);

  double far_;  // [m] parts that are farther apart need not be told apart
  std::vector<NearParts> found_;
};

}  // namespace coupling::detail
