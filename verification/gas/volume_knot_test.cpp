// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "cases.hpp"

// Volumes that follow the pressure, (G.18), where gas rests, or begins, on a knot of their curve.
namespace {

using namespace cases;

constexpr double kVolumeNotRead = 1.0;  // [m3] volumes of calls

gas::Curve knots(std::vector<gas::Curve::Knot> list) {
  return {std::move(list), gas::Outside::held};
}

gas::GasPoint point_of(const gas::ControlVolumeModel& model, const gas::ControlVolumeState& state) {
  return gas::evaluate(model, state, kVolumeNotRead, 0.0, 0.0);
}

/// A knot on p_a itself, and one far away: air comes back through a vent as the walls cool the gas, until
/// both are at rest on that knot.
TEST(volume_knot, air_comes_back_to_rest_on_a_knot) {
  gas::ControlVolumeModel model = closed_tank(nasa7({"N2", "CO2", "O2"}));
  model.ambient.mass_fractions = {0.77, 0.0, 0.23};
  model.volume_of_overpressure = knots({{-2e3, 5e-5}, {0.0, 6e-5}, {100.0, 1.5e-4}, {1e9, 1.6e-4}});
  model.vents.push_back({0.6, 3e-5});
  model.vents.back().backflow = true;
  model.heat_loss = {180.0, 293.15};
  for (const gas::Method method : {gas::Method::dormand_prince_5, gas::Method::rosenbrock_4})
    for (const double tolerance : {1e-4, 1e-7, 1e-9}) {
      SCOPED_TRACE(testing::Message() << static_cast<int>(method) << " at " << tolerance);
      gas::ControlVolumeState state =
          gas::make_state(model, std::vector{0.5, 0.5, 0.0}, 0.3 * kAmbientPressure, 300.0, 5e-5);
      gas::GasIntegrator integrator(model, {tolerance, 100000, method});
      for (int i = 0; i < 50; ++i) integrator.advance(state, 1e-3 * i, 1e-3 * (i + 1), rigid(kVolumeNotRead));
      const gas::GasPoint end = point_of(model, state);
      // p to the laminar range, and V along 9e-7 m3/Pa at most. The gas's own relaxation, m cp/(hA) = 4e-4
      // s, has passed more than a hundred times.
      EXPECT_NEAR(end.pressure, kAmbientPressure, 1e-8 * kAmbientPressure);
      EXPECT_LT(relative(end.temperature, 293.15), 1e-10);
      EXPECT_NEAR(end.volume, 6e-5, 9e-7 * 1e-8 * kAmbientPressure);
    }
}

/// An evacuated volume fills and its walls cool the gas, up to a knot just below p_a above which the volume
/// is ten million times as soft: from there on it takes in what flows through the vent at that overpressure,
/// and nothing at once.
TEST(volume_knot, soft_volume_below_ambient_pressure_fills_no_faster_than_its_vent) {
  constexpr double kArea = 1.2e-8, kKnot = 2e-4, kRigid = 1.5e-11, kLast = 1e-3;
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.ambient.mass_fractions = kPure;
  model.heat_loss = {0.053, 293.15};
  model.volume_of_overpressure =
      knots({{-2.0 * kKnot, kRigid}, {-kKnot, kRigid}, {0.0, 1.8e-10}, {1e4, 7e-10}});
  model.vents.push_back({1.0, kArea});
  model.vents[0].backflow = true;
  model.laminar_share = 0.0;  // the knot lies in the laminar range
  const double density = kAmbientPressure / (296.8 * 293.15), rigid_mass = density * kRigid;
  const double filled = kArea * std::sqrt(2.0 * density * kKnot) * kLast;
  for (const double tolerance : {1e-5, 1e-6, 1e-7, 1e-8, 1e-9}) {
    gas::ControlVolumeState state = gas::make_state(model, kPure, 0.0, 200.0, kRigid);
    gas::GasIntegrator(model, {tolerance, 100000, gas::Method::rosenbrock_4})
        .advance(state, 0.0, kLast, rigid(kVolumeNotRead));
    // 1e-5 s of the time are needed to get there, flow falls by as little as p rises.
    EXPECT_NEAR(state.masses[0], rigid_mass + filled, 0.02 * filled + 20.0 * tolerance * rigid_mass)
        << tolerance;
  }
}

/// p kept on p_a by a wide vent, on a knot: the volume is that of the knot, whichever side is the soft one.
TEST(volume_knot, wide_vent_on_a_knot) {
  for (const double soft : {0.0, -100.0}) {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    model.volume_of_overpressure = knots({{-1e3, 0.02}, {soft, 0.02}, {soft + 100.0, 0.12}, {1e6, 0.13}});
    model.inflows.push_back(steady_inflow(model.thermo, 0.01, 400.0));
    model.vents.push_back({0.6, 20.0});
    const double volume = soft == 0.0 ? 0.02 : 0.12;
    gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure, 300.0, volume);
    const double before = state.masses[0], last = 0.75 * before;  // of the gas at 400 K
    const gas::StepFluxes fluxes = gas::GasIntegrator(model, {1e-6, 1000, gas::Method::rosenbrock_4})
                                       .advance(state, 0.0, 0.1, rigid(kVolumeNotRead));
    const gas::GasPoint end = point_of(model, state);
    const double excess = end.pressure - kAmbientPressure;
    EXPECT_GT(excess, 0.0);
    EXPECT_LT(excess, 1e-8 * kAmbientPressure);
    EXPECT_NEAR(end.volume, volume, 1e-3 * 1e-8 * kAmbientPressure);  // 1e-3 m3/Pa on the soft side
    // p V is held: m' = mdot (1 - m/M), M = m at 400 K. Each sub-step is within a tolerance of the mass.
    const double left = last + (before - last) * std::exp(-1e-3 / last);
    EXPECT_NEAR(fluxes.vent_mass_out, 1e-3 + before - left, fluxes.steps * 1e-6 * before);
  }
}

