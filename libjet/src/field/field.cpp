// SPDX-License-Identifier: Apache-2.0
#include "jet/field.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <elementary/exponential.hpp>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "bits.hpp"
#include "field/outline.hpp"
#include "jet/centreline.hpp"
#include "refuse.hpp"

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

Rows rows(const Points& points) {
  const Eigen::Index last = points.cols() - 1;
  return {points.data(),
          points.outerStride(),
          static_cast<int>(last),
          {points(0, last), points(1, last), points(2, last), 0.0}};
}

[[noreturn]] void refuse_overpressure(int element) {
  throw DomainError("jet overpressure of element " + std::to_string(element) + " is not finite");
}

// Groups of four, to a multiple of 32 that the kernels read.
std::size_t slack_size(int element_count) {
  return set_bytes((static_cast<std::size_t>(element_count) + 3) / 4);
}

// Without a bound, or if it decreased, the motion of the elements is not known.
void move(double displacement_bound, FieldState& state) {
  if (!(displacement_bound >= state.displacement_bound))
    std::fill(state.slack.begin(), state.slack.end(), -HUGE_VAL);
  state.displacement_bound = displacement_bound;
}

void check_outlet(const OutletState& outlet, double restitution) {
  for (const auto& [name, value] :
       {std::pair{"jet outlet velocity", outlet.velocity}, std::pair{"jet outlet density", outlet.density}})
    if (!(value >= 0.0 && std::isfinite(value))) refuse_value<DomainError>(name, value, "finite and >= 0");
  if (outlet.reflected > 1.0)
    refuse_value<DomainError>("jet outlet reflected", outlet.reflected, "at most 1");
  for (const auto& [name, value] : {std::pair{"jet outlet area_ratio", outlet.area_ratio},
                                    std::pair{"jet outlet reflected", outlet.reflected}})
    if (!(value > 0.0 && std::isfinite(value))) refuse_value<DomainError>(name, value, "finite and > 0");
  if (!(restitution >= kLeastRestitution && restitution <= kMostRestitution))
    refuse_value<DomainError>("jet restitution", restitution, kRestitutionRange);
}

double reflection(const OutletState& outlet, double restitution) {
  return 1.0 + restitution * outlet.reflected;
}

// The jet of an outlet that is `ratio` times as large: similar, with the same angles.
JetShape resized(const JetShape& shape, double ratio) {
  JetShape result = shape;
  for (double* length :
       {&result.size, &result.origin, &result.cone_width, &result.cut_core, &result.cut_origin})
    *length *= ratio;
  return result;
}

bool no_flow(const OutletState& outlet) {
  return outlet.density == 0.0 || outlet.velocity == 0.0;
}

constexpr std::size_t kRoom = 8;  // room that the kernels need behind the candidates

// Every width law is the larger of a constant and a straight line in z. The cut-off is a multiple of the
// width.
void set_cut(const JetModel& model, JetShape& shape) {
  constexpr double everywhere = 1e100;  // for a cut-off of 0; its square is finite
  const double multiple = std::min(std::sqrt(-0.5 * elementary::log(model.cut_off)), everywhere);
  const double core = shape.size * (shape.round ? round_core_length(model.decay_coefficient)
                                                : plane_core_length(model.decay_coefficient));
  const double in_core = section(model, 0.0).width;
  const double beyond = section(model, 2.0 * core).width;
  const double slope = shape.momentum ? (section(model, 3.0 * core).width - beyond) / core : shape.cone_slope;
  shape.cut_core = multiple * in_core;
  shape.cut_slope = multiple * slope;
  shape.cut_cosine = 1.0 / std::sqrt(1.0 + shape.cut_slope * shape.cut_slope);
  shape.centre_size = model.centre.cwiseAbs().maxCoeff();
  shape.cut_origin = multiple * (shape.momentum ? beyond - 2.0 * core * slope : in_core);
}

}  // namespace

JetField::JetField(const JetModel& model, int element_count, std::span<const int> null_elements)
    : element_count_(element_count) {
  set_model(model);
  if (element_count < 1) throw std::invalid_argument("jet field surface has no element, allowed: 1 or more");
  loaded_.assign(static_cast<std::size_t>(element_count + 3) / 4, 0xf);
  for (int i = element_count; i % 4 != 0; ++i) take_no_load(i);
  for (const int element : null_elements) {
    if (element < 0 || element >= element_count) {
      throw std::invalid_argument("jet field null element " + std::to_string(element) + ", allowed: 0 to " +
                                  std::to_string(element_count - 1));
    }
    take_no_load(element);
  }
}

void JetField::set_model(const JetModel& model) {
  model_ = validated(model);
  JetShape shape = outline(model_);
  set_cut(model_, shape);
  shape_ = std::make_unique<const JetShape>(shape);
}

JetField JetField::placed(const Eigen::Vector3d& centre, const Eigen::Vector3d& axis,
                          const Eigen::Vector3d& long_direction) const {
  JetModel model = model_;
  model.centre = centre;
  model.axis = axis;
  model.long_direction = long_direction;
  JetField field = *this;
  field.set_model(model);
  return field;
}

// The jets of all outlets are similar: no bound of the cut-off moves by more than that of the core.
void JetField::widen(const OutletState& outlet, FieldState& state) const {
  const double ratio = shape_->round ? std::sqrt(outlet.area_ratio) : outlet.area_ratio;
  if (ratio == state.size_ratio) return;
  state.outline_motion += shape_->cut_core * std::abs(ratio - state.size_ratio);
  state.size_ratio = ratio;
}

