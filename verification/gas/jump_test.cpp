// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "cases.hpp"
#include "claim.hpp"

// Curves of time that jump: two knots at one time.
namespace {

using namespace cases;
using gas::Curve;
using gas::Outside;

constexpr double kTankSize = 0.06, kStepFlow = 2.0, kStepHeat = 900.0;  // [m3], [kg/s], [K]
constexpr double kStepOn = 0.01, kStepOff = 0.03;                       // [s] of the pulse
const std::vector<double> kFirings{0.0, 1e-7, 0.1, 1.0 / 3.0, 0.7123456789};

Curve flow_curve(std::vector<Curve::Knot> knots) {
  return Curve(std::move(knots), Outside::zero);
}
Curve level_curve(std::vector<Curve::Knot> knots) {
  return Curve(std::move(knots), Outside::held);
}

/// On and off by jumps.
Curve step_pulse() {
  return flow_curve(
      {{0.0, 0.0}, {kStepOn, 0.0}, {kStepOn, kStepFlow}, {kStepOff, kStepFlow}, {kStepOff, 0.0}});
}

gas::ControlVolumeModel tank_with(const std::vector<gas::Inflow>& inflows, double vent_area) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.inflows = inflows;
  if (vent_area > 0.0) model.vents.push_back({0.6, vent_area});
  return model;
}

struct Filled {
  gas::GasPoint point;
  double mass_in = 0.0, mass_out = 0.0, before = 0.0;  // [kg]
};

Filled fill(const gas::ControlVolumeModel& model, const gas::IntegratorOptions& options, double end,
            int steps = 1, double pressure = kAmbientPressure) {
  gas::GasIntegrator integrator(model, options);
  gas::ControlVolumeState state = gas::make_state(model, kPure, pressure, 293.15, kTankSize);
  Filled ended;
  ended.before = state.masses[0];
  for (int i = 0; i < steps; ++i) {
    const gas::StepFluxes fluxes =
        integrator.advance(state, end * i / steps, end * (i + 1) / steps, rigid(kTankSize));
    ended.mass_in += fluxes.mass_in;
    ended.mass_out += fluxes.vent_mass_out;
  }
  ended.point = gas::evaluate(model, state, kTankSize, 0.0, end);
  return ended;
}

/// The pulse between two jumps is that of an inflator which delivers nothing else; closed, p rises by
/// gamma R T m/V.
TEST(jump, pulse_eq_inflator_of_its_own) {
  const double mass = kStepFlow * (kStepOff - kStepOn), rise = 1.4 * 296.8 * kStepHeat * mass / kTankSize;
  for (const double start : kFirings)
    for (const double area : {0.0, 5e-4})
      for (const gas::IntegratorOptions& options :
           {gas::IntegratorOptions{}, {1e-4}, {1e-10, 100000, gas::Method::rosenbrock_4}}) {
        SCOPED_TRACE(testing::Message() << start << " s, " << area << " m2");
        const Filled jump =
            fill(tank_with({{kPure, step_pulse(), Curve::constant(kStepHeat), start}}, area), options, 1.0);
        const Filled own =
            fill(tank_with({{kPure, flow_curve({{0.0, kStepFlow}, {kStepOff - kStepOn, kStepFlow}}),
                             Curve::constant(kStepHeat), start + kStepOn}},
                           area),
                 options, 1.0);
        claim::expect_relative({"G.9", "pulse between two jumps of a curve, anywhere: mass [kg]",
                                "knots a few ulp exact, product of two numbers"},
                               jump.mass_in, mass, 1e-14);
        // Firing and knots add in another order: a rounding of a second over 0.01 s of outflow.
        EXPECT_LT(relative(jump.point.pressure, own.point.pressure), 1e-12);
        EXPECT_LT(relative(jump.point.temperature, own.point.temperature), 1e-12);
        EXPECT_NEAR(jump.point.mass - jump.before, jump.mass_in - jump.mass_out, 1e-15);
        if (area == 0.0)
          claim::expect_relative(
              {"G.34", "the same into a closed tank: pressure [Pa]", "some ten operations"},
              jump.point.pressure, kAmbientPressure + rise, 1e-14);
      }
}

