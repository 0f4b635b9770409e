// SPDX-License-Identifier: Apache-2.0
#include "engine/columns.hpp"

#include <algorithm>

#include "engine/energy_terms.hpp"
#include "engine/scene_features.hpp"

namespace driver {
namespace {

using Of = const Scene&;
using At = const State&;

struct Line {
  const char* name;
  bool (*when)(Of);
  double (*value)(Of, At);
};

double lit_elements(Of, At now) {
  double sum = 0.0;
  for (const JetRun& run : now.jets) sum += static_cast<double>(run.counters.lit);
  return sum;
}

double hidden_elements(Of, At now) {
  double sum = 0.0;
  for (const JetRun& run : now.jets) sum += static_cast<double>(run.counters.hidden);
  return sum;
}

// The thickness where nothing touches.
double self_gap(Of scene, At now) {
  return std::min(now.skin_contact.closest.gap, scene.skin_contact->parameters().thickness);
}

double joint_force(Of scene, At now) {
  const PendulumRun& p = *now.pendulum;
  return scene.pendulum->model
      .joint_reaction(now.level.pendulum_angle, p.angular_velocity, p.moment + p.driving_moment,
                      now.contact.force + scene.pendulum->model.parameters().mass * now.level.field)
      .norm();
}

// clang-format off
constexpr Line kLines[] = {
  {"time_s", has::anything, [](Of, At now) { return now.time; }},
  {"pressure_Pa", has::volume, [](Of, At now) { return now.gas_point.pressure; }},
  {"temperature_K", has::volume, [](Of, At now) { return now.gas_point.temperature; }},
  {"volume_m3", has::volume, [](Of, At now) { return now.level.volume; }},
  {"gas_mass_kg", has::volume, [](Of, At now) { return now.gas_point.mass; }},
  {"inflow_kg_s", has::inflators, [](Of, At now) { return now.gas_point.inflow; }},
  {"vent_outflow_kg_s", has::vents, [](Of, At now) { return now.gas_point.vent_mass_flow; }},
  {"backflow_kg_s", has::backflow, [](Of, At now) { return now.gas_point.backflow; }},
  {"heat_loss_W", has::heat_loss, [](Of, At now) { return now.gas_point.heat_loss; }},
  {"fabric_outflow_kg_s", has::fabric_leak, [](Of, At now) { return now.gas_point.fabric_mass_flow; }},
  {"overpressure_Pa", has::prescribed_pressure, [](Of, At now) { return now.bag->gauge_pressure; }},
  {"skin_displacement_m", has::prescribed_pressure, [](Of, At now) { return now.level.displacement; }},
  {"skin_area_m2", has::bag, [](Of, At now) { return now.level.skin_area; }},
  {"jet_force_N", has::jets, [](Of, At now) { return now.level.jet_force; }},
  {"jet_lit_elements", has::jets, lit_elements},
  {"jet_hidden_elements", has::jets, hidden_elements},
  {"self_contacts", has::self_contact, [](Of, At now) { return static_cast<double>(now.skin_contact.contacts); }},
  {"self_gap_m", has::self_contact, self_gap},
  {"contact_force_N", has::contact, [](Of, At now) { return now.contact.force.norm(); }},
  {"contact_penetration_m", has::contact, [](Of, At now) { return now.contact.penetration; }},
  {"pendulum_angle_rad", has::pendulum, [](Of, At now) { return now.level.pendulum_angle; }},
  {"pendulum_angular_velocity_rad_s", has::pendulum, [](Of, At now) { return now.pendulum->angular_velocity; }},
  {"pendulum_cg_tangential_m_s2", has::pendulum, [](Of, At now) { return now.pendulum->acceleration.tangential; }},
  {"pendulum_cg_radial_m_s2", has::pendulum, [](Of, At now) { return now.pendulum->acceleration.radial; }},
  {"pendulum_cg_acceleration_m_s2", has::pendulum, [](Of, At now) { return now.pendulum->acceleration.resultant; }},
  {"pendulum_joint_force_N", has::pendulum, joint_force},
  {"impactor_displacement_m", has::body, [](Of, At now) { return now.body->displacement; }},
  {"impactor_velocity_m_s", has::body, [](Of scene, At now) { return scene.body->model.speed(now.body->velocity); }},
  {"impactor_acceleration_m_s2", has::body, [](Of scene, At now) { return scene.body->model.speed(now.body->acceleration); }},
  {"impactor_x_m", has::free_body, [](Of, At now) { return now.level.impactor.centre.x(); }},
  {"impactor_y_m", has::free_body, [](Of, At now) { return now.level.impactor.centre.y(); }},
  {"impactor_z_m", has::free_body, [](Of, At now) { return now.level.impactor.centre.z(); }},
  {"impactor_angular_velocity_rad_s", has::free_body, [](Of, At now) { return now.body->angular_velocity.norm(); }},
  {"strap_force_N", has::straps, [](Of, At now) { return std::ranges::max(now.bag->strap_tension); }},
  {"plate_force_N", has::plates, [](Of, At now) { return now.bag->forces.plate_force.norm(); }},
};
// clang-format on

// Those of each species and stream: what is in the gas, and what came and went since the start.
void add_streams(Of scene, std::vector<Column>& columns) {
  const auto& model = scene.gas->model;
  const auto add = [&](const std::string& name, auto value) {
    columns.push_back({name, [value](Of, At now) { return value(now.level); }});
  };
  for (std::size_t k = 0; k < model.thermo.size(); ++k)
    add("mass_" + model.thermo.species(k).name + "_kg", [k](const Level& n) { return n.masses[k]; });
  for (std::size_t i = 0; i < model.inflows.size(); ++i)
    add("inflator_" + std::to_string(i) + "_in_kg",
        [i](const Level& n) { return n.streams.inflows[i].mass; });
  const std::size_t vents = model.vents.size();
  for (std::size_t j = 0; j < vents; ++j) {
    const std::string vent = "vent_" + std::to_string(j);
    add(vent + "_out_kg", [j](const Level& n) { return n.streams.outflows[j].mass; });
    if (model.vents[j].backflow)
      add(vent + "_backflow_kg", [j](const Level& n) { return n.streams.backflows[j].mass; });
  }
  if (!has::fabric_leak(scene)) return;
  if (model.fabric_count() == 1)
    add("fabric_out_kg", [vents](const Level& n) { return n.streams.outflows[vents].mass; });
  else
    for (std::size_t i = 0; i < model.fabric_count(); ++i)
      add("fabric_" + std::to_string(i) + "_out_kg",
          [stream = vents + i](const Level& n) { return n.streams.outflows[stream].mass; });
}

}  // namespace

std::vector<Column> history_columns(const Scene& scene) {
  std::vector<Column> columns;
  for (const Line& line : kLines)
    if (line.when(scene)) columns.push_back({line.name, line.value});
  if (scene.output.streams) add_streams(scene, columns);
  return columns;
}

std::vector<Column> energy_columns(const Scene& scene) {
  std::vector<Column> columns{{"time_s", [](Of, At now) { return now.time; }}};
  for (const EnergyTerm& term : energy_terms())
    if (term.when(scene)) columns.push_back({term.name, term.value});
  return columns;
}

std::vector<double> row(const std::vector<Column>& columns, const Scene& scene, const State& state) {
  std::vector<double> values;
  for (const Column& column : columns) values.push_back(column.value(scene, state));
  return values;
}

}  // namespace driver
