// SPDX-License-Identifier: Apache-2.0
#include "results/summary.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <span>

#include "engine/drift.hpp"

namespace driver {
namespace {

using Json = nlohmann::ordered_json;

// The members of every summary, of a run that goes on or has ended.
Json summary_head(const Scene& scene, const char* status, const Provenance& lines) {
  Json json{{"scene", scene.name}, {"status", status}};
  const auto run = std::ranges::find(lines, "run", &Provenance::value_type::first);
  if (run != lines.end()) json["run"] = run->second;
  json["warnings"] = scene.warnings;
  return json;
}

// Paths and overrides may have bytes that are not UTF-8.
std::string text_of(Json json, const Provenance& lines) {
  for (const auto& [key, value] : lines)
    if (key != "run") json["build"][key] = value;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

Json step_sizes(const Scene& scene, const State& state) {
  const StepSizes& step = state.step;
  Json json{{"min", step.minimum}, {"max", step.maximum}};
  if (!scene.bag) return json;
  if (!scene.time.step) {
    json["limited_by_drift"] = step.drift_limited;
    json["limited_by_deformation"] = step.deformation_limited;
    if (scene.skin_contact) json["limited_by_contact"] = step.approach_limited;
  } else {
    json["largest_deformation"] = step.deformation;
    if (scene.skin_contact) json["largest_approach"] = step.approach;
  }
  const double steps = std::max(1.0, static_cast<double>(state.steps));
  json["shares"] = {{"element", step.share_sums.element / steps},
                    {"gas", step.share_sums.gas / steps},
                    {"contact", (step.share_sums.contact - step.self_contact_sum) / steps},
                    {"strap", step.share_sums.strap / steps},
                    {"plate", step.share_sums.plate / steps}};
  if (scene.skin_contact) json["shares"]["self_contact"] = step.self_contact_sum / steps;
  return json;
}

Json residuals(const Scene& scene, const State& state) {
  Json json = Json::object();
  const double energy = state.peaks.energy_scale;
  const auto relative = [&](double joule) { return energy > 0.0 ? joule / energy : joule; };
  if (scene.has_volume()) json["mass_rel"] = state.peaks.mass_residual;
  if (scene.moves()) json["ledger_rel"] = relative(state.peaks.ledger_residual);
  if (scene.has_volume() || scene.moves()) json["energy_rel"] = energy_drift(state);
  if (scene.moves()) json["energy_of_mechanical"] = mechanical_drift(state);
  if (scene.bag && scene.gas) json["momentum_rel"] = state.peaks.momentum_residual;
  return json;
}

Json peaks(const Scene& scene, const State& state) {
  Json json = Json::object();
  const Peaks& p = state.peaks;
  if (scene.has_volume()) json["pressure_Pa"] = p.pressure;
  if (scene.bag && scene.gas) json["volume_m3"] = p.volume;
  if (!scene.jets.empty()) json["jet_force_N"] = p.jet_force;
  if (scene.pendulum) {
    json["pendulum_angle_rad"] = p.pendulum_angle;
    json["pendulum_cg_acceleration_m_s2"] = p.cg_acceleration;
  }
  if (scene.body) {
    json["impactor_displacement_m"] = p.displacement;
    json["impactor_acceleration_m_s2"] = p.acceleration;
  }
  if (scene.contact) {
    json["contact_force_N"] = p.contact_force;
    json["contact_penetration_m"] = p.penetration;
    json["contact_impulse_Ns"] = state.flows.contact_impulse;
    json["path_impulse_Ns"] = state.flows.path_impulse;
    json["first_contact_s"] = p.first_contact >= 0.0 ? Json(p.first_contact) : Json(nullptr);
  }
  return json;
}

/// Null for an event that never happened.
Json time_or_null(double time) {
  return std::isfinite(time) ? Json(time) : Json(nullptr);
}

/// When the vents last choked or unchoked, and when p last came to p_a.
Json moments(const State& state) {
  const gas::StepMoments& last = state.gas_events.last;
  return {{"sonic_switch_s", time_or_null(last.sonic_switch)},
          {"equalisation_s", time_or_null(last.equalisation)}};
}

/// Mass and enthalpy that each stream carried, from the start.
Json streams(const Scene& scene, const State& state) {
  Json json = Json::object();
  const auto entry = [](const gas::StreamFlux& flux, double at_ambient) {
    return Json{
        {"mass_kg", flux.mass}, {"enthalpy_J", flux.enthalpy}, {"sensible_J", flux.enthalpy - at_ambient}};
  };
  const gas::ControlVolumeModel& model = scene.gas->model;
  const auto incoming = [&](const gas::StreamFlux& flux, std::span<const double> fractions) {
    return entry(flux, flux.mass * std::inner_product(fractions.begin(), fractions.end(),
                                                      state.start.ambient_energy.begin(), 0.0));
  };
  const auto& outflow_ambient = state.streams.outflow_ambient;
  const std::size_t vents = model.vents.size();
  for (std::size_t i = 0; i < state.streams.inflows.size(); ++i) {
    Json& inflator = json["inflator." + std::to_string(i)] =
        incoming(state.streams.inflows[i], model.inflows[i].mass_fractions);
    const double fired = gas::firing_time(model.inflows[i], state.gas.triggers);
    inflator["fired_s"] = time_or_null(fired <= state.time ? fired : HUGE_VAL);
  }
  for (std::size_t j = 0; j < vents; ++j) {
    Json& vent = json["vent." + std::to_string(j)] = entry(state.streams.outflows[j], outflow_ambient[j]);
    vent["opened_s"] = time_or_null(state.gas_events.opened[j]);
    if (model.vents[j].backflow)
      json["vent." + std::to_string(j) + ".backflow"] =
          incoming(state.streams.backflows[j], model.ambient.mass_fractions);
  }
  const std::size_t fabrics = model.fabric_count();
  for (std::size_t i = 0; i < fabrics; ++i)
    if (const auto& out = state.streams.outflows[vents + i]; fabrics > 1 || out.mass > 0.0)
      json[fabrics > 1 ? "fabric." + std::to_string(i) : "fabric"] = entry(out, outflow_ambient[vents + i]);
  return json;
}

Json self_contact(const Scene& scene, const State& state) {
  const SelfContactRecord& record = state.peaks.self_contact;
  const bool touched = record.contacts > 0;
  Json json{{"limited_nodes_at_start", record.limited_at_start},
            {"smallest_limit_at_start_m", record.smallest_limit},
            {"limited_nodes_at_end", state.skin_contact_cache->limited_nodes()},
            {"most_contacts", record.contacts},
            {"most_contacts_s", touched ? Json(record.contacts_time) : Json(nullptr)},
            {"smallest_gap_m", touched ? Json(record.gap) : Json(nullptr)},
            {"smallest_gap_s", touched ? Json(record.gap_time) : Json(nullptr)}};
  if (scene.gas) json["one_room_from_s"] = time_or_null(record.one_room_from);
  return json;
}

/// Checks of the skin, and the maximum of each number.
Json self_intersection(const Scene& scene, const std::vector<SkinCheck>& checks) {
  Json list = Json::array(), largest{{"pairs", 0}, {"elements", 0}};
  const auto add = [&](Json& json, const char* key, auto value) {
    json[key] = value;
    if (largest.value(key, decltype(value){}) <= value) largest[key] = value;
  };
  for (const auto& [time, volume, crossing] : checks) {
    Json& json = list.emplace_back(Json{{"time_s", time}});
    add(json, "pairs", crossing.pairs);
    add(json, "elements", crossing.elements);
    if (scene.skin_contact) add(json, "layers", crossing.layers);
    if (!scene.gas) continue;
    json["volume_m3"] = volume;
    add(json, "counted_twice_m3", crossing.volumes.counted_twice.value);
    json["counted_twice_standard_error_m3"] = crossing.volumes.counted_twice.standard_error;
    add(json, "inside_out_m3", crossing.volumes.inside_out.value);
    json["inside_out_standard_error_m3"] = crossing.volumes.inside_out.standard_error;
  }
  return {{"looks", list}, {"largest", largest}};
}

Json counters(const Scene& scene, const State& state) {
  Json json = Json::object();
  if (scene.has_volume()) json["gas_substeps"] = state.flows.gas_substeps;
  if (scene.has_volume()) json["gas_evaluations"] = state.flows.gas_evaluations;
  if (scene.bag) json["elements"] = scene.bag->model.element_count;
  if (scene.bag) json["nodes"] = scene.bag->model.node_count;
  for (std::size_t j = 0; j < state.jets.size(); ++j) {
    const auto& total = state.jets[j].total;
    json["jets"].push_back({{"candidates", total.candidates},
                            {"lit", total.lit},
                            {"hidden", total.hidden},
                            {"facing_away", total.facing_away},
                            {"exact_calls", total.exact_calls},
                            {"fallbacks", total.fallbacks},
                            {"tree_builds", total.tree_builds}});
  }
  if (state.contact_cache) {
    json["contact_looks"] = state.contact_cache->looks;
    json["contact_sweeps"] = state.contact_cache->sweeps;
    json["contact_skips"] = state.contact_cache->skips;
  }
  if (state.skin_contact_cache) {
    json["self_contact_looks"] = state.skin_contact_cache->looks();
    json["self_contact_sweeps"] = state.skin_contact_cache->sweeps();
  }
  return json;
}

}  // namespace

std::string summary_of_running(const Scene& scene, const Provenance& lines) {
  return text_of(summary_head(scene, "running", lines), lines);
}

std::string summary_text(const Scene& scene, const State& state, const RunOutcome& outcome,
                         const std::vector<SkinCheck>& checks, const Provenance& lines) {
  Json json = summary_head(scene, status_name(outcome.status), lines);
  if (!outcome.message.empty()) json["message"] = outcome.message;
  for (const auto& note : outcome.notes) json["warnings"].push_back(note);
  if (!outcome.warning.empty()) json["warnings"].push_back(outcome.warning);
  json["steps"] = state.steps;
  json["time_end_s"] = state.time;
  json["wall_s"] = outcome.wall_seconds;
  json["real_time_factor"] = state.time > 0.0 ? outcome.wall_seconds / state.time : 0.0;
  json["cpu_s"] = outcome.cpu_seconds;
  double rest = outcome.cpu_seconds;
  for (std::size_t i = 0; i < kStages; ++i) {
    if (!(outcome.stage_seconds[i] > 0.0)) continue;
    json["stage_seconds"][std::string(stage_name(static_cast<Stage>(i)))] = outcome.stage_seconds[i];
    rest -= outcome.stage_seconds[i];
  }
  json["stage_seconds"]["rest"] = rest;
  json["dt"] = step_sizes(scene, state);
  json["residual"] = residuals(scene, state);
  json["peak"] = peaks(scene, state);
  if (scene.has_volume()) json["moments"] = moments(state);
  if (scene.has_volume()) json["streams"] = streams(scene, state);
  if (scene.skin_contact) json["self_contact"] = self_contact(scene, state);
  if (!checks.empty()) json["self_intersection"] = self_intersection(scene, checks);
  json["counters"] = counters(scene, state);
  return text_of(std::move(json), lines);
}

}  // namespace driver
