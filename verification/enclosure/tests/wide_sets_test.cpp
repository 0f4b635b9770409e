// SPDX-License-Identifier: Apache-2.0
// Wide sets and long steps, where each part of the proof is needed: a part that is left out loses a solution.
#include <array>
#include <cmath>
#include <numbers>

#include "known.hpp"
#include "walk.hpp"

namespace {

using namespace test;
using enclosure::Balls;
using enclosure::Scene;
using enclosure::Tank;
using enclosure::Tube;
using enclosure::Walk;

struct State {
  double mass, temperature;
};

/// Unknowns within a share of those of `centre`, and totals of `streams` streams.
Balls box_around(const State& centre, double share, std::size_t streams) {
  Balls box{enclosure::wider(Ball(centre.mass), share * centre.mass),
            enclosure::wider(Ball(centre.temperature), share * centre.temperature)};
  box.resize(2 + streams);
  return box;
}

/// Centre, corners and middles of edges, just inside.
std::vector<State> points(const State& centre, double share) {
  std::vector<State> all;
  for (const double i : {-0.999, 0.0, 0.999})
    for (const double j : {-0.999, 0.0, 0.999})
      all.push_back({centre.mass * (1.0 + i * share), centre.temperature * (1.0 + j * share)});
  return all;
}

/// `exact` is in doubles, good to `rounding` of itself.
void expect_within(const Ball& ball, double exact, const std::string& what, double rounding = 1e-12) {
  EXPECT_LE(lower(ball).middle(), exact + rounding * std::abs(exact)) << what;
  EXPECT_GE(upper(ball).middle(), exact - rounding * std::abs(exact)) << what;
}

State start_of(const Scene& s) {
  const double r = gas_constant(s.species[0].molar_mass).middle();
  return {s.initial_pressure * s.volume[0].value / (r * s.initial_temperature), s.initial_temperature};
}

/// Walks to `end`, and expects the exact state of each start after each step.
template <class Exact>
void expect_walk_contains(const Scene& s, double share, double tolerance, double end, Exact&& exact) {
  const Tank tank(s);
  const State centre = start_of(s);
  const std::size_t streams = s.holes.size() + s.fabrics.size();
  Walk walk(tank, Ball(0.0), box_around(centre, share, streams), tolerance);
  while (walk.time().middle() < end) {
    walk.step(Ball(end));
    const Balls values = walk.values();
    for (const State& point : points(centre, share)) {
      const State now = exact(point, walk.time().middle());
      expect_within(values[1], now.temperature, "temperature");
      expect_within(values[3], now.mass, "mass");
      if (streams > 0) expect_within(values[5], point.mass - now.mass, "outflow", 1e-10);
    }
  }
}

// The theorem of Picard: a polynomial of degree 21 is far from exp(150), and so is all that the remainder
// over its range allows. A made-up gas of negative cv runs away from its walls.
TEST(wide_sets, growth_needs_a_box_that_holds) {
  Draw draw(1);
  Scene s = tank(draw);
  s.species = {gas(0.028, 0.5)};
  s.wall_conductance = 10.0;
  s.outside_temperature = 300.0;
  s.initial_temperature = 301.0;
  const double cv = -0.5 * gas_constant(0.028).middle(), rate = 10.0 / (start_of(s).mass * -cv);
  expect_walk_contains(s, 0.0, 1e300, 150.0 / rate, [&](const State& at, double t) {
    return State{at.mass, 300.0 + (at.temperature - 300.0) * std::exp(rate * t)};
  });
}

// The mean value theorem: slopes over the whole box, and both unknowns' terms.
TEST(wide_sets, choked_blowdown_from_all_corners) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    Draw draw(seed);
    Scene s = tank(draw);
    s.ambient_pressure = 0.0;
    // From one point the remainder is all the width that there is.
    const double area = draw(1e-5, 1e-3), share = seed % 2 ? draw(0.001, 0.02) : 0.0;
    s.holes = {{.area = {{0.0, area}}}};
    const double r = gas_constant(s.species[0].molar_mass).middle(),
                 g = s.species[0].low[0] / (s.species[0].low[0] - 1.0), v = s.volume[0].value;
    const double rate = 0.5 * (g - 1.0) * std::pow(2.0 / (g + 1.0), 0.5 * (g + 1.0) / (g - 1.0)) * area / v;
    const double end = 0.1 / (rate * std::sqrt(g * r * s.initial_temperature));
    expect_walk_contains(s, share, 1e-3, end, [&](const State& at, double t) {
      const double z = 1.0 + rate * std::sqrt(g * r * at.temperature) * t;
      return State{at.mass * std::pow(z, -2.0 / (g - 1.0)), at.temperature / (z * z)};
    });
  }
}