/// Many calls, whose ends are no knots and miss those that they meet by roundings.
TEST(jump, pulse_is_the_same_in_one_call_or_many) {
  for (const double start : kFirings) {
    const auto model = tank_with({{kPure, step_pulse(), Curve::constant(kStepHeat), start}}, 5e-4);
    const Filled one = fill(model, {}, 1.0), many = fill(model, {}, 1.0, 1000);
    EXPECT_LT(relative(many.mass_in, kStepFlow * (kStepOff - kStepOn)), 1e-12) << start;
    EXPECT_LT(relative(many.point.pressure, one.point.pressure), 1e-9) << start;
  }
}

/// Flanks of width w about the jumps deliver the same mass and move p by w^2 at the end.
TEST(jump, steep_flanks_converge_to_it) {
  const auto pressure = [](const Curve& curve) {
    return fill(tank_with({{kPure, curve, Curve::constant(kStepHeat)}}, 2e-3), {1e-13}, 0.04, 1, 3e5)
        .point.pressure;
  };
  const double exact = pressure(step_pulse());
  std::vector<double> errors;
  for (double w = 8e-3; w > 8e-4; w *= 0.5)
    errors.push_back(pressure(flow_curve({{0.0, 0.0},
                                          {kStepOn - 0.5 * w, 0.0},
                                          {kStepOn + 0.5 * w, kStepFlow},
                                          {kStepOff - 0.5 * w, kStepFlow},
                                          {kStepOff + 0.5 * w, 0.0},
                                          {0.05, 0.0}})) -
                     exact);
  claim::expect_order({"G.10", "steep flanks about two jumps of the mass flow, 8 to 1 ms: pressure [Pa]",
                       "second order in the width"},
                      errors, 1.9, 2.1);
}

/// Temperatures before and after a jump are those of two inflators.
TEST(jump, temperature_eq_two_inflators) {
  const double mass = 0.5 * kStepFlow * (kStepOff - kStepOn);
  const Curve both = flow_curve({{0.0, kStepFlow}, {kStepOff - kStepOn, kStepFlow}}),
              half = flow_curve({{0.0, kStepFlow}, {0.5 * (kStepOff - kStepOn), kStepFlow}});
  const Curve heat = level_curve({{0.0, 400.0}, {0.01, 400.0}, {0.01, 1200.0}, {0.02, 1200.0}});
  for (const double area : {0.0, 5e-4}) {
    const Filled one = fill(tank_with({{kPure, both, heat}}, area), {}, 0.04);
    const Filled two =
        fill(tank_with({{kPure, half, Curve::constant(400.0)}, {kPure, half, Curve::constant(1200.0), 0.01}},
                       area),
             {}, 0.04);
    EXPECT_LT(relative(one.point.pressure, two.point.pressure), 1e-12);
    if (area == 0.0)
      claim::expect_relative(
          {"G.10", "temperature of the inflow that jumps, closed tank: pressure [Pa]", "some ten operations"},
          one.point.pressure, kAmbientPressure + 1.4 * 296.8 * mass * 1600.0 / kTankSize, 1e-14);
  }
}

/// An area that jumps from nothing is a vent that is opened then; after one to nothing the gas rests.
TEST(jump, area_opens_and_shuts_a_vent) {
  const auto model_of = [](const gas::Vent& vent) {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    model.vents.push_back(vent);
    return model;
  };
  const auto blow = [](const gas::ControlVolumeModel& model, double end) {
    gas::ControlVolumeState state = gas::make_state(model, kPure, 5e5, 600.0, kTankSize);
    gas::GasIntegrator(model).advance(state, 0.0, end, rigid(kTankSize));
    return gas::evaluate(model, state, kTankSize, 0.0, end);
  };
  const auto steps = model_of(
      {0.6, 0.0,
       level_curve({{0.0, 0.0}, {kStepOn, 0.0}, {kStepOn, 2e-3}, {kStepOff, 2e-3}, {kStepOff, 0.0}})});
  const auto open = model_of({0.6, 2e-3});
  EXPECT_EQ(blow(steps, kStepOn).pressure, blow(steps, 0.5 * kStepOn).pressure);
  EXPECT_LT(relative(blow(steps, 0.02).pressure, blow(open, 0.01).pressure), 1e-12);
  const gas::GasPoint shut = blow(steps, 0.05), end = blow(open, kStepOff - kStepOn);
  EXPECT_LT(relative(shut.pressure, end.pressure), 1e-12);
  EXPECT_LT(relative(shut.mass, end.mass), 1e-12);
  // What a moment shows is the area from then on.
  EXPECT_GT(blow(steps, kStepOn).vent_mass_flow, 0.0);
  EXPECT_EQ(blow(steps, kStepOff).vent_mass_flow, 0.0);
}

