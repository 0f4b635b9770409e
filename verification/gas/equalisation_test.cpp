// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "cases.hpp"
#include "claim.hpp"
#include "closed_form/orifice.hpp"

// Outflow that ends: p reaches p_a in finite time and stays there.
namespace {

using namespace cases;

struct Leaking {
  gas::ControlVolumeModel model;
  double volume;
  double leak_area;
};

Leaking porous() {
  return {closed_tank(nitrogen()), 0.12, 0.0025 * 1.5};
}

closed_form::PorousTank porous_exact() {
  return {{}, 0.12, 0.05, 1.5, closed_form::PorosityLaw::printed, 130000.0, 400.0, kAmbientPressure};
}

TEST(equalisation, porous_tank_eq_closed_form) {
  const Leaking tank = porous();
  gas::ControlVolumeState state = gas::make_state(tank.model.thermo, kPure, 130000.0, 400.0, tank.volume);
  gas::GasIntegrator integrator(tank.model);
  double time = 0.0;
  for (const auto& [next, reference] :
       std::vector<std::pair<double, double>>{{0.01, 118759.40296999072}, {0.02, 110661.71823484026}}) {
    integrator.advance(state, time, next, rigid(tank.volume, tank.leak_area));
    const gas::GasPoint point = gas::evaluate(tank.model, state, tank.volume, tank.leak_area, time = next);
    claim::expect_relative({"G.7", "porous tank, printed law: pressure at 10 and 20 ms [Pa]",
                            "a few sub-steps of tolerance 1e-10"},
                           point.pressure, reference, 1e-9);
    EXPECT_LT(relative(closed_form::porous_tank_adiabatic(porous_exact(), time).pressure, reference), 1e-12);
  }
}

TEST(equalisation, end_time_and_state_of_a_porous_tank) {
  const Leaking tank = porous();
  const double end = 0.048952700161241547;
  for (const double t : {0.999 * end, 1.001 * end, 2.0 * end, 1.0}) {
    gas::ControlVolumeState state = gas::make_state(tank.model.thermo, kPure, 130000.0, 400.0, tank.volume);
    gas::GasIntegrator(tank.model).advance(state, 0.0, t, rigid(tank.volume, tank.leak_area));
    const gas::GasPoint point = gas::evaluate(tank.model, state, tank.volume, tank.leak_area, t);
    // dp = 28675 (1 - t/end)^2 Pa near the end, to a correction of dp/p: 0.03 Pa at a thousandth before it.
    if (t < end) {
      EXPECT_GT(point.pressure - kAmbientPressure, 0.02);
      EXPECT_LT(point.pressure - kAmbientPressure, 0.03);
    } else {
      claim::expect_relative(
          {"G.7", "porous tank: pressure after its end [Pa]", "the laminar range, 1e-8 of p_a"},
          point.pressure, kAmbientPressure, 1e-8);
      EXPECT_LT(point.fabric_mass_flow, 0.6 * tank.leak_area * std::sqrt(2e-8 * kAmbientPressure));
    }
  }
}

TEST(equalisation, hole_ends_at_its_time_without_overshoot) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.vents.push_back({1.0, 1e-3});
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    gas::GasIntegrator integrator(model, {tolerance});
    gas::ControlVolumeState state = gas::make_state(model.thermo, kPure, 5e5, 600.0, 0.06);
    double lowest = 5e5;
    int steps = 0;
    for (int i = 0; i < 80; ++i) {
      steps += integrator.advance(state, 0.005 * i, 0.005 * (i + 1), rigid(0.06)).steps;
      lowest = std::min(lowest, gas::evaluate(model, state, 0.06, 0.0, 0.005 * (i + 1)).pressure);
    }
    claim::expect_relative({"G.6", "blow-down to rest by tolerance: lowest pressure [Pa]",
                            "never below ambient pressure but by a tenth of the laminar range"},
                           lowest, kAmbientPressure, 1e-9);
    claim::expect_relative(
        {"G.10", "blow-down to rest by tolerance: temperature, T0 (p_a/p0)^(2/7) [K]",
         "of each sub-step tolerance^(6/5): what is kept is one order above what is controlled"},
        state.temperature, 380.25843168753486, steps * std::pow(tolerance, 1.2));
  }
}

