// SPDX-License-Identifier: Apache-2.0
// The pendulum's acceleration over a run, for filters after its end.
#pragma once

#include <string>
#include <vector>

#include "engine/channel_filter.hpp"
#include "engine/scene.hpp"
#include "engine/state.hpp"

namespace driver {

/// Acceleration of the centre of gravity at every step of a run, and which steps are rows of the history.
class AccelerationRecord {
 public:
  /// Called like a LevelSink. Precondition: the scene has a pendulum.
  void add(bool recorded, const State& now);
  const VectorSignal& signal() const { return signal_; }
  /// [m/s2] its magnitude at the rows, filtered by a channel class; zero for a run of one step.
  std::vector<double> at_rows(int channel_class) const;
  /// Lines of a CSV file: header, then the times of the rows and the magnitude filtered by each class.
  std::string table(const std::vector<int>& classes) const;

 private:
  VectorSignal signal_;
  bool of_pendulum_ = true;
  std::vector<std::size_t> rows_;  // positions of the rows in the signal
  std::vector<double> times_;      // [s] of the rows
  double level_ = 0.0;             // [s] time of the next step
};

}  // namespace driver
