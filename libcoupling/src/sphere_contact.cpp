// SPDX-License-Identifier: Apache-2.0
#include "coupling/sphere_contact.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "check.hpp"
#include "contact_search.hpp"

namespace coupling {
namespace {

using Eigen::Vector3d;

// One element in the sphere's frame: x(xi, eta) = origin + xi first + eta second.
struct Element {
  Vector3d origin, first, second;  // [m]
  double weight;                   // [m2] of one quadrature point
  int subdivision;
};

// What the touched points of one element add up to.
struct ElementSums {
  Vector3d force[3] = {Vector3d::Zero(), Vector3d::Zero(),
                       Vector3d::Zero()};  // [N] on the corners, over kappa
  double shape[3] = {0.0, 0.0, 0.0};       // [m2] sum_q w_q N_a
  double energy = 0.0, area = 0.0;
  double least_distance2;  // [m2] of touched points and r^2
};

void add_point(const Element& element, double radius, double xi, double eta, ElementSums& sums) {
  const Vector3d x = element.origin + xi * element.first + eta * element.second;
  const double distance2 = x.squaredNorm();
  if (!(distance2 < radius * radius)) return;
  sums.least_distance2 = std::min(sums.least_distance2, distance2);
  const double distance = std::sqrt(distance2);
  const double depth = radius - distance;
  const double shape[3] = {1.0 - xi - eta, xi, eta};
  // A point at the centre has no normal; its depth r > r/2 is thrown for by the caller.
  const Vector3d push = (distance > 0.0 ? element.weight * depth / distance : 0.0) * x;
  for (int i = 0; i < 3; ++i) {
    sums.force[i] += shape[i] * push;
    sums.shape[i] += shape[i] * element.weight;
  }
  sums.energy += 0.5 * element.weight * depth * depth;
  sums.area += element.weight;
}

// Points (j + offset)/n of one row that can lie in the sphere: the row's chord, one point more on either
// side.
void add_row(const Element& element, double radius, int row, double offset, int count, ElementSums& sums) {
  const double n = element.subdivision;
  const double eta = (row + offset) / n;
  const Vector3d start = element.origin + eta * element.second;
  const double length2 = element.first.squaredNorm(), middle = -start.dot(element.first);
  const double discriminant = middle * middle - length2 * (start.squaredNorm() - radius * radius);
  const double slack = 1e-9 * length2 * radius * radius;  // round-off near a grazing row
  if (discriminant < -slack || !(length2 > 0.0)) return;
  const double half_chord = std::sqrt(std::max(discriminant, 0.0));
  const double low = (middle - half_chord) / length2 * n - offset - 1.0;
  const double high = (middle + half_chord) / length2 * n - offset + 1.0;
  const int begin = static_cast<int>(std::clamp(std::ceil(low), 0.0, static_cast<double>(count)));
  const int end = static_cast<int>(std::clamp(std::floor(high) + 1.0, 0.0, static_cast<double>(count)));
  for (int j = begin; j < end; ++j) add_point(element, radius, (j + offset) / n, eta, sums);
}

ElementSums integrate(const Element& element, double radius) {
  ElementSums sums;
  sums.least_distance2 = radius * radius;
  for (int row = 0; row < element.subdivision; ++row) {
    add_row(element, radius, row, 1.0 / 3.0, element.subdivision - row, sums);
    add_row(element, radius, row, 2.0 / 3.0, element.subdivision - row - 1, sums);
  }
  return sums;
}

// No point of a sub-triangle is farther from its centroid than two thirds of its longest edge.
double cover(const Element& element) {
  const double edge2 = std::max({element.first.squaredNorm(), element.second.squaredNorm(),
                                 (element.second - element.first).squaredNorm()});
  return 2.0 / 3.0 * std::sqrt(edge2) / element.subdivision;
}

void check_nodes(const Triangles& triangles, Eigen::Index node_count) {
  for (Eigen::Index e = 0; e < triangles.cols(); ++e)
    for (int i = 0; i < 3; ++i)
      if (triangles(i, e) < 0 || triangles(i, e) >= node_count)
        detail::reject("contact.triangles[" + std::to_string(e) + "]", std::to_string(triangles(i, e)),
                       "a node number");
}

int subdivision_of(const std::string& field, double longest_edge, double radius) {
  const double n = std::ceil(4.0 * longest_edge / radius);
  if (!(n <= ContactModel::kMaxSubdivision))
    detail::reject(field, detail::text(longest_edge) + " m long",
                   "at most 128 radii of the sphere long (refine the mesh)");
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
  detail::require_positive("contact.sphere_radius", parameters.sphere_radius);
  detail::require_positive("contact.stiffness", parameters.stiffness);
  detail::require_positive("contact.effective_mass", effective_mass);
  if (masses_.size() != static_cast<std::size_t>(reference.cols()))
    detail::reject("contact.masses", std::to_string(masses_.size()) + " values", "one value a node");
  for (std::size_t a = 0; a < masses_.size(); ++a)
    detail::require_positive("contact.masses[" + std::to_string(a) + "]", masses_[a]);
  check_nodes(triangles, reference.cols());
  for (Eigen::Index e = 0; e < triangles.cols(); ++e) {
    const std::string field = "contact.reference element " + std::to_string(e);
    const Vector3d a = reference.col(triangles(0, e)), b = reference.col(triangles(1, e)),
                   c = reference.col(triangles(2, e));
    const double area = 0.5 * (b - a).cross(c - a).norm();
    detail::require_positive(field + " area", area);
    const double edge = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    const int n = subdivision_of(field, edge, parameters.sphere_radius);
    subdivision_.push_back(n);
    weights_.push_back(area / (static_cast<double>(n) * n));
  }
  for (const int e : open_elements) {
    if (e < 0 || e >= element_count())
      detail::reject("contact.open_elements", std::to_string(e), "an element number");
    weights_[static_cast<std::size_t>(e)] = 0.0;
  }
}

ContactState ContactModel::make_state() const {
  ContactState state;
  state.nodes = Eigen::Matrix3Xd::Zero(3, node_count());
  state.next_nodes = state.nodes;
  state.near.reserve(subdivision_.size());
  state.nodal_stiffness.assign(masses_.size(), 0.0);
  return state;
}

// Takes the new level into the state: certificate or sweep for the path, then a valid list.
void ContactModel::follow(ContactState& state, const Nodes& nodes, const Vector3d& centre) const {
  const double radius = parameters_.sphere_radius;
  const double motion =
      detail::copy_and_measure_motion(nodes, state.nodes, state.next_nodes) + (centre - state.centre).norm();
  if (!std::isfinite(motion)) throw ContactError("contact: a node or the sphere's centre is not finite");
  // No skin point was nearer to the centre than `clearance`: less motion than that cannot bring them
  // together.
  if (state.started && !(motion < state.clearance))
    detail::sweep_centre_path(triangles_, radius, centre, state);
  state.nodes.swap(state.next_nodes);
  state.centre = centre;
  state.travelled += motion;
  if (!state.started || !(state.travelled < state.reach))
    detail::search_near_elements(triangles_, radius, state);
  state.started = true;
}

void ContactModel::add_element(int e, ContactState& state, NodalForces& forces, ContactResult& result) const {
  const double radius = parameters_.sphere_radius, kappa = parameters_.stiffness;
  if (!detail::may_reach(triangles_, state.nodes, e, state.centre, radius)) return;
  const auto corner = triangles_.col(e);
  const Vector3d a = state.nodes.col(corner[0]) - state.centre, b = state.nodes.col(corner[1]) - state.centre,
                 c = state.nodes.col(corner[2]) - state.centre;
  const auto index = static_cast<std::size_t>(e);
  const Element element{a, b - a, c - a, weights_[index], subdivision_[index]};
  const ElementSums sums = integrate(element, radius);
  const double distance = std::sqrt(sums.least_distance2);
  state.clearance = std::min(state.clearance, distance - cover(element));
  if (!(sums.area > 0.0)) return;
  for (int i = 0; i < 3; ++i) {
    const Vector3d force = kappa * sums.force[i];
    forces.col(corner[i]) += force;
    result.force -= force;
    state.nodal_stiffness[static_cast<std::size_t>(corner[i])] += kappa * sums.shape[i];
  }
  result.energy += kappa * sums.energy;
  result.area += sums.area;
  if (result.deepest_element < 0 || radius - distance > result.penetration) {
    result.penetration = radius - distance;
    result.deepest_element = e;
  }
}

// (K.12) The Hessian of kappa (r-d)^2/2 is kappa n n^T less a positive part, so per node the sum of its row's
// 3 x 3 blocks is at most sum_q w_q kappa N_a (sum_b N_b). Leaves nodal_stiffness zero.
void ContactModel::bound_stiffness(ContactState& state, ContactResult& result) const {
  for (const auto& [e, slack] : state.near)
    for (const int node : triangles_.col(e)) {
      const auto a = static_cast<std::size_t>(node);
      result.omega_squared_skin = std::max(result.omega_squared_skin, state.nodal_stiffness[a] / masses_[a]);
    }
  for (const auto& [e, slack] : state.near)
    for (const int node : triangles_.col(e)) state.nodal_stiffness[static_cast<std::size_t>(node)] = 0.0;
  result.omega_squared_sphere = parameters_.stiffness * result.area / effective_mass_;
}

ContactResult ContactModel::evaluate(ContactState& state, const Nodes& nodes, const Vector3d& centre,
                                     NodalForces forces) const {
  if (nodes.cols() != node_count() || forces.cols() != node_count())
    detail::reject("contact.nodes", std::to_string(nodes.cols()) + " columns", "as many as at build");
  follow(state, nodes, centre);
  ContactResult result;
  state.clearance = parameters_.sphere_radius;
  for (const auto& [element, slack] : state.near)
    if (!(state.travelled < slack)) add_element(element, state, forces, result);
  if (result.deepest_element < 0) return result;
  bound_stiffness(state, result);
  if (result.penetration > 0.5 * parameters_.sphere_radius)
    throw ContactError("contact: penetration " + detail::text(result.penetration) + " m at element " +
                       std::to_string(result.deepest_element) + " exceeds half the sphere's radius, " +
                       detail::text(0.5 * parameters_.sphere_radius) + " m");
  return result;
}

double default_contact_stiffness(double share, double omega_squared_other, double surface_density) {
  detail::require_positive("contact.share", share);
  detail::require_positive("contact.omega_squared_other", omega_squared_other);
  detail::require_positive("contact.surface_density", surface_density);
  return share * omega_squared_other * surface_density;
}

}  // namespace coupling