TEST(equalisation, end_time_of_a_hole) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.vents.push_back({1.0, 1e-3});
  gas::ControlVolumeState state = gas::make_state(model.thermo, kPure, 5e5, 600.0, 0.06);
  gas::GasIntegrator integrator(model);
  const double end = 0.31877770016071139;
  integrator.advance(state, 0.0, 0.31128047097707361, rigid(0.06));
  claim::expect_relative({"G.6", "blow-down just before its end: pressure [Pa]",
                          "ten tolerances; of p - p_a, whose slope is -2 (p - p_a)/(end - t), 1e-7"},
                         gas::evaluate(model, state, 0.06, 0.0, 0.0).pressure, 101500.0, 1e-9);
  const gas::StepFluxes last = integrator.advance(state, 0.31128047097707361, end - 1e-5, rigid(0.06));
  EXPECT_GT(last.vent_mass_out, 0.0);
  EXPECT_GT(gas::evaluate(model, state, 0.06, 0.0, 0.0).pressure, kAmbientPressure * (1.0 + 1e-11));
  integrator.advance(state, end - 1e-5, end + 1e-5, rigid(0.06));
  claim::expect_relative({"G.6", "blow-down: pressure 10 microseconds after its end at 0.3188 s [Pa]",
                          "the laminar range, 1e-8 of p_a"},
                         gas::evaluate(model, state, 0.06, 0.0, 0.0).pressure, kAmbientPressure, 1e-8);
}

/// Gas that walls cool while it leaves: flow ends as the root of time, p falls through p_a at a rate of its
/// own. The last sub-step, shortened to there, has the accuracy of the others.
TEST(equalisation, outflow_that_cooling_ends_follows_the_tolerance) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.volume_of_overpressure =
      gas::Curve({{0.0, 1.73e-5}, {1.62, 1.78e-5}, {195.0, 1.81e-5}, {1e8, 2.1e-5}}, gas::Outside::held);
  model.heat_loss = {0.182, 400.0};
  model.vents.push_back({1.0, 1.9e-6});
  const auto left = [&](gas::Method method, double tolerance) {
    gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure + 10.13, 600.0, 1.783e-5);
    const auto fluxes =
        gas::GasIntegrator(model, {tolerance, 100000, method}).advance(state, 0.0, 0.01, rigid(1.0));
    return std::pair{state.masses[0], fluxes.steps};
  };
  const double exact = left(gas::Method::rosenbrock_4, 1e-13).first;
  // No sub-step is off by more than the tolerance.
  for (const gas::Method method : {gas::Method::dormand_prince_5, gas::Method::runge_kutta_4})
    for (double tolerance = 1e-6; tolerance > 0.9e-11; tolerance *= 0.31622776601683794) {
      const auto [mass, steps] = left(method, tolerance);
      EXPECT_LT(relative(mass, exact), steps * tolerance) << static_cast<int>(method) << ' ' << tolerance;
    }
}

TEST(equalisation, nothing_leaves_below_ambient_pressure) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.vents.push_back({1.0, 1e-3});
  for (const double pressure : {5e4, 101325.0}) {
    gas::ControlVolumeState state = gas::make_state(model.thermo, kPure, pressure, 300.0, 0.06);
    const gas::StepFluxes fluxes = gas::GasIntegrator(model).advance(state, 0.0, 1.0, rigid(0.06, 1e-3));
    // At p_a the rounding of p, 1e-11 Pa, is an overpressure: laminar flow of 1e-16 of what a pascal drives.
    EXPECT_LE(fluxes.vent_mass_out + fluxes.fabric_mass_out, pressure < kAmbientPressure ? 0.0 : 1e-18);
  }
}

/// Filled from below p_a, opening when p crosses it, in one call or in two: until then a closed tank,
/// exactly.
TEST(equalisation, outflow_starts_when_ambient_pressure_is_crossed) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.inflows.push_back(steady_inflow(model.thermo, 0.1, 400.0));
  model.vents.push_back({1.0, 1e-4});
  const double crossing = (101325.0 - 80000.0) * 0.06 / (1.4 * 296.8 * 400.0 * 0.1);
  for (const double tolerance : {1e-2, 1e-6, 1e-10}) {
    gas::ControlVolumeState state = gas::make_state(model.thermo, kPure, 80000.0, 300.0, 0.06);
    gas::GasIntegrator integrator(model, {tolerance});
    EXPECT_EQ(integrator.advance(state, 0.0, crossing * (1.0 - 1e-12), rigid(0.06)).vent_mass_out, 0.0);
    gas::StepFluxes fluxes = integrator.advance(state, crossing * (1.0 - 1e-12), 2.0 * crossing, rigid(0.06));
    const double rest = fluxes.vent_mass_out;
    EXPECT_GT(rest, 0.0);
    state = gas::make_state(model.thermo, kPure, 80000.0, 300.0, 0.06);
    int steps = fluxes.steps;
    fluxes = integrator.advance(state, 0.0, 2.0 * crossing, rigid(0.06));
    steps += fluxes.steps;
    // Each sub-step of either is within a tolerance of the mass.
    EXPECT_NEAR(fluxes.vent_mass_out, rest, steps * tolerance * state.masses[0]);
  }
}