void JetField::take_no_load(int element) {
  auto& group = loaded_[static_cast<std::size_t>(element / 4)];
  group = static_cast<std::uint8_t>(group & ~(1 << element % 4));
}

FieldState JetField::make_state() const {
  FieldState state;
  state.overpressure.assign(static_cast<std::size_t>(element_count_), 0.0);
  state.candidates.reserve(static_cast<std::size_t>(element_count_));
  state.selected.resize(static_cast<std::size_t>(element_count_) + kRoom);
  state.restitution = model_.restitution;
  state.slack.assign(slack_size(element_count_), -HUGE_VAL);
  state.inside.assign(slack_size(element_count_), 0);
  return state;
}

void JetField::require_own(const FieldState& state) const {
  if (state.overpressure.size() != static_cast<std::size_t>(element_count_) ||
      state.slack.size() != slack_size(element_count_) || state.inside.size() != slack_size(element_count_) ||
      state.selected.size() != static_cast<std::size_t>(element_count_) + kRoom) {
    throw std::invalid_argument("jet field state does not belong to this surface, use make_state");
  }
}

std::span<const int> JetField::needed(const OutletState& outlet, double displacement_bound,
                                      FieldState& state) const {
  require_own(state);
  move(displacement_bound, state);
  check_outlet(outlet, state.restitution);
  if (no_flow(outlet)) return {};
  widen(outlet, state);
  FieldArrays arrays{};
  arrays.count = element_count_;
  arrays.displacement_bound = displacement_bound + state.outline_motion;
  arrays.slack = state.slack.data();
  arrays.inside = state.inside.data();
  return std::span(state.selected)
      .first(static_cast<std::size_t>(kernel_table().list_needed(arrays, state.selected.data())));
}

void JetField::evaluate(const Points& area_vectors, const Points& centroids, const OutletState& outlet,
                        FieldState& state, const Points* velocities, double displacement_bound) const {
  move(displacement_bound, state);  // even if the input is then refused, the elements may have moved
  require_columns("area_vectors", area_vectors.cols(), element_count_);
  require_columns("centroids", centroids.cols(), element_count_);
  require_velocities(model_, velocities, element_count_);
  require_own(state);
  for (const int element : state.candidates) state.overpressure[static_cast<std::size_t>(element)] = 0.0;
  state.candidates.clear();
  check_outlet(outlet, state.restitution);
  if (no_flow(outlet)) return;
  widen(outlet, state);
  FieldArrays arrays{};
  arrays.area_vectors = rows(area_vectors);
  arrays.centroids = rows(centroids);
  arrays.relative_to_skin = model_.relative_to_skin;
  if (model_.relative_to_skin) arrays.velocities = rows(*velocities);
  arrays.loaded = loaded_.data();
  arrays.count = element_count_;
  arrays.displacement_bound = displacement_bound + state.outline_motion;
  arrays.slack = state.slack.data();
  arrays.inside = state.inside.data();
  arrays.velocity = outlet.velocity;
  arrays.factor = reflection(outlet, state.restitution) * outlet.density;
  arrays.overpressure = state.overpressure.data();
  arrays.candidates = state.selected.data();
  const KernelTable& kernels = kernel_table();
  const JetShape shape = resized(*shape_, state.size_ratio);
  const int count = kernels.evaluate(shape, arrays, kernels.select(shape, arrays));
  if (count < 0) {
    std::fill(state.overpressure.begin(), state.overpressure.end(), 0.0);  // some may already be set
    refuse_overpressure(-1 - count);
  }
  state.candidates.assign(state.selected.begin(), state.selected.begin() + count);
}

void apply_mask(std::span<const std::uint8_t> lit, FieldState& state) {
  if (lit.size() != state.candidates.size()) {
    throw std::invalid_argument("jet mask has " + std::to_string(lit.size()) +
                                " entries, allowed: one a candidate, " +
                                std::to_string(state.candidates.size()));
  }
  double* overpressure = state.overpressure.data();
  // Without a branch. A product would keep the sign and NaN.
  for (std::size_t k = 0; k < lit.size(); ++k) {
    double& dp = overpressure[state.candidates[k]];
    dp = std::bit_cast<double>(std::bit_cast<std::uint64_t>(dp) & (lit[k] == 0 ? 0 : ~std::uint64_t{0}));
  }
}

Eigen::Vector3d jet_force(const FieldState& state, const Points& area_vectors) {
  require_columns("area_vectors", area_vectors.cols(), static_cast<int>(state.overpressure.size()));
  if (state.candidates.empty()) return Eigen::Vector3d::Zero();
  std::array<double, 4> force{};
  kernel_table().force(rows(area_vectors), state.overpressure.data(), state.candidates.data(),
                       static_cast<int>(state.candidates.size()), force.data());
  return {force[0], force[1], force[2]};
}

double damping_rate(const JetModel& model, const OutletState& outlet, const FieldState& state,
                    const Points& area_vectors, std::span<const double> masses) {
  const int elements = static_cast<int>(state.overpressure.size());
  require_columns("area_vectors", area_vectors.cols(), elements);
  require_columns("masses", static_cast<Eigen::Index>(masses.size()), elements);
  if (!model.relative_to_skin) return 0.0;
  const double factor = reflection(outlet, state.restitution) * outlet.density;
  double largest = 0.0;
  for (const int element : state.candidates) {
    const auto e = static_cast<std::size_t>(element);
    const double slope = 2.0 * std::sqrt(factor * state.overpressure[e]);  // d dp / d (v . n)
    largest = std::max(largest, slope * area_vectors.col(element).norm() / masses[e]);
  }
  return largest;
}

}  // namespace jet
