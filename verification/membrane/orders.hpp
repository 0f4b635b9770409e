// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace scenes {

// Errors of meshes (or steps) each twice as fine as the one before: the order between neighbours lies in the
// band, and no error changes sign. Errors and orders are recorded under `name` (--gtest_output=json).
inline void expect_order(const std::string& name, const std::vector<double>& error, double low, double high) {
  std::ostringstream record;
  record.precision(4);
  record << error[0];
  for (std::size_t i = 1; i < error.size(); ++i) {
    const double order = std::log2(error[i - 1] / error[i]);
    record << " -> " << error[i] << " (" << order << ")";
    EXPECT_GT(order, low) << name << " " << i;
    EXPECT_LT(order, high) << name << " " << i;
  }
  testing::Test::RecordProperty(name, record.str());
}

}  // namespace scenes
