// SPDX-License-Identifier: Apache-2.0
#include "jet_object.hpp"

#include <algorithm>
#include <utility>

namespace border {
namespace {

// Triangles that count the nodes they use from 0, as there may be many more.
Eigen::Matrix3Xi own_triangles(const Skin& skin) {
  Eigen::Matrix3Xi own = skin.triangles;
  for (int& node : own.reshaped())
    node =
        static_cast<int>(std::lower_bound(skin.named.begin(), skin.named.end(), node) - skin.named.begin());
  return own;
}

jet::SurfaceRoles roles_of_pieces(const jet::SurfaceRoles& roles, const jet::Subdivision& cut) {
  return {cut.pieces_of(roles.null_elements), cut.pieces_of(roles.attachment_elements)};
}

}  // namespace

Jet::Jet(const jet::JetModel& model, Skin given)
    : skin(std::move(given)),
      restitution(model.restitution),
      model_(model),
      on_(static_cast<std::size_t>(skin.triangles.cols()), 1),
      query_(skin.triangles, static_cast<int>(skin.node_count), skin.roles) {}

void Jet::place(const Eigen::Vector3d& centre, const Eigen::Vector3d& axis,
                const Eigen::Vector3d& long_direction) {
  jet::JetModel moved = model_;
  moved.centre = centre;
  moved.axis = axis;
  moved.long_direction = long_direction;
  model_ = jet::validated(moved);
  if (asked_) asked_->place(model_);
}

void Jet::set_elements(std::span<const std::uint8_t> on) {
  on_.assign(on.begin(), on.end());
  leave_out(query_, cut_ ? &*cut_ : nullptr);
  asked_.reset();
}

void Jet::leave_out(jet::VisibilityQuery& query, const jet::Subdivision* cut) const {
  std::vector<int> off;
  for (std::size_t e = 0; e < on_.size(); ++e)
    if (on_[e] == 0) off.push_back(static_cast<int>(e));
  query.leave_out(cut != nullptr ? cut->pieces_of(off) : off);
}

void Jet::subdivide(int n) {
  std::optional<jet::Subdivision> cut;
  if (n != 1) cut.emplace(own_triangles(skin), static_cast<int>(skin.named.size()), n);
  jet::VisibilityQuery query =
      cut ? jet::VisibilityQuery(cut->triangles(), cut->node_count(), roles_of_pieces(skin.roles, *cut))
          : jet::VisibilityQuery(skin.triangles, static_cast<int>(skin.node_count), skin.roles);
  leave_out(query, cut ? &*cut : nullptr);
  Eigen::Matrix3Xd own_nodes(3, cut ? static_cast<Eigen::Index>(skin.named.size()) : 0),
      points(3, cut ? cut->node_count() : 0);
  own_nodes_.swap(own_nodes);
  points_.swap(points);
  cut_ = std::move(cut);
  query_ = std::move(query);
  asked_.reset();
}

void Jet::set_relative(bool relative) {
  if (relative == model_.relative_to_skin) return;
  model_.relative_to_skin = relative;
  asked_.reset();
}

std::span<const std::uint8_t> Jet::loaded() {
  loaded_ = on_;
  for (const int element : skin.roles.null_elements) loaded_[static_cast<std::size_t>(element)] = 0;
  return loaded_;
}

JetLoad Jet::load(const JetCall& call, std::span<double> overpressure) {
  const jet::Subdivision* cut = cut_ ? &*cut_ : nullptr;
  if (!asked_ || !asked_->serves(call)) asked_.emplace(call, skin, loaded(), cut, model_);
  if (cut_) {
    for (std::size_t i = 0; i < skin.named.size(); ++i)
      own_nodes_.col(static_cast<Eigen::Index>(i)) = call.nodes->col(skin.named[i]);
    cut_->interpolate(own_nodes_, points_);
  }
  const jet::Points points = cut_ ? jet::Points(points_) : jet::Points(*call.nodes);
  asked_->evaluate(call, points, cut, restitution);
  const jet::VisibilityCounters counters = asked_->hide(call, points, jet::ray_source(model_), query_);
  JetLoad result = asked_->write(call, cut, overpressure);
  result.counters = counters;
  return result;
}

}  // namespace border
