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
  signal_.first.push_back(now.pendulum->acceleration.tangential);
  signal_.second.push_back(now.pendulum->acceleration.radial);
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
    text += ',' + filtered_column(channel_class);
    columns.push_back(at_rows(channel_class));
  }
  for (std::size_t i = 0; i < times_.size(); ++i) {
    text += fmt::format("\n{}", times_[i]);
    for (const auto& column : columns) text += fmt::format(",{}", column[i]);
  }
  return text + '\n';
}

}  // namespace driver
