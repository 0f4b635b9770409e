// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>

#include "cases.hpp"
#include "claim.hpp"
#include "gas/orifice.hpp"

// Reference numbers, computed with 20 to 40 digits from the formulas of docs/theory/gas.md (the table is in
// gas_verification.md), against what the library integrates.
namespace {

using namespace cases;

struct ReferenceTank {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  double volume = 0.06, pressure = kAmbientPressure, temperature = 293.15, leak_area = 0.0;
};

ReferenceTank filled(double mass_flow, double inflow_temperature, double pressure = kAmbientPressure) {
  ReferenceTank tank;
  tank.pressure = pressure;
  tank.model.inflows.push_back(steady_inflow(tank.model.thermo, mass_flow, inflow_temperature));
  return tank;
}

ReferenceTank holed(double pressure = 5e5, double temperature = 600.0) {
  ReferenceTank tank;
  tank.model.vents.push_back({1.0, 1e-3});
  tank.pressure = pressure;
  tank.temperature = temperature;
  return tank;
}

/// The gas at time `end`, the volume then being `last` (as at the start if 0).
gas::GasPoint run(const ReferenceTank& tank, double end, const gas::IntegratorOptions& options,
                  double last = 0.0) {
  last = last > 0.0 ? last : tank.volume;
  gas::ControlVolumeState state =
      gas::make_state(tank.model, kPure, tank.pressure, tank.temperature, tank.volume);
  gas::GasIntegrator(tank.model, options)
      .advance(state, 0.0, end, {tank.volume, last, tank.leak_area, tank.leak_area});
  return gas::evaluate(tank.model, state, last, tank.leak_area, end);
}

struct Compared {
  double value, exact;
};

/// The one with the largest relative error.
Compared worst(std::initializer_list<Compared> values) {
  return std::max(values, [](const Compared& a, const Compared& b) {
    return relative(a.value, a.exact) < relative(b.value, b.exact);
  });
}

constexpr gas::IntegratorOptions kFine{1e-13};

Compared choked_blowdown(const gas::IntegratorOptions& options) {
  const gas::GasPoint p = run(holed(), 0.05, options);
  return worst(
      {{p.pressure, 359732.85620962291}, {p.temperature, 546.13120702398068}, {p.mass, 0.13315898190538939}});
}

Compared subsonic_blowdown() {
  return worst({{run(holed(), 0.16, kFine).pressure, 183337.7831698602},
                {run(holed(), 0.18, kFine).pressure, 163432.05950537481},
                {run(holed(), 0.26614434361175357, kFine).pressure, 110000.0},
                {run(holed(), 0.5, kFine).temperature, 380.25843168753486},
                {run(holed(), 0.5, kFine).pressure, kAmbientPressure}});
}

ReferenceTank porous_reference() {
  ReferenceTank tank;
  tank.volume = 0.12, tank.pressure = 130000.0, tank.temperature = 400.0, tank.leak_area = 0.0025 * 1.5;
  return tank;
}

Compared porous_tank() {
  const ReferenceTank tank = porous_reference();
  return worst({{run(tank, 0.01, kFine).pressure, 118759.40296999072},
                {run(tank, 0.02, kFine).pressure, 110661.71823484026},
                {run(tank, 0.06, kFine).pressure, kAmbientPressure}});
}

/// p with walls that keep the gas at its temperature: hA of 4, 8 and 16 MW/K, extrapolated twice in 1/(hA),
/// where a term is some 1e-5 of the one before.
double isothermal(ReferenceTank tank, double time) {
  std::array<double, 3> p{};
  double conductance = 4e6;
  for (double& one : p) {
    tank.model.heat_loss = {conductance, tank.temperature};
    one = run(tank, time, {1e-12, 100000, gas::Method::rosenbrock_4}).pressure;
    conductance *= 2.0;
  }
  const double coarse = 2.0 * p[1] - p[0], fine = 2.0 * p[2] - p[1];
  return fine + (fine - coarse) / 3.0;
}

Compared isothermal_blowdown() {
  // The second at the sonic switch, p_a/r*.
  return worst({{isothermal(holed(), 0.05), 393001.55708981881},
                {isothermal(holed(), 0.1989558274046831), 191801.04700911307}});
}

Compared isothermal_porous_tank() {
  const ReferenceTank tank = porous_reference();
  return worst({{isothermal(tank, 0.01), 121588.46551630102}, {isothermal(tank, 0.02), 114824.70715404161}});
}

Compared piston() {
  ReferenceTank tank;
  tank.volume = 1e-3;
  gas::ControlVolumeState state = gas::make_state(tank.model, kPure, tank.pressure, tank.temperature, 1e-3);
  const double work =
      gas::GasIntegrator(tank.model, kFine).advance(state, 0.0, 1.0, {1e-3, 1e-3 / 8.0, 0.0, 0.0}).work;
  const gas::GasPoint p = gas::evaluate(tank.model, state, 1e-3 / 8.0, 0.0, 1.0);
  return worst(
      {{p.pressure, 1862269.7731211932}, {p.temperature, 673.48184553476162}, {-work, 328.64680410037286}});
}

Compared vented_fill() {
  ReferenceTank tank = holed(332836.0, 690.0);
  tank.model.inflows.push_back(steady_inflow(tank.model.thermo, 0.5, 700.0));
  const gas::GasPoint p = run(tank, 8.0, kFine);
  return worst({{p.pressure, 332836.30571198209}, {p.temperature, 700.0}});
}

Compared constant_pressure() {
  ReferenceTank tank = filled(0.5, 700.0);
  tank.volume = 0.01;
  const gas::GasPoint p = run(tank, 0.1, {}, 0.11252158894645941);
  return worst({{p.pressure, kAmbientPressure}, {p.temperature, 623.14097435750194}});
}

Compared figure_3() {
  Compared all{1.0, 1.0};
  for (const auto& [excess, hole, fabric] :
       std::vector<std::array<double, 3>>{{1e3, 2.70644759005567, 2.72072921326784},
                                          {2e4, 12.0227586600569, 13.2490454817482},
                                          {7.5e4, 22.8532227524414, 30.9301496372155},
                                          {1e5, 26.2178716332128, 38.1630693916162}}) {
    const double p = kAmbientPressure + excess, rho = p / (296.8 * 673.0);
    all = worst({all,
                 {gas::orifice_mass_flow(0.085, p, 673.0, 296.8, 1038.8, 1.4, kAmbientPressure), hole},
                 {gas::fabric_mass_flow(0.085, rho, p - kAmbientPressure), fabric}});
  }
  return all;
}

struct Reference {
  const char *name, *equation, *what;
  double allowed;
  const char* why;
  Compared (*compared)();
};

const char* const kRounding = "nothing is stepped: rounding";
const char* const kTolerance = "sub-steps of tolerance 1e-13";

const Reference kReferences[] = {
    {"constant_inflow", "G.10", "constant inflow, 50 ms: p, T", 1e-13, kRounding,
     [] {
       const gas::GasPoint p = run(filled(1.0, 700.0), 0.05, {});
       return worst({{p.pressure, 343711.66666666667}, {p.temperature, 579.63890406435531}});
     }},
    {"evacuated_fill", "G.10", "evacuated fill, 1 microsecond: T [K]", 1e-13, kRounding,
     [] {
       return Compared{run(filled(1.0, 700.0, 0.0), 1e-6, {}).temperature, 980.0};
     }},
    {"choked_blowdown", "G.6", "choked blow-down, 50 ms: p, T, m", 1e-12, kTolerance,
     [] { return choked_blowdown(kFine); }},
    {"choked_blowdown_rk4_25_steps", "G.6", "choked blow-down in 25 steps of RK4: p, T, m", 1e-9,
     "fourth order: 2 ms against a time constant of 208 ms",
     [] {
       return choked_blowdown({1e-10, 100, gas::Method::runge_kutta_4, 0.05 / 25});
     }},
    {"through_the_sonic_switch_to_rest", "G.6", "blow-down through the switch to rest: p, T", 1e-11,
     kTolerance, subsonic_blowdown},
    {"porous_tank_to_rest", "G.7", "porous tank to rest: p", 1e-11, kTolerance, porous_tank},
    {"isothermal_blowdown", "G.11", "isothermal blow-down, 50 ms and at the switch: p", 1e-11,
     "sub-steps of tolerance 1e-12; an extrapolation that weighs them 6", isothermal_blowdown},
    {"isothermal_porous_tank", "G.11", "isothermal porous tank: p", 1e-11,
     "sub-steps of tolerance 1e-12; an extrapolation that weighs them 6", isothermal_porous_tank},
    {"fill_with_choked_vent", "G.9", "inflow against a choked vent, 8 s: p, T", 1e-12, kTolerance,
     vented_fill},
    {"piston", "G.10", "piston, compressed eightfold: p, T, work", 1e-12, kTolerance, piston},
    {"figure_3", "G.6", "the paper's Figure 3, hole and fabric", 1e-13,
     "numbers of 15 digits; p - p_a loses two", figure_3},
    {"constant_pressure_fill", "G.10", "filling at constant pressure: p, T", 1e-13, kRounding,
     constant_pressure},
};

void PrintTo(const Reference& one, std::ostream* out) {
  *out << one.name;
}

class reference : public testing::TestWithParam<Reference> {};

TEST_P(reference, is_met_to_its_stated_accuracy) {
  const Reference& r = GetParam();
  const auto [value, exact] = r.compared();
  claim::expect_relative({r.equation, r.what, r.why}, value, exact, r.allowed);
}

INSTANTIATE_TEST_SUITE_P(cases, reference, testing::ValuesIn(kReferences),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