/// The clock of a vent or an inflator starts at any time: at its jump what is shown is the value after.
TEST(jump, points_show_the_value_after_by_any_clock) {
  for (int i = 0; i < 1000; ++i) {
    const double start = 0.37 * i / 991.0, time = start + kStepOn;
    gas::ControlVolumeModel model =
        tank_with({{kPure, step_pulse(), level_curve({{kStepOn, 300.0}, {kStepOn, kStepHeat}}), start}}, 0.0);
    model.triggers.sensors = {{gas::SensorKind::time, start}};
    model.vents.push_back({.discharge_coefficient = 0.6,
                           .area = 0.0,
                           .area_of_time = level_curve({{kStepOn, 1e-3}, {kStepOn, 2e-3}}),
                           .trigger = 0});
    gas::ControlVolumeState state = gas::make_state(model, kPure, 2e5, 293.15, kTankSize);
    state.triggers[0] = {true, start, start, start};
    const gas::GasPoint point = gas::evaluate(model, state, kTankSize, 0.0, time);
    model.vents[0].area_of_time = Curve::constant(2e-3);
    ASSERT_EQ(point.vent_mass_flow, gas::evaluate(model, state, kTankSize, 0.0, time).vent_mass_flow)
        << start;
    ASSERT_EQ(point.inflow, kStepFlow) << start;
    ASSERT_EQ(gas::inflator_point(model, 0, time).temperature, kStepHeat) << start;
    ASSERT_EQ(gas::inflator_point(model, 0, time, gas::Side::before).mass_flow, 0.0) << start;
    ASSERT_EQ(gas::inflator_point(model, 0, time, gas::Side::before).temperature, 300.0) << start;
  }
}

/// A signal that jumps past the threshold switches then; one that comes to it and falls at once never does.
TEST(jump, signal_switches_a_sensor) {
  const auto first_on = [](const Curve& signal) {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    model.triggers.sensors = {{gas::SensorKind::signal, 5.0, {}, signal}};
    gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure, 293.15, kTankSize);
    gas::GasIntegrator(model).advance(state, 0.0, 1.0, rigid(kTankSize));
    return state.triggers[0];
  };
  const auto up = first_on(level_curve({{0.0, 0.0}, {0.3, 1.0}, {0.3, 9.0}}));
  EXPECT_EQ(up.first_on, 0.3);
  EXPECT_TRUE(up.on);
  const auto once = first_on(level_curve({{0.2, 0.0}, {0.2, 9.0}, {0.6, 7.0}, {0.6, 1.0}}));
  EXPECT_EQ(once.first_on, 0.2);
  EXPECT_FALSE(once.on);
  EXPECT_EQ(first_on(level_curve({{0.0, 0.0}, {0.4, 5.0}, {0.4, 0.0}})).first_on,
            std::numeric_limits<double>::infinity());
}

TEST(jump, is_refused_against_overpressure) {
  const Curve curve = level_curve({{0.0, 0.0}, {1e4, 1.0}, {1e4, 2.0}});
  const auto message = [](const gas::ControlVolumeModel& model) -> std::string {
    try {
      gas::validate(model);
      return "accepted";
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  gas::ControlVolumeModel area = closed_tank(nitrogen()), velocity = area, volume = area;
  area.vents.push_back({1.0, 0.0, {}, curve});
  velocity.fabrics = {{1.0, curve}};
  volume.volume_of_overpressure = level_curve({{0.0, 1.0}, {1e4, 1.5}, {1e4, 2.0}});
  EXPECT_EQ(message(area).find("knot of vent.area_of_overpressure [Pa] = 10000"), 0u) << message(area);
  EXPECT_EQ(message(velocity).find("knot of fabric.velocity [Pa] = 10000"), 0u) << message(velocity);
  EXPECT_EQ(message(volume).find("knot of volume_of_overpressure [Pa] = 10000"), 0u) << message(volume);
}

}  // namespace
