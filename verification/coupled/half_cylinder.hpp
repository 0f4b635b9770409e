// SPDX-License-Identifier: Apache-2.0
// Half a cylinder as in cases/half_cylinder.obj, with n cells around it.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

namespace coupled {

constexpr double kHalfRadius = 0.15, kHalfLength = 0.3;  // [m]

inline std::string half_cylinder(int n, int along) {
  std::string text;
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i <= n; ++i) {
      const double angle = std::numbers::pi * (static_cast<double>(i) / n - 0.5);
      text += fmt::format("v {} {} {}\n", i == 0 || i == n ? 0.0 : kHalfRadius * std::cos(angle),
                          kHalfRadius * std::sin(angle), kHalfLength * j / along);
    }
  const auto node = [&](int i, int j) { return 1 + i + j * (n + 1); };
  const auto face = [&](int a, int b, int c) { text += fmt::format("f {} {} {}\n", a, b, c); };
  text += "g skin\n";
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < n; ++i) {
      face(node(i, j), node(i + 1, j), node(i + 1, j + 1));
      face(node(i, j), node(i + 1, j + 1), node(i, j + 1));
    }
  text += "g wall\n";
  for (int j = 0; j < along; ++j) {
    face(node(n, j), node(0, j), node(0, j + 1));
    face(node(n, j), node(0, j + 1), node(n, j + 1));
  }
  text += "g ends\n";
  for (int i = 1; i < n; ++i) {
    face(node(0, 0), node(i + 1, 0), node(i, 0));
    face(node(0, along), node(i, along), node(i + 1, along));
  }
  return text;
}

}  // namespace coupled
