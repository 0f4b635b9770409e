// SPDX-License-Identifier: Apache-2.0
#include "skin_motion.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/error.hpp"

namespace coupling::detail {
namespace {

using Eigen::Vector3d;

constexpr double kMargin = 1.0 + 1e-12;  // for rounding

}  // namespace

SkinMotion::SkinMotion(const ElementGroups& groups)
    : groups_(&groups),
      marked_(Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(groups.nodes.size()))),
      shift_(Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(groups.count()))),
      spread_(groups.count(), 0.0),
      step_(groups.count(), 0.0) {}

void SkinMotion::update(const Eigen::Matrix3Xd& now, const Eigen::Matrix3Xd& before) {
  double sum = 0.0;
  for (std::size_t g = 0; g < groups_->count(); ++g) {
    const std::size_t begin = groups_->first_node[g], end = groups_->first_node[g + 1];
    Vector3d mean = Vector3d::Zero();
    double step = 0.0, spread = 0.0;
    for (std::size_t k = begin; k < end; ++k) {
      const auto x = now.col(groups_->nodes[k]);
      mean += x - marked_.col(static_cast<Eigen::Index>(k));
      step = std::max(step, (x - before.col(groups_->nodes[k])).squaredNorm());
    }
    mean /= static_cast<double>(end - begin);
    for (std::size_t k = begin; k < end; ++k)
      spread = std::max(
          spread,
          (now.col(groups_->nodes[k]) - marked_.col(static_cast<Eigen::Index>(k)) - mean).squaredNorm());
    shift_.col(static_cast<Eigen::Index>(g)) = mean;
    spread_[g] = kMargin * std::sqrt(spread);
    step_[g] = kMargin * std::sqrt(step);
    sum += mean.sum();
  }
  // A maximum ignores NaN, a sum does not.
  if (!std::isfinite(sum)) throw ContactError("self-contact: a coordinate of a node is not finite");
}

void SkinMotion::mark(const Eigen::Matrix3Xd& now) {
  for (std::size_t k = 0; k < groups_->nodes.size(); ++k)
    marked_.col(static_cast<Eigen::Index>(k)) = now.col(groups_->nodes[k]);
  shift_.setZero();
  std::ranges::fill(spread_, 0.0);
}

double SkinMotion::moved() const {
  double most = 0.0;
  for (std::size_t g = 0; g < spread_.size(); ++g)
    most = std::max(most, kMargin * shift_.col(static_cast<Eigen::Index>(g)).norm() + spread_[g]);
  return most;
}

double SkinMotion::since_mark(int first, int second) const {
  return kMargin * (shift_.col(first) - shift_.col(second)).norm() +
         spread_[static_cast<std::size_t>(first)] + spread_[static_cast<std::size_t>(second)];
}

double SkinMotion::step(int first, int second) const {
  return step_[static_cast<std::size_t>(first)] + step_[static_cast<std::size_t>(second)];
}

double SkinMotion::largest_step() const {
  return *std::ranges::max_element(step_);
}

}  // namespace coupling::detail
