// SPDX-License-Identifier: Apache-2.0
#include "results/acceleration_record.hpp"

#include <fmt/format.h>

namespace driver {

void AccelerationRecord::add(bool recorded, const State& now) {
  if (recorded) {
    rows_.push_back(signal_.time.size());
    times_.push_back(now.time);
  }
  signal_.time.push_back(level_);
  if (now.pendulum) {
    signal_.first.push_back(now.pendulum->acceleration.tangential);
    signal_.second.push_back(now.pendulum->acceleration.radial);
  } else {
    of_pendulum_ = false;
    const Eigen::Vector3d& a = now.body->acceleration;
    signal_.first.push_back(a.x());
    signal_.second.push_back(a.y());
    signal_.third.push_back(a.z());
  }
  level_ += now.step.after;
}

std::vector<double> AccelerationRecord::at_rows(int channel_class) const {
  if (signal_.time.size() < 2) return std::vector<double>(rows_.size());
  const std::vector<double> filtered = filtered_resultant(signal_, channel_class);
  std::vector<double> values;
  for (const std::size_t row : rows_) values.push_back(filtered[row]);
  return values;
}

std::string AccelerationRecord::table(const std::vector<int>& classes) const {
  std::vector<std::vector<double>> columns;
  std::string text = "time_s";
  for (const int channel_class : classes) {
    text += ',' + filtered_column(channel_class, of_pendulum_);
    columns.push_back(at_rows(channel_class));
  }
  for (std::size_t i = 0; i < times_.size(); ++i) {
    text += fmt::format("\n{}", times_[i]);
    for (const auto& column : columns) text += fmt::format(",{}", column[i]);
  }
  return text + '\n';
}

}  // namespace driver
