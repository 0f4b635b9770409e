// SPDX-License-Identifier: Apache-2.0
// Looks at parts of a skin: their distance, and whether they met in the last step.
#pragma once
#include <vector>

#include "skin_limits.hpp"
#include "skin_pair.hpp"

namespace coupling::detail {

/// Two parts closer than the reach of their kind, now or ahead.
struct Touch {
  PartPair pair;
  Closest closest;
  double ahead;  // [m] distance after kAhead steps like the last one
};

/// Steps like the last one that are looked ahead.
inline constexpr double kAhead = 1.5;

/// The looks of one run.
struct SkinLooks {
  /// Goes on to the next level, without touches.
  void advance();
  /// Looks at a pair of parts on their way from `before` to `now` (3 x N) [m], at `most` [m] relative to each
  /// other. Returns their distance [m].
  double look(const SkinParts& parts, const SkinLimits& limits, const PartPair& pair, double most,
              const Nodes& before, const Nodes& now);
  /// Looks at each pair of parts that are no neighbours, in the order of the search.
  void look_at_all(const SkinParts& parts, const SkinLimits& limits, const Nodes& before, const Nodes& now);

  std::vector<Touch> touches;  // of the last level, and those ahead
  double approach = 0.0;       // [-] as in SkinContactResult
  long level = -1;             // the last one
  long looks = 0, sweeps = 0;  // distances computed, paths tested
};

}  // namespace coupling::detail
