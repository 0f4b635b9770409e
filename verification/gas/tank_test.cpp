// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <numbers>

#include "cases.hpp"
#include "claim.hpp"
#include "closed_form/gas.hpp"

// Closed rigid tanks: no stepper, so every result is exact to round-off.
namespace {

using namespace cases;

constexpr double kRoundOff = 1e-13;
const char* const kWhy = "rounding: sums of a few products, some ten operations more";

TEST(tank, constant_inflow_eq_closed_form) {
  for (const auto& [mass_flow, t_in, p0, t0] : std::vector<std::array<double, 4>>{
           {1.0, 700.0, 101325.0, 293.15}, {0.2, 1200.0, 5e5, 600.0}, {4.0, 250.0, 2e4, 350.0}}) {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    model.inflows.push_back(steady_inflow(model.thermo, mass_flow, t_in));
    gas::GasIntegrator integrator(model);
    gas::ControlVolumeState state = gas::make_state(model.thermo, kPure, p0, t0, 0.06);
    const closed_form::TankFill tank{{}, 0.06, p0, t0, mass_flow, t_in};
    double t = 0.0;
    for (const double next : {1e-5, 0.01, 0.05, 0.1}) {
      const gas::StepFluxes fluxes = integrator.advance(state, t, next, rigid(0.06));
      const gas::GasPoint point = gas::evaluate(model, state, 0.06, 0.0, t = next);
      const closed_form::GasState expected = closed_form::tank_fill(tank, t);
      claim::expect_relative({"G.8", "constant inflow into a closed tank: pressure [Pa]", kWhy},
                             point.pressure, expected.pressure, kRoundOff);
      claim::expect_relative({"G.10", "constant inflow into a closed tank: temperature [K]", kWhy},
                             point.temperature, expected.temperature, kRoundOff);
      claim::expect_relative({"G.9", "constant inflow into a closed tank: mass [kg]", kWhy}, point.mass,
                             expected.mass, kRoundOff);
      EXPECT_EQ(fluxes.steps, 0);
    }
  }
}

TEST(tank, evacuated_fill_gives_gamma_T_in) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.inflows.push_back(steady_inflow(model.thermo, 1.0, 700.0));
  gas::ControlVolumeState state = gas::make_state(model.thermo, kPure, 0.0, 293.15, 0.06);
  const gas::GasPoint empty = gas::evaluate(model, state, 0.06, 0.0, 0.0);
  EXPECT_EQ(empty.pressure, 0.0);
  EXPECT_EQ(empty.temperature, 293.15);
  for (const bool vented : {false, true}) {
    // With p < p_a a vent changes nothing, but makes the integrator step.
    if (vented) model.vents.push_back({0.6, 1e-3});
    gas::GasIntegrator integrator(model);
    state = gas::make_state(model.thermo, kPure, 0.0, 293.15, 0.06);
    double t = 0.0;
    for (const double next : {1e-12, 1e-6, 1e-3}) {
      integrator.advance(state, t, next, rigid(0.06));
      const gas::GasPoint point = gas::evaluate(model, state, 0.06, 0.0, t = next);
      claim::expect_relative({"G.10", "evacuated fill: temperature, gamma T_in [K]", kWhy}, point.temperature,
                             980.0, kRoundOff);
      claim::expect_relative({"G.8", "evacuated fill: pressure [Pa]", kWhy}, point.pressure,
                             1.4 * 296.8 * 700.0 * t / 0.06, kRoundOff);
    }
  }
}

