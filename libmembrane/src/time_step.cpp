// SPDX-License-Identifier: Apache-2.0
#include "membrane/time_step.hpp"

#include <cmath>
#include <string>

#include "blocks.hpp"
#include "checks.hpp"
#include "element.hpp"
#include "law_functions.hpp"
#include "membrane/error.hpp"

namespace membrane {

namespace {

double gas_frequency(const BagState& state, double gamma, double pressure) {
  if (gamma == 0.0) return 0.0;
  if (!(state.surface.volume > 0.0))
    throw MembraneError("critical step: the enclosed volume is " + std::to_string(state.surface.volume) +
                        " m3, gas needs it to be positive");
  return gamma * pressure / state.surface.volume * state.surface.gradient_mobility;
}

PlaneStrain<double> strain_of(const BagModel& model, const BagState& state, int element) {
  const auto [group, lane] = place_of(model.elements, static_cast<std::size_t>(element));
  const ElementGroup& g = model.elements.group[group];
  const auto x = state.position.map();
  const Eigen::Vector3i corner = model.description.elements.col(element);
  const Eigen::Vector3d a = x.col(corner[0]);
  const Eigen::Vector3d ab = x.col(corner[1]) - a, ac = x.col(corner[2]) - a;
  double f1[3], f2[3];
  for (int i = 0; i < 3; ++i) {
    f1[i] = stretch_1(ab[i], g.gradient_b1[lane]);
    f2[i] = stretch_2(ab[i], ac[i], g.gradient_b2[lane], g.gradient_c2[lane]);
  }
  return green_lagrange_strain(f1, f2);
}

}  // namespace

StiffnessShares stiffness_shares(const BagModel& model, const BagState& state, double gamma, double pressure,
                                 double contact) {
  require_not_negative("stiffness_shares", "gamma", gamma);
  require_not_negative("stiffness_shares", "pressure", pressure);
  require_not_negative("stiffness_shares", "contact", contact);
  return {state.forces.element_frequency, gas_frequency(state, gamma, pressure), contact,
          model.strap_frequency, model.plate_frequency};
}

double critical_time_step(const StiffnessShares& shares) {
  const double total = shares.total();
  if (!(std::isfinite(total) && total > 0.0))
    throw MembraneError("critical step: the sum of stiffnesses is not finite and positive");
  return 2.0 / std::sqrt(total);
}

double force_mobility(const BagModel& model, const BagState& state) {
  double sum = 0.0;
  for (int n = 0; n < model.node_count; ++n) {
    Eigen::Vector3d force =
        state.membrane_force.map().col(n) + state.gauge_pressure * state.volume_gradient.map().col(n);
    for (const Vectors* extra : {&state.jet_force, &state.support_force, &state.contact_force})
      if (!extra->empty()) force += extra->map().col(n);
    const auto inverse_mass = model.inverse_mass.map().col(n);
    const Eigen::Vector3d moving = (inverse_mass.array() > 0.0).select(force, 0.0);
    sum += moving.squaredNorm() * inverse_mass.maxCoeff();
  }
  return sum;
}

double strap_mobility(const BagModel& model, const BagState& state) {
  const auto x = state.position.map(), v = state.velocity.map();
  double sum = 0.0;
  for (std::size_t i = 0; i < model.description.straps.size(); ++i) {
    const Strap& s = model.description.straps[i];
    const Eigen::Vector3d span = x.col(s.node_b) - x.col(s.node_a);
    const double parting = span.normalized().dot(v.col(s.node_b) - v.col(s.node_a));
    const auto inverse_mass = model.inverse_mass.map();
    const double mobility = inverse_mass.col(s.node_a).maxCoeff() + inverse_mass.col(s.node_b).maxCoeff();
    sum += s.stiffness * parting * parting + state.strap_tension[i] * state.strap_tension[i] * mobility;
  }
  return sum;
}

ElementResponse element_response(const BagModel& model, const BagState& state, int element) {
  if (element < 0 || element >= model.element_count)
    reject("element_response", "element", element, "0 to " + std::to_string(model.element_count - 1));
  const ElementPlace place = place_of(model.elements, static_cast<std::size_t>(element));
  const FrequencyGroup& bound = state.shares.frequency[place.group];
  ElementResponse r;
  r.strain = strain_of(model, state, element);
  r.response =
      law_functions(model.law).response(model.description.compression, r.strain,
                                        model.elements.fabric_of(place.group), place.lane, model.threads);
  r.frequency = frequency_bound(bound.material[place.lane], bound.geometric[place.lane],
                                r.response.tangent_factor, r.response.stress_1);
  return r;
}

void largest_strains(const BagModel& model, const BagState& state, std::span<double> strains) {
  if (std::ssize(strains) != model.element_count)
    reject("largest_strains", "strains", static_cast<double>(strains.size()), "one per element");
  for (int e = 0; e < model.element_count; ++e) {
    const PlaneStrain<double> strain = strain_of(model, state, e);
    const double mean = 0.5 * (strain.e11 + strain.e22), difference = 0.5 * (strain.e11 - strain.e22);
    strains[static_cast<std::size_t>(e)] =
        mean + std::sqrt(difference * difference + strain.e12 * strain.e12);
  }
}

int governing_element(const BagModel& model, const BagState& state) {
  int governing = 0;
  double largest = -1.0;
  for (int e = 0; e < model.element_count; ++e) {
    const double frequency = element_response(model, state, e).frequency;
    if (frequency > largest) {
      largest = frequency;
      governing = e;
    }
  }
  return governing;
}

}  // namespace membrane
