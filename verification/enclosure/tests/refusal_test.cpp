// SPDX-License-Identifier: Apache-2.0
// What is refused, with its reason.
#include "known.hpp"
#include "network.hpp"

namespace {

using namespace test;
using enclosure::Scene;

template <class Error>
void expect_refused(const Scene& scene, const std::string& reason, double time = 0.01) {
  try {
    tube_at(scene, time);
    ADD_FAILURE() << "not refused: " << reason;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
  }
}

TEST(enclosure_refuses, bad_input) {
  Draw draw(1);
  const Scene good = tank(draw);
  Scene s = good;
  s.initial_fractions = {0.5};
  expect_refused<std::invalid_argument>(s, "sum is not 1");
  s = good;
  s.volume.clear();
  expect_refused<std::invalid_argument>(s, "the volume has no knot");
  s = good;
  s.inflators = {{.mass_fractions = {1.0}, .mass_flow = {{0.0, -1.0}}, .temperature = {{0.0, 300.0}}}};
  expect_refused<std::invalid_argument>(s, "a mass flow is negative");
  expect_refused<std::invalid_argument>(good, "the times need to be 0 or later, finite", -1.0);
}

TEST(enclosure_refuses, what_the_proof_needs_otherwise) {
  Draw draw(1);
  Scene s = tank(draw);
  s.holes = {{.area = {{0.0, -1e-3}}}};
  expect_refused<std::invalid_argument>(s, "the area of a hole is negative");
  s.holes.clear();
  s.species = {gas(0.028, 0.5)};
  expect_refused<enclosure::Refusal>(s, "cp of gas is not above its gas constant");
}

TEST(enclosure_refuses, law_with_a_jump) {
  Draw draw(1);
  Scene s = tank(draw);
  s.fabrics = {{.coefficient = 1.0, .velocity = enclosure::Curve{{0.0, 0.0}, {1e3, 1.0}, {1e3, 2.0}}}};
  expect_refused<enclosure::Refusal>(s, "jumps");
}

TEST(enclosure_refuses, evacuated_start_into_a_vacuum) {
  Draw draw(1);
  Scene s = tank(draw);
  s.initial_pressure = s.ambient_pressure = 0.0;
  expect_refused<enclosure::Refusal>(s, "evacuated start into a vacuum");
}

// One ball is one time only if it is one event: of the same level, or of sensors of time.
TEST(enclosure_refuses, order_of_two_events_with_one_ball) {
  Scene s;
  s.sensors = {{.threshold = 1e4}, {.threshold = 2e4}};
  s.gates = {{.logic = enclosure::Gate::Logic::all, .inputs = {0, 1}}};
  const Ball t = hull(Ball(0.1), Ball(0.2));
  EXPECT_THROW(enclosure::switching_times(s, {{t}, {t}}), enclosure::Refusal);
  s.sensors[1].threshold = 1e4;
  EXPECT_EQ(enclosure::switching_times(s, {{t}, {t}})[2].size(), 1);
  s.gates.insert(s.gates.begin(), {.logic = enclosure::Gate::Logic::all, .inputs = {1}, .delay = 0.01});
  s.gates[1].inputs = {0, 2};
  EXPECT_THROW(enclosure::switching_times(s, {{t}, {t}}), enclosure::Refusal);  // between 0.1 and 0.21
  s.sensors = {{.switching = {0.25}}, {.switching = {0.25}}};
  EXPECT_EQ(enclosure::switching_times(s, {{}, {}})[3].size(), 1);
}

TEST(enclosure_refuses, temperature_out_of_range) {
  Draw draw(1);
  Scene s = tank(draw);
  s.species[0].constant_cp = false;
  s.species[0].minimum_temperature = 200.0;
  s.species[0].maximum_temperature = 1600.0;
  s.inflators = {{.mass_fractions = {1.0}, .mass_flow = {{0.0, 10.0}}, .temperature = {{0.0, 1500.0}}}};
  expect_refused<enclosure::Refusal>(s, "is not within 200 to 1600 K");
}

TEST(enclosure_refuses, what_takes_too_long) {
  Draw draw(1);
  Scene s = tank(draw);
  s.wall_conductance = 1.0;
  try {
    enclosure::enclose(s, {.times = {1.0}, .width = 1e-12, .longest = 0.0});
    ADD_FAILURE() << "not refused";
  } catch (const enclosure::Refusal& refusal) {
    EXPECT_NE(std::string(refusal.what()).find("takes longer than"), std::string::npos);
  }
}

}  // namespace
