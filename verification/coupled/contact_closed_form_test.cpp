// SPDX-License-Identifier: Apache-2.0
// Coupled scenes against closed forms: the pendulum on a gas spring, the columns of a swing.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "case_folder.hpp"
#include "claim.hpp"
#include "closed_form/coupled.hpp"
#include "run_case.hpp"

namespace {

// --- pendulum on a gas spring
// ------------------------------------------------------------------------------------

// The impactor of the paper's pendulum closes a cylinder on either side of it, both at ambient pressure at
// rest: as stiff as one of twice the gas. Steps as the driver takes them: pressure at n, gas last, with its
// own work.
double gas_spring_period(int steps_per_period, double expected) {
  constexpr double area = 0.05, volume = 0.06, pressure = 101325.0;  // [m2] [m3] [Pa]
  const gas::ControlVolumeModel model{
      gas::Thermo({gas::constant_cp_species("N2", 296.8, 1038.8)}), {pressure, 293.15}, {}, {}};
  gas::GasIntegrator integrator(model);
  const double one[] = {1.0};
  gas::ControlVolumeState front = gas::make_state(model.thermo, one, pressure, 400.0, volume), back = front;
  coupling::PendulumParameters p;
  p.pivot = {0.0, 0.0, 0.0};
  p.axis = {0.0, -1.0, 0.0};
  p.rest_direction = {0.0, 0.0, -1.0};
  p.mass = 10.9, p.inertia_cg = 2.07, p.cg_distance = 1.065, p.impactor_distance = 1.31,
  p.impactor_radius = 0.041;
  p.gravity = {0.0, 0.0, -9.80665};
  const coupling::PendulumModel pendulum(p);
  coupling::PendulumState swing{0.0, 1e-4};
  const double dt = expected / steps_per_period;
  double crossing = 0.0;
  for (int n = 0;; ++n) {
    const auto swept = [&](double angle) { return area * p.impactor_distance * std::sin(angle); };
    const double v = swept(swing.angle);
    const double push = gas::evaluate(model, back, volume + v, 0.0, 0.0).pressure -
                        gas::evaluate(model, front, volume - v, 0.0, 0.0).pressure;
    const double moment =
        pendulum.gravity_moment(swing.angle) + push * area * p.impactor_distance * std::cos(swing.angle);
    const double last = swing.angle;
    swing = pendulum.advance(swing, moment, n == 0 ? 0.5 * dt : dt, dt);
    const double w = swept(swing.angle), t = n * dt;
    integrator.advance(back, t, t + dt, {volume + v, volume + w, 0.0, 0.0});
    integrator.advance(front, t, t + dt, {volume - v, volume - w, 0.0, 0.0});
    // From 0 upwards and back through 0 to 0 again, the last by the sine through both levels.
    if (n > steps_per_period / 2 + 2 && last < 0.0 && swing.angle >= 0.0) {
      const double turn = 2.0 * std::numbers::pi / steps_per_period, ratio = -last / swing.angle;
      const double part = std::atan2(ratio * std::sin(turn), 1.0 + ratio * std::cos(turn)) / turn;
      crossing = (n + part) * dt;
      return crossing;
    }
  }
}

TEST(contact_closed_form, gas_spring_period_is_second_order) {
  closed_form::PendulumGasSpring scene;
  scene.pendulum = closed_form::paper_pendulum();
  scene.gas = {296.8, 1.4};
  scene.area = 0.05, scene.volume = 0.06, scene.pressure = 2.0 * 101325.0;  // two cylinders
  const double exact = 2.0 * std::numbers::pi / closed_form::pendulum_gas_spring_frequency(scene);
  std::vector<double> error;
  for (int level = 0; level < 3; ++level)
    error.push_back(std::abs(gas_spring_period(40 << level, exact) - exact) / exact);
  claim::expect_order(
      {"K.4", "pendulum on a gas spring: period", "the next term is (omega dt)^2 / 9 of the first"}, error,
      1.95, 2.05);
  claim::expect_relative(
      {"K.4", "pendulum on a gas spring, 160 steps: error of the period, (omega dt)^2 / 24",
       "the next term is 2e-4 of it; the rest for locating the crossing"},
      error.back(), std::pow(2.0 * std::numbers::pi / 160.0, 2) / 24.0, 0.01);
}

// --- the pendulum's columns
// ----------------------------------------------------------------------------------------

TEST(contact_closed_form, columns_of_a_swing_eq_closed_form) {
  const coupled::Folder folder;
  const auto file = folder.path / "swing.toml";
  std::ofstream(file)
      << "[scene]\nname = \"swing\"\nend_time = 1.0\ngravity = [0.0, 0.0, -9.80665]\n"
         "[time]\nstep = 1e-4\n"
         "[pendulum]\npivot = [0.0, 0.0, 0.0]\naxis = [0.0, -2.0, 0.0]\n"
         "rest_direction = [0.0, 0.0, -1.0]\nmass = 10.9\ninertia_cg = 2.07\ncg_distance = 1.065\n"
         "impactor_distance = 1.31\nimpactor_radius = 0.041\ninitial_angle = 1.0471975511965976\n";
  driver::CaseDocument document(file, {});
  const auto scene = driver::load_scene(document);
  driver::State state = driver::make_state(scene);
  const auto pendulum = closed_form::paper_pendulum();
  const double w = closed_form::pendulum_constants(pendulum).angular_frequency, arm = 1.065, g = 9.80665;
  const auto columns = driver::history_columns(scene);
  int rows = 0;
  driver::run_scene(scene, state, [&](bool recorded, const driver::State& now) {
    if (!recorded || ++rows % 100 != 1) return;
    const auto row = coupled::row_of(columns, scene, now);
    const auto exact = closed_form::pendulum_swing(pendulum, 1.0471975511965976, row.at("time_s"));
    const double tangential = -w * w * std::sin(exact.angle) * arm;
    const double radial = exact.angular_velocity * exact.angular_velocity * arm;
    // Newton along and across the arm: the joint carries m (a - g).
    const double joint =
        10.9 * std::hypot(tangential + g * std::sin(exact.angle), radial + g * std::cos(exact.angle));
    claim::expect_near({"K.4", "swing from 60 degrees, columns of the history: angle [rad]",
                        "order 2: (omega0 dt)^2 omega0 t / 24 = 1e-8 of the phase"},
                       row.at("pendulum_angle_rad"), exact.angle, 1e-7);
    EXPECT_NEAR(row.at("pendulum_cg_tangential_m_s2"), tangential, 1e-6) << row.at("time_s");
    EXPECT_NEAR(row.at("pendulum_cg_radial_m_s2"), radial, 2e-6) << row.at("time_s");
    claim::expect_near(
        {"K.5", "swing from 60 degrees, columns of the history: acceleration of the c.g. [m/s2]",
         "of the angle's error, times 10 m/s2 and twice the rate"},
        row.at("pendulum_cg_acceleration_m_s2"), std::hypot(tangential, radial), 2e-6);
    claim::expect_near({"K.6", "swing from 60 degrees, columns of the history: joint force [N]",
                        "of the acceleration's error, times 10.9 kg"},
                       row.at("pendulum_joint_force_N"), joint, 3e-5);
  });
  EXPECT_GT(rows, 900);
}

}  // namespace
