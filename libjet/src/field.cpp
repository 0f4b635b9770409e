// SPDX-License-Identifier: Apache-2.0
#include "jet/field.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "profile.hpp"

namespace jet {
namespace {

void require_columns(const char* name, Eigen::Index columns, int element_count) {
  if (columns == element_count) return;
  std::ostringstream message;
  message << "jet field " << name << " has " << columns << " columns, allowed: " << element_count;
  throw std::invalid_argument(message.str());
}

void require_velocities(const JetModel& model, const Points* velocities, int element_count) {
  if (!model.relative_to_skin) return;
  if (velocities == nullptr) {
    throw std::invalid_argument("jet field velocities are missing, needed with relative_to_skin");
  }
  require_columns("velocities", velocities->cols(), element_count);
}

double sqr(double x) {
  return x * x;
}

}  // namespace

JetField::JetField(const JetModel& model, int element_count, std::span<const int> null_elements)
    : model_(validated(model)), element_count_(element_count) {
  if (element_count < 1) throw std::invalid_argument("jet field surface has no element, allowed: 1 or more");
  is_null_.assign(static_cast<std::size_t>(element_count), 0);
  for (const int element : null_elements) {
    if (element < 0 || element >= element_count) {
      throw std::invalid_argument("jet field null element " + std::to_string(element) + ", allowed: 0 to " +
                                  std::to_string(element_count - 1));
    }
    is_null_[static_cast<std::size_t>(element)] = 1;
  }
  const bool round = model_.shape == OutletShape::round;
  frame_.across = round ? Eigen::Vector3d::Zero() : Eigen::Vector3d(model_.axis.cross(model_.long_direction));
  frame_.half_long = round ? 0.0 : 0.5 * model_.long_side;
  set_cut();
}

// Every width law is the larger of a constant and a straight line in z; the cut-off is the same multiple of
// it.
void JetField::set_cut() {
  constexpr double everywhere = 1e100;  // stands for a cut-off of 0; its square is finite
  const double multiple = std::min(std::sqrt(-0.5 * std::log(model_.cut_off)), everywhere);
  const bool round = model_.shape == OutletShape::round;
  const double core =
      (round ? model_.radius : 0.5 * model_.short_side) *
      (round ? round_core_length(model_.decay_coefficient) : plane_core_length(model_.decay_coefficient));
  const double in_core = section(model_, 0.0).width;
  const double beyond = section(model_, 2.0 * core).width;
  const double slope = model_.spread == Spread::cone ? std::tan(model_.cone_half_angle)
                                                     : (section(model_, 3.0 * core).width - beyond) / core;
  frame_.cut_core = multiple * in_core;
  frame_.cut_slope = multiple * slope;
  frame_.cut_origin = multiple * (model_.spread == Spread::cone ? in_core : beyond - 2.0 * core * slope);
}

FieldState JetField::make_state() const {
  FieldState state;
  state.overpressure.assign(static_cast<std::size_t>(element_count_), 0.0);
  state.candidates.reserve(static_cast<std::size_t>(element_count_));
  return state;
}

void JetField::reset(FieldState& state) const {
  if (state.overpressure.size() != static_cast<std::size_t>(element_count_)) {
    throw std::invalid_argument("jet field state does not belong to this surface, use make_state");
  }
  for (const int element : state.candidates) state.overpressure[static_cast<std::size_t>(element)] = 0.0;
  state.candidates.clear();
}

// Written so that a non-finite coordinate counts as inside and is found in store().
inline bool JetField::inside(const double* point) const {
  const double x = point[0] - model_.centre[0], y = point[1] - model_.centre[1],
               z = point[2] - model_.centre[2];
  const auto along = [&](const Eigen::Vector3d& v) { return x * v[0] + y * v[1] + z * v[2]; };
  const double downstream = along(model_.axis);
  if (downstream <= 0.0) return false;
  const double cut = std::max(frame_.cut_core, frame_.cut_origin + frame_.cut_slope * downstream);
  if (model_.shape == OutletShape::round) return !(x * x + y * y + z * z - sqr(downstream) > sqr(cut));
  return !(std::abs(along(frame_.across)) > cut || std::abs(along(model_.long_direction)) > frame_.half_long);
}

double JetField::normal_velocity(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) const {
  const profile::Local local = profile::local(model_, frame_.across, point);
  return profile::speed(section(model_, local.z), local.radius2) *
         profile::direction(model_, frame_.across, point).dot(normal);
}

// Elements that an axial jet does not see from behind, inside the cut-off: they fill state.candidates for
// evaluate().
void JetField::select(const Points& area_vectors, const Points& centroids, FieldState& state) const {
  state.candidates.resize(static_cast<std::size_t>(element_count_));
  const bool axial = model_.direction == Direction::axial;
  const double a[3] = {model_.axis[0], model_.axis[1], model_.axis[2]};
  const double *area = area_vectors.data(), *centroid = centroids.data();
  const Eigen::Index area_stride = area_vectors.outerStride(), centroid_stride = centroids.outerStride();
  std::size_t count = 0;
  for (int e = 0; e < element_count_; ++e, area += area_stride, centroid += centroid_stride) {
    if (axial && area[0] * a[0] + area[1] * a[1] + area[2] * a[2] <= 0.0) continue;
    if (!inside(centroid) || is_null_[static_cast<std::size_t>(e)] != 0) continue;
    state.candidates[count++] = e;
  }
  state.candidates.resize(count);
}

void JetField::store(int element, double overpressure, FieldState& state) const {
  if (!std::isfinite(overpressure)) {
    throw DomainError("jet overpressure of element " + std::to_string(element) + " is not finite");
  }
  state.overpressure[static_cast<std::size_t>(element)] = overpressure;
}

void JetField::evaluate(const Points& area_vectors, const Points& centroids, const OutletState& outlet,
                        FieldState& state, const Points* velocities) const {
  require_columns("area_vectors", area_vectors.cols(), element_count_);
  require_columns("centroids", centroids.cols(), element_count_);
  require_velocities(model_, velocities, element_count_);
  reset(state);
  if (outlet.density == 0.0 || outlet.velocity == 0.0) return;
  select(area_vectors, centroids, state);
  const double factor = (1.0 + model_.restitution) * outlet.density;
  std::size_t count = 0;
  for (const int e : state.candidates) {
    const Eigen::Vector3d area = area_vectors.col(e);
    const double size = area.norm();
    if (size == 0.0) continue;
    const double inverse = 1.0 / size;
    double speed = outlet.velocity * normal_velocity(centroids.col(e), area) * inverse;
    if (speed > 0.0 && model_.relative_to_skin) speed -= velocities->col(e).dot(area) * inverse;
    if (speed <= 0.0) continue;
    store(e, factor * sqr(speed), state);
    state.candidates[count++] = e;
  }
  state.candidates.resize(count);
}

void apply_mask(std::span<const std::uint8_t> lit, FieldState& state) {
  if (lit.size() != state.candidates.size()) {
    throw std::invalid_argument("jet mask has " + std::to_string(lit.size()) +
                                " entries, allowed: one a candidate, " +
                                std::to_string(state.candidates.size()));
  }
  for (std::size_t k = 0; k < lit.size(); ++k) {
    if (lit[k] == 0) state.overpressure[static_cast<std::size_t>(state.candidates[k])] = 0.0;
  }
}

Eigen::Vector3d jet_force(const FieldState& state, const Points& area_vectors) {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  for (const int element : state.candidates) {
    force += state.overpressure[static_cast<std::size_t>(element)] * area_vectors.col(element);
  }
  return force;
}

}  // namespace jet