/// Evacuated fill with cp(T): u(T) = h(T_in), by bisection here.
TEST(tank, evacuated_fill_with_nasa7_gives_u_eq_h_in) {
  for (const double t_in : {406.0, 700.0, 900.0, 2000.0}) {
    gas::ControlVolumeModel model = closed_tank(nasa7({"N2"}));
    model.inflows.push_back(steady_inflow(model.thermo, 0.5, t_in));
    gas::ControlVolumeState state = gas::make_state(model.thermo, kPure, 0.0, 300.0, 0.06);
    gas::GasIntegrator(model).advance(state, 0.0, 0.01, rigid(0.06));
    double low = t_in, high = 1.5 * t_in;
    for (int i = 0; i < 100; ++i) {
      const double middle = 0.5 * (low + high);
      (model.thermo.internal_energy(0, middle) < model.thermo.enthalpy(0, t_in) ? low : high) = middle;
    }
    claim::expect_relative({"G.4", "evacuated fill with cp(T): temperature, u(T) = h(T_in) [K]", kWhy},
                           state.temperature, low, kRoundOff);
    EXPECT_GT(relative(state.temperature, 1.4 * t_in), 1e-3) << "constant gamma is not the answer";
  }
}

/// The gas at time `end` of a smooth pulse whose flow is a curve with n pieces.
gas::GasPoint pulse_fill(const closed_form::PulseFill& pulse, int n, double end) {
  std::vector<gas::Curve::Knot> flow;
  for (int i = 0; i <= n; ++i) {
    const double x = static_cast<double>(i) / n, s = std::sin(std::numbers::pi * x);
    flow.push_back({pulse.duration * x, 2.0 * pulse.total_mass / pulse.duration * s * s});
  }
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.inflows.push_back(
      {kPure, gas::Curve(flow, gas::Outside::zero),
       gas::Curve({{0.0, pulse.start_temperature}, {pulse.duration, pulse.end_temperature}},
                  gas::Outside::held)});
  gas::ControlVolumeState state = gas::make_state(model.thermo, kPure, 101325.0, 293.15, 0.06);
  gas::GasIntegrator(model).advance(state, 0.0, end, rigid(0.06));
  return gas::evaluate(model, state, 0.06, 0.0, end);
}

const closed_form::PulseFill kPulse{{}, 0.06, 101325.0, 293.15, 0.08, 0.05, 800.0, 400.0};

/// The only error is that of the curve: a piecewise linear sin^2, second order in the knots' distance.
TEST(tank, smooth_pulse_converges_with_the_knots_squared) {
  const double exact = closed_form::pulse_fill(kPulse, 0.025).pressure;
  EXPECT_LT(relative(exact, 284007.40580611622), 1e-12);
  std::vector<double> errors;
  for (const int n : {20, 40, 80, 160})
    errors.push_back(std::abs(pulse_fill(kPulse, n, 0.025).pressure - exact));
  claim::expect_order({"G.10", "smooth pulse of inflow as a curve of 20 to 160 pieces: pressure [Pa]",
                       "trapezoidal rule; its fourth-order term is (pi/n)^2 of it"},
                      errors, 1.9, 2.1);
}

/// A table dense enough that its chords are no error: they cut h^2/12 max|mdot''| per second off the inflow,
/// mdot'' = 4 pi^2 M/t_e^3, at 800 K at most: 2.6/n^2 of p at half the pulse, 6.5e-11 with 200 000 pieces,
/// whose sum rounds to 1e-11.
TEST(tank, smooth_pulse_as_a_dense_table_eq_reference) {
  const gas::GasPoint half = pulse_fill(kPulse, 200000, 0.025), end = pulse_fill(kPulse, 200000, 0.05);
  const char* why = "chords of the table, 2.6/n^2 of p";
  claim::expect_relative({"G.10", "smooth pulse as a table of 200 000 pieces, 25 ms: pressure [Pa]", why},
                         half.pressure, 284007.40580611622, 1e-10);
  claim::expect_relative({"G.10", "smooth pulse as a table of 200 000 pieces, 25 ms: temperature [K]", why},
                         half.temperature, 522.54423562731905, 1e-10);
  claim::expect_relative({"G.10", "smooth pulse as a table of 200 000 pieces, 50 ms: pressure [Pa]", why},
                         end.pressure, 433741.0, 1e-10);
}

