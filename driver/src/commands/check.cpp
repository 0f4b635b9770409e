// SPDX-License-Identifier: Apache-2.0
// Validates a case and prints what follows from it before any step is made.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "../stages.hpp"
#include "commands.hpp"
#include "coupling/side.hpp"
#include "driver/run.hpp"

namespace driver::commands {
namespace {

void print_settings(const CaseDocument& document) {
  fmt::print("settings (* by default)\n");
  for (const auto& setting : document.settings())
    fmt::print("  {}{} = {}\n", setting.path, setting.is_default ? " *" : "", setting.value);
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
}

double peak_time(const gas::Curve& curve) {
  const auto knots = curve.knots();
  return std::max_element(knots.begin(), knots.end(),
                          [](const auto& a, const auto& b) { return a.value < b.value; })
      ->time;
}

void print_jet(const Scene& scene, const JetPart& part) {
  const auto& inflow = scene.gas->model.inflows[part.inflator];
  const double time =
      inflow.start_time + (inflow.mass_flow.is_constant() ? 0.0 : peak_time(inflow.mass_flow));
  const auto point = gas::inflator_point(scene.gas->model, part.inflator, time);
  const auto outlet = jet::outlet_state(part.outlet, {point.mass_flow, point.temperature, point.cp,
                                                      point.gas_constant, scene.ambient.pressure});
  const double force = jet::momentum_flux(outlet, part.outlet.area);
  fmt::print(
      "jet of inflator {}: at its peak (t = {:.4g} s) V0 = {:.5g} m/s, rho0 = {:.4g} kg/m3, outlet pressure "
      "{:.4g} Pa, "
      "momentum {:.4g} N; cut-off loses {:.2g} of it\n",
      part.inflator, time, outlet.velocity, outlet.density, outlet.pressure, force,
      jet::momentum_loss(part.field.model()));
  if (outlet.pressure < scene.ambient.pressure)
    fmt::print(
        "warning: the outlet pressure is below ambient even at the peak of the mass flow: a sonic outlet of "
        "that area "
        "cannot blow into the bag (outlet = \"pressure_matched\" can)\n");
  else if (part.outlet.law == jet::OutletLaw::sonic && !inflow.mass_flow.is_constant())
    fmt::print(
        "warning: outlet = \"sonic\" (the paper's form) lets the outlet pressure fall with the mass flow, "
        "below "
        "ambient under {:.3g} kg/s\n",
        point.mass_flow * scene.ambient.pressure / outlet.pressure);
}

void print_visibility(const Scene& scene) {
  if (!scene.bag) return;
  jet::VisibilityQuery query(scene.bag->mesh.elements, scene.bag->model.node_count);
  for (std::size_t j = 0; j < scene.jets.size(); ++j) {
    std::vector<int> every(static_cast<std::size_t>(scene.bag->model.element_count));
    for (std::size_t e = 0; e < every.size(); ++e) every[e] = static_cast<int>(e);
    const auto windings = query.winding_numbers(scene.bag->initial_position,
                                                jet::ray_source(scene.jets[j].field.model()), every);
    const auto other = std::count_if(windings.begin(), windings.end(), [](const auto& w) { return w != 1; });
    if (other > 0)
      fmt::print("warning: {} of {} rays of jet {} start where the winding number is not 1\n", other,
                 windings.size(), j);
  }
}

}  // namespace

int check(const CaseArguments& arguments) {
  CaseDocument document(arguments.file, arguments.overrides);
  const Scene scene = read_scene(document);
  State state = make_state(scene);
  gas_point(scene, state);
  forces(scene, state);
  print_settings(document);
  fmt::print("\nderived\n");
  if (scene.has_volume())
    fmt::print("gas: {:.5g} kg at {:.6g} Pa, {:.5g} K, gamma {:.5g}\n", state.gas_point.mass,
               state.gas_point.pressure, state.gas_point.temperature, state.gas_point.gamma);
  if (scene.bag) print_bag(scene, state);
  for (const auto& part : scene.jets) print_jet(scene, part);
  print_visibility(scene);
  if (scene.pendulum)
    fmt::print("pendulum: {:.6g} kg m2 about the axis, effective mass {:.5g} kg\n",
               scene.pendulum->model.axis_inertia(), scene.pendulum->model.effective_mass());
  if (scene.contact) fmt::print("contact stiffness: {:.4g} N/m3\n", scene.contact->parameters().stiffness);
  for (const auto& warning : scene.warnings) fmt::print("warning: {}\n", warning);
  return exit_done;
}

}  // namespace driver::commands
