// SPDX-License-Identifier: Apache-2.0
// What a simulation shows: arrays, gas, impactor, columns.
#include <gasjet/simulation.h>

#include <array>

#include "arrays.hpp"
#include "engine/controls.hpp"
#include "engine/drift.hpp"
#include "engine/impactor.hpp"
#include "gas/control_volume.hpp"
#include "sim_object.hpp"

using namespace border;

namespace {

// Rows of doubles.
struct View {
  const double* values = nullptr;
  int64_t rows = 0, columns = 3, stride = 4;
};

View view_of(const membrane::Vectors& vectors) {
  return {vectors.empty() ? nullptr : vectors.data(), vectors.count()};
}
View view_of(const std::vector<gas::StreamFlux>& streams) {
  static_assert(sizeof(gas::StreamFlux) == 2 * sizeof(double));
  return {streams.empty() ? nullptr : &streams.front().mass, static_cast<int64_t>(streams.size()), 2, 2};
}

View view_of(const Sim& sim, int array) {
  const driver::State& state = sim.state();
  if (array < GASJET_SIM_POSITION || array > GASJET_SIM_BACKFLOWS)
    refuse("array",
           "is " + std::to_string(array) + ", allowed: 0 to " + std::to_string(GASJET_SIM_BACKFLOWS));
  if (array == GASJET_SIM_GAS_MASS)
    return {state.gas.masses.data(), static_cast<int64_t>(state.gas.masses.size()), 1, 1};
  if (array == GASJET_SIM_INFLOWS) return view_of(state.streams.inflows);
  if (array == GASJET_SIM_OUTFLOWS) return view_of(state.streams.outflows);
  if (array == GASJET_SIM_BACKFLOWS) return view_of(state.streams.backflows);
  if (!state.bag) return {};
  const membrane::BagState& bag = *state.bag;
  const std::array<const membrane::Vectors*, GASJET_SIM_SUPPORT_FORCE + 1> all{
      &bag.position,      &bag.velocity,  &bag.membrane_force, &bag.volume_gradient,
      &bag.contact_force, &bag.jet_force, &bag.support_force};
  return view_of(*all[static_cast<std::size_t>(array)]);
}

}  // namespace

int gasjet_sim_view(gasjet_handle sim, int array, const double** values, int64_t* rows, int64_t* columns,
                    int64_t* stride) {
  return call([&] {
    const Use<Sim> use(sim, "sim");
    needed(values, "values");
    needed(rows, "rows");
    needed(columns, "columns");
    needed(stride, "stride");
    const bool of_step = array >= GASJET_SIM_CONTACT_FORCE && array <= GASJET_SIM_SUPPORT_FORCE;
    if (of_step && use->simulation.now().failure.empty()) use->simulation.evaluate();
    const View view = view_of(*use, array);
    *values = view.values;
    *rows = view.rows;
    *columns = view.columns;
    *stride = view.stride;
  });
}

int gasjet_sim_triangles(gasjet_handle sim, const int32_t** triangles, int64_t* elements) {
  return call([&] {
    const Use<Sim> use(sim, "sim");
    needed(triangles, "triangles");
    needed(elements, "elements");
    const auto& given = use->simulation.now().given;
    if (!given->bag) refuse("sim", "has no skin, allowed: a case with [membrane]");
    *triangles = given->bag->mesh.elements.data();
    *elements = given->bag->mesh.elements.cols();
  });
}

int gasjet_sim_jet(gasjet_handle sim, int64_t jet, const double** overpressure, int64_t* elements,
                   const int32_t** candidates, const uint8_t** lit, int64_t* candidate_count) {
  return call([&] {
    const Use<Sim> use(sim, "sim");
    needed(overpressure, "overpressure");
    needed(elements, "elements");
    needed(candidates, "candidates");
    needed(lit, "lit");
    needed(candidate_count, "candidate_count");
    const auto& jets = use->state().jets;
    if (jets.empty()) refuse("jet", "is " + std::to_string(jet) + ", but the scene has none");
    if (jet < 0 || jet >= static_cast<int64_t>(jets.size()))
      refuse("jet", "is " + std::to_string(jet) + ", allowed: 0 to " + std::to_string(jets.size()) + " - 1");
    use->simulation.evaluate();
    const driver::JetRun& run = jets[static_cast<std::size_t>(jet)];
    const bool pieces = !run.elements.overpressure.empty();
    *overpressure = run.load().overpressure.data();
    *elements = static_cast<int64_t>(run.load().overpressure.size());
    *candidates = run.field.candidates.data();
    *lit = run.lit.data();
    *candidate_count = pieces ? 0 : static_cast<int64_t>(run.field.candidates.size());
  });
}

int gasjet_sim_gas(gasjet_handle sim, gasjet_tank_state* gas) {
  return call([&] {
    const Use<Sim> use(sim, "sim");
    needed(gas, "gas");
    if (!use->scene().has_volume()) refuse("sim", "has no volume of gas, allowed: a case with one");
    const gas::GasPoint p = driver::gas_now(use->scene(), use->state());
    const gasjet_tank_state all{
        use->state().time,  p.pressure, p.temperature,
        p.volume,           p.mass,     use->state().gas.internal_energy + use->state().jet_work.ahead(),
        p.density,          p.gamma,    p.cp,
        p.gas_constant,     p.inflow,   p.vent_mass_flow,
        p.fabric_mass_flow, p.backflow, p.heat_loss};
    *gas = finite(all, "gas");
  });
}

int gasjet_sim_read_impact(gasjet_handle sim, gasjet_sim_impact* impact) {
  return call([&] {
    const Use<Sim> use(sim, "sim");
    needed(impact, "impact");
    if (!use->scene().has_impactor()) refuse("sim", "has no impactor, allowed: a case with one");
    use->simulation.evaluate();
    const driver::State& state = use->state();
    gasjet_sim_impact all{};
    const coupling::Pose& pose = state.level.impactor;
    write_vector(pose.centre, all.centre);
    for (int i = 0; i < 3; ++i) write_vector(pose.axes.col(i), all.axes + 3 * i);
    const auto [velocity, angular_velocity] = driver::impactor_speeds(use->scene(), state);
    write_vector(velocity, all.velocity);
    write_vector(angular_velocity, all.angular_velocity);
    write_vector(state.contact.force, all.force);
    write_vector(state.contact.couple, all.couple);
    all.energy = state.contact.energy;
    all.penetration = state.contact.penetration;
    *impact = finite(all, "impact");
  });
}

int gasjet_sim_value(gasjet_handle sim, int table, const char* name, double* value) {
  return call([&] {
    const Use<Sim> use(sim, "sim");
    needed(value, "value");
    const Table& asked = table_of(use->tables, table);
    const auto& values = asked.values[column_of(asked, text(name, "name"))];
    if (values.empty()) refuse("sim", "has no row yet, allowed: after the first step");
    *value = values.back();
  });
}

int gasjet_sim_drift(gasjet_handle sim, double* drift) {
  return call([&] {
    const Use<Sim> use(sim, "sim");
    needed(drift, "drift") = driver::energy_drift(use->state());
  });
}
