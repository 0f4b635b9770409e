// SPDX-License-Identifier: Apache-2.0
// The skin's contact with itself in whole runs: two discs that the pressure outside lays on each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "case_folder.hpp"
#include "claim.hpp"
#include "engine/step.hpp"
#include "run_case.hpp"

namespace {

constexpr double kThickness = 0.01, kStiffness = 5e5;  // [m], [N/m3]
constexpr const char* kSuction = R"(
[scene]
name = "suction"
end_time = 0.03
[fabric]
young_modulus = 60.0e6
poisson_ratio = 0.3
density = 620.0
thickness = 0.5e-3
[membrane]
mesh = { generator = "driver", radius = 0.3, rings = 6, vent_ring = 4 }
overpressure = { time = [0.0, 0.02], value = [0.0, -500.0] }
fixed_panels = ["attachment"]
mass_damping = 200.0
self_contact = { thickness = 0.01, stiffness = 5.0e5 }
)";

driver::Scene suction(const std::vector<std::string>& overrides = {}) {
  const coupled::Folder folder;
  return coupled::scene_of_text(folder, kSuction, overrides);
}

TEST(self_contact, bears_the_pressure_at_the_distance_of_its_law) {
  // All nodes slide along x alone, so the discs stay flat, and each point bears its own pressure.
  const auto run = coupled::run_of(
      suction({"scene.end_time=0.2", "membrane.mass_damping=600.0",
               "membrane.roller=[{low=[-1.0,-1.0,-1.0],high=[1.0,1.0,1.0],directions=[\"y\",\"z\"]}]"}));
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  const auto position = run.state.bag->position.map();
  const double distance = kThickness - 500.0 / kStiffness;
  int counted = 0;
  // Far from the rim and from the attachment, which the fabric's tension holds.
  for (Eigen::Index n = 0; n < position.cols(); ++n) {
    const double r = position.col(n).tail<2>().norm();
    if (r < 0.14 || r > 0.2) continue;
    double nearest = 1.0;
    for (Eigen::Index m = 0; m < position.cols(); ++m)
      if (m != n && (position.col(m) - position.col(n)).tail<2>().norm() < 1e-9)
        nearest = std::abs(position(0, m) - position(0, n));
    EXPECT_NEAR(nearest, distance, 0.05 * distance) << r;
    ++counted;
  }
  EXPECT_GT(counted, 20);
}

TEST(self_contact, energy_drifts_with_the_square_of_the_step) {
  for (const char* friction : {"0.0", "0.3"}) {
    std::vector<double> drifts;
    for (const char* step : {"time.step=30e-6", "time.step=15e-6", "time.step=7.5e-6"}) {
      const auto run = coupled::run_of(suction({step, "membrane.overpressure.value=[0.0,-200.0]",
                                                std::string("membrane.self_contact.friction=") + friction}));
      ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
      EXPECT_GT(run.energy.back().at("self_contact_J"), 0.01);
      if (friction != std::string("0.0")) {
        EXPECT_GT(run.energy.back().at("friction_J"), 1e-4);
      }
      drifts.push_back(run.state.peaks.energy_residual);
    }
    // Order 1.7 to 2.7: where layers begin to touch there is a kink.
    EXPECT_GT(drifts[0] / drifts[2], 10.0) << friction;
    EXPECT_LT(drifts[0] / drifts[2], 40.0) << friction;
  }
}

TEST(self_contact, changes_no_bit_while_nothing_touches) {
  const std::vector<std::string> until{"scene.end_time=0.004"};
  std::vector<std::string> with = until;
  with.emplace_back("membrane.self_contact.thickness=0.005");
  const auto far = coupled::run_case("sphere_inflation", with),
             without = coupled::run_case("sphere_inflation", until);
  EXPECT_EQ(far.state.steps, without.state.steps);
  EXPECT_EQ(far.state.bag->position.map(), without.state.bag->position.map());
  EXPECT_EQ(far.state.gas.internal_energy, without.state.gas.internal_energy);
  EXPECT_EQ(far.state.peaks.self_contact.contacts, 0);
  EXPECT_EQ(far.history.back().at("self_gap_m"), 0.005);
  EXPECT_EQ(without.history.back().count("self_gap_m"), 0u);
  EXPECT_EQ(without.energy.back().count("self_contact_J"), 0u);
}

TEST(self_contact, closes_by_a_share_of_the_thickness_in_a_step) {
  const auto scene = suction({"membrane.overpressure=-2.0e4", "membrane.self_contact.stiffness=5.0e7"});
  driver::State state = driver::make_state(scene);
  double largest = 0.0;
  bool asked = false;
  // Until the middles meet: the ahead of (K.47) is that of the last step.
  while (state.time < 0.001) {
    driver::evaluate_level(scene, state, {});
    const double ahead =
        state.step.before > 0.0 ? state.skin_contact.approach * state.step.after / state.step.before : 0.0;
    largest = std::max(largest, ahead);
    asked = asked || ahead > 0.0;
    driver::advance_level(scene, state, {});
    state.time += state.step.after;
    ++state.steps;
  }
  EXPECT_TRUE(asked);
  EXPECT_GT(state.step.approach_limited, 0);
  EXPECT_LE(largest, 0.2 * (1.0 + 1e-12));
}