// T V^(g-1) is constant. Of a small wave the pressure hardly changes, but the rate does: it is that of its
// time.
TEST(wide_sets, piston_keeps_its_isentrope_after_each_step) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    Draw draw(seed);
    Scene s = tank(draw);
    const double share = seed % 2 ? 0.3 : 1e-3, v0 = s.volume[0].value,
                 g = s.species[0].low[0] / (s.species[0].low[0] - 1.0);
    s.wave = {v0, share * v0, draw(10.0, 60.0) * (seed % 2 ? 1.0 : 10.0), 0.0};
    const auto turn = [&](double t) {
      return 1.0 + share * std::sin(2.0 * std::numbers::pi * s.wave->frequency * t);
    };
    expect_walk_contains(s, 0.0, 1e-5, 0.02, [&](const State& at, double t) {
      return State{at.mass, at.temperature * std::pow(turn(t), 1.0 - g)};
    });
  }
}

// cv jumps at 1000 K, and the choked flow with it: in one step across both laws count.
TEST(wide_sets, blowdown_across_a_jump_of_cp) {
  for (const double tolerance : {1e-4, 1e-7}) {
    Scene s;
    s.species = {{.name = "gas",
                  .molar_mass = 0.028,
                  .low = {2.2, 0, 0, 0, 0, -1200.0},
                  .high = {8.0, 0, 0, 0, 0, -7000.0},
                  .constant_cp = false}};
    s.initial_fractions = {1.0};
    s.initial_pressure = 1e6;
    s.initial_temperature = 1010.0;
    s.ambient_pressure = 0.0;
    s.volume = {{0.0, 0.01}};
    s.holes = {{.area = {{0.0, 1e-3}}}};
    const double r = gas_constant(0.028).middle();
    const auto rate = [&](double cp) {
      const double g = cp / (cp - 1.0);
      return 0.5 * (g - 1.0) * std::pow(2.0 / (g + 1.0), 0.5 * (g + 1.0) / (g - 1.0)) * 0.1 *
             std::sqrt(g * r);
    };
    const double joint = (std::sqrt(1010.0 / 1000.0) - 1.0) / (rate(8.0) * std::sqrt(1010.0));
    expect_walk_contains(s, 0.0, tolerance, 3.0 * joint, [&](const State& at, double t) {
      const double z = 1.0 + rate(8.0) * std::sqrt(at.temperature) * std::min(t, joint);
      const double m = at.mass * std::pow(z, -2.0 * 7.0), temperature = at.temperature / (z * z);
      if (t <= joint) return State{m, temperature};
      const double y = 1.0 + rate(2.2) * std::sqrt(1000.0) * (t - joint);
      return State{m * std::pow(y, -2.0 * 1.2), 1000.0 / (y * y)};
    });
  }
}

// Starts about p_a, or all a little above it, end on their isentropes. With gamma near 1 the mass falls as p
// does, with a large gamma the temperature does. A knot of the fabric's curve is among them. With backflow
// starts below p_a fill up: V (p_a - p) = gamma R T_a dm.
TEST(wide_sets, rest_holds_all_isentropes) {
  for (const double cp : {1.01, 3.5, 100.0})
    for (const double above : {0.0, 3e-4})
      for (const bool backflow : {false, true}) {
        const double share = 1e-4, pa = 101325.0, r = gas_constant(0.028).middle(), v = 0.01;
        Scene s;
        s.species = {gas(0.028, cp)};
        s.initial_fractions = s.ambient_fractions = {1.0};
        s.ambient_pressure = pa;
        s.initial_pressure = pa * (1.0 + above);
        s.initial_temperature = 400.0;
        s.volume = {{0.0, v}};
        s.fabrics = {{.coefficient = 1e-3,
                      .velocity = enclosure::Curve{{0.0, 0.0}, {pa * above + 1.0, 1.0}, {1e5, 2.0}}}};
        if (backflow) s.holes = {{.area = {{0.0, 1e-3}}, .backflow = true}};
        const Tank tank(s);
        Walk walk(tank, Ball(0.0), box_around(start_of(s), share, backflow ? 3 : 1), 1e-5);
        walk.step(Ball(10.0));
        ASSERT_EQ(walk.time().middle(), 10.0);
        const Balls values = walk.values();
        for (const State& point : points(start_of(s), share)) {
          const double p = point.mass * r * point.temperature / v, q = std::min(1.0, pa / p);
          const double in =
              backflow ? std::max(0.0, pa - p) * v * (1.0 - 1.0 / cp) / (r * s.ambient_temperature) : 0.0;
          const double out = point.mass * (1.0 - std::pow(q, 1.0 - 1.0 / cp)), mass = point.mass - out + in;
          const double t = in > 0.0 ? pa * v / (mass * r) : point.temperature * std::pow(q, 1.0 / cp);
          expect_within(values[0], backflow ? pa : std::min(p, pa), "pressure");
          expect_within(values[1], t, "temperature");
          expect_within(values[3], mass, "mass");
          expect_within(values[5], out, "outflow", 1e-9);
          if (backflow) expect_within(values[7], in, "backflow", 1e-9);
        }
      }
}

