// SPDX-License-Identifier: Apache-2.0
// Validates a case and prints its derived values, without a step.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/curve_reader.hpp"
#include "commands/command.hpp"
#include "engine/bag_mesh.hpp"
#include "engine/drift.hpp"
#include "engine/impactor.hpp"
#include "engine/run.hpp"
#include "engine/stages.hpp"
#include "engine/supply.hpp"
#include "forecast/check_json.hpp"
#include "forecast/jet_peak.hpp"
#include "forecast/jet_push.hpp"
#include "forecast/self_contact_start.hpp"
#include "gas/orifice.hpp"
#include "results/load_scene.hpp"
#include "results/skin_checks.hpp"

namespace driver::commands {
namespace {

void print_settings(const CaseDocument& document) {
  fmt::print("settings (* by default)\n");
  for (const auto& setting : document.settings())
    fmt::print("  {}{} = {}\n", setting.path, setting.is_default ? " *" : "", setting.value);
}

// Curves that are in files, or that units, scale and the like change.
void print_curves(const CaseDocument& document) {
  if (!document.used_curves().empty()) fmt::print("curves as they are used\n");
  for (const auto& [path, is_changed, abscissa, unit, data] : document.used_curves()) {
    const auto [low, high] = std::ranges::minmax(data.value);
    if (data.time.empty()) {
      fmt::print("  {}: {:.6g} {}\n", path, low, unit);
      continue;
    }
    fmt::print("  {}: {} knots, {} {:.6g} to {:.6g}, values {:.6g} to {:.6g} {}", path, data.time.size(),
               abscissa, data.time.front(), data.time.back(), low, high, unit);
    if (unit == "kg/s") fmt::print(", in all {:.6g} kg", integral(data));
    fmt::print("\n");
  }
}

// A line for each possible key of the case: path, unit, allowed values, default; separated by tabs.
void print_keys(const CaseDocument& document) {
  for (const auto& key : document.keys())
    fmt::print("{}\t{}\t{}\t{}\n", key.path, key.unit, key.allowed, key.fallback);
}

void print_panels(const BagPart& bag) {
  const mesh::Mesh& mesh = bag.mesh;
  const Eigen::VectorXd areas = mesh::panel_areas(mesh);
  for (std::size_t i = 0; i < mesh.panel_names.size(); ++i)
    fmt::print("panel {}: {:.5g} m2\n", mesh.panel_names[i], areas(static_cast<Eigen::Index>(i)));
}

// Ends of the straps on the design shape, as in a case file, and their panels.
void print_straps(const BagPart& bag) {
  const auto point = [&](int node) {
    const Eigen::Vector3d p = bag.mesh.nodes.col(node);
    return fmt::format("[{}, {}, {}] ({})", p.x(), p.y(), p.z(),
                       fmt::join(panels_of_node(bag.mesh, node), ", "));
  };
  const auto& straps = bag.model.description.straps;
  for (std::size_t i = 0; i < straps.size(); ++i)
    fmt::print("strap {}: from = {}, to = {}\n", i, point(straps[i].node_a), point(straps[i].node_b));
}

// The step limit of each part alone; parts without one are left out.
std::string limits_alone(const membrane::StiffnessShares& shares) {
  std::string text;
  const auto add = [&](const char* name, double omega_squared) {
    if (omega_squared > 0.0)
      text += fmt::format("{} {} {:.4g}", text.empty() ? "" : ",", name, 2.0 / std::sqrt(omega_squared));
  };
  add("fabric", shares.element);
  add("gas", shares.gas);
  add("straps", shares.strap);
  add("plate", shares.plate);
  return text;
}

void print_bag(const Scene& scene, const State& state) {
  const auto& bag = *scene.bag;
  const auto shares =
      membrane::stiffness_shares(bag.model, *state.bag, state.gas_point.gamma, state.gas_point.pressure);
  fmt::print("bag: {} elements, {} nodes, fabric {:.4g} kg", bag.model.element_count, bag.model.node_count,
             bag.model.fabric_mass);
  if (scene.gas)
    fmt::print(", initial volume {:.4g} m3, design volume {:.4g} m3", state.bag->surface.volume,
               mesh::enclosed_volume(bag.mesh.nodes, bag.mesh.elements));
  const double critical = membrane::critical_time_step(shares);
  fmt::print("\ncritical step at the start: {:.4g} s (alone:{})\n", critical, limits_alone(shares));
  if (const double kept = drift_limit(scene, state); kept < critical)
    fmt::print("step at the start that keeps the energy (M.22), (M.24): {:.4g} s\n", kept);
  print_panels(bag);
  print_straps(bag);
}

// True if ambient gas enters through a vent at the speed of sound.
bool chokes_inwards(const Scene& scene, double pressure) {
  const gas::ControlVolumeModel& model = scene.gas->model;
  const gas::Ambient& outside = model.ambient;
  return outside.pressure > 0.0 && std::ranges::any_of(model.vents, &gas::Vent::backflow) &&
         pressure <= outside.pressure * gas::critical_pressure_ratio(
                                            model.thermo.gamma(outside.mass_fractions, outside.temperature));
}

// Prints whether the vents choke at the start, and the pressure above which they do.
void print_vents(const Scene& scene, const State& state, double gamma) {
  if (!scene.has_volume() || scene.gas->model.vents.empty()) return;
  const double pressure = state.gas_point.pressure, ambient = scene.ambient.pressure;
  const double critical = ambient / gas::critical_pressure_ratio(gamma);
  if (chokes_inwards(scene, pressure))
    fmt::print("vents: choked inwards at the start, outwards from {:.6g} Pa at that gamma\n", critical);
  else
    fmt::print("vents: {} at the start, choked {} {:.6g} Pa at that gamma\n",
               pressure > ambient && pressure >= critical ? "choked" : "not choked",
               ambient > 0.0 ? "from" : "above", critical);
}

// Time of an inflator's peak; its trigger's time is not known before a run.
std::string peak_text(const Scene& scene, std::size_t inflator, double time) {
  const bool triggered = scene.gas->model.inflows[inflator].trigger.has_value();
  return fmt::format("t = {:.4g} s{}", time, triggered ? " after its trigger" : "");
}

void print_inflators(const Scene& scene) {
  if (!scene.gas) return;
  for (std::size_t i = 0; i < scene.gas->model.inflows.size(); ++i) {
    const auto [time, point] = inflator_peak(scene, i);
    fmt::print("inflator {}: at its peak ({}) {:.5g} kg/s at {:.5g} K, R {:.5g} J/(kg K), gamma {:.5g}\n", i,
               peak_text(scene, i, time), point.mass_flow, point.temperature, point.gas_constant,
               point.gamma);
  }
}

void print_range(const JetPart& part, const RestitutionRange& range) {
  const Range e = restitution(part);
  const std::string own = e.low < e.high
                              ? fmt::format("{:.3g} to {:.3g}", e.low, e.high)
                              : fmt::format("{:.3g}{}", e.low, e.low == 1.0 ? " (the paper's)" : "");
  fmt::print(
      "  restitution is {}; computed flows in bags {} than wide have {} to {}{}, the first passes least "
      "(here "
      "the depth ahead of the outlet is {:.3g} of the width)\n",
      own, range.deep ? "deeper" : "less deep", range.low, range.high,
      range.deep ? "" : ", by one turbulence model up to 3.3", range.depth_over_width);
}

void print_missing_energy(const MissingEnergy& missing) {
  fmt::print(
      "  temperature = \"static\" leaves out the kinetic energy V0^2/2 of the gas, in all {:.3g} J{}\n",
      missing.energy,
      missing.pressure ? fmt::format(": up to {:.3g} Pa if nothing leaves the bag as sewn", *missing.pressure)
                       : "");
}

// What the load rests on, beside what the model makes of it.
void print_push(const Scene& scene, const JetPart& part) {
  const JetPush push = jet_push(scene, part);
  const bool in_motion = part.outlet.temperature == jet::OutletTemperature::static_value;
  const std::string most = push.most_load > push.load ? fmt::format(" to {:.4g}", push.most_load) : "";
  const std::string parts =
      push.pressure_ratio > 1.0
          ? fmt::format(": mdot V0 = {:.4g} N and (pe - p) A = {:.4g} N at pe/p = {:.3g}", push.momentum,
                        push.thrust - push.momentum, push.pressure_ratio)
          : "";
  fmt::print(
      "  load on a plate: {:.4g}{} N by the model; {:.4g} N in free air{}; outlet = \"expanded\" with "
      "restitution = 0{} gives that\n",
      push.load, most, push.thrust, parts,
      in_motion ? fmt::format(" and temperature = \"stagnation\" at {:.4g} K, the same outlet,",
                              push.rest_temperature)
                : "");
  if (const auto range = restitution_range(scene, part.field.model())) print_range(part, *range);
  if (scene.bag && in_motion) print_missing_energy(missing_energy(scene, part));
}

void print_jet(const Scene& scene, const JetPart& part) {
  const JetPeak peak = jet_peak(scene, part);
  const jet::JetModel& model = part.field.model();
  const bool choked = peak.sonic_pressure > scene.ambient.pressure;
  const char* index = part.outlet.law == jet::OutletLaw::expanded ? "" : "0";
  fmt::print(
      "jet of inflator {}: at its peak ({}) V{} = {:.5g} m/s, rho{} = {:.4g} kg/m3{}, outlet pressure "
      "{:.4g} Pa ({}), momentum {:.4g} N; cut-off loses {:.2g} of it\n",
      part.name, peak_text(scene, part.inflator, peak.time), index, peak.outlet.velocity, index,
      peak.outlet.density,
      *index ? ""
             : fmt::format(" at the notional nozzle, {:.3g} times the outlet's area", peak.outlet.area_ratio),
      choked ? peak.sonic_pressure : peak.outlet.pressure, choked ? "choked" : "not choked",
      jet::momentum_flux(peak.outlet, part.outlet.area), jet::momentum_loss(model));
  if (peak.mass_flow > 0.0) print_push(scene, part);
}

void print_self_contact(const Scene& scene) {
  const SelfContactStart start = self_contact_start(scene);
  const coupling::SkinContactParameters& p = scene.skin_contact->parameters();
  fmt::print(
      "self-contact: {:.4g} N/m3 for layers closer than {:.4g} m; while some are, it adds {:.3g} of "
      "the fabric's omega^2 (critical step alone: {:.4g} s)\n",
      p.stiffness, p.thickness, start.share, start.critical_step);
  if (start.limited_nodes > 0)
    fmt::print(
        "  {} nodes start closer than that to another layer, the closest at {:.3g} m: they begin without "
        "force, and keep their distance as the limit until they are farther away (K.45)\n",
        start.limited_nodes, start.smallest_gap);
  fmt::print("  while layers touch, gas is in all pockets at once, also where they shut one off\n");
}

void print_forecast(const Forecast& f) {
  if (f.full && !f.full->fills)
    fmt::print(
        "\nthe inflow up to the end does not fill the volume: {:.3g} Pa in {:.3g} m3, below ambient (K.30)\n",
        f.full->closed_pressure, f.full->volume);
  if (f.groups.empty()) return;
  fmt::print("\nforecast (sizes: 0.1 matters, 0.01 shows, below negligible)\n");
  for (const Group& g : f.groups)
    fmt::print("  {:<10} {:>9.3g}  {} ({})\n", verdict(g), g.value, g.meaning, g.equation);
}

}  // namespace

int check(const CaseArguments& arguments, const std::string& format) {
  CaseDocument document(arguments.file, arguments.overrides);
  Scene scene = load_scene(document);
  if (format == "keys") {
    print_keys(document);
    return exit_done;
  }
  add_jet_warnings(scene);
  add_skin_warning(scene);
  const State state = state_at_start(scene);
  const Forecast groups = forecast(scene, state);
  if (format == "json") {
    fmt::print("{}\n", check_json(document, scene, state, groups));
    return exit_done;
  }
  print_settings(document);
  print_curves(document);
  fmt::print("\nderived\n");
  const double gamma = gamma_at_start(state, groups);
  if (scene.has_volume())
    fmt::print("gas: {:.5g} kg at {:.6g} Pa, {:.5g} K, gamma {:.5g}{}\n", state.gas_point.mass,
               state.gas_point.pressure, state.gas_point.temperature, gamma,
               state.gas_point.mass > 0.0 ? "" : " of the gas that fills it");
  if (scene.bag) print_bag(scene, state);
  print_vents(scene, state, gamma);
  print_inflators(scene);
  for (const auto& part : scene.jets) print_jet(scene, part);
  if (scene.pendulum)
    fmt::print("pendulum: {:.6g} kg m2 about the axis, effective mass {:.5g} kg\n",
               scene.pendulum->model.axis_inertia(), scene.pendulum->model.effective_mass());
  if (scene.body) fmt::print("impactor: effective mass {:.5g} kg\n", impactor_mass(scene));
  if (scene.contact) fmt::print("contact stiffness: {:.4g} N/m3\n", scene.contact->parameters().stiffness);
  if (scene.skin_contact) print_self_contact(scene);
  if (scene.moves() && !scene.output.history_exact)
    fmt::print(
        "history: a row at the first step at or after each multiple of {} s; exactly there with "
        "history_exact\n",
        scene.output.history_every);
  print_forecast(groups);
  if (const std::string advice = gas_advice(scene, groups); !advice.empty())
    fmt::print("advice: {}\n", advice);
  for (const auto& warning : scene.warnings) fmt::print("warning: {}\n", warning);
  return exit_done;
}

}  // namespace driver::commands
