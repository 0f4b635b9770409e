// SPDX-License-Identifier: Apache-2.0
// The results of `gasjet check` as JSON for other programs.
#include "forecast/check_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/curve_reader.hpp"
#include "base/json_head.hpp"
#include "engine/bag_mesh.hpp"
#include "engine/drift.hpp"
#include "engine/impactor.hpp"
#include "engine/stages.hpp"
#include "engine/supply.hpp"
#include "forecast/jet_peak.hpp"
#include "forecast/jet_push.hpp"
#include "forecast/self_contact_start.hpp"
#include "membrane/time_step.hpp"

namespace driver {
namespace {

using Json = nlohmann::ordered_json;

// Every setting of the case, as nested tables and arrays.
Json settings_of(const CaseDocument& document) {
  Json settings = Json::object();
  for (const auto& setting : document.settings()) {
    Json* node = &settings;
    for (const auto& part : split_path(setting.path))
      node = part.index ? &(*node)[*part.index] : &(*node)[part.key];
    *node = Json::parse(setting.value);
  }
  return settings;
}

Json defaults_of(const CaseDocument& document) {
  Json defaults = Json::array();
  for (const auto& setting : document.settings())
    if (setting.is_default) defaults.push_back(setting.path);
  return defaults;
}

// Curves that units, scale and the like change, as they are used.
Json curves_of(const CaseDocument& document) {
  Json curves = Json::object();
  for (const auto& curve : document.used_curves())
    if (curve.is_changed)
      curves[curve.path] = {{"abscissa", curve.abscissa},
                            {"unit", curve.unit},
                            {"knots", curve.data.time},
                            {"values", curve.data.value}};
  return curves;
}

Json species_of(const gas::Thermo& thermo) {
  Json all = Json::object();
  for (std::size_t k = 0; k < thermo.size(); ++k) {
    const gas::Species& s = thermo.species(k);
    Json& one =
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

// Fractions by mass; air as its four species.
Json fractions_of(const gas::Thermo& thermo, const std::vector<double>& mass_fractions) {
  Json all = Json::object();
  for (std::size_t k = 0; k < mass_fractions.size(); ++k)
    if (mass_fractions[k] > 0.0) all[thermo.species(k).name] = mass_fractions[k];
  return all;
}

Json point_of(const BagPart& bag, int node) {
  const Eigen::Vector3d point = bag.mesh.nodes.col(node);
  return {point.x(), point.y(), point.z()};
}

// Ends of the straps in the design shape; a generated mesh has its own.
Json straps_of(const BagPart& bag) {
  Json straps = Json::array();
  for (const auto& strap : bag.model.description.straps)
    straps.push_back({{"from_m", point_of(bag, strap.node_a)},
                      {"from_panels", panels_of_node(bag.mesh, strap.node_a)},
                      {"to_m", point_of(bag, strap.node_b)},
                      {"to_panels", panels_of_node(bag.mesh, strap.node_b)}});
  return straps;
}

Json bag_of(const Scene& scene, const State& state) {
  const BagPart& bag = *scene.bag;
  const auto shares =
      membrane::stiffness_shares(bag.model, *state.bag, state.gas_point.gamma, state.gas_point.pressure);
  const double drift = drift_limit(scene, state);
  Json plates = Json::array();
  for (const auto& plate : bag.model.description.plates) plates.push_back(plate.stiffness.value());
  Json all = {{"elements", bag.model.element_count},
              {"nodes", bag.model.node_count},
              {"mass_kg", bag.model.fabric_mass}};
  if (scene.gas)
    all.update({{"initial_volume_m3", state.bag->surface.volume},
                {"design_volume_m3", mesh::enclosed_volume(bag.mesh.nodes, bag.mesh.elements)}});
  all.update({{"straps", straps_of(bag)},
              {"plate_stiffness_N_m3", plates},
              {"critical_step_s", membrane::critical_time_step(shares)},
              {"drift_step_s", std::isfinite(drift) ? Json(drift) : Json(nullptr)},
              {"omega_squared_1_s2",
               {{"elements", shares.element},
                {"gas", shares.gas},
                {"straps", shares.strap},
                {"plates", shares.plate}}}});
  return all;
}

Json inflators_of(const Scene& scene) {
  Json inflators = Json::array();
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

Json jets_of(const Scene& scene) {
  Json jets = Json::array();
  for (const auto& part : scene.jets) {
    const JetPeak peak = jet_peak(scene, part);
    const JetPush push = jet_push(scene, part);
    jets.push_back({{"inflator_number", part.inflator},
                    {"share", part.share},
                    {"peak_time_s", peak.time},
                    {"peak_velocity_m_s", peak.outlet.velocity},
                    {"peak_density_kg_m3", peak.outlet.density},
                    {"peak_outlet_pressure_Pa", std::max(peak.outlet.pressure, peak.sonic_pressure)},
                    {"peak_momentum_N", jet::momentum_flux(peak.outlet, part.outlet.area)},
                    {"peak_area_ratio", peak.outlet.area_ratio},
                    {"peak_pressure_ratio", push.pressure_ratio},
                    {"rest_temperature_K", push.rest_temperature},
                    {"peak_outlet_momentum_N", push.momentum},
                    {"peak_thrust_N", push.thrust},
                    {"peak_plate_load_N", push.load},
                    {"peak_plate_load_most_N", push.most_load},
                    {"cut_off_loss", jet::momentum_loss(part.field.model())}});
    if (!scene.bag) continue;
    if (const auto range = restitution_range(scene, part.field.model()))
      jets.back().update({{"depth_over_width", range->depth_over_width},
                          {"restitution_low", range->low},
                          {"restitution_high", range->high}});
    if (part.outlet.temperature != jet::OutletTemperature::static_value) continue;
    const MissingEnergy missing = missing_energy(scene, part);
    jets.back()["missing_energy_J"] = missing.energy;
    if (missing.pressure) jets.back()["missing_pressure_Pa"] = *missing.pressure;
  }
  return jets;
}

Json full_volume_of(const FullState& full) {
  Json all = {
      {"volume_m3", full.volume}, {"closed_pressure_Pa", full.closed_pressure}, {"fills", full.fills}};
  if (full.fills)
    all.update({{"pressure_Pa", full.pressure},
                {"vent_outflow_kg_s", full.vent_flow},
                {"fabric_outflow_kg_s", full.fabric_flow}});
  return all;
}

Json self_contact_of(const Scene& scene) {
  const SelfContactStart start = self_contact_start(scene);
  return {{"stiffness_N_m3", scene.skin_contact->parameters().stiffness},
          {"share_of_fabric", start.share},
          {"critical_step_s", start.critical_step},
          {"limited_nodes", start.limited_nodes},
          {"smallest_gap_m", start.smallest_gap}};
}

Json derived_of(const Scene& scene, const State& state, const Forecast& f) {
  Json derived = {{"step_s", f.step}};
  if (scene.has_volume())
    derived["gas_at_start"] = {
        {"mass_kg", state.gas_point.mass},
        {"pressure_Pa", state.gas_point.pressure},
        {"temperature_K", state.gas_point.temperature},
        {"gamma", gamma_at_start(state, f)},
        {"mass_fractions", fractions_of(scene.gas->model.thermo, scene.gas->initial_fractions)}};
  if (f.full) derived["full_volume"] = full_volume_of(*f.full);
  if (scene.gas) derived["inflators"] = inflators_of(scene);
  if (scene.gas) derived["supply"] = {{"mass_kg", f.supply.mass}, {"peak_flow_kg_s", f.supply.peak_flow}};
  if (scene.bag) derived["bag"] = bag_of(scene, state);
  if (!scene.jets.empty()) derived["jets"] = jets_of(scene);
  if (scene.pendulum)
    derived["pendulum"] = {{"axis_inertia_kg_m2", scene.pendulum->model.axis_inertia()},
                           {"effective_mass_kg", scene.pendulum->model.effective_mass()}};
  if (scene.body) derived["impactor"] = {{"effective_mass_kg", impactor_mass(scene)}};
  if (scene.contact) derived["contact_stiffness_N_m3"] = scene.contact->parameters().stiffness;
  if (scene.skin_contact) derived["self_contact"] = self_contact_of(scene);
  return derived;
}

}  // namespace

std::string check_json(const CaseDocument& document, const Scene& scene, const State& state,
                       const Forecast& f) {
  Json groups = Json::array();
  for (const Group& g : f.groups)
    groups.push_back({{"name", g.name},
                      {"equation", g.equation},
                      {"meaning", g.meaning},
                      {"value", std::isfinite(g.value) ? Json(g.value) : Json("infinite")},
                      {"verdict", verdict(g)}});
  auto warnings = scene.warnings;
  if (std::string advice = gas_advice(scene, f); !advice.empty()) warnings.push_back(std::move(advice));
  Json derived = derived_of(scene, state, f);
  if (Json curves = curves_of(document); !curves.empty()) derived["curves"] = std::move(curves);
  auto all = json_head<Json>();
  all.update({{"settings", settings_of(document)},
              {"defaults", defaults_of(document)},
              {"warnings", warnings},
              {"derived", derived},
              {"forecast", groups}});
  if (scene.gas) all["species"] = species_of(scene.gas->model.thermo);
  return all.dump(2);
}

std::string check_file(const CaseDocument& document, const Scene& scene, const std::string& id) {
  try {
    const State state = state_at_start(scene);
    Json settings = Json::parse(check_json(document, scene, state, forecast(scene, state)));
    settings["run"] = id;
    return settings.dump(2) + '\n';
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace driver
