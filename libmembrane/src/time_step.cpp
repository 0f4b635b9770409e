// SPDX-License-Identifier: Apache-2.0
#include "membrane/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "blocks.hpp"
#include "checks.hpp"
#include "element.hpp"
#include "kernel_table.hpp"
#include "law_functions.hpp"
#include "membrane/error.hpp"

namespace membrane {

namespace {

double gas_frequency(const BagState& state, double gamma, double pressure) {
  if (gamma == 0.0) return 0.0;
  if (!(state.surface.volume > 0.0))
    throw MembraneError("critical step: the enclosed volume is " + std::to_string(state.surface.volume) +
                        " m3, which must be positive for gas");
  return gamma * pressure / state.surface.volume * state.surface.gradient_mobility;
}

// |dF/dt|^2 of an element [1/s2].
double rate_squared(const BagModel& model, const BagState& state, std::int32_t element) {
  const auto v = state.velocity.map();
  const Eigen::Vector3i corner = model.description.elements.col(element);
  const Eigen::Matrix<double, 2, 3>& gradient = model.stiffness[static_cast<std::size_t>(element)].gradient;
  const Eigen::Vector3d a = v.col(corner[0]), ab = v.col(corner[1]) - a, ac = v.col(corner[2]) - a;
  double sum = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double f1 = stretch_1(ab[i], gradient(0, 1));
    const double f2 = stretch_2(ab[i], ac[i], gradient(1, 1), gradient(1, 2));
    sum += f1 * f1 + f2 * f2;
  }
  return sum;
}

struct Fastest {
  double rate_squared;  // [1/s2]
  std::int32_t element;
};

double speed_squared(const BagState& state, int node) {
  const double* v = state.velocity.data() + 4 * static_cast<std::ptrdiff_t>(node);
  return (v[0] * v[0] + v[1] * v[1]) + v[2] * v[2];
}

// |dF/dt|^2 <= sum of |v_a|^2 times sum of |grad N_a|^2, by Cauchy and Schwarz.
Fastest fastest_around(const BagModel& model, const BagState& state, int node, Fastest fastest) {
  const auto row = static_cast<std::size_t>(node);
  for (auto k = model.corners.row_begin[row]; k < model.corners.row_begin[row + 1]; ++k) {
    const std::int32_t element = model.corners.element[static_cast<std::size_t>(k)];
    double speeds = 0.0;
    for (const int corner : model.description.elements.col(element)) speeds += speed_squared(state, corner);
    const double bound = speeds * model.gradient_squared[static_cast<std::size_t>(element)];
    if (!(bound > fastest.rate_squared)) continue;
    if (const double squared = rate_squared(model, state, element); squared > fastest.rate_squared)
      fastest = {squared, element};
  }
  return fastest;
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
  check_state(model, state);
  require_not_negative("stiffness_shares", "gamma", gamma);
  require_not_negative("stiffness_shares", "pressure", pressure);
  require_not_negative("stiffness_shares", "contact", contact);
  return {state.forces.element_frequency,
          gas_frequency(state, gamma, pressure),
          contact,
          model.strap_frequency,
          model.plate_frequency,
          model.description.stiffness_damping * state.forces.element_frequency};
}

double critical_time_step(const StiffnessShares& shares, double jet_damping) {
  require_not_negative("critical_time_step", "damping", shares.damping);
  require_not_negative("critical_time_step", "jet_damping", jet_damping);
  const double total = shares.total();
  if (!(std::isfinite(total) && total > 0.0))
    throw MembraneError("critical step: the sum of stiffnesses is not finite and positive");
  const double undamped = 2.0 / std::sqrt(total), rate = jet_damping + shares.damping;
  return 4.0 / (rate + std::sqrt(rate * rate + 16.0 / (undamped * undamped)));
}

double force_mobility(const BagModel& model, const BagState& state) {
  check_state(model, state);
  double sum = 0.0;
  for (int n = 0; n < model.node_count; ++n) {
    Eigen::Vector3d force =
        state.membrane_force.map().col(n) + state.gauge_pressure * state.volume_gradient.map().col(n);
    for (const Vectors* extra :
         {&state.jet_force, &state.support_force, &state.contact_force, &state.own_force})
      if (!extra->empty()) force += extra->map().col(n);
    const auto inverse_mass = model.inverse_mass.map().col(n);
    const Eigen::Vector3d moving = (inverse_mass.array() > 0.0).select(force, 0.0);
    sum += moving.squaredNorm() * inverse_mass.maxCoeff();
  }
  return sum;
}

double strap_mobility(const BagModel& model, const BagState& state) {
  check_state(model, state);
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

double bounce_time_step(const BagModel& model) {
  constexpr double most = 1.5;  // (omega dt)^2 of straps and plates that open and close many times
  const double frequency = model.strap_frequency + model.plate_frequency;
  return frequency > 0.0 ? std::sqrt(most / frequency) : std::numeric_limits<double>::infinity();
}

double energy_time_step(const BagModel& model, const BagState& state, double energy, double mobility,
                        bool at_rest) {
  if (!(energy >= 0.0)) reject("energy_time_step", "energy", energy, ">= 0");
  if (!(mobility >= 0.0)) reject("energy_time_step", "mobility", mobility, ">= 0");
  // Shares of the energy. A single spring that opens and closes, and fabric that moves as a whole, drift by
  // the full error; the many waves of fabric without compression partly cancel each other's errors.
  constexpr double share_together = 1e-4, share_apart = 1.4e-3;
  const bool together = at_rest || model.description.compression == Compression::linear;
  const double rate =
      mobility / (together ? share_together : share_apart) + strap_mobility(model, state) / share_together;
  const double bounce = bounce_time_step(model);
  return rate > 0.0 ? std::min(std::sqrt(8.0 * energy / rate), bounce) : bounce;
}

DeformationRate deformation_rate(const BagModel& model, const BagState& state, double floor) {
  check_state(model, state);
  Fastest fastest{floor * floor, -1};
  for (std::size_t chunk = 0; chunk < state.rate_bound_squared.size(); ++chunk) {
    if (!(state.rate_bound_squared[chunk] > fastest.rate_squared)) continue;
    const int first = static_cast<int>(chunk) * kRateNodes;
    for (int n = first; n < std::min(first + kRateNodes, model.node_count); ++n)
      if (speed_squared(state, n) * model.node_gradient_squared[static_cast<std::size_t>(n)] >
          fastest.rate_squared)
        fastest = fastest_around(model, state, n, fastest);
  }
  return {fastest.element < 0 ? floor : std::sqrt(fastest.rate_squared), fastest.element};
}

ElementResponse element_response(const BagModel& model, const BagState& state, int element) {
  check_state(model, state);
  if (element < 0 || element >= model.element_count)
    reject("element_response", "element", element, "0 to " + std::to_string(model.element_count - 1));
  const ElementPlace place = place_of(model.elements, static_cast<std::size_t>(element));
  const FrequencyGroup& bound = state.shares.frequency[place.group];
  ElementResponse r;
  r.strain = strain_of(model, state, element);
  r.response =
      law_functions(model.law).response(model.description.compression, r.strain,
                                        model.elements.fabric_of(place.group), place.lane, model.yarns);
  r.frequency = frequency_bound(bound.material[place.lane], bound.geometric[place.lane],
                                r.response.tangent_factor, r.response.stress_1);
  return r;
}

void largest_strains(const BagModel& model, const BagState& state, std::span<double> strains) {
  check_state(model, state);
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