/// Gas that starts on the last knot stays in the curve where it leaves or rests; heated, it has no volume.
TEST(volume_knot, start_on_the_last_knot) {
  for (const double walls : {300.0, 299.0, 301.0})
    for (const gas::Method method : kMethods) {
      gas::ControlVolumeModel model = closed_tank(nasa7({"N2", "CO2"}));
      model.volume_of_overpressure = knots({{0.0, 0.06}, {5e4, 0.07}});
      model.heat_loss = {10.0, walls};
      gas::ControlVolumeState state =
          gas::make_state(model, std::vector{0.5, 0.5}, kAmbientPressure + 5e4, 300.0, 0.07);
      try {
        gas::GasIntegrator(model, {1e-6, 1000, method}).advance(state, 0.0, 0.01, rigid(kVolumeNotRead));
        EXPECT_LT(walls, 301.0);
        EXPECT_LE(point_of(model, state).pressure, (kAmbientPressure + 5e4) * (1.0 + 1e-12));
      } catch (const gas::DomainError& error) {
        EXPECT_EQ(walls, 301.0) << error.what();
        EXPECT_NE(std::string(error.what()).find("passes 50000 Pa"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("at t = 0 s"), std::string::npos) << error.what();
      }
    }
}

/// Close to p_a a soft volume takes up gas that a stiff one would not: p is not held there.
TEST(volume_knot, soft_bag_follows_the_pressure_next_to_ambient) {
  int steps = 0;
  const auto filled = [&](gas::Method method, double tolerance) {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    model.volume_of_overpressure = knots({{0.0, 0.009}, {0.1, 0.12}, {1e5, 0.3}});
    model.heat_loss = {260.0, 293.15};
    model.inflows.push_back(steady_inflow(model.thermo, 1.0, 406.0));
    model.inflows.back().mass_flow = gas::Curve({{0.0, 0.0}, {0.012, 4.0}, {0.02, 0.0}}, gas::Outside::zero);
    model.vents.push_back({0.6, 2e-3});
    gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure, 293.15, 0.009);
    gas::GasIntegrator integrator(model, {tolerance, 100000, method});
    steps = 0;
    for (int i = 0; i < 20; ++i)
      steps += integrator.advance(state, 1e-3 * i, 1e-3 * (i + 1), rigid(kVolumeNotRead)).steps;
    return point_of(model, state);
  };
  const gas::GasPoint exact = filled(gas::Method::dormand_prince_5, 1e-11);
  for (const double tolerance : {1e-6, 1e-8}) {
    const gas::GasPoint end = filled(gas::Method::rosenbrock_4, tolerance);
    // Nothing is forgotten (m cv/(hA) = 30 ms and more): each sub-step adds at most a tolerance.
    EXPECT_LT(relative(end.temperature, exact.temperature), steps * tolerance);
    EXPECT_LT(relative(end.volume, exact.volume), steps * tolerance);
  }
}

