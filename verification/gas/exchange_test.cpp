// SPDX-License-Identifier: Apache-2.0
#include "closed_form/exchange.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "cases.hpp"
#include "claim.hpp"
#include "closed_form/orifice.hpp"

// Vents that open, change and let air in; fabric given as a table; heat through the walls.
namespace {

using namespace cases;

double pressure(const gas::ControlVolumeModel& model, const gas::ControlVolumeState& state) {
  return gas::evaluate(model, state, 0.06, 0.0, 0.0).pressure;
}

gas::Curve held(std::vector<gas::Curve::Knot> knots) {
  return gas::Curve(std::move(knots), gas::Outside::held);
}

/// Tanks below ambient pressure, evacuated or not, that fill through a vent: sonic, subsonic, at rest.
TEST(exchange, backflow_eq_closed_form) {
  for (const auto& [p0, t0, t_a] :
       std::vector<std::array<double, 3>>{{0.0, 293.15, 293.15}, {2e4, 350.0, 280.0}, {8e4, 250.0, 320.0}}) {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    model.ambient = {kAmbientPressure, t_a, kPure};
    model.vents.push_back({0.5, 2e-3, {}, {}, true});
    const closed_form::AmbientInrush exact{{}, 0.06, 1e-3, p0, t0, kAmbientPressure, t_a};
    const double end = closed_form::ambient_inrush_end(exact);
    gas::ControlVolumeState state = gas::make_state(model, kPure, p0, t0, 0.06);
    gas::GasIntegrator integrator(model);
    const double before = state.masses[0];
    double back = 0.0;
    for (int i = 0; i < 5; ++i) {
      const gas::StepFluxes fluxes =
          integrator.advance(state, 0.3 * i * end, 0.3 * (i + 1) * end, rigid(0.06));
      back += fluxes.backflows[0].mass;
      const closed_form::GasState expected = closed_form::ambient_inrush(exact, 0.3 * (i + 1) * end);
      const char* why = "some thirty sub-steps of 1e-10, of mass and energy";
      claim::expect_relative({"G.9", "air into a tank below ambient pressure: pressure [Pa]", why},
                             pressure(model, state), expected.pressure, 3e-9);
      claim::expect_relative({"G.10", "air into a tank below ambient pressure: temperature [K]", why},
                             state.temperature, expected.temperature, 3e-9);
      EXPECT_NEAR(fluxes.backflow_enthalpy, fluxes.backflow_mass * 1038.8 * t_a,
                  8.0 * kEpsilon * fluxes.backflow_enthalpy);
    }
    EXPECT_NEAR(state.masses[0], before + back, 8.0 * kEpsilon * state.masses[0]);
    // At rest on p_a, to the laminar range.
    EXPECT_NEAR(pressure(model, state), kAmbientPressure, 1e-8 * kAmbientPressure);
  }
}

/// Air of several species into helium: each species and the enthalpy come in together.
TEST(exchange, backflow_brings_the_ambient_species) {
  gas::ControlVolumeModel model = closed_tank(nasa7({"He", "N2", "O2"}));
  model.ambient.mass_fractions = {0.0, 0.77, 0.23};
  model.vents.push_back({1.0, 1e-3, {}, {}, true});
  gas::ControlVolumeState state = gas::make_state(model, std::vector{1.0, 0.0, 0.0}, 3e4, 500.0, 0.06);
  const double helium = state.masses[0];
  const gas::StepFluxes fluxes = gas::GasIntegrator(model).advance(state, 0.0, 0.05, rigid(0.06));
  EXPECT_EQ(state.masses[0], helium);
  EXPECT_LT(relative(state.masses[1], 0.77 * fluxes.backflow_mass), 8.0 * kEpsilon);
  EXPECT_LT(relative(state.masses[2], 0.23 * fluxes.backflow_mass), 8.0 * kEpsilon);
  const double h = model.thermo.enthalpy(model.ambient.mass_fractions, 293.15);
  EXPECT_LT(relative(fluxes.backflow_enthalpy, h * fluxes.backflow_mass), 16.0 * kEpsilon);
}

TEST(exchange, heat_loss_eq_closed_form) {
  for (const auto& [flow, conductance] :
       std::vector<std::array<double, 2>>{{1.0, 100.0}, {0.0, 300.0}, {0.3, 1000.0}}) {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    model.inflows.push_back(steady_inflow(model.thermo, flow, 700.0));
    model.heat_loss = {conductance, 310.0};
    gas::ControlVolumeState state = gas::make_state(model, kPure, 2e5, 600.0, 0.06);
    const double energy = state.internal_energy;
    const gas::StepFluxes fluxes = gas::GasIntegrator(model).advance(state, 0.0, 0.1, rigid(0.06));
    const closed_form::GasState exact =
        closed_form::heat_loss_fill({{}, 0.06, 2e5, 600.0, flow, 700.0, conductance, 310.0}, 0.1);
    const char* why = "up to forty sub-steps of 1e-10";
    claim::expect_relative({"G.11", "fill with heat loss: temperature [K]", why}, state.temperature,
                           exact.temperature, 4e-9);
    claim::expect_relative({"G.11", "fill with heat loss: pressure [Pa]", why}, pressure(model, state),
                           exact.pressure, 4e-9);
    // Two sums of three terms each: some four roundings of their magnitudes.
    const double magnitudes = std::abs(energy) + std::abs(fluxes.enthalpy_in) + std::abs(fluxes.heat);
    EXPECT_NEAR(state.internal_energy, energy + fluxes.enthalpy_in - fluxes.heat,
                4.0 * kEpsilon * magnitudes);
    EXPECT_GT(fluxes.heat, 0.0);
  }
}

/// An evacuated tank that an inflow and, sonic, air fill at once: mass and enthalpy are proportional to time.
TEST(exchange, evacuated_fill_by_inflow_and_air_is_exact_by_any_method) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.ambient.mass_fractions = kPure;
  model.inflows.push_back(steady_inflow(model.thermo, 1e-3, 406.0));
  model.vents.push_back({0.5, 2e-5});
  model.vents.back().backflow = true;
  // The flux of a sonic hole, (G.6) at (G.5), gamma = 7/5.
  const double back = 1e-5 * kAmbientPressure * std::sqrt(1.4 / (296.8 * 293.15)) * std::pow(2.0 / 2.4, 3.0);
  const double mass = 0.01 * (1e-3 + back), energy = 0.01 * 1038.8 * (1e-3 * 406.0 + back * 293.15);
  for (const gas::Method method : kMethods)
    for (const double tolerance : {1e-2, 1e-6, 1e-10}) {
      SCOPED_TRACE(testing::Message() << static_cast<int>(method) << " at " << tolerance);
      gas::ControlVolumeState state = gas::make_state(model, kPure, 0.0, 300.0, 1e-3);
      gas::GasIntegrator(model, {tolerance, 1000, method}).advance(state, 0.0, 0.01, rigid(1e-3));
      // Some hundred roundings: constant rates are exact by every method.
      EXPECT_LT(relative(state.masses[0], mass), 1e-13);
      EXPECT_LT(relative(state.internal_energy, energy), 1e-13);
    }
}

