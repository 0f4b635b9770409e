// SPDX-License-Identifier: Apache-2.0
#include "results/impactor_picture.hpp"

#include <cmath>
#include <elementary/trigonometric.hpp>
#include <numbers>
#include <variant>
#include <vector>

namespace driver {
namespace {

constexpr int kAround = 32, kArc = 16;  // sections of a turn, and of a half turn

// Radius and height [m] of a point of the outline, from the lower pole to the upper one.
struct Outline {
  double radius, height;
};

// Half a turn of a rim: its lower half around one centre, its upper half around the other.
std::vector<Outline> rim(double rim_radius, double centre_radius, double half_length) {
  std::vector<Outline> outline;
  for (int i = 0; i <= kArc; ++i) {
    const double angle = std::numbers::pi * i / kArc;
    const double across = i == 0 || i == kArc ? 0.0 : rim_radius * elementary::sin(angle);
    outline.push_back({centre_radius + across,
                       (2 * i < kArc ? -half_length : half_length) - rim_radius * elementary::cos(angle)});
    // A rounded end has no flat part.
    if (2 * i == kArc && half_length > 0.0)
      outline.insert(outline.end() - 1, {outline.back().radius, -half_length});
  }
  if (centre_radius > 0.0) {
    outline.insert(outline.begin(), {0.0, outline.front().height});
    outline.push_back({0.0, outline.back().height});
  }
  return outline;
}

std::vector<Outline> outline_of(const coupling::Impactor& shape) {
  if (const auto* sphere = std::get_if<coupling::Sphere>(&shape)) return rim(sphere->radius, 0.0, 0.0);
  if (const auto* cylinder = std::get_if<coupling::Cylinder>(&shape))
    return rim(cylinder->radius, 0.0, cylinder->half_length);
  if (const auto* disc = std::get_if<coupling::Disc>(&shape)) return rim(disc->rim_radius, disc->radius, 0.0);
  return rim(1.0, 0.0, 0.0);  // an ellipsoid is a sphere, stretched
}

}  // namespace

mesh::Mesh impactor_picture(const coupling::Impactor& shape) {
  const std::vector<Outline> outline = outline_of(shape);
  const auto rows = static_cast<int>(outline.size()) - 2;
  mesh::Mesh picture;
  picture.nodes.resize(3, 2 + rows * kAround);
  picture.elements.resize(3, 2 * rows * kAround);
  picture.nodes.col(0) << 0.0, 0.0, outline.front().height;
  picture.nodes.col(1) << 0.0, 0.0, outline.back().height;
  const auto node = [](int row, int k) { return 2 + row * kAround + k % kAround; };
  Eigen::Index e = 0;
  for (int row = 0; row < rows; ++row)
    for (int k = 0; k < kAround; ++k) {
      const auto& [radius, height] = outline[static_cast<std::size_t>(row) + 1];
      const double angle = 2.0 * std::numbers::pi * k / kAround;
      picture.nodes.col(node(row, k)) << radius * elementary::cos(angle), radius * elementary::sin(angle),
          height;
      if (row == 0) picture.elements.col(e++) << 0, node(0, k + 1), node(0, k);
      if (row + 1 == rows) {
        picture.elements.col(e++) << 1, node(row, k), node(row, k + 1);
      } else {
        picture.elements.col(e++) << node(row, k), node(row, k + 1), node(row + 1, k + 1);
        picture.elements.col(e++) << node(row, k), node(row + 1, k + 1), node(row + 1, k);
      }
    }
  if (const auto* ellipsoid = std::get_if<coupling::Ellipsoid>(&shape))
    picture.nodes = ellipsoid->half_axes.asDiagonal() * picture.nodes;
  picture.panel.assign(static_cast<std::size_t>(picture.elements.cols()), 0);
  picture.panel_names = {"impactor"};
  return picture;
}

}  // namespace driver
