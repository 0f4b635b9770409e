// SPDX-License-Identifier: Apache-2.0
// Surfaces as a C caller has them, and what the tests of the border share.
#pragma once

#include <gasjet.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace border_test {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Rows of three.
struct Mesh {
  std::vector<double> nodes;
  std::vector<int32_t> triangles;
  int64_t node_count() const { return static_cast<int64_t>(nodes.size()) / 3; }
  int64_t triangle_count() const { return static_cast<int64_t>(triangles.size()) / 3; }
};

/// A box of n x n squares a side, each in two triangles; outward, closed, nodes on [low, low + size].
Mesh box(int n, double size, double low = 0.0);

/// The same nodes in another layout, what lies between them NaN.
struct Layout {
  std::vector<double> data;
  std::ptrdiff_t first;
  int64_t stride[2];
};
std::vector<Layout> layouts_of(const std::vector<double>& rows);

/// A handle that is freed at the end.
class Handle {
 public:
  Handle() = default;
  ~Handle() {
    if (value == 0) return;
    EXPECT_EQ(gasjet_free(value), GASJET_OK);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  gasjet_handle value = 0;
};

#define EXPECT_OK(call) EXPECT_EQ(call, GASJET_OK) << gasjet_last_error()
#define ASSERT_OK(call) ASSERT_EQ(call, GASJET_OK) << gasjet_last_error()

/// A round jet along x out of the origin.
gasjet_jet_model round_jet();
gasjet_pendulum_model pendulum();
/// A body that turns about all its axes, 4.5 kg, with principal moments 0.016, 0.021 and 0.026 kg m2.
gasjet_rigid_body_model tumbling_body();
/// A mass of 6.8 kg that comes along -x at 9 m/s, with a spring, a stop and dampers, under gravity.
gasjet_rigid_body_model guided_body();

}  // namespace border_test
