// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>

#include "cases.hpp"
#include "gas/orifice.hpp"

// Reference numbers, computed with 20 to 40 digits from the formulas of docs/theory/gas.md (its table
// "Reference cases"), against what the library integrates; each records its error.
namespace {

using namespace cases;

struct Tank {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  double volume = 0.06, pressure = kAmbientPressure, temperature = 293.15, leak_area = 0.0;
};

Tank filled(double mass_flow, double inflow_temperature, double pressure = kAmbientPressure) {
  Tank tank;
  tank.pressure = pressure;
  tank.model.inflows.push_back(steady_inflow(tank.model.thermo, mass_flow, inflow_temperature));
  return tank;
}

Tank holed(double pressure = 5e5, double temperature = 600.0) {
  Tank tank;
  tank.model.vents.push_back({1.0, 1e-3});
  tank.pressure = pressure;
  tank.temperature = temperature;
  return tank;
}

/// The gas at time `end`, the volume then being `last` (as at the start if 0).
gas::GasPoint run(const Tank& tank, double end, const gas::IntegratorOptions& options, double last = 0.0) {
  last = last > 0.0 ? last : tank.volume;
  gas::ControlVolumeState state =
      gas::make_state(tank.model, kPure, tank.pressure, tank.temperature, tank.volume);
  gas::GasIntegrator(tank.model, options)
      .advance(state, 0.0, end, {tank.volume, last, tank.leak_area, tank.leak_area});
  return gas::evaluate(tank.model, state, last, tank.leak_area, end);
}

double worst(std::initializer_list<std::pair<double, double>> values) {
  double error = 0.0;
  for (const auto& [value, exact] : values) error = std::max(error, relative(value, exact));
  return error;
}

constexpr gas::IntegratorOptions kFine{1e-13};

double choked_blowdown(const gas::IntegratorOptions& options) {
  const gas::GasPoint p = run(holed(), 0.05, options);
  return worst(
      {{p.pressure, 359732.85620962291}, {p.temperature, 546.13120702398068}, {p.mass, 0.13315898190538939}});
}

double subsonic_blowdown() {
  return worst({{run(holed(), 0.16, kFine).pressure, 183337.7831698602},
                {run(holed(), 0.18, kFine).pressure, 163432.05950537481},
                {run(holed(), 0.26614434361175357, kFine).pressure, 110000.0},
                {run(holed(), 0.5, kFine).temperature, 380.25843168753486},
                {run(holed(), 0.5, kFine).pressure, kAmbientPressure}});
}

double porous_tank() {
  Tank tank;
  tank.volume = 0.12, tank.pressure = 130000.0, tank.temperature = 400.0, tank.leak_area = 0.0025 * 1.5;
  return worst({{run(tank, 0.01, kFine).pressure, 118759.40296999072},
                {run(tank, 0.02, kFine).pressure, 110661.71823484026},
                {run(tank, 0.06, kFine).pressure, kAmbientPressure}});
}

double piston() {
  Tank tank;
  tank.volume = 1e-3;
  const gas::GasPoint p = run(tank, 1.0, kFine, 1e-3 / 8.0);
  return worst({{p.pressure, 1862269.7731211932}, {p.temperature, 673.48184553476162}});
}

double vented_fill() {
  Tank tank = holed(332836.0, 690.0);
  tank.model.inflows.push_back(steady_inflow(tank.model.thermo, 0.5, 700.0));
  const gas::GasPoint p = run(tank, 8.0, kFine);
  return worst({{p.pressure, 332836.30571198209}, {p.temperature, 700.0}});
}

double constant_pressure() {
  Tank tank = filled(0.5, 700.0);
  tank.volume = 0.01;
  const gas::GasPoint p = run(tank, 0.1, {}, 0.11252158894645941);
  return worst({{p.pressure, kAmbientPressure}, {p.temperature, 623.14097435750194}});
}

double figure_3() {
  double error = 0.0;
  for (const auto& [excess, hole, fabric] :
       std::vector<std::array<double, 3>>{{1e3, 2.70644759005567, 2.72072921326784},
                                          {2e4, 12.0227586600569, 13.2490454817482},
                                          {7.5e4, 22.8532227524414, 30.9301496372155},
                                          {1e5, 26.2178716332128, 38.1630693916162}}) {
    const double p = kAmbientPressure + excess, rho = p / (296.8 * 673.0);
    error = std::max(
        error, worst({{gas::orifice_mass_flow(0.085, p, 673.0, 296.8, 1038.8, 1.4, kAmbientPressure), hole},
                      {gas::fabric_mass_flow(0.085, rho, p, kAmbientPressure), fabric}}));
  }
  return error;
}

struct Reference {
  const char* name;
  double allowed;  // stated accuracy: rounding where nothing is stepped, else the tolerance times sub-steps
  double (*error)();
};

const Reference kReferences[] = {
    {"constant_inflow", 1e-13,
     [] {
       const gas::GasPoint p = run(filled(1.0, 700.0), 0.05, {});
       return worst({{p.pressure, 343711.66666666667}, {p.temperature, 579.63890406435531}});
     }},
    {"evacuated_fill", 1e-13,
     [] { return relative(run(filled(1.0, 700.0, 0.0), 1e-6, {}).temperature, 980.0); }},
    {"choked_blowdown", 1e-12, [] { return choked_blowdown(kFine); }},
    // Fourth order: 25 steps of 2 ms against a time constant of 208 ms.
    {"choked_blowdown_rk4_25_steps", 1e-9,
     [] {
       return choked_blowdown({1e-10, 100, gas::Method::kRungeKutta4, 0.05 / 25});
     }},
    {"through_the_sonic_switch_to_rest", 1e-11, subsonic_blowdown},
    {"porous_tank_to_rest", 1e-11, porous_tank},
    {"fill_with_choked_vent", 1e-12, vented_fill},
    {"piston", 1e-11, piston},
    {"figure_3", 1e-13, figure_3},  // the numbers have 15 digits, p - p_a loses two
    {"constant_pressure_fill", 1e-13, constant_pressure},
};

void PrintTo(const Reference& one, std::ostream* out) {
  *out << one.name;
}

class reference : public testing::TestWithParam<Reference> {};

TEST_P(reference, is_met_to_its_stated_accuracy) {
  const double error = GetParam().error();
  RecordProperty("error", std::to_string(1e15 * error) + "e-15");
  EXPECT_LE(error, GetParam().allowed);
}

INSTANTIATE_TEST_SUITE_P(cases, reference, testing::ValuesIn(kReferences),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
