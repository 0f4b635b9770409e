// SPDX-License-Identifier: Apache-2.0
// Algebra of the rigid pendulum: constants, moments, energies, accelerations, reaction, bad input.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <functional>
#include <numbers>

#include "claim.hpp"
#include "closed_form/pendulum.hpp"
#include "coupling/error.hpp"
#include "scenes.hpp"

namespace {

using coupling::PendulumModel;
using coupling::PendulumParameters;
using Eigen::Vector3d;

// A few dozen operations on numbers of order one.
constexpr double kRoundOff = 1e-13;

// Pendulums about tilted axes, with tilted gravity.
std::vector<PendulumModel> models() {
  std::vector<PendulumModel> list{PendulumModel(scenes::paper_pendulum())};
  PendulumParameters p = scenes::paper_pendulum();
  p.pivot = {0.3, -1.2, 2.0};
  p.axis = {1.0, 2.0, -0.5};
  p.rest_direction = Vector3d(1.0, 2.0, -0.5).cross(Vector3d(0.0, 0.3, 1.0));
  p.gravity = {1.0, -2.0, -9.0};
  list.emplace_back(p);
  p.mass = 3.0;
  p.inertia_cg = 0.0;
  p.impactor_distance = 0.4;
  list.emplace_back(p);
  return list;
}

const double kAngles[] = {-7.0, -1.3, 0.0, 1e-9, 0.4, 2.0, 3.2, 12.0};

TEST(Pendulum, constants_eq_closed_form) {
  const PendulumModel model(scenes::paper_pendulum());
  const auto exact = closed_form::pendulum_constants(closed_form::paper_pendulum());
  const char* why = "a few dozen operations on numbers of order one";
  claim::expect_relative({"K.2", "the paper's pendulum: moment of inertia about its axis [kg m2]", why},
                         model.axis_inertia(), exact.axis_inertia, kRoundOff);
  claim::expect_relative({"K.3", "the paper's pendulum: mass that a blow at the impactor feels [kg]", why},
                         model.effective_mass(), exact.effective_mass, kRoundOff);
  const double moment = model.moment({1.0, 0.0, 0.0}, model.impactor_centre(0.0));
  EXPECT_NEAR(moment / model.axis_inertia(), exact.angular_acceleration_per_force, kRoundOff);
  claim::expect_near({"K.5", "the paper's pendulum: acceleration of the c.g. for 1 N [m/s2]", why},
                     model.cg_acceleration(moment, 0.0).tangential, exact.cg_acceleration_per_force,
                     kRoundOff);
}

TEST(Pendulum, impactor_velocity_eq_axis_cross_arm) {
  for (const PendulumModel& model : models())
    for (const double angle : kAngles) {
      const Vector3d arm = model.impactor_centre(angle) - model.parameters().pivot;
      EXPECT_NEAR(arm.norm(), model.parameters().impactor_distance, kRoundOff);
      const Vector3d exact = 1.7 * model.parameters().axis.cross(arm);
      EXPECT_LT((model.impactor_velocity(angle, 1.7) - exact).norm(), kRoundOff * exact.norm());
    }
}

TEST(Pendulum, gravity_moment_eq_minus_energy_slope) {
  for (const PendulumModel& model : models()) {
    const double scale = model.parameters().mass * 10.0 * model.parameters().cg_distance;
    for (const double angle : kAngles) {
      const Vector3d weight = model.parameters().mass * model.parameters().gravity;
      EXPECT_NEAR(model.gravity_moment(angle), model.moment(weight, model.cg_position(angle)),
                  kRoundOff * scale);
      // Central difference: h^2/6 + eps/h at h = 1e-5 is 2e-11 and 1e-11 of the scale.
      const double h = 1e-5;
      const double slope =
          (model.potential_energy(angle + h) - model.potential_energy(angle - h)) / (2.0 * h);
      EXPECT_NEAR(model.gravity_moment(angle), -slope, 1e-10 * scale);
    }
  }
}

TEST(Pendulum, potential_energy_eq_mgh) {
  for (const PendulumModel& model : models())
    for (const double angle : kAngles) {
      const Vector3d lift = model.cg_position(angle) - model.cg_position(0.0);
      const double exact = -model.parameters().mass * model.parameters().gravity.dot(lift);
      claim::expect_near({"K.7", "three pendulums, tilted axes and gravity: potential energy [J]",
                          "height cancels metres: 200 J of weight times arm"},
                         model.potential_energy(angle), exact, kRoundOff * 200.0);
    }
  // Small angles keep their digits: m g L a^2/2 with a relative error of a^2/12.
  const PendulumModel model(scenes::paper_pendulum());
  const double quadratic = 10.9 * 9.80665 * 1.065 * 0.5 * 1e-16;
  EXPECT_NEAR(model.potential_energy(1e-8) / quadratic, 1.0, kRoundOff);
}

// At rest under a horizontal blow at the centre of percussion, the joint feels nothing; nearer or farther it
// feels 1 - m L L_i / I of the blow.
TEST(Pendulum, joint_feels_nothing_at_centre_of_percussion) {
  PendulumParameters p = scenes::paper_pendulum();
  p.gravity.setZero();
  const double percussion =
      closed_form::pendulum_constants(closed_form::paper_pendulum()).centre_of_percussion;
  for (const double arm : {0.2, 0.9, percussion, 1.31, 2.0}) {
    p.impactor_distance = arm;
    const PendulumModel model(p);
    const Vector3d force(100.0, 0.0, 0.0);
    const double moment = model.moment(force, model.impactor_centre(0.0));
    const Vector3d reaction = model.joint_reaction(0.0, 0.0, moment, force);
    const double exact = 100.0 * (10.9 * 1.065 * arm / model.axis_inertia() - 1.0);
    EXPECT_LT((reaction - Vector3d(exact, 0.0, 0.0)).norm(), 100.0 * kRoundOff);
    claim::expect_near({"K.6", "blows about the centre of percussion: reaction of the joint [N]",
                        "a few dozen operations on 100 N"},
                       reaction.x(), exact, 100.0 * kRoundOff);
  }
}

// Newton's law of the whole body with a second difference of the c.g.'s path.
TEST(Pendulum, joint_reaction_closes_newtons_law) {
  for (const PendulumModel& model : models())
    for (const double angle : kAngles) {
      const double omega = 2.3, h = 1e-4;
      const Vector3d force(30.0, -20.0, 10.0);
      const double moment = model.moment(force, model.impactor_centre(angle)) + model.gravity_moment(angle);
      const double alpha = moment / model.axis_inertia();
      const auto path = [&](double t) { return model.cg_position(angle + omega * t + 0.5 * alpha * t * t); };
      const Vector3d acceleration = (path(h) - 2.0 * path(0.0) + path(-h)) / (h * h);
      const Vector3d sum = model.joint_reaction(angle, omega, moment, force) + force +
                           model.parameters().mass * model.parameters().gravity;
      // h^2/12 x fourth derivative (omega^4 .. alpha^2, below 4e4 m/s4) plus 4 eps x 10 m / h^2.
      const double tolerance = h * h / 12.0 * 4e4 + 9e-15 / (h * h);
      EXPECT_LT((sum / model.parameters().mass - acceleration).norm(), tolerance);
      const auto a = model.cg_acceleration(moment, omega);
      EXPECT_NEAR(a.resultant, acceleration.norm(), tolerance);
      EXPECT_NEAR(a.radial, omega * omega * model.parameters().cg_distance, kRoundOff * a.radial);
    }
}

TEST(Pendulum, bad_input_names_the_field) {
  const std::vector<std::pair<const char*, std::function<void(PendulumParameters&)>>> faults = {
      {"pendulum.pivot", [](auto& p) { p.pivot.x() = std::nan(""); }},
      {"pendulum.axis", [](auto& p) { p.axis.setZero(); }},
      {"pendulum.rest_direction",
       [](auto& p) {
         p.rest_direction = {0.0, 0.1, -1.0};
       }},
      {"pendulum.mass", [](auto& p) { p.mass = 0.0; }},
      {"pendulum.inertia_cg", [](auto& p) { p.inertia_cg = -1.0; }},
      {"pendulum.inertia_cg", [](auto& p) { p.inertia_cg = p.cg_distance = 0.0; }},
      {"pendulum.cg_distance", [](auto& p) { p.cg_distance = coupling::kNotGiven; }},
      {"pendulum.impactor_distance", [](auto& p) { p.impactor_distance = 0.0; }},
      {"pendulum.impactor_radius", [](auto& p) { p.impactor_radius = -0.041; }},
      {"pendulum.impactor_radius", [](auto& p) { p.impactor_radius = 1.32; }},
      {"gravity", [](auto& p) { p.gravity.z() = std::numeric_limits<double>::infinity(); }}};
  for (const auto& [field, fault] : faults) {
    PendulumParameters p = scenes::paper_pendulum();
    fault(p);
    try {
      PendulumModel model(p);
      ADD_FAILURE() << field << " accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()).rfind(field, 0), 0u) << error.what();
    }
  }
}

TEST(Pendulum, turn_that_takes_the_impactor_half_a_radius_is_the_last_one_followed) {
  for (const auto& model : models()) {
    const double turn = 0.5 * model.parameters().impactor_radius / model.parameters().impactor_distance;
    for (const double sign : {1.0, -1.0}) {
      EXPECT_NO_THROW(model.require_followed(sign * turn * (1.0 - 1e-14)));
      EXPECT_THROW(model.require_followed(sign * turn * (1.0 + 1e-14)), coupling::ContactError);
      EXPECT_THROW(model.require_followed(sign * 2.0 * std::numbers::pi), coupling::ContactError);
    }
    EXPECT_THROW(model.require_followed(std::nan("")), coupling::ContactError);
    // The arc's middle is off its chord by half a radius squared over 8 arms, to the turn's square / 48.
    const Vector3d chord = 0.5 * (model.impactor_centre(0.0) + model.impactor_centre(turn));
    const double sagitta = (model.impactor_centre(0.5 * turn) - chord).norm();
    const double radius = model.parameters().impactor_radius, arm = model.parameters().impactor_distance;
    EXPECT_NEAR(sagitta / (radius * radius / (32.0 * arm)), 1.0, turn * turn / 48.0 + 1e-10);
  }
}

TEST(Pendulum, advance_refuses_what_is_not_finite) {
  const PendulumModel model(scenes::paper_pendulum());
  EXPECT_THROW(model.advance({0.0, 1.0}, std::nan(""), 1e-3, 1e-3), coupling::ContactError);
  EXPECT_THROW(model.advance({0.0, 1.0}, 1e300, 1e10, 1e300), coupling::ContactError);
  for (const double bad : {-1e-3, std::nan("")}) {
    EXPECT_THROW(model.advance({0.0, 1.0}, 0.0, bad, 1e-3), std::invalid_argument);
    EXPECT_THROW(model.advance({0.0, 1.0}, 0.0, 1e-3, bad), std::invalid_argument);
  }
}

}  // namespace