TEST(tank, two_gas_fill_eq_closed_form) {
  const gas::Thermo thermo(
      {gas::constant_cp_species("A", 296.8, 1038.8), gas::constant_cp_species("B", 2077.1, 2.5 * 2077.1)});
  gas::ControlVolumeModel model = closed_tank(thermo);
  model.inflows.push_back({{0.0, 1.0}, gas::Curve::constant(0.2), gas::Curve::constant(650.0)});
  gas::ControlVolumeState state = gas::make_state(thermo, std::vector{1.0, 0.0}, 101325.0, 293.15, 0.06);
  gas::GasIntegrator(model).advance(state, 0.0, 0.05, rigid(0.06));
  const gas::GasPoint point = gas::evaluate(model, state, 0.06, 0.0, 0.05);
  const closed_form::TwoGasState expected =
      closed_form::two_gas_fill({{}, {2077.1, 5.0 / 3.0}, 0.06, 101325.0, 293.15, 0.01, 650.0});
  claim::expect_relative({"G.10", "helium-like gas into nitrogen: temperature [K]", kWhy}, point.temperature,
                         expected.state.temperature, kRoundOff);
  claim::expect_relative({"G.8", "helium-like gas into nitrogen: pressure [Pa]", kWhy}, point.pressure,
                         expected.state.pressure, kRoundOff);
  claim::expect_relative({"G.1", "helium-like gas into nitrogen: gamma of the mixture [-]", kWhy},
                         point.gamma, expected.heat_capacity_ratio, kRoundOff);
  // Negative control: a mass-weighted mean of gamma is another number.
  const double mean = (state.masses[0] * 1.4 + state.masses[1] * 5.0 / 3.0) / point.mass;
  EXPECT_GT(relative(point.gamma, mean), 1e-2);
}

TEST(tank, several_inflows_superpose) {
  const gas::Thermo thermo = nitrogen();
  gas::ControlVolumeModel model = closed_tank(thermo);
  for (const double t_in : {400.0, 900.0}) model.inflows.push_back(steady_inflow(thermo, 0.5, t_in));
  gas::ControlVolumeState state = gas::make_state(thermo, kPure, 101325.0, 293.15, 0.06);
  gas::GasIntegrator(model).advance(state, 0.0, 0.02, rigid(0.06));
  const closed_form::GasState expected =
      closed_form::tank_fill({{}, 0.06, 101325.0, 293.15, 1.0, 650.0}, 0.02);
  claim::expect_relative({"G.8", "two inflows at once: pressure [Pa]", kWhy},
                         gas::evaluate(model, state, 0.06, 0.0, 0.02).pressure, expected.pressure, kRoundOff);
}

TEST(tank, stage_quantities_of_an_inflator) {
  gas::ControlVolumeModel model = closed_tank(nasa7({"N2", "He"}));
  model.inflows.push_back({{0.0, 1.0},
                           gas::Curve({{0.0, 1.0}, {0.01, 3.0}}, gas::Outside::zero),
                           gas::Curve({{0.0, 400.0}, {0.01, 600.0}}, gas::Outside::held),
                           0.5});
  const gas::InflatorPoint point = gas::inflator_point(model, 0, 0.505);
  EXPECT_LT(relative(point.mass_flow, 2.0), kRoundOff);
  EXPECT_LT(relative(point.temperature, 500.0), kRoundOff);
  EXPECT_LT(relative(point.gamma, 5.0 / 3.0), kRoundOff);
  EXPECT_LT(relative(point.cp, 2.5 * point.gas_constant), kRoundOff);
  EXPECT_LT(relative(point.gas_constant, gas::kMolarGasConstant / 4.002602e-3), kRoundOff);
  EXPECT_EQ(gas::inflator_point(model, 0, 0.4).mass_flow, 0.0);
  EXPECT_EQ(gas::inflator_point(model, 0, 0.6).mass_flow, 0.0);
  const gas::ControlVolumeState state = gas::make_state(model.thermo, std::vector{1.0, 0.0}, 1e5, 300.0, 1.0);
  EXPECT_LT(relative(gas::evaluate(model, state, 1.0, 0.0, 0.505).inflow, 2.0), kRoundOff);
}

}  // namespace