// The discs stay flat, and all their nodes meet in one step.
TEST(self_contact, discs_that_clap_flat_keep_their_energy) {
  for (const char* safety : {"0.95", "0.8", "0.65", "0.5"}) {
    const auto run = coupled::run_of(
        suction({"scene.end_time=0.002", std::string("time.safety=") + safety, "membrane.mass_damping=0.0",
                 "membrane.overpressure={time=[0.0,0.001,0.0011],value=[-2000.0,-2000.0,0.0]}",
                 "membrane.fixed_panels=[]", "membrane.self_contact={thickness=0.01}",
                 "membrane.roller=[{low=[-1.0,-1.0,-1.0],high=[1.0,1.0,1.0],directions=[\"y\",\"z\"]}]"}));
    EXPECT_GT(run.state.peaks.self_contact.contacts, 100);
    EXPECT_GT(run.state.step.approach_limited, 20);
    claim::expect_near({"K.48", "two discs that clap flat: drift of the energy, of its largest",
                        "two kinks of 1e-3 each, and as much again as the step changes"},
                       run.state.peaks.energy_residual / run.state.peaks.energy_scale, 0.0, 4e-3);
  }
}

TEST(self_contact, says_how_far_a_given_step_closes_layers) {
  const auto run = coupled::run_of(suction({"time.step=40e-6", "scene.end_time=0.01"}));
  EXPECT_EQ(run.state.step.approach_limited, 0);
  EXPECT_GT(run.state.step.approach, 0.0);
  EXPECT_LT(run.state.step.approach, 0.3);
}

// Soft layers that hardly brake, and some that nearly hold.
TEST(self_contact, layers_that_meet_end_the_run_with_a_stiffness_that_keeps_them_apart) {
  const std::string key = " s; try membrane.self_contact.stiffness = ";
  for (const char* load : {"-2.0e3", "-5.0e3", "-8.0e4"})
    for (const char* soft : {"1e3", "1e5"}) {
      const std::vector<std::string> overrides{std::string("membrane.overpressure=") + load,
                                               "scene.end_time=0.004"};
      const auto run_at = [&](const std::string& stiffness) {
        auto all = overrides;
        all.push_back("membrane.self_contact.stiffness=" + stiffness);
        return coupled::run_of(suction(all));
      };
      const auto run = run_at(soft);
      ASSERT_EQ(run.outcome.status, driver::RunStatus::failed);
      for (const char* word : {"stage S4_contact at ", " met; ", "(elements ", " against ",
                               ", from 0) in a step of ", key.c_str(), "(now 1e+0", "time.safety"})
        EXPECT_NE(run.outcome.message.find(word), std::string::npos) << run.outcome.message;
      const double advised =
          std::stod(run.outcome.message.substr(run.outcome.message.find(key) + key.size()));
      EXPECT_GE(advised, 4.0 * std::stod(soft));
      const auto stiffer = run_at(std::to_string(advised));
      EXPECT_NE(stiffer.outcome.status, driver::RunStatus::failed) << load << stiffer.outcome.message;
      EXPECT_EQ(stiffer.state.time, 0.004) << load << stiffer.outcome.message;
      EXPECT_GT(stiffer.state.peaks.self_contact.gap, 0.0);
    }
}

TEST(self_contact, stiffness_that_asks_for_steps_without_end_is_named) {
  const auto run = coupled::run_of(suction({"membrane.self_contact.stiffness=1e25"}));
  ASSERT_EQ(run.outcome.status, driver::RunStatus::failed);
  for (const char* word : {"more than 1e9 steps of", "for layers of the skin that touch or may soon",
                           "lower membrane.self_contact.stiffness or membrane.self_contact.stiffness_share"})
    EXPECT_NE(run.outcome.message.find(word), std::string::npos) << run.outcome.message;
}

TEST(self_contact, record_says_when_layers_touch) {
  const auto run = coupled::run_of(suction());
  const driver::SelfContactRecord& record = run.state.peaks.self_contact;
  const auto at = [](const char* name) { return [name](const coupled::Row& row) { return row.at(name); }; };
  EXPECT_EQ(record.limited_at_start, 0) << "at the rim there are neighbours";
  EXPECT_GE(record.contacts, std::ranges::max(run.history, {}, at("self_contacts")).at("self_contacts"));
  EXPECT_LE(record.gap, std::ranges::min(run.history, {}, at("self_gap_m")).at("self_gap_m"));
  EXPECT_TRUE(std::isinf(record.one_room_from)) << "pressed together to the end";
  EXPECT_GT(run.state.step.self_contact_sum, 0.0);
  EXPECT_LT(run.state.step.self_contact_sum, run.state.step.share_sums.total());
}

}  // namespace
