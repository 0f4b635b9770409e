// SPDX-License-Identifier: Apache-2.0
// The elements of a call: their geometry, field and sums.
#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <utility>

#include "jet_object.hpp"

namespace border {
namespace {

// Every number once: a sum over ranks would count an element twice.
void require_once(std::span<const int> list, std::size_t elements) {
  std::vector<std::uint8_t> known(elements, 0);
  for (const int element : list)
    if (std::exchange(known[static_cast<std::size_t>(element)], std::uint8_t{1}) != 0)
      refuse("elements", "has the number " + std::to_string(element) + " twice, allowed: once");
}

std::vector<int> all_elements(Eigen::Index count) {
  std::vector<int> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

Eigen::Matrix3Xi columns(const Eigen::Matrix3Xi& of, const std::vector<int>& numbers) {
  Eigen::Matrix3Xi chosen(3, static_cast<Eigen::Index>(numbers.size()));
  for (std::size_t k = 0; k < numbers.size(); ++k)
    chosen.col(static_cast<Eigen::Index>(k)) = of.col(numbers[k]);
  return chosen;
}

}  // namespace

AskedElements::AskedElements(const JetCall& call, const Skin& skin, std::span<const std::uint8_t> loaded,
                             const jet::Subdivision* cut, const jet::JetModel& model) {
  if (call.elements) {
    require_once(*call.elements, loaded.size());
    list_.emplace(call.elements->begin(), call.elements->end());
  }
  const std::vector<int> asked = list_ ? *list_ : all_elements(skin.triangles.cols());
  for (std::size_t k = 0; k < asked.size(); ++k) {
    if (loaded[static_cast<std::size_t>(asked[k])] == 0) continue;
    places_.push_back(static_cast<int>(k));
    pieces_.push_back(asked[k]);
  }
  corners_ = columns(skin.triangles, pieces_);
  if (places_.empty()) return;
  const Eigen::Index count = corners_.cols();
  area_vectors_.resize(3, count);
  velocities_.resize(3, count);
  if (cut != nullptr) {
    whole_ = jet::JetField(model, static_cast<int>(count)).make_state();
    pieces_ = cut->pieces_of(pieces_);
    piece_corners_ = columns(cut->triangles(), pieces_);
    piece_area_vectors_.resize(3, piece_corners_.cols());
    piece_velocities_.resize(3, piece_corners_.cols());
  }
  field_.emplace(model, static_cast<int>(pieces_.size()));
  state_ = field_->make_state();
  centroids_.resize(3, static_cast<Eigen::Index>(pieces_.size()));
  candidates_.reserve(pieces_.size());
  lit_.resize(pieces_.size());
}

bool AskedElements::serves(const JetCall& call) const {
  if (!list_ || !call.elements) return !list_ && !call.elements;
  return std::equal(list_->begin(), list_->end(), call.elements->begin(), call.elements->end());
}

void AskedElements::place(const jet::JetModel& model) {
  if (!field_) return;
  const double motion = jet::outlet_motion(field_->model(), model, reach());
  field_ = field_->placed(model.centre, model.axis, model.long_direction);
  if (motion < extent_.farthest)
    state_.outline_motion += motion;
  else
    state_.displacement_bound = jet::kMotionUnknown;
}

// Bound of the distance [m] of the centroids from the outlet.
double AskedElements::reach() const {
  return extent_.farthest + (state_.displacement_bound - extent_.bound) +
         (field_->model().centre - extent_.centre).norm();
}

void AskedElements::measure(const JetCall& call, const jet::Points& points, const jet::Subdivision* cut) {
  const Points::View& nodes = *call.nodes;
  for (Eigen::Index e = 0; e < corners_.cols(); ++e) {
    const Eigen::Vector3d a = nodes.col(corners_(0, e)), b = nodes.col(corners_(1, e)),
                          c = nodes.col(corners_(2, e));
    area_vectors_.col(e) = 0.5 * (b - a).cross(c - a);
    if (cut == nullptr) centroids_.col(e) = ((a + b) + c) / 3.0;
  }
  if (cut != nullptr) {
    jet::corner_means(points, piece_corners_, centroids_);
    cut->share_areas(area_vectors_, piece_area_vectors_);
  }
  if (call.velocities == nullptr) return;
  jet::corner_means(*call.velocities, corners_, velocities_);
  if (cut == nullptr) return;
  const int n = cut->pieces();
  for (Eigen::Index e = 0; e < velocities_.cols(); ++e)
    piece_velocities_.middleCols(e * n, n).colwise() = velocities_.col(e);
}

void AskedElements::evaluate(const JetCall& call, const jet::Points& points, const jet::Subdivision* cut,
                             double restitution) {
  if (!field_) return;
  measure(call, points, cut);
  const bool goes_on = call.displacement_bound >= state_.displacement_bound;  // not of a new run
  if (!goes_on || !(reach() < 1.5 * extent_.farthest)) {
    extent_.centre = field_->model().centre;
    extent_.bound = call.displacement_bound;
    extent_.farthest = (centroids_.colwise() - extent_.centre).colwise().norm().maxCoeff();
  }
  state_.restitution = restitution;
  const jet::Points velocities(cut != nullptr ? piece_velocities_ : velocities_);
  field_->evaluate(cut != nullptr ? piece_area_vectors_ : area_vectors_, centroids_, call.outlet, state_,
                   call.velocities != nullptr ? &velocities : nullptr, call.displacement_bound);
}

jet::VisibilityCounters AskedElements::hide(const JetCall& call, const jet::Points& points,
                                            const jet::RaySource& source, jet::VisibilityQuery& query) {
  jet::VisibilityCounters seen;
  seen.candidates = seen.lit = state_.candidates.size();
  if (!call.occlusion) return seen;
  candidates_.clear();
  for (const int own : state_.candidates) candidates_.push_back(pieces_[static_cast<std::size_t>(own)]);
  const std::span lit(lit_.data(), candidates_.size());
  seen = query.query(jet::VisibilityRoute::fast, points, source, candidates_, lit, call.displacement_bound);
  jet::apply_mask(lit, state_);
  return seen;
}

JetLoad AskedElements::write(const JetCall& call, const jet::Subdivision* cut,
                             std::span<double> overpressure) {
  std::fill(overpressure.begin(), overpressure.end(), 0.0);
  JetLoad load;
  if (!field_) return load;
  if (cut != nullptr) cut->average(state_, whole_);
  const jet::FieldState& result = cut != nullptr ? whole_ : state_;
  for (const int own : result.candidates) {
    const auto e = static_cast<std::size_t>(own);
    overpressure[static_cast<std::size_t>(places_[e])] = result.overpressure[e];
    if (call.velocities != nullptr)
      load.power += result.overpressure[e] * area_vectors_.col(own).dot(velocities_.col(own));
  }
  load.force = jet::jet_force(result, area_vectors_);
  return load;
}

}  // namespace border
