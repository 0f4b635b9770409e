// SPDX-License-Identifier: Apache-2.0
// A brick as impactor: its force on a flat skin is the closed form, forces are minus the derivative of the
// energy, and the gap is that of a face.
#include <cmath>
#include <cstdio>

#include "coupling/side.hpp"
#include "coupling/sphere_contact.hpp"

namespace {

constexpr double kRadius = 0.1, kLong = 0.12, kWide = 0.08, kDepth = 0.03, kStiffness = 1e6;
constexpr int kCells = 80;  // of a sheet of 0.8 m

struct Sheet {
  Eigen::Matrix3Xd nodes{3, (kCells + 1) * (kCells + 1)};
  Eigen::Matrix3Xi triangles{3, 2 * kCells* kCells};
  Sheet() {
    for (int i = 0; i <= kCells; ++i)
      for (int j = 0; j <= kCells; ++j)
        nodes.col(i * (kCells + 1) + j) << 0.01 * i - 0.4, 0.01 * j - 0.4, 0.0;
    for (int i = 0, e = 0; i < kCells; ++i)
      for (int j = 0; j < kCells; ++j) {
        const int a = i * (kCells + 1) + j, b = a + kCells + 1;
        triangles.col(e++) << a, b, b + 1;
        triangles.col(e++) << a, b + 1, a + 1;
      }
  }
};

// A face, four edges and the eighths of a sphere at the corners (K.52).
double plate_force() {
  const double h = kRadius - kDepth, w = std::sqrt(kRadius * kRadius - h * h), pi = 3.14159265358979323846;
  const double strip = kRadius * std::asinh(w / h) - w;
  return kStiffness *
         (4.0 * kLong * kWide * kDepth + 4.0 * (kLong + kWide) * h * strip + pi * kDepth * kDepth * h);
}

int failures = 0;
void expect_near(const char* what, double value, double expected, double tolerance) {
  if (std::abs(value - expected) <= tolerance) return;
  std::printf("%s: %.9g, expected %.9g within %.2g\n", what, value, expected, tolerance);
  ++failures;
}

}  // namespace

int main() {
  const Sheet sheet;
  const std::vector<double> masses(static_cast<std::size_t>(sheet.nodes.cols()), 1e-3);
  const coupling::Brick brick{{kLong, kWide, 0.05}, kRadius};
  const coupling::ContactModel model(sheet.triangles, sheet.nodes, masses, 10.0, {brick, kStiffness});
  coupling::Pose pose{{0.001, 0.002, 0.05 + kRadius - kDepth}};
  const auto evaluate = [&](const Eigen::Matrix3Xd& nodes, Eigen::Matrix3Xd& forces) {
    auto state = model.make_state();
    forces.setZero(3, nodes.cols());
    return model.evaluate(state, nodes, pose, forces);
  };
  Eigen::Matrix3Xd forces, ignored;
  const auto result = evaluate(sheet.nodes, forces);
  // Cells of a tenth of the radius: (0.01/3 / 0.07)^2 on the edges.
  expect_near("force", result.force.z(), plate_force(), 1e-3 * plate_force());
  expect_near("penetration", result.penetration, kDepth, 1e-12);

  pose.axes << 0.96, -0.28, 0.0, 0.28, 0.96, 0.0, 0.0, 0.0, 1.0;
  evaluate(sheet.nodes, forces);
  const int node = 40 * (kCells + 1) + 49;  // near an edge
  for (int axis = 0; axis < 3; ++axis) {
    constexpr double h = 1e-6;
    Eigen::Matrix3Xd moved = sheet.nodes;
    moved(axis, node) += h;
    const double above = evaluate(moved, ignored).energy;
    moved(axis, node) -= 2.0 * h;
    const double slope = (above - evaluate(moved, ignored).energy) / (2.0 * h);
    expect_near("force", forces(axis, node), -slope, 1e-6 * forces.col(node).norm());
  }
  if (!(forces.col(node).norm() > 0.1)) expect_near("force under the brick", 0.0, 1.0, 0.0);

  pose.centre.z() = 0.25;
  const double gap = coupling::smallest_gap(sheet.triangles, sheet.nodes, brick, pose).distance;
  expect_near("gap", gap, 0.25 - 0.05 - kRadius, 1e-12);
  return failures > 0;
}