/// The first gas of an evacuated tank has no heat capacity: inflow and walls balance from the first moment.
TEST(exchange, evacuated_fill_with_heat_loss_is_at_its_balance_with_the_walls) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.inflows.push_back(steady_inflow(model.thermo, 1.0, 700.0));
  model.heat_loss = {100.0, 300.0};
  gas::ControlVolumeState state = gas::make_state(model, kPure, 0.0, 300.0, 0.06);
  gas::GasIntegrator(model).advance(state, 0.0, 0.05, rigid(0.06));
  // m = mdot t throughout: T = (mdot cp T_in + hA T_ext)/(mdot cv + hA) at once, and constant.
  const double balance = (1038.8 * 700.0 + 100.0 * 300.0) / (742.0 + 100.0);
  claim::expect_relative({"G.11", "evacuated fill with heat loss: temperature at 50 ms [K]",
                          "constant rates: two roundings each of mass and energy in a hundred sub-steps"},
                         state.temperature, balance, 1e-13);
}

TEST(exchange, fabric_table_eq_closed_form) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  // Two pieces on one line, and a knot between that changes nothing; held beyond 1 MPa.
  model.fabrics = {{1.0, held({{0.0, 0.0}, {1e4, 0.1}, {1e6, 10.0}})}};
  const closed_form::LinearFabricTank exact{{}, 0.06, 1.5, 1e-5, 130000.0, 400.0, kAmbientPressure};
  gas::ControlVolumeState state = gas::make_state(model, kPure, 130000.0, 400.0, 0.06);
  gas::GasIntegrator integrator(model);
  for (int i = 0; i < 10; ++i) {
    integrator.advance(state, 0.01 * i, 0.01 * (i + 1), rigid(0.06, 1.5));
    const char* why = "some sub-steps of 1e-10 a call; errors decay";
    const closed_form::GasState expected = closed_form::linear_fabric_tank(exact, 0.01 * (i + 1));
    claim::expect_relative({"G.12", "tank of fabric given as a table: pressure at ten times [Pa]", why},
                           pressure(model, state), expected.pressure, 1e-9);
    claim::expect_relative({"G.12", "tank of fabric given as a table: temperature at ten times [K]", why},
                           state.temperature, expected.temperature, 1e-9);
  }
}