// Of starts on both sides of p_a those above lose gas, and those below get some.
TEST(wide_sets, both_sides_of_ambient_pressure_flow) {
  Scene s;
  s.species = {gas(0.028, 3.5)};
  s.initial_fractions = s.ambient_fractions = {1.0};
  s.initial_pressure = s.ambient_pressure;
  s.initial_temperature = s.ambient_temperature;
  s.volume = {{0.0, 0.01}};
  s.holes = {{.area = {{0.0, 1e-3}}, .backflow = true}};
  const Tank tank(s);
  const double share = 1e-3, density = start_of(s).mass / 0.01;
  Walk walk(tank, Ball(0.0), box_around(start_of(s), share, 2), 1e-6);
  walk.step(Ball(1.0));
  const double flow = 1e-3 * std::sqrt(2.0 * density * share * s.ambient_pressure), t = walk.time().middle();
  EXPECT_GE(upper(walk.values()[5]).middle(), 0.9 * flow * t);
  EXPECT_GE(upper(walk.values()[6]).middle(), 0.9 * flow * t);
  EXPECT_LE(lower(walk.values()[5]).middle(), 0.0);
  EXPECT_LE(lower(walk.values()[6]).middle(), 0.0);
}

// A tank at p_a that is fed is not at rest.
TEST(wide_sets, inflow_leaves_ambient_pressure) {
  Draw draw(1);
  Scene s = tank(draw);
  s.initial_pressure = s.ambient_pressure;
  s.holes = {{.area = {{0.0, 1e-4}}}};
  s.inflators = {{.mass_fractions = {1.0}, .mass_flow = {{0.0, 0.5}}, .temperature = {{0.0, 500.0}}}};
  const Tube tube = tube_at(s, 0.01);
  expect_contains(tube, "inflator_0_in_kg", Ball(0.5) * Ball(0.01), 1e-10);
  EXPECT_GT(tube.moments[0].bounds[column(tube, "vent_0_out_kg")].lower, 0.0);
}

/// A closed cubic metre of gas that breathes by a tenth, ten times a second.
Scene breathing_tank(double phase) {
  Scene s;
  s.species = {gas(0.028, 3.5)};
  s.initial_fractions = {1.0};
  s.initial_pressure = 2e5;
  s.initial_temperature = 300.0;
  s.volume = {{0.0, 1.0}};
  s.wave = enclosure::Wave{1.0, 0.1, 10.0, phase};
  return s;
}

// A wave lifts the pressure over the opening of a fabric for a thousandth of its period: a step that sees
// both ends alone would not notice. The excess is a parabola of time.
TEST(wide_sets, opening_for_a_thousandth_of_a_period) {
  Scene s = breathing_tank(0.0);
  const double peak = 2e5 * std::pow(0.9, -1.4), excess = 1e-6 * peak,
               opens = peak - excess - s.ambient_pressure;
  s.fabrics = {
      {.coefficient = 0.01, .velocity = enclosure::Curve{{0.0, 0.0}, {opens, 0.0}, {opens + 1e4, 10.0}}}};
  const Tank tank(s);
  const State centre = start_of(s);
  const double tau = 2.0 * std::acos(-1.0) * 10.0;
  const double half = std::sqrt(2.0 * excess / (1.4 * peak * tau * tau / 9.0));  // [s] V''/V is tau^2/9
  const double density = centre.mass / 0.9, out = density * 1e-5 * excess * 4.0 / 3.0 * half;
  ASSERT_LT(out / centre.mass, 1e-3 * excess / peak);  // so that it does not feel its own leak
  for (const double tolerance : {1e-3, 1e-7}) {
    Walk walk(tank, Ball(0.0), box_around(centre, 0.0, 1), tolerance);
    while (walk.time().middle() < 0.1) walk.step(Ball(0.1));
    expect_within(walk.values()[5], out, "outflow", 0.01);
  }
}

// The centre of a set comes close to the opening of a fabric, one edge passes it: the excess rises as time
// does.
TEST(wide_sets, edge_passes_an_opening) {
  Scene s = breathing_tank(std::acos(-1.0));
  const double pi = std::acos(-1.0), omega = 20.0 * pi, end = 0.5 / omega, share = 1e-3;
  const double v = 1.0 - 0.1 * std::sin(0.5), peak = 2e5 * std::pow(v, -1.4);
  const double opens = peak * (1.0 + share) - s.ambient_pressure;
  s.fabrics = {
      {.coefficient = 0.01, .velocity = enclosure::Curve{{0.0, 0.0}, {opens, 0.0}, {opens + 1e4, 10.0}}}};
  const double excess = 0.99 * share * peak, rise = 1.4 * peak * 0.1 * omega * std::cos(0.5) / v;
  const double out = 0.5 * start_of(s).mass / v * 1e-5 * excess * excess / rise;
  const Tank tank(s);
  Walk walk(tank, Ball(0.0), box_around(start_of(s), share, 1), 1e-4);
  while (walk.time().middle() < end) walk.step(Ball(end));
  EXPECT_GE(upper(walk.values()[5]).middle(), 0.95 * out);
  EXPECT_LE(lower(walk.values()[5]).middle(), 0.0);
}

}  // namespace
