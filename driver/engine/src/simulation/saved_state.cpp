// SPDX-License-Identifier: Apache-2.0
#include "engine/saved_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "base/build_info.hpp"
#include "engine/controls.hpp"
#include "engine/energy_terms.hpp"
#include "simulation/archive.hpp"

namespace driver {
namespace {

void add(Archive& a, Streams& s) {
  a.whole(s.inflows), a.whole(s.outflows), a.whole(s.backflows), a.whole(s.outflow_ambient);
  a.plain(s.ambient);
}

void add(Archive& a, Level& s) {
  a.plain(s.internal_energy, s.volume, s.skin_area, s.skin_strain, s.displacement, s.pendulum_angle,
          s.impactor.centre, s.impactor.axes, s.field, s.flows, s.ambient, s.jet_force, s.skin_gravity,
          s.jet_power, s.pressure_power, s.own_power, s.skin_kinetic, s.energy_residual, s.kick_residual);
  a.list(s.masses);
  add(a, s.streams);
}

// The name of a term is a text of the program.
void add(Archive& a, LargestTerm& s) {
  std::string name = s.name;
  a.text(name);
  a.plain(s.magnitude);
  const auto terms = energy_terms();
  const auto found = std::ranges::find_if(terms, [&](const EnergyTerm& term) { return name == term.name; });
  s.name = found == terms.end() ? "" : found->name;
}

void add(Archive& a, Peaks& s) {
  a.plain(s.pressure, s.volume, s.pendulum_angle, s.cg_acceleration, s.displacement, s.acceleration,
          s.contact_force, s.penetration, s.jet_force, s.first_contact, s.mass_residual, s.ledger_residual,
          s.energy_residual, s.energy_scale, s.mechanical, s.self_contact, s.momentum_residual);
  add(a, s.largest_term);
}

void add(Archive& a, AtStart& s) {
  a.plain(s.gas_mass, s.volume, s.ambient_work, s.energy, s.kinetic, s.smallest_energy);
  a.whole(s.masses), a.whole(s.ambient_energy);
}

void add(Archive& a, gas::ControlVolumeState& s) {
  a.whole(s.masses);
  a.plain(s.internal_energy, s.temperature);
  a.whole(s.triggers);
}

void add(Archive& a, membrane::BagState& s) {
  for (membrane::Vectors* v : {&s.position, &s.velocity, &s.area_vector, &s.centroid, &s.volume_gradient,
                               &s.membrane_force, &s.jet_force, &s.support_force, &s.viscous.force,
                               &s.viscous.elastic_stress, &s.contact_force, &s.own_force})
    a.vectors(*v);
  a.list(s.rate_bound_squared), a.list(s.jet_nodes), a.list(s.has_jet_force), a.list(s.strap_tension);
  a.plain(s.gauge_pressure, s.gravity, s.surface, s.forces, s.advance);
  a.matrix(s.shares.mass);
  a.list(s.shares.frequency);
}

void add(Archive& a, coupling::ContactState& s) {
  a.plain(s.centre, s.axes, s.shift, s.kept, s.started, s.displacement_bound, s.told, s.ahead, s.expected,
          s.gap, s.nearest);
  a.matrix(s.nodes);
  a.list(s.slack), a.list(s.group_slack), a.list(s.near), a.list(s.bristles), a.list(s.old_bristles);
}

void add(Archive& a, coupling::SkinContactRecord& s) {
  a.plain(s.level, s.looks, s.sweeps);
  a.matrix(s.nodes);
  a.list(s.node_limits), a.list(s.edge_limits), a.list(s.bristles);
}

// Structures with gaps between their members are named by member, or the bytes would hold what the memory
// held.
template <class T, std::size_t size>
void require_all_named() {
  static_assert(sizeof(T) == size, "a member was added: name it, too");
}

void add(Archive& a, coupling::ContactResult& s) {
  require_all_named<coupling::ContactResult, 104>();
  a.plain(s.force, s.couple, s.energy, s.friction_loss, s.area, s.penetration, s.deepest_element,
          s.omega_squared_skin, s.omega_squared_sphere);
}

void add(Archive& a, coupling::SkinContactResult& s) {
  require_all_named<coupling::SkinContactResult, 80>();
  a.plain(s.energy, s.friction_loss, s.omega_squared, s.contacts, s.closest.first, s.closest.second,
          s.closest.gap, s.approach, s.kink_energy);
}

void add(Archive& a, BodyRun& s) {
  require_all_named<BodyRun, 536>();
  a.plain(s.driven, s.last_pose, s.last_contact, s.last_velocity, s.motion, s.contact, s.displacement,
          s.gravity_energy, s.spring_energy, s.driving_work, s.driving_work_before, s.kick, s.velocity,
          s.acceleration, s.angular_velocity, s.kinetic);
}

void add(Archive& a, LevelProgress& s) {
  require_all_named<LevelProgress, 24>();
  a.plain(s.history, s.request, s.all);
}

// What only saves work is made anew.
void add(Archive& a, const coupling::SkinContactModel& model, State& s) {
  coupling::SkinContactRecord record = s.skin_contact_cache->record();
  add(a, record);
  if (a.reads()) s.skin_contact_cache = model.make_state(record);
}

// Likewise.
void add(Archive& a, JetRun& s) {
  a.plain(s.outlet, s.field.restitution, s.field.size_ratio, s.field.outline_motion, s.counters, s.total,
          s.force, s.load_change, s.firing, s.known_inside);
  for (jet::FieldState* field : {&s.field, &s.elements})
    a.list(field->overpressure), a.list(field->candidates);
  a.list(s.lit);
  if (a.reads()) s.field.displacement_bound = jet::kMotionUnknown;
}

void add(Archive& a, const Scene& scene, State& s) {
  a.plain(s.time, s.steps, s.stage, s.step, s.flows, s.gas_point, s.jet_work, s.stage_ticks);
  add(a, s.contact), add(a, s.skin_contact);
  add(a, s.level), add(a, s.peaks), add(a, s.start), add(a, s.gas), add(a, s.streams);
  a.plain(s.gas_events.last);
  a.whole(s.gas_events.opened);
  if (s.bag) add(a, *s.bag);
  if (s.pendulum) a.plain(*s.pendulum);
  if (s.body) add(a, *s.body);
  if (s.contact_cache) add(a, *s.contact_cache);
  if (s.skin_contact_cache) add(a, *scene.skin_contact, s);
  for (JetRun& jet : s.jets) add(a, jet);
}

std::string_view bytes_of(const double* values, std::size_t count) {
  return {reinterpret_cast<const char*>(values), count * sizeof(double)};
}

// What a state must agree on with its case: its settings, where skin and impactor start, and the gas.
std::string key_of(const Scene& scene, const State& start) {
  std::uint64_t sum = checksum(scene.name);
  if (start.bag)
    sum = checksum(
        bytes_of(start.bag->position.data(), 4 * static_cast<std::size_t>(start.bag->position.count())), sum);
  if (start.body) sum = checksum(bytes_of(start.body->motion.centre.data(), 3), sum);
  const double numbers[] = {scene.time.end, start.gas.masses.empty() ? 0.0 : start.gas.internal_energy,
                            start.pendulum ? start.pendulum->motion.angle : 0.0};
  sum = checksum(bytes_of(numbers, 3),
                 checksum(bytes_of(start.gas.masses.data(), start.gas.masses.size()), sum));
  return fmt::format("gasjet state 1, {} {}, {} {:016x} {:016x}", build_info::version, build_info::commit,
                     scene.name, sum, scene.digest);
}

// The start of the scene as it was given.
std::string key_of(const Simulation& simulation) {
  return key_of(*simulation.now().given, make_state(*simulation.now().given));
}

}  // namespace

std::string saved(const Simulation& simulation) {
  const Moment& now = simulation.now();
  if (!now.failure.empty()) throw std::invalid_argument("sim: has failed, allowed: one that can go on");
  if (!now.later.empty())
    throw std::invalid_argument("sim: has a setting that waits for the next level, allowed: after a step");
  Archive archive;
  State state = now.state;
  std::string key = key_of(simulation);
  std::vector<Control> controls = now.controls;
  LevelProgress progress = simulation.loop().progress();
  std::uint8_t evaluated = now.evaluated ? 1 : 0;
  archive.text(key);
  archive.list(controls);
  add(archive, progress);
  archive.plain(evaluated);
  add(archive, simulation.scene(), state);
  const std::uint64_t sum = checksum(archive.written());
  return archive.written() + std::string(reinterpret_cast<const char*>(&sum), sizeof sum);
}

void restore(Simulation& simulation, std::string_view bytes) {
  std::uint64_t sum = 0;
  if (bytes.size() < sizeof sum)
    throw std::invalid_argument("state: is cut off, allowed: bytes as they were saved");
  std::memcpy(&sum, bytes.end() - sizeof sum, sizeof sum);
  bytes.remove_suffix(sizeof sum);
  if (sum != checksum(bytes))
    throw std::invalid_argument("state: is damaged, allowed: bytes as they were saved");
  Archive archive(bytes);
  Simulation fresh(simulation);
  fresh.reset();
  const std::string wanted = key_of(simulation);
  std::string key;
  archive.text(key);
  if (key != wanted)
    throw std::invalid_argument(
        fmt::format("state: is of \"{}\", allowed: of this case and build, \"{}\"", key, wanted));
  std::vector<Control> controls;
  archive.list(controls);
  for (const Control& control : controls) apply(fresh, control);
  LevelProgress progress = fresh.loop().progress();
  std::uint8_t evaluated = 0;
  add(archive, progress);
  archive.plain(evaluated);
  State state = fresh.state();
  add(archive, fresh.scene(), state);
  if (!archive.at_end()) throw std::invalid_argument("state: has more bytes than were saved");
  fresh.take(state, progress, evaluated != 0);
  simulation = static_cast<const Simulation&>(fresh);
}

}  // namespace driver