/// A vent whose area grows linearly from 0: choked blow-down runs on the integral of the area.
TEST(exchange, area_of_time_eq_closed_form) {
  for (const bool triggered : {false, true}) {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    const double opening = triggered ? 0.0123 : 0.0;
    model.triggers = {{{gas::SensorKind::time, opening}}, {}};
    gas::Vent vent{1.0, 0.0, held({{0.0, 0.0}, {0.04, 1e-3}})};
    if (triggered) vent.trigger = 0;
    model.vents.push_back(vent);
    gas::ControlVolumeState state = gas::make_state(model, kPure, 5e5, 600.0, 0.06);
    gas::GasIntegrator(model).advance(state, 0.0, opening + 0.1, rigid(0.06));
    // int A dt = 2e-5 + 6e-5 m2 s: as 0.08 s of the full hole, in one step with two breaks.
    const closed_form::Blowdown hole{{}, 0.06, 1e-3, 1.0, 5e5, 600.0, kAmbientPressure};
    claim::expect_relative(
        {"G.6", "blow-down through a vent that opens: pressure [Pa]", "some ten sub-steps of 1e-10"},
        pressure(model, state), closed_form::blowdown(hole, 0.08).pressure, 1e-9);
  }
}

/// Area proportional to overpressure, then constant: against a fine run of the same law written as many steps
/// of fixed areas is no reference; the balance with an inflow is: mdot = A(dp) flux(p).
TEST(exchange, area_of_overpressure_balances_inflow_on_its_curve) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.inflows.push_back(steady_inflow(model.thermo, 0.1, 400.0));
  model.vents.push_back({0.8, 0.0, {}, held({{5e3, 0.0}, {4e4, 2e-3}, {9e4, 2.5e-3}})});
  gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure, 400.0, 0.06);
  gas::GasIntegrator(model).advance(state, 0.0, 5.0, rigid(0.06));
  const double p = pressure(model, state), excess = p - kAmbientPressure;
  ASSERT_GT(excess, 5e3);
  ASSERT_LT(excess, 4e4);
  const double area = 0.8 * 2e-3 * (excess - 5e3) / 3.5e4;
  const double flow = closed_form::orifice_mass_flow({{}, area, 1.0, p, state.temperature, kAmbientPressure});
  claim::expect_relative({"G.6", "vent whose area grows with overpressure: flow in balance [kg/s]",
                          "five seconds of relaxation at 1.5/s, felt as the root of T"},
                         flow, 0.1, 1e-3);
}

/// Each stream's fluxes, and their sums.
TEST(exchange, streams_add_up_to_the_books) {
  gas::ControlVolumeModel model = closed_tank(nasa7({"N2", "CO2"}));
  model.ambient.mass_fractions = {1.0, 0.0};
  for (const double t_in : {500.0, 1200.0})
    model.inflows.push_back(
        {{0.4, 0.6}, gas::Curve({{0.0, 2.0}, {0.02, 0.0}}, gas::Outside::zero), gas::Curve::constant(t_in)});
  for (const double area : {1e-3, 2e-3}) model.vents.push_back({0.6, area, {}, {}, true});
  model.heat_loss = {50.0, 290.0};
  gas::ControlVolumeState state = gas::make_state(model, std::vector{1.0, 0.0}, 1.5e5, 300.0, 0.06);
  double mass = state.masses[0] + state.masses[1], energy = state.internal_energy, scale = std::abs(energy);
  gas::GasIntegrator integrator(model);
  for (int i = 0; i < 100; ++i) {
    const double v0 = 0.06 + 0.02 * std::sin(0.2 * i), v1 = 0.06 + 0.02 * std::sin(0.2 * (i + 1));
    const gas::StepFluxes f = integrator.advance(state, 1e-3 * i, 1e-3 * (i + 1), {v0, v1, 1e-3, 1e-3});
    ASSERT_EQ(f.inflows.size(), 2u);
    ASSERT_EQ(f.outflows.size(), 3u);
    ASSERT_EQ(f.backflows.size(), 2u);
    for (const auto& s : f.inflows) mass += s.mass, energy += s.enthalpy, scale += std::abs(s.enthalpy);
    for (const auto& s : f.outflows) mass -= s.mass, energy -= s.enthalpy, scale += std::abs(s.enthalpy);
    for (const auto& s : f.backflows) mass += s.mass, energy += s.enthalpy, scale += std::abs(s.enthalpy);
    energy -= f.work + f.heat;
    // Twice the area, twice the flow, out and in: the same rounding of two products.
    EXPECT_NEAR(f.outflows[1].mass, 2.0 * f.outflows[0].mass, 1e-13 * f.outflows[1].mass);
    EXPECT_NEAR(f.backflows[1].mass, 2.0 * f.backflows[0].mass, 1e-13 * f.backflows[1].mass);
  }
  // A hundred steps, a dozen additions each: 1e3 eps.
  EXPECT_NEAR(state.masses[0] + state.masses[1], mass, 1e-12 * mass);
  EXPECT_NEAR(state.internal_energy, energy, 1e-12 * scale);
}

}  // namespace
