// SPDX-License-Identifier: Apache-2.0
// Evacuated tanks and pressure sensors with known solutions.
#include "known.hpp"
#include "start.hpp"

namespace {

using namespace test;
using enclosure::Scene;
using enclosure::Tube;

// An evacuated tank fills at g T_in.
TEST(enclosure, contains_evacuated_fill) {
  for (unsigned seed = 1; seed <= few; ++seed) {
    Draw draw(seed);
    const double width = width_of(seed);
    Scene s = tank(draw);
    s.initial_pressure = 0.0;
    const double flow = draw(0.1, 1.0), t_in = draw(300.0, 1000.0), time = draw(1e-3, 2e-3);
    s.inflators = {
        {.mass_fractions = {1.0}, .mass_flow = {{0.0, 0.0}, {0.01, flow}}, .temperature = {{0.0, t_in}}}};
    const OneGas g(s);
    const Tube tube = tube_at(s, time, width);
    expect_contains(tube, "temperature_K", g.gamma * Ball(t_in), width);
    expect_contains(tube, "gas_mass_kg", Ball(flow) * Ball(time) * Ball(time) / Ball(0.02), width);
  }
}

// Flow and temperature of what flows in rise with time, w = a t and T_in = T_0 + k t: T = g (T_0 + 2/3 k t).
TEST(enclosure, start_of_an_evacuated_tank_holds_gas_that_warms) {
  for (unsigned seed = 1; seed <= draws; ++seed) {
    Draw draw(seed);
    Scene s = tank(draw);
    s.initial_pressure = 0.0;
    const double t_in = draw(300.0, 1000.0), warmer = draw(1100.0, 2000.0);
    s.inflators = {{.mass_fractions = {1.0},
                    .mass_flow = {{0.0, 0.0}, {1.0, draw(0.1, 1.0)}},
                    .temperature = {{0.0, t_in}, {1.0, warmer}}}};
    const enclosure::Start start = enclosure::start_of(enclosure::Tank(s));
    const Ball share = Ball(2.0) / Ball(3.0) * start.time;
    EXPECT_TRUE(
        start.unknowns[1].contains(OneGas(s).gamma * (Ball(t_in) + (Ball(warmer) - Ball(t_in)) * share)));
    EXPECT_LE(start.unknowns[1].radius(), 1e-6 * t_in);
  }
}

// A constant flow lifts p by (gamma - 1) w cp T_in/V t; at a threshold, and a delay later, a second one sets
// in.
TEST(enclosure, contains_fill_that_a_pressure_sensor_doubles) {
  for (unsigned seed = 1; seed <= few; ++seed) {
    Draw draw(seed);
    const double width = width_of(seed);
    Scene s = tank(draw);
    const OneGas g(s);
    const double flow = draw(0.1, 1.0), second = draw(0.1, 1.0), t_in = draw(300.0, 1000.0), end = 0.05,
                 delay = seed % 2 ? 0.0 : 0.005;
    for (const double w : {flow, second})
      s.inflators.push_back({.mass_fractions = {1.0}, .mass_flow = {{0.0, w}}, .temperature = {{0.0, t_in}}});
    const Ball rise = g.gamma * g.r * Ball(t_in) * Ball(flow) / g.v;
    const double level = s.initial_pressure - s.ambient_pressure + 0.02 * rise.middle();
    s.sensors = {{.threshold = level, .reset = level - 1.0}};
    s.gates = {{.logic = enclosure::Gate::Logic::all, .inputs = {0}, .delay = delay}};
    s.inflators[1].node = 1;
    const Ball fires =
        (Ball(level) + Ball(s.ambient_pressure) - Ball(s.initial_pressure)) / rise + Ball(delay);
    const Ball in = Ball(second) * (Ball(end) - fires);
    const Tube tube = tube_at(s, end, width);
    expect_contains(tube, "inflator_1_in_kg", in, 100.0 * width);
    expect_contains(tube, "gas_mass_kg", g.mass + Ball(flow) * Ball(end) + in, width);
  }
}

/// A tank of 60 l that 1 kg/s fills, and a second inflator or a hole that sensors open.
Scene sensed(double vent, std::size_t node) {
  Scene s;
  s.species = {gas(0.028, 3.5)};
  s.initial_fractions = {1.0};
  s.initial_pressure = 101325.0;
  s.initial_temperature = 300.0;
  s.volume = {{0.0, 0.06}};
  for (int i = 0; i < 2; ++i)
    s.inflators.push_back(
        {.mass_fractions = {1.0}, .mass_flow = {{0.0, 1.0}}, .temperature = {{0.0, 300.0}}});
  s.inflators[1].node = node;
  if (vent > 0.0) s.holes = {{.area = {{0.0, vent}}, .node = 0}};
  return s;
}

/// Bounds of a column, or none where the width leaves the order of events open.
std::optional<Known> bounds_or_refusal(const Scene& s, double time, double width, const std::string& name) {
  try {
    return bounds_of(tube_at(s, time, width), 0, name);
  } catch (const enclosure::Refusal&) {
    return {};
  }
}

constexpr double close = 20000.000000001;  // [Pa] far less above 20000 than a wide tube is

// The first of two sensors opens a large hole: the pressure never comes to the second.
TEST(enclosure, sensor_that_another_keeps_from_its_threshold_does_not_switch) {
  Scene s = sensed(0.1, 1);
  s.sensors = {{.threshold = 20000.0}, {.threshold = close}};
  int decided = 0;
  for (const double width : {1e-4, 1e-8, 1e-12, 1e-16})
    if (const auto in = bounds_or_refusal(s, 0.01, width, "inflator_1_in_kg")) {
      EXPECT_FALSE(in->lower.is_positive()) << width;
      EXPECT_LE(in->upper.middle(), width) << width;  // [kg]; 6 g if it fires
      ++decided;
    }
  EXPECT_GE(decided, 1);
}

// The first is on and the second is not for 0.1 ps; a latch keeps that.
TEST(enclosure, order_of_two_sensors_is_proved_or_refused) {
  Scene s = sensed(0.0, 3);
  s.sensors = {{.threshold = 20000.0}, {.threshold = close}};
  s.gates = {{.logic = enclosure::Gate::Logic::negated, .inputs = {1}},
             {.logic = enclosure::Gate::Logic::all, .inputs = {0, 2}, .latch = true}};
  int decided = 0;
  for (const double width : {1e-4, 1e-8, 1e-12, 1e-16, 1e-20})
    if (const auto in = bounds_or_refusal(s, 0.01, width, "inflator_1_in_kg")) {
      EXPECT_TRUE(in->lower.is_positive()) << width;
      ++decided;
    }
  EXPECT_GE(decided, 1);
}

// Times right after a hole of 10 m2 has opened: the old law's bounds are never told.
TEST(enclosure, bounds_right_after_an_event_are_of_its_law_or_refused) {
  Scene s = sensed(10.0, 0);
  s.sensors = {{.threshold = 20000.0}};
  s.inflators.pop_back();
  const double fires = 20000.0 * 0.06 / (1.4 * (8.31446261815324 / 0.028) * 300.0);
  int decided = 0;
  for (int i = -8; i <= 8; ++i) {
    const double time = fires * (1.0 + 1e-13 * i);
    const auto narrow = bounds_or_refusal(s, time, 1e-20, "pressure_Pa"),
               wide = bounds_or_refusal(s, time, 1e-8, "pressure_Pa");
    if (!narrow || !wide) continue;
    ++decided;
    EXPECT_FALSE((narrow->lower - wide->upper).is_positive() || (wide->lower - narrow->upper).is_positive())
        << time;
  }
  EXPECT_GE(decided, 4);
}

// With walls a constant flow fills it at (w cp T_in + h A T_ext)/(w cv + h A).
TEST(enclosure, contains_evacuated_fill_with_walls) {
  for (unsigned seed = 1; seed <= few; ++seed) {
    Draw draw(seed);
    const double width = width_of(seed);
    Scene s = tank(draw);
    s.initial_pressure = 0.0;
    const double flow = draw(0.1, 1.0), t_in = draw(300.0, 1000.0);
    s.inflators = {{.mass_fractions = {1.0}, .mass_flow = {{0.0, flow}}, .temperature = {{0.0, t_in}}}};
    s.wall_conductance = draw(10.0, 1000.0);
    const OneGas g(s);
    const Ball cv = gas_constant(s.species[0].molar_mass) / (g.gamma - Ball(1.0)), walls(s.wall_conductance);
    const Ball t = (Ball(flow) * g.gamma * cv * Ball(t_in) + walls * Ball(s.outside_temperature)) /
                   (Ball(flow) * cv + walls);
    expect_contains(tube_at(s, 1e-3, width), "temperature_K", t, width);
  }
}

// Ambient gas fills it at gamma T_a, with a choked flow at first.
TEST(enclosure, contains_evacuated_backflow) {
  for (unsigned seed = 1; seed <= few; ++seed) {
    Draw draw(seed);
    const double width = width_of(seed);
    Scene s = tank(draw);
    s.initial_pressure = 0.0;
    s.ambient_fractions = {1.0};
    s.holes = {{.area = {{0.0, 1e-4}}, .backflow = true}};
    const OneGas g(s);
    const Ball r = gas_constant(s.species[0].molar_mass), ta(s.ambient_temperature), one(1.0);
    const Ball flow = Ball(1e-4) * Ball(s.ambient_pressure) * sqrt(g.gamma / (r * ta)) *
                      pow(Ball(2.0) / (g.gamma + one), (g.gamma + one) / (Ball(2.0) * (g.gamma - one)));
    const Tube tube = tube_at(s, 1e-3, width);
    expect_contains(tube, "temperature_K", g.gamma * ta, width);
    expect_contains(tube, "vent_0_backflow_kg", flow * Ball(1e-3), width);
  }
}

}  // namespace
