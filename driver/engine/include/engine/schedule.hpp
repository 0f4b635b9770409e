// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace driver {

/// Levels to record: the first at or past each multiple of the interval; none if that is 0.
class Schedule {
 public:
  explicit Schedule(double interval) : interval_(interval) {}
  /// Whether the level at `time` [s] is one. Asked once for each level.
  bool due(double time) {
    // Multiples meet the step's times to round-off only.
    if (interval_ <= 0.0 || time < next_ * interval_ * (1.0 - 1e-12)) return false;
    next_ = std::floor(time / interval_ * (1.0 + 1e-12)) + 1.0;
    return true;
  }

 private:
  double interval_;    // [s]
  double next_ = 0.0;  // multiple that is due next
};

}  // namespace driver
