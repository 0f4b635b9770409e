// SPDX-License-Identifier: Apache-2.0
#include "skin_motion.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/error.hpp"
#include "skin_lanes.hpp"

namespace coupling::detail {

SkinMotion::SkinMotion(const ElementGroups& groups, double ahead)
    : groups_(&groups),
      ahead_(static_cast<float>(ahead)),
      paths_(groups.count(), 0.0),
      steps_(groups.count(), 0.0F) {}

void SkinMotion::advance(const Nodes& nodes) {
  const bool first = now_.cols() == 0;
  if (first) {
    const auto count = static_cast<std::size_t>(nodes.cols());
    origin_ = nodes.col(groups_->nodes.front());
    points_now_.resize(count);
    points_before_.resize(count);
    path_boxes_.resize(count);
    node_steps_.resize(count);
  }
  now_.swap(before_);
  now_ = nodes;
  points_now_.swap(points_before_);
  double sum = 0.0, largest = 0.0;
  for (std::size_t n = 0; n < points_now_.size(); ++n) {
    const Eigen::Vector3d x = now_.col(static_cast<Eigen::Index>(n)) - origin_;
    sum += x[0] + x[1] + x[2];
    largest = std::max({largest, std::abs(x[0]), std::abs(x[1]), std::abs(x[2])});
    points_now_[n] = along_directions(x);
  }
  // A maximum ignores NaN, a sum does not.
  if (!std::isfinite(sum)) throw ContactError("self-contact: a coordinate of a node is not finite");
  rounding_ = std::max(rounding_, 4e-6F * static_cast<float>(largest));
  if (first) {
    before_ = now_;
    points_before_ = points_now_;
  }
  step();
}

Box SkinMotion::group_box(int group) const {
  const auto g = static_cast<std::size_t>(group);
  Box box = empty_box();
  for (std::size_t k = groups_->first_node[g]; k < groups_->first_node[g + 1]; ++k)
    add(box, path_box(groups_->nodes[k]));
  return box;
}

void SkinMotion::step() {
  Four total{};
  for (std::size_t n = 0; n < points_now_.size(); ++n) {
    Box& box = path_boxes_[n];
    for (std::size_t k = 0; k < 8; k += 4) {
      const Four now = load(points_now_[n].data() + k), before = load(points_before_[n].data() + k);
      const Four ahead = now + ahead_ * (now - before);
      store(box.low.data() + k, smaller(before, ahead));
      store(box.high.data() + k, larger(before, ahead));
      if (k == 0) total += now - before;
    }
  }
  const Four mean = total / static_cast<float>(points_now_.size());
  for (std::size_t n = 0; n < points_now_.size(); ++n) {
    const Four step = load(points_now_[n].data()) - load(points_before_[n].data()) - mean;
    const Four square = step * step;
    node_steps_[n] = square[0] + square[1] + square[2];
  }
  largest_step_ = 0.0F;
  for (std::size_t g = 0; g < groups_->count(); ++g) {
    float most = 0.0F;
    for (std::size_t k = groups_->first_node[g]; k < groups_->first_node[g + 1]; ++k)
      most = std::max(most, node_steps_[static_cast<std::size_t>(groups_->nodes[k])]);
    steps_[g] = (1.0F + 1e-6F) * std::sqrt(most) + rounding_;
    paths_[g] += steps_[g];
    largest_step_ = std::max(largest_step_, steps_[g]);
  }
}

}  // namespace coupling::detail
