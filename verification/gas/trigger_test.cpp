// SPDX-License-Identifier: Apache-2.0
#include "gas/trigger.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "cases.hpp"

// Sensors and their logic: when an inflator fires and a vent opens.
namespace {

using namespace cases;
using gas::Logic;
using gas::SensorKind;

constexpr double kNever = std::numeric_limits<double>::infinity();

/// A signal that rises to 100 at 20 ms, falls to 0 at 40 ms, and rises again.
gas::Curve signal() {
  return gas::Curve({{0.0, 0.0}, {0.02, 100.0}, {0.04, 0.0}, {0.06, 100.0}}, gas::Outside::held);
}

/// A sealed tank with an inflator of 10 us that fires on node `trigger`.
gas::ControlVolumeModel triggered_tank(const gas::TriggerModel& triggers, std::size_t trigger) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.triggers = triggers;
  model.inflows.push_back({kPure, gas::Curve({{0.0, 3.0}, {1e-5, 5.0}}, gas::Outside::zero),
                           gas::Curve::constant(900.0), 0.0, trigger});
  return model;
}

struct Fired {
  double time;  // of the inflator's trigger
  double mass;  // delivered
};

/// One step over a second; the tank is opened by the integrator only where the model says so.
Fired fire(const gas::ControlVolumeModel& model, const gas::IntegratorOptions& options = {},
           double pressure = kAmbientPressure) {
  gas::ControlVolumeState state = gas::make_state(model, kPure, pressure, 293.15, 0.06);
  gas::GasIntegrator integrator(model, options);
  const gas::StepFluxes fluxes = integrator.advance(state, 0.0, 1.0, rigid(0.06));
  return {gas::firing_time(model.inflows.back(), state.triggers), fluxes.inflows.back().mass};
}

double fires_at(const gas::TriggerModel& triggers) {
  return fire(triggered_tank(triggers, triggers.size() - 1)).time;
}

const gas::Sensor kClock{SensorKind::time, 0.03};
const gas::Sensor kShock{SensorKind::signal, 50.0, {}, signal()};

TEST(trigger, time_and_signal_fire_at_their_crossing) {
  // 0.7123456789 s is no sum of steps; a time is compared, not computed.
  EXPECT_EQ(fires_at({{{SensorKind::time, 0.7123456789}}, {}}), 0.7123456789);
  // One interpolation: two roundings of 0.01.
  EXPECT_NEAR(fires_at({{kShock}, {}}), 0.01, 4.0 * kEpsilon * 0.01);
  EXPECT_EQ(fires_at({{{SensorKind::signal, 101.0, {}, signal()}}, {}}), kNever);
  EXPECT_EQ(fires_at({{{SensorKind::signal, -1.0, {}, signal()}}, {}}), 0.0);
}

/// What an inflator delivers before it has fired: nothing, at the temperature with which it begins.
TEST(trigger, inflator_that_has_not_fired_has_a_temperature) {
  gas::ControlVolumeModel model = triggered_tank({{kClock}, {}}, 0);
  const auto state = gas::make_state(model, kPure, kAmbientPressure, 293.15, 0.06);
  for (const gas::Curve& temperature :
       {gas::Curve::constant(900.0), gas::Curve({{0.0, 900.0}, {1.0, 400.0}}, gas::Outside::held)}) {
    model.inflows[0].temperature = temperature;
    const gas::InflatorPoint point = gas::inflator_point(model, state, 0, 0.02);
    EXPECT_EQ(point.mass_flow, 0.0);
    EXPECT_EQ(point.temperature, 900.0);
  }
}

TEST(trigger, logic_combines_sensors) {
  // The signal is on in [0.01, 0.03) and from 0.05; the clock from 0.03.
  EXPECT_NEAR(fires_at({{kClock, kShock}, {{Logic::all, {0, 1}}}}), 0.05, 4.0 * kEpsilon);
  EXPECT_NEAR(fires_at({{kClock, kShock}, {{Logic::any, {0, 1}}}}), 0.01, 4.0 * kEpsilon);
  EXPECT_EQ(fires_at({{kClock, kShock}, {{Logic::negated, {1}}}}), 0.0);
  // (not clock) and (not signal), then not that: first false at 0.01.
  EXPECT_NEAR(
      fires_at({{kClock, kShock},
                {{Logic::negated, {0}}, {Logic::negated, {1}}, {Logic::all, {2, 3}}, {Logic::negated, {4}}}}),
      0.01, 4.0 * kEpsilon);
}

