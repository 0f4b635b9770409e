// SPDX-License-Identifier: Apache-2.0
// Validates a case and prints what follows from it before any step is made.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "../jet_peak.hpp"
#include "../stages.hpp"
#include "commands.hpp"
#include "driver/run.hpp"
#include "gas/orifice.hpp"

namespace driver::commands {
namespace {

void print_settings(const CaseDocument& document) {
  fmt::print("settings (* by default)\n");
  for (const auto& setting : document.settings())
    fmt::print("  {}{} = {}\n", setting.path, setting.is_default ? " *" : "", setting.value);
}

// Every setting of the case, as nested tables, and which of them were taken by default.
void print_json(const CaseDocument& document) {
  nlohmann::json settings, defaults = nlohmann::json::array();
  for (const auto& setting : document.settings()) {
    auto path = "/" + setting.path;
    std::replace(path.begin(), path.end(), '.', '/');
    const auto value = nlohmann::json::parse(setting.value, nullptr, false);
    settings[nlohmann::json::json_pointer(path)] =
        value.is_discarded() ? nlohmann::json(setting.value) : value;
    if (setting.is_default) defaults.push_back(setting.path);
  }
  fmt::print("{}\n", nlohmann::json{{"settings", settings}, {"defaults", defaults}}.dump(2));
}

void print_panels(const membrane::Mesh& mesh) {
  const Eigen::VectorXd areas = membrane::panel_areas(mesh);
  for (std::size_t i = 0; i < mesh.panel_names.size(); ++i)
    fmt::print("panel {}: {:.5g} m2\n", mesh.panel_names[i], areas(static_cast<Eigen::Index>(i)));
}

void print_bag(const Scene& scene, State& state) {
  const auto& bag = *scene.bag;
  const double stiffness_gas = state.gas_point.gamma;
  const auto shares =
      membrane::stiffness_shares(bag.model, *state.bag, stiffness_gas, state.gas_point.pressure);
  fmt::print(
      "bag: {} elements, {} nodes, fabric {:.4g} kg, initial volume {:.4g} m3, design volume {:.4g} m3\n",
      bag.model.element_count, bag.model.node_count, bag.model.fabric_mass, state.bag->surface.volume,
      membrane::enclosed_volume(bag.mesh.nodes, bag.mesh.elements));
  const auto limit = [](double omega_squared) {
    return omega_squared > 0.0 ? 2.0 / std::sqrt(omega_squared) : INFINITY;
  };
  fmt::print(
      "critical step at the start: {:.4g} s (alone: fabric {:.4g}, gas {:.4g}, straps {:.4g}, plate "
      "{:.4g})\n",
      membrane::critical_time_step(shares), limit(shares.element), limit(shares.gas), limit(shares.strap),
      limit(shares.plate));
  print_panels(bag.mesh);
}

// Whether the vents choke: at the start, and from which pressure.
void print_vents(const Scene& scene, const State& state) {
  if (!scene.has_volume() || scene.gas->model.vents.empty()) return;
  const double critical = scene.ambient.pressure / gas::critical_pressure_ratio(state.gas_point.gamma);
  fmt::print("vents: {} at the start, choked from {:.6g} Pa at that gamma\n",
             state.gas_point.pressure >= critical ? "choked" : "not choked", critical);
}

void print_jet(const Scene& scene, const JetPart& part) {
  const JetPeak peak = jet_peak(scene, part);
  const jet::JetModel& model = part.field.model();
  fmt::print(
      "jet of inflator {}: at its peak (t = {:.4g} s) V0 = {:.5g} m/s, rho0 = {:.4g} kg/m3, outlet pressure "
      "{:.4g} Pa ({}), momentum {:.4g} N; cut-off loses {:.2g} of it\n",
      part.inflator, peak.time, peak.outlet.velocity, peak.outlet.density, peak.outlet.pressure,
      peak.outlet.pressure > scene.ambient.pressure ? "choked" : "not choked",
      jet::momentum_flux(peak.outlet, part.outlet.area), jet::momentum_loss(model));
  if (!scene.pendulum) return;
  const Eigen::Vector3d impactor = scene.pendulum->model.impactor_centre(scene.pendulum->initial.angle);
  const double speed = peak.outlet.velocity * jet::relative_velocity(model, impactor).dot(model.axis);
  fmt::print(
      "  its force on the impactor, unhidden, over that of the pressure: {:.4g} Pa / (p - p_a), overpressure "
      "by bag pressure\n",
      (1.0 + model.restitution) * peak.outlet.density * speed * speed);
}

}  // namespace

int check(const CaseArguments& arguments, const std::string& format) {
  CaseDocument document(arguments.file, arguments.overrides);
  const Scene scene = read_scene(document);
  State state = make_state(scene);
  gas_point(scene, state);
  forces(scene, state);
  if (format == "json") {
    print_json(document);
    return exit_done;
  }
  print_settings(document);
  fmt::print("\nderived\n");
  if (scene.has_volume())
    fmt::print("gas: {:.5g} kg at {:.6g} Pa, {:.5g} K, gamma {:.5g}\n", state.gas_point.mass,
               state.gas_point.pressure, state.gas_point.temperature, state.gas_point.gamma);
  if (scene.bag) print_bag(scene, state);
  print_vents(scene, state);
  for (const auto& part : scene.jets) print_jet(scene, part);
  if (scene.pendulum)
    fmt::print("pendulum: {:.6g} kg m2 about the axis, effective mass {:.5g} kg\n",
               scene.pendulum->model.axis_inertia(), scene.pendulum->model.effective_mass());
  if (scene.contact) fmt::print("contact stiffness: {:.4g} N/m3\n", scene.contact->parameters().stiffness);
  for (const auto& warning : scene.warnings) fmt::print("warning: {}\n", warning);
  return exit_done;
}

}  // namespace driver::commands
