// SPDX-License-Identifier: Apache-2.0
#include "weave_direction.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <elementary/trigonometric.hpp>
#include <numbers>

namespace driver::imported {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

struct Side {
  Eigen::Vector3d along, normal;
  double area;
};

std::vector<Side> first_sides(const BagDeck& bag, const std::string& panel, double beta) {
  const auto at = [&](long node) -> Eigen::Vector3d {
    const auto found = bag.reference.find(node);
    if (found != bag.reference.end()) return found->second;
    const auto start = bag.nodes.find(node);
    return start != bag.nodes.end() ? start->second : Eigen::Vector3d::Zero();
  };
  std::vector<Side> sides;
  for (const Facet& facet : bag.facets) {
    if (facet.panel != panel || facet.nodes.size() < 3) continue;
    const Eigen::Vector3d a = at(facet.nodes[0]), b = at(facet.nodes[1]), c = at(facet.nodes[2]);
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    const double twice = normal.norm(), length = (b - a).norm();
    if (!(twice > 0.0) || !(length > 0.0)) continue;
    const Eigen::Vector3d n = normal / twice, x = (b - a) / length;
    const double angle = beta * degree;
    sides.push_back({elementary::cos(angle) * x + elementary::sin(angle) * n.cross(x), n, 0.5 * twice});
  }
  return sides;
}

}  // namespace

WarpDirection mean_direction(const BagDeck& bag, const std::string& panel, double beta) {
  const auto sides = first_sides(bag, panel, beta);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Side& side : sides) sum += side.area * side.along * side.along.transpose();
  if (sides.empty()) return {Eigen::Vector3d::UnitX(), 0.0};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(sum);
  const Eigen::Vector3d along = axes.eigenvectors().col(2);
  double squares = 0.0, area = 0.0;
  for (const Side& side : sides) {
    const Eigen::Vector3d in_plane = along - along.dot(side.normal) * side.normal;
    const double length = in_plane.norm();
    const double cosine = length > 0.0 ? std::min(1.0, std::abs(in_plane.dot(side.along)) / length) : 0.0;
    const double angle = elementary::atan2(std::sqrt(1.0 - cosine * cosine), cosine) / degree;
    squares += side.area * angle * angle;
    area += side.area;
  }
  return {along, std::sqrt(squares / area)};
}

Knots as_stress_curve(const Knots& knots, ImportReport& report) {
  constexpr std::size_t most = 64;
  Knots curve{{0.0, 0.0}};
  std::size_t dropped = 0;
  for (const auto& knot : knots) {
    if (knot[0] == 0.0 && knot[1] == 0.0) continue;
    const bool rises = knot[0] > curve.back()[0] && knot[1] > curve.back()[1];
    if (rises)
      curve.push_back(knot);
    else
      ++dropped;
  }
  if (dropped > 0)
    report.note(fmt::format("{} points of a curve of stress that do not rise are left out", dropped));
  if (curve.size() <= most) return curve;
  report.note(fmt::format("a curve of stress has {} points, allowed: {}: every so many are left out",
                          curve.size(), most));
  Knots thinned;
  for (std::size_t i = 0; i < most; ++i) thinned.push_back(curve[i * (curve.size() - 1) / (most - 1)]);
  return thinned;
}

}  // namespace driver::imported
