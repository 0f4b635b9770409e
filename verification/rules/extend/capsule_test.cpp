// SPDX-License-Identifier: Apache-2.0
// A capsule in place of the sphere: its energy on a flat skin is the sphere's and that of a cylinder, and the
// forces are minus the derivative of the energy.
#include <cmath>
#include <cstdio>

#include "coupling/sphere_contact.hpp"

namespace {

constexpr double kRadius = 0.1, kDepth = 0.03, kStiffness = 1e6;
constexpr int kCells = 80;  // of a sheet of 0.8 m

struct Sheet {
  Eigen::Matrix3Xd nodes{3, (kCells + 1) * (kCells + 1)};
  Eigen::Matrix3Xi triangles{3, 2 * kCells * kCells};
  Sheet() {
    for (int i = 0; i <= kCells; ++i)
      for (int j = 0; j <= kCells; ++j) nodes.col(i * (kCells + 1) + j) << 0.01 * i - 0.4, 0.01 * j - 0.4, 0.0;
    for (int i = 0, e = 0; i < kCells; ++i)
      for (int j = 0; j < kCells; ++j) {
        const int a = i * (kCells + 1) + j, b = a + kCells + 1;
        triangles.col(e++) << a, b, b + 1;
        triangles.col(e++) << a, b + 1, a + 1;
      }
  }
};

// int kappa d^2 / 2 over a line across the axis [J/m], or over the disc of a sphere [J].
double energy(bool disc) {
  constexpr int kSteps = 100000;
  const double height = kRadius - kDepth, half = std::sqrt(kRadius * kRadius - height * height);
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double x = half * (i + 0.5) / kSteps, depth = kRadius - std::hypot(x, height);
    sum += 0.5 * kStiffness * depth * depth * half / kSteps * (disc ? 2.0 * 3.14159265358979323846 * x : 2.0);
  }
  return sum;
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
  const coupling::ContactModel model(sheet.triangles, sheet.nodes, masses, 10.0, {kRadius, kStiffness});
  const Eigen::Vector3d centre(0.001, 0.002, kRadius - kDepth);
  const auto evaluate = [&](const Eigen::Matrix3Xd& nodes, Eigen::Matrix3Xd& forces) {
    auto state = model.make_state();
    forces.setZero(3, nodes.cols());
    return model.evaluate(state, nodes, centre, forces);
  };
  Eigen::Matrix3Xd forces, ignored;
  const auto result = evaluate(sheet.nodes, forces);
  const double expected = energy(true) + 2.0 * coupling::Impactor{kRadius}.half_length * energy(false);
  // Cells of a tenth of the radius, by points a third of that apart: (0.01/3 / 0.14)^2 of a smooth integrand.
  expect_near("energy", result.energy, expected, 1e-3 * expected);
  expect_near("penetration", result.penetration, kDepth, 1e-4);

  const int node = 40 * (kCells + 1) + 47;  // under the cylinder, 0.07 m from the middle
  for (int axis = 0; axis < 3; ++axis) {
    constexpr double h = 1e-6;
    Eigen::Matrix3Xd moved = sheet.nodes;
    moved(axis, node) += h;
    const double above = evaluate(moved, ignored).energy;
    moved(axis, node) -= 2.0 * h;
    const double slope = (above - evaluate(moved, ignored).energy) / (2.0 * h);
    expect_near("force", forces(axis, node), -slope, 1e-6 * forces.col(node).norm());
  }
  if (!(forces.col(node).norm() > 0.1)) expect_near("force under the cylinder", 0.0, 1.0, 0.0);

  auto state = model.make_state();
  model.evaluate(state, sheet.nodes, {0.0, 0.0, 0.2}, forces);
  expect_near("free gap", coupling::ContactModel::free_gap(state), 0.1, 0.06);
  return failures > 0;
}
