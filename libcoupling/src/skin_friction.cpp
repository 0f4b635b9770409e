// SPDX-License-Identifier: Apache-2.0
#include "skin_friction.hpp"

#include <algorithm>
#include <utility>

namespace coupling::detail {
namespace {

using Eigen::Vector3d;

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
  closest_.resize(parts.masses.size());
}

// The bristle of the last level on the same layer.
Bristle SkinFriction::take(int node, int triangle, const SkinParts& parts) {
  for (Bristle& old : before_[static_cast<std::size_t>(node)])
    if (old.triangle >= 0 && neighbours(parts, old.triangle, triangle)) {
      const Bristle taken = old;
      old.triangle = -1;
      return taken;
    }
  return {};
}

// Keeps the closest element of each layer, because others of the layer are near too.
void SkinFriction::choose(const Touch& touch, const SkinParts& parts) {
  auto& chosen = closest_[static_cast<std::size_t>(touch.pair.first)];
  if (!chosen[0]) held_.push_back(touch.pair.first);
  for (const Touch*& other : chosen) {
    if (other && !neighbours(parts, other->pair.second, touch.pair.second)) continue;
    if (!other || touch.closest.distance < other->closest.distance) other = &touch;
    return;
  }
}

Bristle SkinFriction::hold(const Touch& touch, double depth, const SkinParts& parts,
                           const Eigen::Matrix3Xd& now, const Eigen::Matrix3Xd& before, NodalForces& forces,
                           SkinContactResult& result) {
  const int node = touch.pair.first;
  const Corners corners = corners_of(parts, touch.pair);
  Vector3d slip = Vector3d::Zero();
  for (int k = 0; k < 4; ++k)
    slip += touch.closest.weight[k] * (now.col(corners.node[k]) - before.col(corners.node[k]));
  const Bristle old = take(node, touch.pair.second, parts);
  const Vector3d& normal = touch.closest.normal;
  const Vector3d wanted = old.triangle < 0 ? Vector3d::Zero().eval() : (old.stretch + slip).eval();
  Vector3d stretch = wanted - normal.dot(wanted) * normal;
  const double most = parts.parameters.friction * depth, length = stretch.norm();
  if (length > most) stretch *= most / length;
  const double weight = weight_of(parts, node);
  for (int k = 0; k < 4; ++k) forces.col(corners.node[k]) -= touch.closest.weight[k] * weight * stretch;
  result.energy += 0.5 * weight * stretch.squaredNorm();
  result.friction_loss += 0.5 * weight * (old.stretch + stretch).dot(wanted - stretch);
  return {touch.pair.second, stretch};
}

// A bristle that has lost its layer loses its energy.
double SkinFriction::release(const SkinParts& parts) {
  double loss = 0.0;
  for (const int node : held_before_)
    for (Bristle& old : before_[static_cast<std::size_t>(node)]) {
      if (old.triangle >= 0) loss += 0.5 * weight_of(parts, node) * old.stretch.squaredNorm();
      old = {};
    }
  held_before_.clear();
  return loss;
}

std::vector<SkinBristle> SkinFriction::bristles() const {
  std::vector<SkinBristle> all;
  for (const int node : held_before_)
    for (const int side : {0, 1}) {
      const Bristle& one = before_[static_cast<std::size_t>(node)][static_cast<std::size_t>(side)];
      if (one.triangle >= 0)
        all.push_back({node, side, one.triangle, 0, {one.stretch[0], one.stretch[1], one.stretch[2]}});
    }
  return all;
}

void SkinFriction::set(const std::vector<SkinBristle>& bristles) {
  for (const SkinBristle& one : bristles) {
    before_[static_cast<std::size_t>(one.node)][static_cast<std::size_t>(one.side)] = {
        one.triangle, Eigen::Map<const Eigen::Vector3d>(one.stretch)};
    if (held_before_.empty() || held_before_.back() != one.node) held_before_.push_back(one.node);
  }
}

void SkinFriction::add(const std::vector<Touch>& touches, const SkinParts& parts, const SkinLimits& limits,
                       const Eigen::Matrix3Xd& now, const Eigen::Matrix3Xd& before, NodalForces& forces,
                       SkinContactResult& result) {
  if (now_.empty()) return;
  for (const Touch& touch : touches)
    if (!touch.pair.edges && touch.closest.distance < limits.of_node(touch.pair.first)) choose(touch, parts);
  for (const int node : held_) {
    const auto n = static_cast<std::size_t>(node);
    for (const std::size_t side : {0u, 1u})
      if (const Touch* touch = std::exchange(closest_[n][side], nullptr))
        now_[n][side] =
            hold(*touch, limits.of_node(node) - touch->closest.distance, parts, now, before, forces, result);
  }
  result.friction_loss += release(parts);
  now_.swap(before_);
  held_.swap(held_before_);
}

}  // namespace coupling::detail