TEST(trigger, delay_needs_the_condition_to_hold_unless_latched) {
  // On in [0.01, 0.03): held 5 ms, but not 25 ms before 0.05 + 0.025.
  EXPECT_NEAR(fires_at({{kShock}, {{Logic::any, {0}, 0.005}}}), 0.015, 4.0 * kEpsilon);
  EXPECT_NEAR(fires_at({{kShock}, {{Logic::any, {0}, 0.025}}}), 0.075, 4.0 * kEpsilon);
  EXPECT_NEAR(fires_at({{kShock}, {{Logic::any, {0}, 0.025, true}}}), 0.035, 4.0 * kEpsilon);
}

/// What a run finds is known before it, unless a pressure or an input decides.
TEST(trigger, switching_times_of_clocks_and_signals_are_known) {
  const gas::TriggerModel models[]{
      {{kClock, kShock}, {{Logic::all, {0, 1}}}},
      {{kClock, kShock}, {{Logic::any, {0, 1}}, {Logic::negated, {2}}}},
      {{kShock}, {{Logic::any, {0}, 0.025}}},
      {{kShock}, {{Logic::any, {0}, 0.025, true}}},
  };
  for (const gas::TriggerModel& model : models) {
    const auto times = gas::switching_times(model, model.size() - 1, 1.0);
    ASSERT_TRUE(times);
    EXPECT_EQ(times->front(), fires_at(model));
  }
  const auto all = gas::switching_times({{kShock}, {}}, 0, 0.06);
  ASSERT_EQ(all->size(), 3u);  // on, off, and on again
  EXPECT_NEAR((*all)[1], 0.03, 4.0 * kEpsilon);
  EXPECT_TRUE(gas::switching_times({{kClock}, {}}, 0, 0.02)->empty());
  const gas::TriggerModel run{{kClock, {SensorKind::pressure, 5e4}, {SensorKind::input}},
                              {{Logic::any, {0, 1}}, {Logic::all, {0, 2}}, {Logic::negated, {0}}}};
  for (const std::size_t node : {1, 2, 3, 4}) EXPECT_FALSE(gas::switching_times(run, node, 1.0)) << node;
  EXPECT_EQ(gas::switching_times(run, 5, 1.0), (std::vector<double>{0.0, 0.03}));
}

/// A pulse of 10 us that any trigger fires, by any method, at any tolerance, in one step of a second.
TEST(trigger, triggered_pulse_adds_its_mass_with_any_method) {
  const gas::TriggerModel triggers{{{SensorKind::time, 0.1}}, {{Logic::any, {0}, 1.0 / 3.0, true}}};
  for (const bool open : {false, true}) {
    gas::ControlVolumeModel model = triggered_tank(triggers, 1);
    if (open) model.vents.push_back({0.6, 1e-4});
    for (const gas::Method method : kMethods) {
      for (const double tolerance : {1e-2, 1e-6, 1e-9}) {
        // Euler needs some 1/tolerance sub-steps, the loose tolerances show it.
        if (method == gas::Method::euler && tolerance < 1e-6) continue;
        const Fired fired = fire(model, {tolerance, 100000000, method});
        EXPECT_EQ(fired.time, 0.1 + 1.0 / 3.0);
        EXPECT_LT(relative(fired.mass, 4e-5), 1e-12);
      }
    }
  }
}

