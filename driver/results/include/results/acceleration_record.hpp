// SPDX-License-Identifier: Apache-2.0
// The pendulum's acceleration over a run, for what is filtered behind it.
#pragma once

#include <string>
#include <vector>

#include "engine/channel_filter.hpp"
#include "engine/scene.hpp"
#include "engine/state.hpp"

namespace driver {

/// Acceleration of the centre of gravity at every step of a run, and which of the steps are rows of its
/// history.
class AccelerationRecord {
 public:
  /// As a LevelSink is called; the scene has a pendulum.
  void add(bool recorded, const State& now);
  const PlanarSignal& signal() const { return signal_; }
  /// [m/s2] Its size behind a channel class, at the rows; zero of a run of one step.
  std::vector<double> at_rows(int channel_class) const;
  /// Lines of a CSV file: header, then times of the rows and the size behind each class.
  std::string table(const std::vector<int>& classes) const;

 private:
  PlanarSignal signal_;
  std::vector<std::size_t> rows_;  // places in the signal
  std::vector<double> times_;      // [s] of the rows
  double level_ = 0.0;             // [s] time of the next step
};

}  // namespace driver
