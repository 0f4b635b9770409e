// SPDX-License-Identifier: Apache-2.0
// The passenger bag against the pendulum, cases/passenger_pendulum.toml, from the four libraries alone.
// The stages S1 to S10 are those of docs/stages.md.
#include <coupling/pendulum.hpp>
#include <coupling/side.hpp>
#include <coupling/sphere_contact.hpp>
#include <cstdint>
#include <cstdio>
#include <gas/integrator.hpp>
#include <jet/field.hpp>
#include <jet/visibility.hpp>
#include <membrane/stages.hpp>
#include <membrane/time_step.hpp>
#include <mesh/passenger_bag.hpp>
#include <mesh/surface_check.hpp>
#include <stdexcept>

namespace {

using Eigen::Vector3d;

constexpr double kAmbientPressure = 101325.0, kAmbientTemperature = 293.15;  // Pa, K
constexpr double kThickness = 0.5e-3, kDensity = 620.0, kRadius = 0.041;     // m, kg/m3, m
const Vector3d kGravity(0.0, 0.0, -9.80665);                                 // m/s2

membrane::BagModel bag_model(const mesh::PassengerBag& design) {
  const mesh::Mesh& mesh = design.mesh;
  membrane::BagDescription bag;
  bag.reference = mesh.nodes;
  bag.elements = mesh.elements;
  bag.properties.assign(mesh.panel.size(), {kThickness, kDensity, 60e6, 0.3, 0.05});
  for (const int e : mesh::panel_elements(mesh, "vent")) {
    bag.properties[e] = {};
    bag.properties[e].null_panel = true;
  }
  for (const int e : mesh::panel_elements(mesh, "attachment")) bag.properties[e].porosity = 0.0;  // bolted on
  bag.fixed_nodes = mesh::panel_nodes(mesh, "attachment");
  for (const auto& [back, front] : design.strap_anchors) bag.straps.push_back({back, front, 4500.0, 0.62});
  bag.plates.push_back({Vector3d::Zero(), Vector3d::UnitX()});
  bag.gravity = kGravity;
  return membrane::make_model(bag);
}

gas::ControlVolumeModel gas_model() {
  std::vector<gas::Species> species;
  for (const char* name : {"N2", "O2", "Ar", "CO2"}) species.push_back(gas::constant_cp_species(name));
  gas::ControlVolumeModel model{
      gas::Thermo(species), {kAmbientPressure, kAmbientTemperature}, {}, {{0.6, 2e-3}}};
  model.inflows.push_back({{1.0, 0.0, 0.0, 0.0},
                           gas::Curve({{0.0, 0.0}, {0.012, 4.0}, {0.08, 0.0}}, gas::Outside::zero),
                           gas::Curve::constant(406.0)});
  return model;
}

jet::JetModel jet_model() {
  return {.shape = jet::OutletShape::rectangular,
          .centre = Vector3d::Zero(),
          .axis = Vector3d::UnitX(),
          .long_direction = Vector3d::UnitY(),
          .short_side = 0.045,
          .long_side = 0.08,
          .decay_coefficient = 0.11};
}

}  // namespace

