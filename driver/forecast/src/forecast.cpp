// SPDX-License-Identifier: Apache-2.0
#include "forecast/forecast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <elementary/exponential.hpp>
#include <numbers>

#include "engine/drift.hpp"
#include "engine/impactor.hpp"
#include "engine/stages.hpp"
#include "engine/supply.hpp"
#include "forecast/jet_peak.hpp"
#include "gas/orifice.hpp"
#include "membrane/time_step.hpp"

namespace driver {
namespace {

using std::numbers::pi;

// Mean side of the surface's elements as sewn, as of equilateral triangles of the same area.
double mean_side(const Scene& scene) {
  const auto& model = scene.bag->model;
  double area = 0.0;
  for (const double a : model.reference_area) area += a;
  return std::sqrt(4.0 * area / (std::sqrt(3.0) * model.element_count));
}

// Area mean of E h / (1 - nu) over the fabric [N/m].
double fabric_stiffness(const membrane::BagModel& model) {
  double sum = 0.0, area = 0.0;
  for (std::size_t e = 0; e < model.reference_area.size(); ++e) {
    const auto& p = model.description.properties[e];
    if (p.null_panel) continue;
    const double young_modulus =
        p.weave ? std::sqrt(p.young_modulus * p.weave->young_modulus_weft) : p.young_modulus;
    sum += model.reference_area[e] * young_modulus * p.thickness / (1.0 - p.poisson);
    area += model.reference_area[e];
  }
  return sum / area;
}

struct Groups {
  std::vector<Group> list;
  void add_size(std::string name, const char* equation, std::string meaning, double value) {
    list.push_back({std::move(name), equation, std::move(meaning), value, true});
  }
  void add_number(std::string name, const char* equation, std::string meaning, double value) {
    list.push_back({std::move(name), equation, std::move(meaning), value, false});
  }
};

// The faster relaxation rate [1/s] of two: the gas at the start with choked outflow, and the full volume.
double relaxation_rate(double mass_at_start, const Forecast& f) {
  if (!(mass_at_start > 0.0)) return f.full->relaxation;
  return std::max(gas::outflow_relaxation_rate(f.full->gamma, f.supply.peak_flow / mass_at_start, 1.0),
                  f.full->relaxation);
}

void add_gas(const Scene& scene, const State& state, const Forecast& f, Groups& groups) {
  const FullState& full = *f.full;
  const double ambient = scene.ambient.pressure, flow = f.supply.peak_flow;
  if (ambient > 0.0)
    groups.add_number("full_pressure", "K.31", "pressure of the full volume, relative to ambient",
                      full.pressure / ambient);
  if (ambient > 0.0 && !scene.gas->model.vents.empty())
    groups.add_number("vent_choking", "K.32", "that pressure relative to the one at which vents choke",
                      full.pressure / ambient * gas::critical_pressure_ratio(full.gamma));
  if (flow > 0.0 && full.vent_flow > 0.0)
    groups.add_size("vent_leak", "K.33", "outflow of the vents relative to the peak inflow",
                    full.vent_flow / flow);
  if (flow > 0.0 && full.fabric_flow > 0.0)
    groups.add_size("fabric_leak", "K.33", "outflow of the fabric relative to the peak inflow",
                    full.fabric_flow / flow);
  if (full.vent_flow + full.fabric_flow > 0.0)
    groups.add_number("gas_relaxation", "K.37", "relaxations of the gas in a step at the start",
                      f.step * relaxation_rate(state.gas_point.mass, f));
  if (full.relaxations > 0.0)
    groups.add_number("gas_relaxations_in_scene", "K.39", "relaxations of the gas in the whole scene",
                      full.relaxations);
}

// A jet's names in the groups.
std::string key_of(const JetPart& part) {
  std::string key = '_' + part.name;
  std::ranges::replace(key, '.', '_');
  return key;
}
std::string text_of(const JetPart& part) {
  return fmt::format("jet {}: ", part.name);
}

void add_jet_forces(const Scene& scene, const JetPart& part, const jet::OutletState& outlet,
                    const FullState& full, Groups& groups) {
  const jet::JetModel& model = part.field.model();
  const double excess = full.pressure - scene.ambient.pressure, bag = elementary::pow(full.volume, 1.0 / 3.0);
  const double flux =
      (1.0 + model.restitution * outlet.reflected) * outlet.density * outlet.velocity * outlet.velocity;
  groups.add_size(
      "jet_on_bag" + key_of(part), "K.35", text_of(part) + "its force relative to the pressure's on the bag",
      excess > 0.0 ? flux * part.outlet.area * outlet.area_ratio / (excess * bag * bag) : INFINITY);
  if (!scene.has_impactor()) return;
  const Eigen::Vector3d impactor = impactor_start(scene).centre;
  const double ratio =
      jet::relative_velocity(jet::widened(model, outlet.area_ratio), impactor).dot(model.axis);
  groups.add_size("jet_on_impactor" + key_of(part), "K.35",
                  text_of(part) + "its force relative to the pressure's on the impactor, not hidden",
                  excess > 0.0 ? flux * ratio * ratio / excess : INFINITY);
}

void add_jet_mesh(const Scene& scene, const JetPart& part, Groups& groups) {
  if (!scene.bag || !scene.has_impactor()) return;
  const jet::JetModel& model = part.field.model();
  const Eigen::Vector3d impactor = impactor_start(scene).centre;
  const double distance = (impactor - model.centre).dot(model.axis);
  if (!(distance > 0.0)) return;
  const double pieces =
      part.pieces ? std::sqrt(part.pieces->triangles().cols() / scene.bag->model.element_count) : 1.0;
  groups.add_size(
      "jet_mesh" + key_of(part), "K.38", text_of(part) + "(element side / its width at the impactor)^2",
      elementary::pow(mean_side(scene) / pieces / (2.0 * jet::section(model, distance).width), 2));
}

void add_jet(const Scene& scene, const JetPart& part, const Forecast& f, Groups& groups) {
  const JetPeak peak = jet_peak(scene, part);
  if (!(peak.mass_flow > 0.0)) return;
  groups.add_size("below_sonic" + key_of(part), "K.34",
                  text_of(part) + "share of the gas that leaves with an outlet pressure below ambient",
                  below_sonic_share(scene, part));
  if (f.full && f.full->fills) add_jet_forces(scene, part, peak.outlet, *f.full, groups);
  if (f.full) add_jet_mesh(scene, part, groups);
}

void add_bag(const Scene& scene, const FullState& full, Groups& groups) {
  const double radius = elementary::pow(0.75 * full.volume / pi, 1.0 / 3.0),
               stiffness = fabric_stiffness(scene.bag->model);
  if (full.fills)
    groups.add_size("fabric_stretch", "K.36",
                    "stiffness of the gas relative to the fabric's, for a breathing sphere",
                    1.5 * full.gamma * full.pressure * radius / stiffness);
  if (scene.contact)
    groups.add_size(
        "contact_mesh", "K.38", "(element side / diameter of the impactor)^2",
        elementary::pow(mean_side(scene) / (2.0 * coupling::size_of(scene.contact->parameters().impactor)),
                        2));
}

double first_step(const Scene& scene, const State& state) {
  if (scene.time.step) return *scene.time.step;
  if (!scene.bag) return scene.moves() ? 0.0 : scene.output.history_every;
  const double critical = membrane::critical_time_step(membrane::stiffness_shares(
      scene.bag->model, *state.bag, state.gas_point.gamma, state.gas_point.pressure));
  return scene.time.safety * std::min(critical, drift_limit(scene, state));
}

}  // namespace

Forecast forecast(const Scene& scene, const State& state) {
  Forecast f;
  f.step = first_step(scene, state);
  if (!scene.gas) return f;
  f.supply = supply_of(scene);
  Groups groups;
  if (scene.has_volume()) {
    f.full = full_state(scene, state, f.supply);
    if (f.full->fills) add_gas(scene, state, f, groups);
  }
  for (const JetPart& part : scene.jets) add_jet(scene, part, f, groups);
  if (scene.bag && f.full) add_bag(scene, *f.full, groups);
  f.groups = std::move(groups.list);
  return f;
}

double gas_substeps(const Scene& scene, double relaxations) {
  const gas::IntegratorOptions& options = scene.gas->integrator;
  const bool only_explicit =
      options.method == gas::Method::euler || options.method == gas::Method::runge_kutta_4;
  return only_explicit && options.fixed_step == 0.0 ? relaxations / gas::stability_limit(options.method)
                                                    : 0.0;
}

std::string gas_advice(const Scene& scene, const Forecast& f) {
  constexpr double many = 1e5;  // some 0.1 s, at a microsecond each; fewer are not worth a change of method
  if (!f.full) return {};
  const double all = gas_substeps(scene, f.full->relaxations);
  if (!(all > many)) return {};
  // Sub-steps in one call: a step at the peak flow, or all of a shorter pulse.
  const double of_a_step = gas_substeps(scene, std::min(f.full->relaxations, f.step * f.full->relaxation));
  const int most = scene.gas->integrator.maximum_steps;
  return fmt::format(
      "the gas method is explicit and needs some {:.1g} sub-steps for all relaxations (K.39){}; use "
      "time.gas_method = \"dormand_prince\", the default, or \"rosenbrock\"",
      all,
      of_a_step > most
          ? fmt::format("; some {:.1g} of them are in one step, where the run ends after {}", of_a_step, most)
          : "");
}

const char* verdict(const Group& group) {
  if (!group.is_size) return "";
  return group.value >= kMatters ? "matters" : group.value >= 0.01 ? "shows" : "negligible";
}

double gamma_at_start(const State& state, const Forecast& f) {
  return f.full && !(state.gas_point.mass > 0.0) ? f.full->gamma : state.gas_point.gamma;
}

}  // namespace driver
