// SPDX-License-Identifier: Apache-2.0
// What the caller of a simulation sets: impactors, forces, gravity, gas, each with its balance.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "claim.hpp"
#include "engine/controls.hpp"
#include "engine/impactor.hpp"
#include "refusal.hpp"
#include "run_simulation.hpp"

namespace {

using driver::Simulation, Eigen::Vector3d, coupled::drift, coupled::Overrides, coupled::shared_scene_of,
    coupled::simulation_of;

// Takes the headform's scene to its end; `move` does the dynamics of its impactor, with the contact's force
// on it, the kick's length and the step.
using Mover = std::function<void(driver::ImpactorPlace&, const Vector3d&, double, double)>;
Simulation drive_headform(const Overrides& overrides, const Mover& move) {
  Simulation simulation = simulation_of("guided_headform", overrides);
  const auto& body = simulation.scene().body->model.parameters();
  driver::ImpactorPlace place{body.centre, body.axes, body.velocity};
  for (double before = 0.0;; simulation.step()) {
    set_impactor(simulation, place);
    simulation.evaluate();
    if (simulation.ended()) break;
    const double after = simulation.state().step.after;
    move(place, simulation.state().contact.force, 0.5 * (before + after), after);
    before = after;
  }
  return simulation;
}

double value_at_end(const Simulation& simulation, const std::string& column) {
  return coupled::row_of(driver::history_columns(simulation.scene()), simulation.scene(), simulation.state())
      .at(column);
}

TEST(simulation, own_impactor_by_the_same_arithmetic_has_the_bits_of_the_scenes) {
  const Overrides overrides{"scene.end_time=0.03"};
  const auto scene = shared_scene_of("guided_headform", overrides);
  const coupling::RigidBodyModel& model = scene->body->model;
  coupling::RigidBodyState motion = model.initial();
  const Simulation simulation = drive_headform(
      overrides, [&](driver::ImpactorPlace& place, const Vector3d& force, double tau, double step) {
        model.advance(motion, {force, Vector3d::Zero()}, tau, step);
        place = {motion.centre, motion.axes, motion.velocity};
      });
  const auto last = coupled::run_of(*scene).history.back();
  EXPECT_GT(last.at("contact_force_N"), 100.0);
  EXPECT_EQ(value_at_end(simulation, "impactor_displacement_m"), last.at("impactor_displacement_m"));
  EXPECT_EQ(value_at_end(simulation, "pressure_Pa"), last.at("pressure_Pa"));
  EXPECT_LT(drift(simulation), 1e-3);
}

// The caller takes over a body in contact and moves it on as it would have moved: nothing appears in the
// balance.
TEST(simulation, a_body_is_taken_over_without_a_jump_of_the_energy) {
  Simulation simulation =
      simulation_of("guided_headform", {"scene.end_time=0.04", "contact.stiffness_share=0.02"});
  simulation.record_all(true);
  simulation.advance(0.03);
  simulation.step();
  const coupling::RigidBodyModel& model = simulation.scene().body->model;
  coupling::RigidBodyState motion = simulation.state().body->motion;
  const double before = simulation.state().level.energy_residual,
               kick = simulation.state().level.kick_residual;
  double largest = 0.0;
  for (int k = 0; k < 20; ++k) {
    set_impactor(simulation, {motion.centre, motion.axes, motion.velocity, model.angular_velocity(motion)});
    simulation.evaluate();
    const driver::State& now = simulation.state();
    model.advance(motion, {now.contact.force, now.contact.couple}, 0.5 * (now.step.before + now.step.after),
                  now.step.after);
    set_impactor_speed(simulation, motion.velocity, model.angular_velocity(motion));
    simulation.step();
    largest = std::max(largest, std::abs(simulation.state().level.energy_residual - before));
  }
  EXPECT_GT(simulation.state().contact.force.norm(), 100.0);
  EXPECT_LT(largest, 0.02);  // [J], of some 150 that the body had
  EXPECT_LT(std::abs(simulation.state().level.kick_residual - kick), 1e-9);
}

// A sphere of the caller turns against a ball that it presses: its axes alone tell the turn, its speed only
// how it goes on.
TEST(simulation, friction_feels_the_turn_of_the_axes) {
  const auto spun = [](double rate_given) {
    Simulation simulation = simulation_of(
        "ball_impact", {"unset pendulum", "impactor.centre=[-0.152,0,0]", "impactor.shape.type=sphere",
                        "impactor.shape.radius=0.041", "impactor.motion.type=free", "impactor.motion.mass=1",
                        "impactor.motion.inertia=[1e-3,1e-3,1e-3]", "scene.end_time=0.008"});
    constexpr double rate = 40.0, speed = 2.0;  // [rad/s] about z, [m/s] along x
    while (!simulation.ended()) {
      const double t = simulation.state().time;
      const Eigen::Matrix3d axes = driver::turned(Eigen::Matrix3d::Identity(), {0.0, 0.0, rate * t});
      set_impactor(simulation,
                   {{-0.152 + speed * t, 0.0, 0.0}, axes, {speed, 0.0, 0.0}, {0.0, 0.0, rate_given}});
      simulation.step();
    }
    EXPECT_LT(drift(simulation), 1e-3);
    return simulation.state().flows;
  };
  const driver::Flows with = spun(40.0), without = spun(0.0);
  EXPECT_GT(with.friction_loss, 0.05);
  EXPECT_NEAR(without.friction_loss, with.friction_loss,
              1e-6 * with.friction_loss);  // roundings of the turns
  EXPECT_NEAR(without.driving_work, with.driving_work, 1e-6 * with.driving_work);
}

// In a stiff contact that bounces, roundings grow: to 4e-7 in 30 ms.
TEST(simulation, own_impactor_follows_the_scenes) {
  const Overrides overrides{"scene.end_time=0.03", "contact.stiffness_share=0.02"};
  const auto scene = shared_scene_of("guided_headform", overrides);
  const Vector3d along = scene->body->model.parameters().rail->direction;
  const double mass = scene->body->model.parameters().mass;
  const Simulation simulation = drive_headform(
      overrides, [&](driver::ImpactorPlace& place, const Vector3d& force, double tau, double step) {
        place.velocity += tau / mass * force.dot(along) * along;
        place.centre += step * place.velocity;
      });
  const auto last = coupled::run_of(*scene).history.back();
  EXPECT_GT(last.at("contact_force_N"), 100.0);
  claim::expect_relative({"K.53", "own guided impactor in the loop, displacement at 30 ms [m]",
                          "roundings that contact amplifies"},
                         value_at_end(simulation, "impactor_displacement_m"),
                         last.at("impactor_displacement_m"), 1e-9);
}

// Weights as forces of the caller: those of the scene's gravity.
TEST(simulation, own_forces_do_the_work_of_gravity) {
  const Overrides alone{"unset pendulum", "unset contact", "scene.end_time=0.01"};
  Overrides fall = alone;
  fall.push_back("scene.gravity={time=[0,1],value=[[0,0,-50],[0,0,-50]]}");
  const auto reference = coupled::run_of(*shared_scene_of("ball_impact", fall));
  Simulation simulation = simulation_of("ball_impact", alone);
  const auto& mass = simulation.scene().bag->model.node_mass;
  auto force = own_force(simulation);
  for (Eigen::Index n = 0; n < force.cols(); ++n)
    force.col(n) << 0.0, 0.0, -50.0 * mass[static_cast<std::size_t>(n)];
  simulation.advance(0.01);
  simulation.evaluate();
  double all = 0.0, moment = 0.0;
  for (Eigen::Index n = 0; n < force.cols(); ++n) {
    const double m = mass[static_cast<std::size_t>(n)];
    all += m;
    moment +=
        m * (simulation.state().bag->position.map()(2, n) - simulation.scene().bag->initial_position(2, n));
  }
  claim::expect_relative(
      {"K.42", "own forces of the size of the weight: fall of a ball in 10 ms [m]", "eps x steps"},
      moment / all, -0.5 * 50.0 * 1e-4, 1e-11);
  claim::expect_relative({"K.42", "own forces of the size of the weight: their work [J]", "eps x steps"},
                         simulation.state().level.flows.driving_work,
                         reference.state.level.flows.driving_work, 1e-9);
  EXPECT_LT(drift(simulation), 1e-3);
}

// Gravity set before each step, as the mean over that kick: the table's.
TEST(simulation, gravity_by_steps_follows_the_table) {
  const Overrides end{"scene.end_time=0.02"};
  const auto reference = coupled::run_of(*shared_scene_of("sled_pulse", end));
  auto overrides = end;
  overrides.push_back("unset scene.gravity");
  Simulation simulation = simulation_of("sled_pulse", overrides);
  while (!simulation.ended()) {
    set_gravity(simulation, {-250.0 * simulation.state().time / 0.03, 0.0, 0.0});
    simulation.step();
  }
  simulation.evaluate();
  const double there = reference.history.back().at("impactor_velocity_m_s");
  claim::expect_relative({"K.53", "sled pulse set step by step, impactor's velocity at 20 ms [m/s]",
                          "value at n in place of the mean over the kick: a step in time, 1e-3"},
                         value_at_end(simulation, "impactor_velocity_m_s"), there, 1e-3);
  EXPECT_LT(drift(simulation), 1e-3);
}

// Pressure outside that falls, a vent and an inflow that the caller moves, an outlet that turns: all balances
// hold.
TEST(simulation, what_the_caller_sets_is_in_the_balance) {
  Simulation simulation = simulation_of("passenger_sharp", {"scene.end_time=0.02"});
  const auto& scene = simulation.scene();
  const Vector3d centre = scene.jets[0].field.model().centre, axis = scene.jets[0].field.model().axis;
  while (!simulation.ended()) {
    const double t = simulation.state().time;
    set_ambient(simulation, 101325.0 - 1e6 * t, 293.0);
    set_vent_area(simulation, 0, 1e-3 * (1.0 + std::sin(500.0 * t)));
    set_inflow(simulation, 0, 4.0 * std::sin(100.0 * t), 350.0);
    set_outlet(simulation, 0, centre, axis + 0.2 * std::sin(300.0 * t) * Vector3d::UnitZ());
    simulation.step();
  }
  simulation.evaluate();
  EXPECT_LT(drift(simulation), 2e-3);
  EXPECT_LT(simulation.state().peaks.mass_residual, 1e-12);
  EXPECT_GT(simulation.state().peaks.jet_force, 100.0);
  // 4 (1 - cos 2) / 100 kg, in steps that hold the value at their beginning
  claim::expect_relative(
      {"G.9", "inflow set step by step, mass in 20 ms [kg]", "first order in steps of 50 us, 5e-3"},
      simulation.state().flows.mass_in, 0.04 * (1.0 - std::cos(2.0)), 5e-3);
}

// An outlet that its module pulls out of the bag, by jumps and step by step; the next step's bits are those
// of the last place that was accepted.
TEST(simulation, outlets_outside_the_bag_are_refused) {
  Simulation simulation = simulation_of("passenger_sharp", {"scene.end_time=0.001"});
  const jet::JetModel jet = simulation.scene().jets[0].field.model();
  const auto moved = [&](double way) {
    return refusal([&] { set_outlet(simulation, 0, jet.centre + way * jet.axis, jet.axis); });
  };
  for (const double way : {-0.5, -0.05, 5.0})
    EXPECT_EQ(moved(way).rfind("centre: the outlet's point [", 0), 0u) << moved(way);
  EXPECT_NE(moved(-0.05).find("m is outside the bag; allowed: an outlet inside it"), std::string::npos);
  EXPECT_NE(moved(-0.05).find("moved 0.05"), std::string::npos) << moved(-0.05);
  EXPECT_EQ(moved(0.02), "accepted");
  EXPECT_EQ((simulation.scene().jets[0].field.model().centre - jet.centre).norm(), 0.02);
  double way = 0.0;
  while (moved(way) == "accepted" && way > -1.0) way -= 1e-3;
  EXPECT_GT(way, -0.1 * jet.short_side - 2e-3);
  EXPECT_NE(refusal([&] { set_outlet(simulation, 0, jet.centre, -jet.axis); }).find("is outside the bag"),
            std::string::npos);
}

TEST(simulation, external_sensor_opens_a_vent) {
  const Overrides overrides{"sensor=[{name=\"controller\",external=true}]", "unset trigger", "unset inflator",
                            "vent=[{area=1e-3,discharge_coefficient=0.6,trigger=\"controller\"}]",
                            "gas.initial.pressure=2e5"};
  Simulation simulation = simulation_of("tank_triggers", overrides);
  simulation.advance_exactly(0.05);
  EXPECT_EQ(simulation.state().flows.vent_mass_out, 0.0);
  set_sensor(simulation, "controller", true);
  simulation.advance_exactly(0.06);
  const double out = simulation.state().flows.vent_mass_out;
  EXPECT_GT(out, 1e-3);
  set_sensor(simulation, "controller", false);
  simulation.advance(0.1);
  EXPECT_EQ(simulation.state().flows.vent_mass_out, out);
}

TEST(simulation, names_what_is_wrong) {
  Simulation simulation = simulation_of("guided_headform", {"scene.end_time=1e-3"});
  const double nan = std::nan("");
  const auto expect = [](const std::string& message, const std::string& part) {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  expect(refusal([&] { set_vent_area(simulation, 7, 1e-3); }), "vent: is 7, allowed: 0 to 0");
  expect(refusal([&] { set_vent_area(simulation, 0, -1e-3); }), "area: is -0.001");
  expect(refusal([&] { set_inflow(simulation, 0, 1.0, 0.0); }), "temperature: is 0");
  expect(refusal([&] { set_outlet(simulation, 0, Vector3d::Zero(), Vector3d::UnitX()); }),
         "jet: is 0, but the scene has none");
  expect(refusal([&] { set_sensor(simulation, "s", true); }), "name: is 's'");
  expect(refusal([&] { set_ambient(simulation, nan, 300.0); }), "pressure: is nan");
  expect(refusal([&] { set_gravity(simulation, {nan, 0.0, 0.0}); }), "gravity");
  expect(refusal([&] { set_impactor(simulation, {}); }), "jumps by 0.52 m, allowed: ");
  expect(refusal([&] {
           set_impactor(simulation, {Vector3d::UnitX(), Eigen::Matrix3d::Zero()});
         }),
         "not a rotation");
  expect(refusal([&] { simulation.advance(nan); }), "time: is nan");
  expect(refusal([&] { simulation.step(-1); }), "count: is -1");
  simulation.evaluate();
  expect(refusal([&] { set_impactor(simulation, {}); }), "evaluated");
  simulation.advance(1.0);
  expect(refusal([&] { simulation.step(); }), "at its end");
}

}  // namespace
