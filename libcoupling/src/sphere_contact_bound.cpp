// SPDX-License-Identifier: Apache-2.0
// Effect of contact on the stable step: (K.12), (K.13).
#include <algorithm>
#include <cmath>

#include "check.hpp"
#include "coupling/sphere_contact.hpp"

namespace coupling {
namespace {

// Factors by which friction raises the two parts of (K.12).
struct FrictionFactors {
  double skin = 1.0, sphere = 1.0;
};

FrictionFactors friction_factors(double coefficient) {
  if (!(coefficient > 0.0)) return {};
  // Sticking adds the same stiffness at right angles; a sliding force, mu times the normal one, follows the
  // depth.
  const double skewed = std::sqrt(1.0 + coefficient * coefficient);
  // Friction acts at the sphere's surface, at most twice as far from a pivot as the centre (r <= L_i).
  return {skewed, 4.0 * skewed};
}

}  // namespace

// Centroids of sub-triangles integrate the shape functions exactly: each corner gets a third of the element's
// area.
double ContactModel::full_omega_squared_of_skin() const {
  std::vector<double> area(masses_.size(), 0.0);
  for (int e = 0; e < element_count(); ++e) {
    const double n = subdivision(e);
    for (const int node : triangles_.col(e))
      area[static_cast<std::size_t>(node)] += quadrature_[static_cast<std::size_t>(e)].weight * n * n / 3.0;
  }
  double largest = 0.0;
  for (std::size_t a = 0; a < area.size(); ++a) largest = std::max(largest, area[a] / masses_[a]);
  return parameters_.stiffness * largest * friction_factors(parameters_.friction).skin;
}

// (K.12) The Hessian of kappa (r-d)^2/2 is kappa n n^T less a positive part, so per node the sum of its row's
// 3 x 3 blocks is at most sum_q w_q kappa N_a (sum_b N_b). Leaves nodal_stiffness zero.
void ContactModel::bound_stiffness(ContactState& state, ContactResult& result) const {
  for (const int e : state.near)
    for (const int node : triangles_.col(e)) {
      const auto a = static_cast<std::size_t>(node);
      result.omega_squared_skin = std::max(result.omega_squared_skin, state.nodal_stiffness[a] / masses_[a]);
    }
  for (const int e : state.near)
    for (const int node : triangles_.col(e)) state.nodal_stiffness[static_cast<std::size_t>(node)] = 0.0;
  result.omega_squared_sphere = parameters_.stiffness * result.area / effective_mass_;
  const FrictionFactors factors = friction_factors(parameters_.friction);
  result.omega_squared_skin *= factors.skin;
  result.omega_squared_sphere *= factors.sphere;
}

double default_contact_stiffness(const StiffnessBudget& budget) {
  detail::require_positive("contact.stiffness_share", budget.share);
  detail::require_positive("contact.other_omega_squared", budget.other_omega_squared);
  detail::require_positive("contact.surface_density", budget.surface_density);
  require_valid(budget.impactor);
  detail::require_positive("contact.effective_mass", budget.effective_mass);
  detail::require_not_negative("contact.friction", budget.friction);
  const FrictionFactors factors = friction_factors(budget.friction);
  // At depth r/2, 3/4 of a sphere's great circle touch. The rotation of the force adds less than the last
  // quarter.
  const double section = section_of(budget.impactor);
  return budget.share * budget.other_omega_squared /
         (factors.skin / budget.surface_density + factors.sphere * section / budget.effective_mass);
}

}  // namespace coupling