/// Through both knots and past equalisation, with walls that go on cooling the gas at p_a, all methods end
/// alike.
TEST(volume_knot, methods_agree_past_equalisation) {
  const auto end = [](gas::Method method, double tolerance) {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    model.volume_of_overpressure = knots({{0.0, 0.02}, {400.0, 0.05}, {12800.0, 0.06}});
    model.heat_loss = {10.0, 293.15};
    model.vents.push_back({1.0, 3e-3});
    gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure + 1e4, 600.0, 0.0577);
    gas::GasIntegrator integrator(model, {tolerance, 100000, method});
    for (int i = 0; i < 4; ++i) integrator.advance(state, 0.05 * i, 0.05 * (i + 1), rigid(kVolumeNotRead));
    return point_of(model, state);
  };
  const gas::GasPoint exact = end(gas::Method::dormand_prince_5, 1e-12);
  for (const gas::Method method : kMethods) {
    // Some ten sub-steps of 1e-8 each; Euler's thousands at 1e-7 add up to the root of it.
    const bool first_order = method == gas::Method::euler;
    const gas::GasPoint point = end(method, first_order ? 1e-7 : 1e-8);
    const double bound = first_order ? std::sqrt(1e-7) : 1e-7;
    EXPECT_LT(relative(point.temperature, exact.temperature), bound) << static_cast<int>(method);
    EXPECT_LT(relative(point.mass, exact.mass), bound) << static_cast<int>(method);
  }
}

/// A vent that is shut at p_a and below: the gas comes to rest at p_a with the walls, nothing leaves or
/// comes.
TEST(rest_at_ambient, vent_shut_at_ambient_pressure) {
  for (const gas::Method method : {gas::Method::dormand_prince_5, gas::Method::rosenbrock_4})
    for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
      gas::ControlVolumeModel model = closed_tank(nitrogen());
      gas::Vent vent{1.0, 0.0};
      vent.area_of_overpressure = knots({{0.0, 0.0}, {2.0, 3.5e-7}});
      vent.backflow = true;
      model.vents.push_back(vent);
      model.ambient.mass_fractions = kPure;
      model.heat_loss = {0.76, 293.15};
      gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure, 200.0, 9e-8);
      gas::GasIntegrator integrator(model, {tolerance, 100000, method});
      for (int i = 0; i < 50; ++i) integrator.advance(state, 2e-4 * i, 2e-4 * (i + 1), rigid(9e-8));
      const gas::GasPoint end = gas::evaluate(model, state, 9e-8, 0.0, 0.0);
      // p to the laminar range; of T what 0.01 s leave, m cv/(hA) = 1e-4 s.
      EXPECT_NEAR(end.pressure, kAmbientPressure, 1e-8 * kAmbientPressure);
      EXPECT_LT(relative(end.temperature, 293.15), 1e-10);
    }
}

}  // namespace