/// Filled at a known rate of pressure: the threshold is crossed inside one long step and located there.
TEST(trigger, pressure_threshold_is_located_inside_the_step) {
  const double rate = 1.4 * 296.8 * 700.0 * 0.2 / 0.06;  // [Pa/s]
  for (const bool open : {false, true}) {
    gas::ControlVolumeModel model = triggered_tank({{{SensorKind::pressure, 50000.0}}, {}}, 0);
    model.inflows.insert(model.inflows.begin(), steady_inflow(model.thermo, 0.2, 700.0));
    // An opening that stays shut until long after makes the same tank step by step.
    if (open)
      model.vents.push_back({1.0, 1e-3, {}, gas::Curve({{9e5, 0.0}, {1e6, 1e-3}}, gas::Outside::held)});
    const Fired fired = fire(model);
    // Located to 1e-12 p_a, at that rate, and to the rounding of some ten operations on p.
    EXPECT_NEAR(fired.time, 50000.0 / rate, 3e-12 * kAmbientPressure / rate);
    EXPECT_LT(relative(fired.mass, 4e-5), 1e-12);
  }
}

/// Near vacuum outside the threshold is located to its own digits, not to those of p_a.
TEST(trigger, pressure_threshold_far_above_the_ambient_pressure_is_not_missed) {
  const double rate = 1.4 * 296.8 * 700.0 * 0.2 / 0.06;  // [Pa/s]
  for (int i = 1; i <= 400; ++i) {
    const double rise = 12.345 * i;  // [Pa]; where rounding hides a threshold, it hides one in a hundred
    gas::ControlVolumeModel model =
        triggered_tank({{{SensorKind::pressure, kAmbientPressure + rise - 10.0}}, {}}, 0);
    model.ambient.pressure = 10.0;
    model.inflows.insert(model.inflows.begin(), steady_inflow(model.thermo, 0.2, 700.0));
    // To 1e-12 of the pressure, and the rounding of some ten operations on it.
    EXPECT_NEAR(fire(model).time, rise / rate, 3e-12 * (kAmbientPressure + rise) / rate);
  }
}

/// Where an inflow starts within rounding of a call's end, and lifts p by more than a level's tolerance
/// within that rounding.
TEST(trigger, pressure_threshold_is_not_missed_after_a_firing_between_two_calls) {
  const double rate = 1.4 * 296.8 * 406.0 * 10.0 / 0.005;  // [Pa/s]
  gas::ControlVolumeModel model = triggered_tank({{{SensorKind::pressure, 200.0}}, {}}, 0);
  model.ambient.pressure = 1000.0;
  model.inflows.insert(model.inflows.begin(), steady_inflow(model.thermo, 10.0, 406.0));
  for (int start = 1; start <= 29; ++start) {
    const double fires = 0.01 * start;
    model.inflows.front().start_time = fires;
    for (const double call : {std::nextafter(fires, 0.0), fires, std::nextafter(fires, 1.0)}) {
      gas::ControlVolumeState state = gas::make_state(model, kPure, 1000.0, 293.15, 0.005);
      gas::GasIntegrator integrator(model);
      integrator.advance(state, 0.0, call, rigid(0.005));
      integrator.advance(state, call, fires + 0.01, rigid(0.005));
      // Located to 1e-12 of the pressure; a few roundings of the time.
      EXPECT_NEAR(gas::firing_time(model.inflows.back(), state.triggers), fires + 200.0 / rate,
                  3e-12 * 1200.0 / rate + 4.0 * kEpsilon * fires);
    }
  }
}

/// A valve that opens at 20 kPa and closes at 10 kPa: each opening and closing is located.
TEST(trigger, valve_with_hysteresis_keeps_the_pressure_in_its_band) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.triggers = {{{SensorKind::pressure, 20000.0, 10000.0}}, {}};
  model.inflows.push_back(steady_inflow(model.thermo, 0.05, 300.0));
  gas::Vent valve{1.0, 5e-3};
  valve.trigger = 0;
  model.vents.push_back(valve);
  gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure, 300.0, 0.06);
  gas::GasIntegrator integrator(model);
  int changes = 0;
  bool open = false;
  double lowest = 1e9, highest = 0.0;
  for (int i = 0; i < 1000; ++i) {
    integrator.advance(state, 1e-3 * i, 1e-3 * (i + 1), rigid(0.06));
    if (state.triggers[0].on != open) ++changes;
    open = state.triggers[0].on;
    const double excess = gas::evaluate(model, state, 0.06, 0.0, 0.0).pressure - kAmbientPressure;
    highest = std::max(highest, excess);
    if (i > 300) lowest = std::min(lowest, excess);
  }
  EXPECT_GT(changes, 10);
  // Never past a threshold by more than its location, 1e-12 p_a.
  EXPECT_LT(highest, 20000.0 + 1e-6);
  EXPECT_GT(lowest, 10000.0 - 1e-6);
}

