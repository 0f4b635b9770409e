// SPDX-License-Identifier: Apache-2.0
// Scenes that their caller steps: the bits of a run, copies, and what the caller sets with its balance.
#include "engine/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/controls.hpp"
#include "engine/drift.hpp"
#include "engine/saved_state.hpp"
#include "refusal.hpp"
#include "run_simulation.hpp"

namespace {

using driver::Simulation, Eigen::Vector3d, coupled::drift, coupled::Overrides, coupled::shared_scene_of,
    coupled::simulation_of;

// Rows of a simulation that `drive` takes to its end.
std::vector<coupled::Row> rows_of(const std::shared_ptr<const driver::Scene>& scene,
                                  const std::function<void(Simulation&)>& drive) {
  std::vector<coupled::Row> rows;
  const auto columns = driver::history_columns(*scene);
  Simulation simulation(scene);
  simulation.watch([&](bool recorded, const driver::State& now) {
    if (recorded) rows.push_back(coupled::row_of(columns, *scene, now));
  });
  drive(simulation);
  EXPECT_TRUE(simulation.ended());
  simulation.evaluate();
  return rows;
}

void expect_same(const std::vector<coupled::Row>& mine, const std::vector<coupled::Row>& reference) {
  ASSERT_EQ(mine.size(), reference.size());
  for (std::size_t i = 0; i < mine.size(); ++i)
    for (const auto& [name, value] : reference[i]) {
      const double own = mine[i].at(name);
      ASSERT_TRUE(own == value || (std::isnan(own) && std::isnan(value))) << name << " in row " << i;
    }
}

struct Shipped {
  const char* name;
  Overrides overrides;
};

class simulation_of_case : public testing::TestWithParam<Shipped> {};

TEST_P(simulation_of_case, steps_with_the_bits_of_a_run) {
  const auto scene = shared_scene_of(GetParam().name, GetParam().overrides);
  expect_same(rows_of(scene, [](Simulation& s) { s.advance(s.scene().time.end); }),
              coupled::run_of(*scene).history);
}

INSTANTIATE_TEST_SUITE_P(shipped, simulation_of_case,
                         testing::Values(Shipped{"rigid_tank", {}}, Shipped{"tank_triggers", {}},
                                         Shipped{"piston_leak", {}}, Shipped{"plate_jet", {}},
                                         Shipped{"pendulum_pulse", {}}, Shipped{"ball_impact", {}},
                                         Shipped{"tank_fixed_steps", {}}, Shipped{"rail_stop", {}},
                                         Shipped{"free_headform", {"scene.end_time=0.02"}},
                                         Shipped{"sled_pulse", {"scene.end_time=0.01"}},
                                         Shipped{"passenger_sharp", {"scene.end_time=0.006"}},
                                         Shipped{"driver_folded", {"scene.end_time=0.0005"}}),
                         [](const auto& tested) { return std::string(tested.param.name); });

// Each half of each step by itself, and copies in place of the original.
TEST(simulation, halves_and_copies_have_the_bits_of_a_run) {
  const auto scene = shared_scene_of("passenger_sharp", {"scene.end_time=0.004"});
  const auto columns = driver::history_columns(*scene);
  coupled::Row last;
  Simulation simulation(scene);
  while (!simulation.ended()) {
    if (simulation.state().steps % 3 == 0) simulation.evaluate();
    if (simulation.state().steps % 25 == 0) {
      Simulation copy(simulation);
      copy.step(2);  // of which the original must not know
      copy = simulation;
      simulation = copy;
    }
    simulation.step();
  }
  simulation.evaluate();
  last = coupled::row_of(columns, simulation.scene(), simulation.state());
  expect_same({last}, {coupled::run_of(*scene).history.back()});
}

TEST(simulation, values_of_the_case_change_no_bit) {
  const auto scene = shared_scene_of("passenger_sharp", {"scene.end_time=0.004"});
  const auto rows = rows_of(scene, [](Simulation& s) {
    const auto& vents = s.scene().gas->model.vents;
    while (!s.ended()) {
      for (std::size_t i = 0; i < vents.size(); ++i) set_vent_area(s, i, vents[i].area);
      set_ambient(s, s.scene().ambient.pressure, s.scene().ambient.temperature);
      const jet::JetModel& jet = s.scene().jets[0].field.model();
      set_outlet(s, 0, jet.centre, jet.axis);
      own_force(s).setZero();
      s.step();
    }
  });
  expect_same(rows, coupled::run_of(*scene).history);
}

TEST(simulation, meets_times_exactly) {
  Simulation simulation = simulation_of("ball_impact");
  for (const double time : {0.00031, 0.0031, 0.01}) {
    simulation.advance_exactly(time);
    EXPECT_EQ(simulation.state().time, time);
  }
  simulation.evaluate();
  const double step = simulation.state().step.after;
  EXPECT_NE(refusal([&] { simulation.advance_exactly(0.01 + 0.5 * step); }).find("evaluated"),
            std::string::npos);
  simulation.advance(0.01 + 0.5 * step);
  EXPECT_EQ(simulation.state().time, 0.01 + step);
  EXPECT_LT(drift(simulation), 1e-3);
}

// Saved at each tenth step of a scene with all kinds of settings, and restored into another simulation.
TEST(simulation, saved_states_go_on_with_the_same_bits) {
  const Overrides end{"scene.end_time=0.004"};
  Simulation original = simulation_of("passenger_sharp", end);
  Simulation other = simulation_of("passenger_sharp", end);
  const Vector3d centre = original.scene().jets[0].field.model().centre;
  while (!original.ended()) {
    const double t = original.state().time;
    set_vent_area(original, 0, 0.01 + t);
    set_ambient(original, 1e5 + 1e6 * t, 300.0);
    set_inflow(original, 0, 3.0 + 100.0 * t, 400.0);
    set_outlet(original, 0, centre, {1.0, 0.01 * t, 0.0});
    own_force(original).setConstant(1e-3 * t);
    if (original.state().steps % 20 == 10) original.evaluate();
    if (original.state().steps % 10 == 0) {
      restore(other, saved(original));
      other.step();
      restore(original, saved(original));
      original.step();
      const driver::State &mine = other.state(), &theirs = original.state();
      ASSERT_EQ(mine.bag->position.map(), theirs.bag->position.map());
      ASSERT_EQ(mine.gas.internal_energy, theirs.gas.internal_energy);
      ASSERT_EQ(mine.level.kick_residual, theirs.level.kick_residual);
      ASSERT_EQ(mine.jets[0].force, theirs.jets[0].force);
    } else {
      original.step();
    }
  }
  EXPECT_GT(original.state().peaks.jet_force, 1.0);
}

// A folded bag whose layers touch and rub: what the contact remembers goes along.
TEST(simulation, saved_states_of_touching_layers_go_on_with_the_same_bits) {
  const Overrides overrides{"scene.end_time=0.001", "membrane.self_contact.friction=0.3"};
  Simulation original = simulation_of("driver_folded", overrides),
             other = simulation_of("driver_folded", overrides);
  original.step(40);
  for (int n = 0; n < 2; ++n) {
    restore(other, saved(original));
    original.step(5);
    other.step(5);
    const driver::State &mine = other.state(), &theirs = original.state();
    EXPECT_GT(theirs.skin_contact.contacts, 10);
    EXPECT_GT(theirs.flows.friction_loss, 0.0);
    EXPECT_EQ(mine.bag->position.map(), theirs.bag->position.map());
    EXPECT_EQ(mine.skin_contact.energy, theirs.skin_contact.energy);
    EXPECT_EQ(mine.flows.friction_loss, theirs.flows.friction_loss);
    EXPECT_EQ(mine.step.after, theirs.step.after);
    original.evaluate();
  }
}

TEST(simulation, damaged_states_are_refused) {
  Simulation simulation = simulation_of("tank_triggers", {"scene.end_time=0.01"});
  simulation.step(3);
  const std::string bytes = saved(simulation);
  EXPECT_EQ(refusal([&] { restore(simulation, bytes); }), "accepted");
  for (std::size_t cut = 0; cut < bytes.size(); cut += 7)
    EXPECT_NE(refusal([&] { restore(simulation, bytes.substr(0, cut)); }), "accepted") << cut;
  EXPECT_NE(refusal([&] { restore(simulation, bytes + "x"); }), "accepted");
  Simulation other = simulation_of("rigid_tank");
  EXPECT_NE(refusal([&] { restore(other, bytes); }).find("allowed: of this case and build"),
            std::string::npos);
  EXPECT_EQ(simulation.state().steps, 3);
}

// A force that blows the skin up: the failure is named, and named again.
TEST(simulation, failures_stay) {
  Simulation simulation = simulation_of("ball_impact");
  own_force(simulation).setConstant(std::nan(""));
  EXPECT_THROW(simulation.step(10), driver::SimulationError);
  EXPECT_NE(simulation.now().failure.find("S8_advance"), std::string::npos) << simulation.now().failure;
  EXPECT_THROW(simulation.step(), driver::SimulationError);
  EXPECT_EQ(simulation.state().steps, 0);
}

}  // namespace
