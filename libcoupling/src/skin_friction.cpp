// SPDX-License-Identifier: Apache-2.0
#include "skin_friction.hpp"

#include <algorithm>
#include <bit>

namespace coupling::detail {
namespace {

using Eigen::Vector3d;

// True for one of the elements that have the closest point, so that a layer counts once.
bool has_point(const Touch& touch, const SkinParts& parts) {
  const int triangle = touch.pair.second;
  const unsigned inside = touch.closest.inside;
  if (inside == 7) return true;
  if (std::popcount(inside) == 1) {
    const int corner = parts.triangles(std::countr_zero(inside), triangle);
    return parts.node_owner[static_cast<std::size_t>(corner)] == triangle;
  }
  const int edge = parts.triangle_edges(std::countr_zero(~inside & 7u), triangle);
  return parts.edge_owner[static_cast<std::size_t>(edge)] == triangle;
}

bool neighbours(const SkinParts& parts, int first, int second) {
  for (const int a : parts.triangles.col(first))
    if ((parts.triangles.col(second).array() == a).any()) return true;
  return false;
}

double weight_of(const SkinParts& parts, int node) {
  return parts.parameters.stiffness * parts.node_weight[static_cast<std::size_t>(node)];
}

}  // namespace

SkinFriction::SkinFriction(const SkinParts& parts) {
  if (!(parts.parameters.friction > 0.0)) return;
  now_.resize(parts.masses.size());
  before_.resize(parts.masses.size());
}

// The bristle of the last level on the same layer.
SkinBristle SkinFriction::take(int node, int triangle, const SkinParts& parts) {
  for (SkinBristle& old : before_[static_cast<std::size_t>(node)])
    if (old.triangle >= 0 && neighbours(parts, old.triangle, triangle)) {
      const SkinBristle taken = old;
      old.triangle = -1;
      return taken;
    }
  return {};
}

void SkinFriction::add(const Touch& touch, double depth, const SkinParts& parts, const Eigen::Matrix3Xd& now,
                       const Eigen::Matrix3Xd& before, NodalForces& forces, SkinContactResult& result) {
  const int node = touch.pair.first;
  Sides& sides = now_[static_cast<std::size_t>(node)];
  SkinBristle* const place = sides[0].triangle < 0 ? &sides[0] : sides[1].triangle < 0 ? &sides[1] : nullptr;
  if (!place) return;
  if (place == &sides[0]) held_.push_back(node);
  const Corners corners = corners_of(parts, touch.pair);
  Vector3d slip = Vector3d::Zero();
  for (int k = 0; k < 4; ++k)
    slip += touch.closest.weight[k] * (now.col(corners.node[k]) - before.col(corners.node[k]));
  const SkinBristle old = take(node, touch.pair.second, parts);
  const Vector3d& normal = touch.closest.normal;
  const Vector3d wanted = old.triangle < 0 ? Vector3d::Zero().eval() : (old.stretch + slip).eval();
  Vector3d stretch = wanted - normal.dot(wanted) * normal;
  const double most = parts.parameters.friction * depth, length = stretch.norm();
  if (length > most) stretch *= most / length;
  const double weight = weight_of(parts, node);
  for (int k = 0; k < 4; ++k) forces.col(corners.node[k]) -= touch.closest.weight[k] * weight * stretch;
  result.energy += 0.5 * weight * stretch.squaredNorm();
  result.friction_loss += 0.5 * weight * (old.stretch + stretch).dot(wanted - stretch);
  *place = {touch.pair.second, stretch};
}

// A bristle that has lost its layer loses its energy.
double SkinFriction::release(const SkinParts& parts) {
  double loss = 0.0;
  for (const int node : held_before_)
    for (SkinBristle& old : before_[static_cast<std::size_t>(node)]) {
      if (old.triangle >= 0) loss += 0.5 * weight_of(parts, node) * old.stretch.squaredNorm();
      old = {};
    }
  held_before_.clear();
  return loss;
}

void SkinFriction::add(const std::vector<Touch>& touches, const SkinParts& parts, const Limits& limits,
                       const Eigen::Matrix3Xd& now, const Eigen::Matrix3Xd& before, NodalForces& forces,
                       SkinContactResult& result) {
  if (now_.empty()) return;
  for (const Touch& touch : touches) {
    if (touch.pair.edges) continue;
    const double depth = limits[touch.pair.first] - touch.closest.distance;
    if (depth > 0.0 && has_point(touch, parts)) add(touch, depth, parts, now, before, forces, result);
  }
  result.friction_loss += release(parts);
  now_.swap(before_);
  held_.swap(held_before_);
}

}  // namespace coupling::detail
