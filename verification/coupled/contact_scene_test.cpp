// SPDX-License-Identifier: Apache-2.0
// The pendulum hits a ball that floats free: books, momenta and order with contact and friction active.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "claim.hpp"
#include "run_case.hpp"

namespace {

using coupled::run_case;
using Eigen::Vector3d;

const std::vector<std::string> kCoarse{"membrane.mesh.levels=2"};  // 320 elements

TEST(contact_scene, books_close_with_contact_and_friction) {
  const auto run = run_case("ball_impact");
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  EXPECT_GT(run.state.step.maximum, 1.2 * run.state.step.minimum) << "steps have to vary for this claim";
  EXPECT_GT(run.state.flows.friction_loss, 0.3);  // [J] of the pendulum's 65
  EXPECT_GT(run.state.flows.contact_impulse, 1.0);
  const double scale = run.state.peaks.energy_scale;
  // Bookkeeping: eps x some 1000 steps of additions.
  EXPECT_LT(run.state.peaks.ledger_residual, 1e-12 * scale);
  EXPECT_LT(run.state.peaks.mass_residual, 1e-12);
  // (K.17) is a trapezium: a point whose slip turns within a step may give a little back, a few 1e-6 of the
  // whole at this step and less at smaller ones.
  for (std::size_t i = 1; i < run.energy.size(); ++i)
    EXPECT_GE(run.energy[i].at("friction_J"),
              run.energy[i - 1].at("friction_J") - 1e-5 * run.state.flows.friction_loss)
        << i;
}

// What contact gives the pendulum along the impactor's path is what its angular momentum gained, but for
// gravity's.
TEST(contact_scene, path_impulse_eq_angular_momentum_that_contact_gave) {
  for (const char* friction : {"0.0", "0.3"}) {
    const auto run = run_case("ball_impact",
                              {std::string("contact.friction=") + friction, "scene.gravity=[0.0, 0.0, 0.0]"});
    ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
    const auto scene = coupled::scene_of("ball_impact");
    const auto& model = scene.pendulum->model;
    const double gained = model.axis_inertia() *
                          (run.state.pendulum->angular_velocity - scene.pendulum->initial.angular_velocity) /
                          model.parameters().impactor_distance;
    claim::expect_near({"K.26", "pendulum strikes a ball, without gravity: impulse along its path [N s]",
                        "eps x 1000 kicks"},
                       run.state.flows.path_impulse, gained, 1e-12 * std::abs(gained));
    // The force leans off the path, the more so with friction: its size has more impulse.
    EXPECT_LT(std::abs(run.state.flows.path_impulse), run.state.flows.contact_impulse) << friction;
  }
}

// Root mean square of the physical drift over the run [J]: its last or largest value alone falls on one phase
// of the skin's vibration.
double drift(const std::string& step, const std::string& friction, const std::string& share) {
  auto overrides = kCoarse;
  overrides.insert(overrides.end(),
                   {"time.step=" + step, "contact.friction=" + friction, "contact.stiffness_share=" + share});
  const auto run = run_case("ball_impact", overrides);
  EXPECT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  double squares = 0.0;
  for (const auto& row : run.energy) squares += row.at("residual_J") * row.at("residual_J");
  return std::sqrt(squares / static_cast<double>(run.energy.size()));
}

// The contact force has a kink where points come into touch, and friction where they begin to slide; a soft
// contact spreads over many points, which average it out. What is left scatters one halving by 0.26, two
// together by 0.12 (five stiffnesses, with and without friction).
TEST(contact_scene, drift_is_second_order_through_an_impact) {
  const auto drifts_at = [](const std::string& friction, const std::string& share) {
    return std::vector<double>{drift("6e-6", friction, share), drift("3e-6", friction, share),
                               drift("1.5e-6", friction, share)};
  };
  const auto mean_order = [](const std::vector<double>& drifts) {
    return std::log2(drifts[0] / drifts[2]) / 2.0;
  };
  for (const char* friction : {"0.0", "0.3"}) {
    const auto drifts = drifts_at(friction, "0.05");
    claim::expect_order({"K.21", std::string("impact on a bag, friction ") + friction + ": drift of energy",
                         "points come into touch one by one: one halving scatters by 0.26"},
                        drifts, 1.7, 2.3);
    EXPECT_NEAR(mean_order(drifts), 2.0, 0.15) << friction;
  }
  const auto stiff = drifts_at("0.0", "1.0");  // the default
  EXPECT_NEAR(mean_order(stiff), 2.0, 0.15);
  EXPECT_NEAR(std::log2(stiff[0] / stiff[1]), 2.0, 0.3);
  EXPECT_NEAR(std::log2(stiff[1] / stiff[2]), 2.0, 0.3);
}

// Momenta of x^{n+1}, v^{n+1/2}, which one step of the central difference carries on exactly.
struct Momenta {
  Vector3d linear = Vector3d::Zero();  // of the bag [kg m/s]
  double about_axis = 0.0;             // of bag and pendulum about the pendulum's axis [kg m2/s]
};

Momenta momenta(const driver::Scene& scene, const driver::State& state) {
  const auto& p = scene.pendulum->model;
  Momenta m;
  const auto x = state.bag->position.map(), v = state.bag->velocity.map();
  for (Eigen::Index a = 0; a < x.cols(); ++a) {
    const double mass = scene.bag->model.node_mass[static_cast<std::size_t>(a)];
    m.linear += mass * v.col(a);
    m.about_axis +=
        mass * p.parameters().axis.dot((x.col(a) - p.parameters().pivot).cross(Vector3d(v.col(a))));
  }
  m.about_axis += p.axis_inertia() * state.pendulum->motion.angular_velocity;
  return m;
}

TEST(contact_scene, momenta_are_conserved_without_supports) {
  for (const char* friction : {"contact.friction=0.0", "contact.friction=0.3"}) {
    auto overrides = kCoarse;
    overrides.push_back(friction);
    const auto scene = coupled::scene_of("ball_impact", overrides);
    driver::State state = driver::make_state(scene);
    const Momenta start = momenta(scene, state);
    Vector3d impulse = Vector3d::Zero();  // on the bag
    double before = 0.0;
    while (state.time < 0.015) {  // the impact lasts from 3 to 17 ms
      driver::step(scene, state, {});
      impulse -= 0.5 * (before + state.step.after) * state.contact.force;
      before = state.step.after;
      state.time += state.step.after;
      ++state.steps;
    }
    const Momenta end = momenta(scene, state);
    EXPECT_GT(impulse.norm(), 1.0) << friction;
    claim::expect_relative({"K.11", "free ball and pendulum: angular momentum about the axis [kg m2/s]",
                            "400 steps of a few roundings of what they pass on; arm 1.3 m"},
                           end.about_axis, start.about_axis, 1e-12);
    claim::expect_near({"K.11", "free ball: momentum less impulse of contact [N s]", "the same 400 steps"},
                       (end.linear - start.linear - impulse).norm(), 0.0, 1e-12 * impulse.norm());
  }
}

// The plate behind a bag is one-sided: nodes behind it are pushed out, and their sum is reported.
TEST(contact_scene, plate_force_is_the_sum_over_the_nodes_behind_it) {
  auto overrides = kCoarse;
  overrides.push_back(
      "membrane.plate={point=[0.112, 0.0, 0.0], normal=[-1.0, 0.0, 0.0]}");  // 2 mm from the ball
  const auto scene = coupled::scene_of("ball_impact", overrides);
  driver::State state = driver::make_state(scene);
  state.bag->position.map().row(0).array() += 0.012;  // 10 mm into the plate
  driver::step(scene, state, {.record = true});
  const auto& model = scene.bag->model;
  double expected = 0.0;
  for (Eigen::Index a = 0; a < scene.bag->initial_position.cols(); ++a)
    expected += *model.description.plates[0].stiffness * model.node_area[static_cast<std::size_t>(a)] *
                std::max(0.0, scene.bag->initial_position(0, a) + 0.012 - 0.112);
  ASSERT_GT(expected, 0.0);
  EXPECT_NEAR(coupled::row_of(driver::history_columns(scene), scene, state).at("plate_force_N") / expected,
              1.0, 1e-13);  // a few dozen additions of one sign
}

// The default stiffness never lets contact govern the step by more than its share of the fabric's omega^2.
TEST(contact_scene, default_stiffness_keeps_contact_within_its_share_of_the_step) {
  for (const char* name : {"ball_impact", "contact_vent", "passenger_pendulum_no_jet"}) {
    const auto scene = coupled::scene_of(name, {"scene.end_time=0.03"});
    driver::State state = driver::make_state(scene);
    double largest = 0.0;
    while (state.time < scene.time.end) {
      driver::step(scene, state, {});
      largest = std::max(largest, state.step.shares.contact / state.step.shares.total());
      state.time += state.step.after;
      ++state.steps;
    }
    EXPECT_LE(largest, 0.5) << name;   // share 1: 1/(1 + 1)
    EXPECT_GT(largest, 0.01) << name;  // it touches; large elements do so in part only
  }
}

// Until the paper's scene comes into touch a step may cost 2 % more for the broad phase, the work on 55 of
// 2744 elements; a look at one costs about as much as that work on three.
TEST(contact_scene, broad_phase_looks_at_few_elements_until_something_touches) {
  for (const char* name : {"passenger_pendulum", "passenger_pendulum_no_jet"}) {
    const auto scene = coupled::scene_of(name);
    driver::State state = driver::make_state(scene);
    int looks = 0, levels = 0;
    for (;; ++levels) {
      driver::step(scene, state, {});
      if (state.contact.area > 0.0) break;
      looks = state.contact_cache->looks;
      state.time += state.step.after;
      ++state.steps;
    }
    EXPECT_GT(levels, 100) << name;
    EXPECT_LT(3.0 * looks, 0.02 * scene.contact->element_count() * levels) << name;
    EXPECT_GT(state.contact_cache->skips, 0.8 * levels) << name;
  }
}

// Out of reach a level costs a comparison (0.1 % of the step's time); one in a hundred looks at the skin at
// most.
TEST(contact_scene, broad_phase_is_idle_while_nothing_is_near) {
  const auto run =
      run_case("passenger_pendulum_no_jet", {"pendulum.pivot=[1.5, 0.0, 1.31]", "scene.end_time=0.03"});
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  EXPECT_EQ(run.state.peaks.first_contact, -1.0);
  EXPECT_GT(run.state.contact_cache->skips, 0.99 * static_cast<double>(run.state.steps));
}

}  // namespace