int main() {
  const mesh::PassengerBag design = mesh::passenger_bag();
  const mesh::Mesh& mesh = design.mesh;
  mesh::require_closed_surface(mesh.nodes, mesh.elements);
  const membrane::BagModel bag = bag_model(design);
  const Eigen::Matrix3Xd start = mesh::flatten(mesh, 0.1);
  membrane::BagState skin = membrane::make_state(bag, start, {.jet = true, .contact = true});

  const gas::ControlVolumeModel volume = gas_model();
  gas::GasIntegrator integrator(volume);
  const auto air = volume.thermo.mass_fractions_by_mole(gas::air_by_mole());

  const std::vector<int> vent = mesh::panel_elements(mesh, "vent");
  const jet::JetField field(jet_model(), bag.element_count, vent);
  const jet::OutletModel outlet{.area = jet::outlet_area(field.model())};
  jet::FieldState load = field.make_state();
  jet::VisibilityQuery query(mesh.elements, bag.node_count, {vent, mesh::panel_elements(mesh, "attachment")});
  std::vector<std::uint8_t> lit(mesh.panel.size());

  const coupling::PendulumModel pendulum(
      {{0.35, 0.0, 1.31}, {0.0, -1.0, 0.0}, {0.0, 0.0, -1.0}, 10.9, 2.07, 1.065, 1.31, kRadius, kGravity});
  coupling::PendulumState swing;
  coupling::require_outside(mesh.elements, start, coupling::Sphere{kRadius},
                            {pendulum.impactor_centre(swing.angle)});
  const double mass = pendulum.effective_mass();
  const double stiffness = coupling::default_contact_stiffness(
      {1.0, bag.fabric_frequency, kThickness * kDensity, coupling::Sphere{kRadius}, mass});
  const coupling::ContactModel contact(mesh.elements, mesh.nodes, bag.node_mass, mass,
                                       {coupling::Sphere{kRadius}, stiffness}, vent);
  coupling::ContactState touched = contact.make_state();

  membrane::update_skin(bag, skin);  // S1, and later S9: surface, volume, forces of the fabric
  gas::ControlVolumeState content =
      gas::make_state(volume, air, kAmbientPressure, kAmbientTemperature, skin.surface.volume);
  std::puts("time_s,pressure_Pa,volume_m3,pendulum_angle_rad");
  constexpr int steps = 2000;
  constexpr double step = 1e-5;  // s
  double time = 0.0, before = 0.0;
  for (int n = 0; n <= steps; ++n, time += step, before = step) {
    const membrane::SurfaceSums surface = skin.surface;  // V and the leak area that the gas sees at n
    const auto point =
        gas::evaluate(volume, content, surface.volume, surface.porosity_squared_area, time);  // S2
    if (n % 100 == 0)
      std::printf("%.17g,%.17g,%.17g,%.17g\n", time, point.pressure, surface.volume, swing.angle);
    auto inflow = gas::inflator_point(volume, content, 0, time);  // S5: the mean over the kick
    inflow.mass_flow = volume.inflows[0].mass_flow.integral(time - 0.5 * before, time + 0.5 * step) /
                       (0.5 * (before + step));
    const auto nozzle =
        jet::outlet_state(outlet, {inflow.mass_flow, inflow.temperature, inflow.cp, inflow.gas_constant});
    membrane::update_geometry(bag, skin);  // S6
    field.evaluate(skin.area_vector.map(), skin.centroid.map(), nozzle, load);
    const std::span<std::uint8_t> mask(lit.data(), load.candidates.size());  // S7
    query.query(jet::VisibilityRoute::fast, skin.position.map(), jet::ray_source(field.model()),
                load.candidates, mask);
    jet::apply_mask(mask, load);
    membrane::support_forces(bag, skin);  // S3
    membrane::pressure_forces(skin, point.pressure - kAmbientPressure);
    const membrane::JetLoad jets[] = {{load.overpressure, load.candidates}};
    membrane::jet_forces(bag, skin, jets);
    pendulum.require_followed(before * swing.angular_velocity);  // S4
    const Vector3d centre = pendulum.impactor_centre(swing.angle);
    skin.contact_force.map().setZero();
    const auto hit = contact.evaluate(touched, skin.position.map(), {centre}, skin.contact_force.map());
    const double moment = pendulum.gravity_moment(swing.angle) + pendulum.moment(hit.force, centre);
    const double touch =
        contact.full_omega_squared() + hit.omega_squared_sphere + pendulum.omega_squared(hit.force);
    const auto shares = membrane::stiffness_shares(bag, skin, point.gamma, point.pressure, touch);  // S8
    if (step > membrane::critical_time_step(shares)) throw std::runtime_error("the step is above its bound");
    membrane::advance(bag, skin, before, step);
    swing = pendulum.advance(swing, moment, 0.5 * (before + step), step);
    membrane::update_skin(bag, skin);               // S9
    integrator.advance(content, time, time + step,  // S10
                       {surface.volume, skin.surface.volume, surface.porosity_squared_area,
                        skin.surface.porosity_squared_area});
  }
}