/// A weak inflow against a large opening: the balance sqrt(p - p_a) = mdot/K, reached from p = p_a.
TEST(equalisation, weak_inflow_balances_outflow_just_above_ambient) {
  for (const double mass_flow : {1e-1, 1e-2, 1e-3}) {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    model.inflows.push_back(steady_inflow(model.thermo, mass_flow, 300.0));
    gas::ControlVolumeState state = gas::make_state(model.thermo, kPure, kAmbientPressure, 300.0, 0.06);
    gas::GasIntegrator(model, {1e-11}).advance(state, 0.0, 0.1, rigid(0.06, 5e-3));
    const gas::GasPoint point = gas::evaluate(model, state, 0.06, 5e-3, 0.1);
    const double excess = laminar(std::pow(mass_flow / 5e-3, 2.0) / (2.0 * point.density));
    // Balanced as the square of a flow at T within 1e-3; the state's error is a few times 1e-11 of p_a.
    EXPECT_NEAR(point.pressure - kAmbientPressure, excess, 1e-3 * excess + 1e-10 * kAmbientPressure)
        << mass_flow;
  }
}

/// Out and in through holes, out through fabric: sqrt(2 rho dp) times (G.22), from far below its range to far
/// above; nothing at p_a itself.
TEST(equalisation, flow_next_to_ambient_pressure_is_laminar) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.ambient = {kAmbientPressure, 300.0, kPure};
  model.vents.push_back({1.0, 1e-3});
  model.vents.back().backflow = true;
  const auto at = [&](double share) {
    const auto state = gas::make_state(model, kPure, kAmbientPressure * (1.0 + share), 300.0, 0.06);
    return gas::evaluate(model, state, 0.06, 1e-3, 0.0);
  };
  for (const double share : {1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6}) {
    const gas::GasPoint above = at(share), below = at(-share);
    const double flow = 1e-3 * std::sqrt(2.0 * above.density * share * kAmbientPressure),
                 expected = flow * std::pow(1.0 + std::pow(1e-8 / share, 2.0), -0.75);
    // The rounding of p and p_a in p - p_a, which laminar flow doubles, and dp/p of the subsonic law.
    const double bound = expected * (8.0 * kEpsilon / share + 2.0 * share);
    EXPECT_NEAR(above.vent_mass_flow, expected, bound) << share;
    EXPECT_NEAR(above.fabric_mass_flow, expected, bound) << share;
    EXPECT_NEAR(below.backflow, expected, bound) << share;
    EXPECT_EQ(above.backflow + below.vent_mass_flow + below.fabric_mass_flow, 0.0) << share;
  }
  model.laminar_share = 0.0;  // the laws as they are
  const gas::GasPoint literal = at(1e-9);
  EXPECT_NEAR(literal.vent_mass_flow, 1e-3 * std::sqrt(2.0 * literal.density * 1e-9 * kAmbientPressure),
              1e-6 * literal.vent_mass_flow);
}

TEST(equalisation, too_stiff_a_gas_is_reported) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.inflows.push_back(steady_inflow(model.thermo, 1e-3, 300.0));
  gas::ControlVolumeState state = gas::make_state(model.thermo, kPure, kAmbientPressure, 300.0, 1e-6);
  const gas::ControlVolumeState before = state;
  gas::GasIntegrator integrator(model, {1e-10, 1000, gas::Method::runge_kutta_4});
  try {
    integrator.advance(state, 0.0, 10.0, rigid(1e-6, 5e-3));
    FAIL() << "no error";
  } catch (const gas::DomainError& error) {
    EXPECT_NE(std::string(error.what()).find("too stiff"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("sub-step"), std::string::npos);
  }
  EXPECT_EQ(state.masses, before.masses);
  EXPECT_EQ(state.internal_energy, before.internal_energy);
}

}  // namespace