TEST(trigger, input_acts_from_the_next_step) {
  const gas::TriggerModel triggers{{{SensorKind::input}}, {}};
  const gas::ControlVolumeModel model = triggered_tank(triggers, 0);
  gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure, 293.15, 0.06);
  gas::GasIntegrator integrator(model);
  EXPECT_EQ(integrator.advance(state, 0.0, 0.5, rigid(0.06)).mass_in, 0.0);
  gas::set_input(model.triggers, 0, true, state.triggers);
  EXPECT_LT(relative(integrator.advance(state, 0.5, 0.6, rigid(0.06)).mass_in, 4e-5), 1e-12);
  EXPECT_EQ(state.triggers[0].first_on, 0.5);
  // An inflator fires once: the contact's end and return change nothing.
  gas::set_input(model.triggers, 0, false, state.triggers);
  integrator.advance(state, 0.6, 0.7, rigid(0.06));
  gas::set_input(model.triggers, 0, true, state.triggers);
  EXPECT_EQ(integrator.advance(state, 0.7, 0.8, rigid(0.06)).mass_in, 0.0);
}

template <class Change>
void expect_bad_model(Change change, const std::string& field) {
  gas::TriggerModel model{{kClock, kShock, {SensorKind::pressure, 2e4, 1e4}}, {{Logic::all, {0, 1}}}};
  EXPECT_NO_THROW(gas::validate(model));
  change(model);
  try {
    gas::validate(model);
    FAIL() << field << " was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(field), std::string::npos) << error.what();
  }
}

TEST(trigger, bad_models_are_refused) {
  expect_bad_model([](auto& m) { m.sensors[0].threshold = std::nan(""); }, "sensor.threshold");
  expect_bad_model([](auto& m) { m.sensors[2].reset = 2e4; }, "sensor.reset");
  expect_bad_model([](auto& m) { m.sensors[0].reset = 0.0; }, "sensor.reset");
  expect_bad_model([](auto& m) { m.sensors[1].signal.reset(); }, "sensor.signal");
  expect_bad_model([](auto& m) { m.gates[0].inputs = {}; }, "gate.inputs");
  expect_bad_model([](auto& m) { m.gates[0].inputs = {3}; }, "gate.inputs");
  expect_bad_model([](auto& m) { m.gates[0].logic = Logic::negated; }, "gate.inputs");
  expect_bad_model([](auto& m) { m.gates[0].delay = -1.0; }, "gate.delay");
  gas::TriggerModel model{{kClock}, {}};
  gas::TriggerState state(1);
  EXPECT_THROW(gas::set_input(model, 0, true, state), std::invalid_argument);
  gas::ControlVolumeModel tank = triggered_tank(model, 1);
  EXPECT_THROW(gas::GasIntegrator{tank}, std::invalid_argument);
}

/// A relief valve that closes a hair below where it opens keeps p there by switching ever again: that, not
/// the gas, is what the error names.
TEST(trigger, chatter_is_named) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.triggers.sensors = {{gas::SensorKind::pressure, 5e4, 5e4 - 1e-3}};
  model.inflows.push_back(steady_inflow(model.thermo, 0.1, 400.0));
  model.vents.push_back({1.0, 1e-3});
  model.vents.back().trigger = 0;
  gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure + 4.99e4, 300.0, 0.06);
  try {
    gas::GasIntegrator(model, {1e-6, 20000}).advance(state, 0.0, 0.1, rigid(0.06));
    FAIL() << "no error";
  } catch (const gas::DomainError& error) {
    const std::string text = error.what(), words = " Pa, keeps switching: ";
    EXPECT_NE(text.find("pressure sensor 1, on at 50000 Pa"), std::string::npos) << text;
    ASSERT_NE(text.find(words), std::string::npos) << text;
    EXPECT_GT(std::stoi(text.substr(text.find(words) + words.size())), 1000) << text;
    EXPECT_NE(text.find("a lower reset, a delay"), std::string::npos) << text;
  }
}

}  // namespace
