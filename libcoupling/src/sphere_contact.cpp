// SPDX-License-Identifier: Apache-2.0
#include "coupling/sphere_contact.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "check.hpp"
#include "contact_element.hpp"
#include "contact_search.hpp"
#include "placed_body.hpp"

namespace coupling {
namespace {

using Eigen::Vector3d;

constexpr double kRounding = 1.0 + 1e-12;  // margin for a motion bound that others computed

void require_columns(const std::string& field, Eigen::Index columns, int node_count) {
  if (columns != node_count)
    detail::reject(field, std::to_string(columns) + " columns", "one a node, " + std::to_string(node_count));
}

void require_own(const ContactState& state, const std::shared_ptr<const ElementGroups>& groups) {
  if (state.owner != groups)
    detail::reject("contact.state", "not of this model", "from make_state of this model");
}

int subdivision_of(const std::string& field, double longest_edge, double size) {
  const double n = std::ceil(4.0 * longest_edge / size);
  if (!(n <= ContactModel::kMaxSubdivision))
    detail::reject(
        field, detail::text(longest_edge) + " m long",
        "at most 128 times the impactor's size, " + detail::text(size, 3) + " m, long (refine the mesh)");
  return std::max(1, static_cast<int>(n));
}

}  // namespace

ContactModel::ContactModel(const Triangles& triangles, const Nodes& reference, std::span<const double> masses,
                           double effective_mass, const ContactParameters& parameters,
                           std::span<const int> open_elements)
    : triangles_(triangles),
      masses_(masses.begin(), masses.end()),
      effective_mass_(effective_mass),
      parameters_(parameters) {
  require_valid(parameters.impactor);
  const double size = size_of(parameters.impactor);
  detail::require_positive("contact.stiffness", parameters.stiffness);
  detail::require_not_negative("contact.friction", parameters.friction);
  detail::require_positive("contact.effective_mass", effective_mass);
  if (masses_.size() != static_cast<std::size_t>(reference.cols()))
    detail::reject("contact.masses", std::to_string(masses_.size()) + " values", "one value a node");
  for (std::size_t a = 0; a < masses_.size(); ++a)
    detail::require_positive("contact.masses[" + std::to_string(a) + "]", masses_[a]);
  detail::require_nodes("contact.triangles", triangles, reference.cols());
  for (Eigen::Index e = 0; e < triangles.cols(); ++e) {
    const std::string field = "contact: skin element " + std::to_string(e);
    const Vector3d a = reference.col(triangles(0, e)), b = reference.col(triangles(1, e)),
                   c = reference.col(triangles(2, e));
    const double area = 0.5 * (b - a).cross(c - a).norm();
    detail::require_positive(field + " area", area);
    const double edge = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    const int n = subdivision_of(field, edge, size);
    quadrature_.push_back({area / (static_cast<double>(n) * n), n});
  }
  for (const int e : open_elements) {
    if (e < 0 || e >= element_count())
      detail::reject("contact.open_elements", std::to_string(e), "an element number");
    quadrature_[static_cast<std::size_t>(e)].weight = 0.0;
  }
  groups_ = std::make_shared<const ElementGroups>(make_groups(triangles, reference));
  full_omega_squared_ = full_omega_squared_of_skin();
}

ContactState ContactModel::make_state() const {
  ContactState state;
  state.owner = groups_;
  state.nodes = Eigen::Matrix3Xd::Zero(3, node_count());
  state.slack.resize(quadrature_.size());
  state.group_slack.resize(groups_->count());
  state.near.reserve(quadrature_.size());
  state.nodal_stiffness.assign(masses_.size(), 0.0);
  if (parameters_.friction > 0.0) {
    // More points in contact than in any scene so far. If there are more, the list allocates once.
    constexpr std::size_t kManyPoints = 1 << 16;
    std::size_t points = 0;
    for (const auto& [weight, n] : quadrature_)
      points += static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
    state.bristles.reserve(std::min(points, kManyPoints));
    state.old_bristles.reserve(std::min(points, kManyPoints));
  }
  return state;
}

bool ContactModel::stays_clear(ContactState& state, double motion, double ahead) const {
  require_own(state, groups_);
  state.ahead = ahead;
  state.told = motion >= 0.0 ? motion : std::numeric_limits<double>::infinity();
  // NaN compares false.
  if (!state.started || !(state.displacement_bound + kRounding * motion + ahead < state.gap)) return false;
  state.displacement_bound += kRounding * motion;
  state.told = ContactState::kNotTold;
  ++state.skips;
  return true;
}

// Updates the state to the new level: a certificate or sweep for the path, then the overlapping elements.
template <class Body>
void ContactModel::follow(const Body& body, ContactState& state, const Nodes& nodes, const Pose& pose) const {
  const Vector3d& centre = pose.centre;
  const double size = body.size();
  if (!state.started) detail::forget_gaps(state);
  double motion = state.told;
  if (state.started && !(motion >= 0.0) && !state.kept)
    detail::reject("contact motion", "not known",
                   "stays_clear called before each level after it got the motion ahead");
  if (!(motion >= 0.0)) {
    motion = detail::largest_motion(nodes, state.nodes) + (centre - state.centre).norm();
    // A rotation by phi moves no point by more than 2 sin(phi/2) times its distance from the centre.
    if constexpr (Body::kTurns) motion += std::sqrt(0.5) * (pose.axes - state.axes).norm() * body.reach();
  }
  if (!std::isfinite(motion) || !centre.allFinite())
    throw ContactError("contact: a node or the impactor's centre is not finite");
  // No skin point was closer to a sphere's centre, or another body's core, than this. So a smaller motion
  // cannot bring them together.
  const double clearance = size + state.gap - state.displacement_bound;
  if (state.started && !(motion < clearance)) {
    if (Body::kTurns)
      throw ContactError("contact: skin and impactor moved " + detail::text(motion, 3) +
                         " m past each other within one step, the limit is " + detail::text(clearance, 3) +
                         " m, " + Body::kSizeName + " plus the gap before: the skin may have crossed it");
    if (!state.kept)
      throw ContactError("contact: skin and sphere moved " + detail::text(motion) +
                         " m within one step, but only " + detail::text(state.expected) +
                         " m were expected: the centre may have crossed the skin");
    detail::sweep_centre_path(triangles_, size, nodes, centre, state);
  }
  state.displacement_bound += kRounding * motion;
  state.told = ContactState::kNotTold;
  state.shift = centre - state.centre;
  state.centre = centre;
  state.axes = pose.axes;
  detail::Search<Body> search{triangles_, *groups_, nodes, body, state};
  search.find_near_elements();
  search.settle_gap();
  state.bristles.swap(state.old_bristles);
  state.bristles.clear();
  if (!state.started) state.old_bristles.clear();
  state.started = true;
}

// Keeps positions that the next call may need: for its sweep if the motion ahead may be too long for the
// certificate, and for the skin's motion under bristles.
void ContactModel::keep(double size, ContactState& state, const Nodes& nodes) const {
  const double clearance = size + state.gap - state.displacement_bound;
  const bool certain = state.ahead > 0.0 && state.ahead < clearance;
  state.expected = state.ahead;
  state.kept = !certain || !state.bristles.empty();
  if (state.kept) state.nodes = nodes;
}

// Sets the motion of the corners since the last level. Without kept positions no bristle needs it.
void ContactModel::aim(int e, const ContactState& state, const Nodes& nodes, detail::Grip& grip) const {
  const auto corner = triangles_.col(e);
  Vector3d moved[3];
  for (int i = 0; i < 3; ++i) moved[i] = nodes.col(corner[i]) - state.nodes.col(corner[i]) - state.shift;
  grip.origin = moved[0];
  grip.first = moved[1] - moved[0];
  grip.second = moved[2] - moved[0];
  grip.element = e;
}

template <class Body>
void ContactModel::add_element(const Body& body, int e, detail::Grip* grip, ContactState& state,
                               const Nodes& nodes, NodalForces& forces, ContactResult& result) const {
  const double kappa = parameters_.stiffness;
  const auto corner = triangles_.col(e);
  const Vector3d a = nodes.col(corner[0]) - state.centre, b = nodes.col(corner[1]) - state.centre,
                 c = nodes.col(corner[2]) - state.centre;
  const auto index = static_cast<std::size_t>(e);
  const detail::Element element{a, b - a, c - a, quadrature_[index].weight, quadrature_[index].subdivision};
  if (grip) aim(e, state, nodes, *grip);
  const detail::ElementSums sums = detail::integrate(element, body, grip);
  if (!(sums.area > 0.0)) return;
  for (int i = 0; i < 3; ++i) {
    const Vector3d force = kappa * sums.force[i];
    forces.col(corner[i]) += force;
    result.force -= force;
    state.nodal_stiffness[static_cast<std::size_t>(corner[i])] += kappa * sums.shape[i];
  }
  result.couple -= kappa * sums.couple;
  result.energy += kappa * sums.energy;
  result.area += sums.area;
  if (result.deepest_element < 0 || sums.depth > result.penetration) {
    result.penetration = sums.depth;
    result.deepest_element = e;
  }
}

template <class Body>
ContactResult ContactModel::evaluate_body(const Body& body, ContactState& state, const Nodes& nodes,
                                          const Pose& pose, NodalForces& forces, const Vector3d& turn) const {
  follow(body, state, nodes, pose);
  ContactResult result;
  detail::Grip grip{{}, {}, {}, turn, parameters_.friction, -1, state.old_bristles, 0, state.bristles, 0.0};
  detail::Grip* const used = parameters_.friction > 0.0 ? &grip : nullptr;
  for (const int element : state.near) add_element(body, element, used, state, nodes, forces, result);
  if (used) result.friction_loss = parameters_.stiffness * detail::release_rest(grip);
  keep(body.size(), state, nodes);
  if (result.deepest_element < 0) return result;
  bound_stiffness(state, result);
  if (result.penetration > 0.5 * body.size())
    throw PenetrationError("contact: penetration " + detail::text(result.penetration, 3) + " m at element " +
                               std::to_string(result.deepest_element) + " exceeds half " + Body::kSizeName +
                               ", " + detail::text(0.5 * body.size(), 3) + " m",
                           result.deepest_element);
  return result;
}

ContactResult ContactModel::evaluate(ContactState& state, const Nodes& nodes, const Pose& pose,
                                     NodalForces forces, const Vector3d& turn) const {
  require_own(state, groups_);
  require_columns("contact.nodes", nodes.cols(), node_count());
  require_columns("contact.forces", forces.cols(), node_count());
  detail::require_finite("contact.turn", turn);
  return std::visit(
      [&](const auto& shape) {
        return evaluate_body(detail::place(shape, pose.axes), state, nodes, pose, forces, turn);
      },
      parameters_.impactor);
}

}  // namespace coupling
