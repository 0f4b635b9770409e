// SPDX-License-Identifier: Apache-2.0
// What `gasjet check` knows of a case, as JSON for other programs.
#include <cmath>
#include <nlohmann/json.hpp>

#include "commands/check.hpp"
#include "commands/json_head.hpp"
#include "membrane/time_step.hpp"
#include "scene/jet_peak.hpp"
#include "scene/supply.hpp"
#include "step/drift.hpp"
#include "step/stages.hpp"

namespace driver::commands {
namespace {

using nlohmann::json;

// Every setting of the case, as nested tables and arrays.
json settings_of(const CaseDocument& document) {
  json settings = json::object();
  for (const auto& setting : document.settings()) {
    json* node = &settings;
    for (const auto& part : split_path(setting.path))
      node = part.index ? &(*node)[*part.index] : &(*node)[part.key];
    *node = json::parse(setting.value);
  }
  return settings;
}

json defaults_of(const CaseDocument& document) {
  json defaults = json::array();
  for (const auto& setting : document.settings())
    if (setting.is_default) defaults.push_back(setting.path);
  return defaults;
}

json species_of(const gas::Thermo& thermo) {
  json all = json::object();
  for (std::size_t k = 0; k < thermo.size(); ++k) {
    const gas::Species& s = thermo.species(k);
    json& one =
        all[s.name] = {{"gas_constant_J_kg_K", thermo.gas_constant(k)}, {"molar_mass_kg_mol", s.molar_mass}};
    if (s.constant_cp)
      one["constant_cp_J_kg_K"] = s.low[0] * thermo.gas_constant(k);
    else
      one.update({{"minimum_temperature_K", s.minimum_temperature},
                  {"joint_temperature_K", gas::kJointTemperature},
                  {"maximum_temperature_K", s.maximum_temperature},
                  {"coefficients_low", s.low},
                  {"coefficients_high", s.high}});
  }
  return all;
}

// By mass, `air` resolved.
json fractions_of(const gas::Thermo& thermo, const std::vector<double>& mass_fractions) {
  json all = json::object();
  for (std::size_t k = 0; k < mass_fractions.size(); ++k)
    if (mass_fractions[k] > 0.0) all[thermo.species(k).name] = mass_fractions[k];
  return all;
}

json point_of(const BagPart& bag, int node) {
  const Eigen::Vector3d point = bag.mesh.nodes.col(node);
  return {point.x(), point.y(), point.z()};
}

// Where the straps begin and end in the design shape; a generated mesh brings its own places.
json straps_of(const BagPart& bag) {
  json straps = json::array();
  for (const auto& strap : bag.model.description.straps)
    straps.push_back({{"from_m", point_of(bag, strap.node_a)}, {"to_m", point_of(bag, strap.node_b)}});
  return straps;
}

json bag_of(const Scene& scene, const State& state) {
  const BagPart& bag = *scene.bag;
  const auto shares =
      membrane::stiffness_shares(bag.model, *state.bag, state.gas_point.gamma, state.gas_point.pressure);
  const double drift = drift_limit(scene, state);
  json plates = json::array();
  for (const auto& plate : bag.model.description.plates) plates.push_back(plate.stiffness.value());
  json all = {{"elements", bag.model.element_count},
              {"nodes", bag.model.node_count},
              {"mass_kg", bag.model.fabric_mass}};
  if (scene.gas)
    all.update({{"initial_volume_m3", state.bag->surface.volume},
                {"design_volume_m3", membrane::enclosed_volume(bag.mesh.nodes, bag.mesh.elements)}});
  all.update({{"straps", straps_of(bag)},
              {"plate_stiffness_N_m3", plates},
              {"critical_step_s", critical_step(scene, shares)},
              {"drift_step_s", std::isfinite(drift) ? json(drift) : json(nullptr)},
              {"omega_squared_1_s2",
               {{"elements", shares.element},
                {"gas", shares.gas},
                {"straps", shares.strap},
                {"plates", shares.plate}}}});
  return all;
}

json inflators_of(const Scene& scene) {
  json inflators = json::array();
  const gas::ControlVolumeModel& model = scene.gas->model;
  for (std::size_t i = 0; i < model.inflows.size(); ++i) {
    const auto [time, point] = inflator_peak(scene, i);
    inflators.push_back({{"peak_time_s", time},
                         {"peak_flow_kg_s", point.mass_flow},
                         {"temperature_K", point.temperature},
                         {"gas_constant_J_kg_K", point.gas_constant},
                         {"gamma", point.gamma},
                         {"mass_fractions", fractions_of(model.thermo, model.inflows[i].mass_fractions)}});
  }
  return inflators;
}

json jets_of(const Scene& scene) {
  json jets = json::array();
  for (const auto& part : scene.jets) {
    const JetPeak peak = jet_peak(scene, part);
    jets.push_back({{"inflator_number", part.inflator},
                    {"peak_time_s", peak.time},
                    {"peak_velocity_m_s", peak.outlet.velocity},
                    {"peak_density_kg_m3", peak.outlet.density},
                    {"peak_outlet_pressure_Pa", peak.outlet.pressure},
                    {"peak_momentum_N", jet::momentum_flux(peak.outlet, part.outlet.area)},
                    {"cut_off_loss", jet::momentum_loss(part.field.model())}});
  }
  return jets;
}

json full_volume_of(const FullState& full) {
  json all = {
      {"volume_m3", full.volume}, {"closed_pressure_Pa", full.closed_pressure}, {"fills", full.fills}};
  if (full.fills)
    all.update({{"pressure_Pa", full.pressure},
                {"vent_outflow_kg_s", full.vent_flow},
                {"fabric_outflow_kg_s", full.fabric_flow}});
  return all;
}

json derived_of(const Scene& scene, const State& state, const Forecast& f) {
  json derived = {{"step_s", f.step}};
  if (scene.has_volume())
    derived["gas_at_start"] = {
        {"mass_kg", state.gas_point.mass},
        {"pressure_Pa", state.gas_point.pressure},
        {"temperature_K", state.gas_point.temperature},
        {"gamma", state.gas_point.gamma},
        {"mass_fractions", fractions_of(scene.gas->model.thermo, scene.gas->initial_fractions)}};
  if (f.full) derived["full_volume"] = full_volume_of(*f.full);
  if (scene.gas) derived["inflators"] = inflators_of(scene);
  if (scene.gas) derived["supply"] = {{"mass_kg", f.supply.mass}, {"peak_flow_kg_s", f.supply.peak_flow}};
  if (scene.bag) derived["bag"] = bag_of(scene, state);
  if (!scene.jets.empty()) derived["jets"] = jets_of(scene);
  if (scene.pendulum)
    derived["pendulum"] = {{"axis_inertia_kg_m2", scene.pendulum->model.axis_inertia()},
                           {"effective_mass_kg", scene.pendulum->model.effective_mass()}};
  if (scene.contact) derived["contact_stiffness_N_m3"] = scene.contact->parameters().stiffness;
  return derived;
}

}  // namespace

std::string check_json(const CaseDocument& document, const Scene& scene, const State& state,
                       const Forecast& f) {
  json groups = json::array();
  for (const Group& g : f.groups)
    groups.push_back({{"name", g.name},
                      {"equation", g.equation},
                      {"meaning", g.meaning},
                      {"value", std::isfinite(g.value) ? json(g.value) : json("infinite")},
                      {"verdict", verdict(g)}});
  auto warnings = scene.warnings;
  if (std::string advice = gas_advice(scene, f); !advice.empty()) warnings.push_back(std::move(advice));
  auto all = json_head<json>();
  all.update({{"settings", settings_of(document)},
              {"defaults", defaults_of(document)},
              {"warnings", warnings},
              {"derived", derived_of(scene, state, f)},
              {"forecast", groups}});
  if (scene.gas) all["species"] = species_of(scene.gas->model.thermo);
  return all.dump(2);
}

}  // namespace driver::commands
