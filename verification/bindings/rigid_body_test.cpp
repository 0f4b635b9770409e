// SPDX-License-Identifier: Apache-2.0
// Rigid bodies and the head injury criterion through gasjet.h.
#include "coupling/rigid_body.hpp"

#include <numbers>

#include "meshes.hpp"

using namespace border_test;

namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

Matrix3d matrix_of(const double* columns) {
  return Eigen::Map<const Matrix3d>(columns);
}

// The same body through the library.
coupling::RigidBodyModel library_body(const gasjet_rigid_body_model& given) {
  coupling::RigidBodyParameters p;
  p.mass = given.mass;
  p.centre = Vector3d(given.centre);
  p.axes = matrix_of(given.axes);
  p.velocity = Vector3d(given.velocity);
  p.angular_velocity = Vector3d(given.angular_velocity);
  p.inertia = matrix_of(given.inertia);
  p.gravity = Vector3d(given.gravity);
  if (given.motion == GASJET_ON_RAIL) p.rail = coupling::Rail{Vector3d(given.direction), {}};
  for (const gasjet_rail_spring& s : given.springs)
    if (p.rail && s.stiffness > 0.0)
      p.rail->springs.push_back({s.stiffness, s.damping, s.at, s.one_sided != 0});
  return coupling::RigidBodyModel(p);
}

void expect_same(const gasjet_rigid_body_state& mine, const coupling::RigidBodyState& library) {
  EXPECT_EQ(Vector3d(mine.centre), library.centre);
  EXPECT_EQ(matrix_of(mine.axes), library.axes);
  EXPECT_EQ(Vector3d(mine.velocity), library.velocity);
  EXPECT_EQ(Vector3d(mine.angular_momentum), library.angular_momentum);
}

// Steps of two sizes under a load that changes.
void march_both(const gasjet_rigid_body_model& model) {
  const auto library = library_body(model);
  auto theirs = library.initial();
  gasjet_rigid_body_state mine;
  ASSERT_OK(gasjet_rigid_body_start(&model, &mine));
  expect_same(mine, theirs);
  double before = 0.0;
  for (int n = 0; n < 200; ++n) {
    const double after = n % 3 == 0 ? 2e-4 : 5e-4;
    const double force[] = {300.0 - n, 2.0 * n, -50.0}, couple[] = {0.1, -0.02 * n, 0.3};
    gasjet_rigid_body_point point;
    ASSERT_OK(gasjet_rigid_body_evaluate(&model, &mine, &point));
    EXPECT_EQ(point.displacement, library.displacement(theirs));
    EXPECT_EQ(point.speed, library.speed(theirs.velocity));
    EXPECT_EQ(Vector3d(point.angular_velocity), library.angular_velocity(theirs));
    EXPECT_EQ(Vector3d(point.own_force), library.own_force(theirs));
    EXPECT_EQ(point.gravity_energy, library.gravity_energy(theirs));
    EXPECT_EQ(point.spring_energy, library.spring_energy(theirs));
    gasjet_rigid_body_kick kick;
    ASSERT_OK(gasjet_rigid_body_advance(&model, force, couple, before, after, &mine, &kick));
    const Vector3d old = theirs.velocity;
    const auto done =
        library.advance(theirs, {Vector3d(force), Vector3d(couple)}, 0.5 * (before + after), after);
    expect_same(mine, theirs);
    EXPECT_EQ(kick.kinetic_before, done.kinetic_before);
    EXPECT_EQ(point.kinetic_energy, done.kinetic_before);
    EXPECT_EQ(kick.kinetic_after, done.kinetic_after);
    EXPECT_EQ(kick.load_work, done.load_work);
    EXPECT_EQ(kick.damping_loss, done.damping_loss);
    EXPECT_EQ(kick.work, done.work);
    const Vector3d change = theirs.velocity - old, level = old + before / (before + after) * change;
    EXPECT_LT((Vector3d(kick.velocity) - level).norm(), 1e-14 * level.norm());
    EXPECT_LT((Vector3d(kick.acceleration) - change / (0.5 * (before + after))).norm(),
              1e-14 * Vector3d(kick.acceleration).norm());
    before = after;
  }
}

TEST(c_rigid_body, has_the_bits_of_the_library) {
  march_both(tumbling_body());
  march_both(guided_body());
}

TEST(c_rigid_body, a_step_of_0_brings_the_speeds_to_the_place) {
  // A constant force stops the mass within m v^2 / 2 F and m v / F; (K.55) is exact there.
  gasjet_rigid_body_model model = guided_body();
  for (gasjet_rail_spring& spring : model.springs) spring = {};
  for (double& b : model.gravity) b = 0.0;
  gasjet_rigid_body_state state;
  ASSERT_OK(gasjet_rigid_body_start(&model, &state));
  const double speed = 9.0, force[] = {2500.0, 100.0, 0.0};
  const double dt = model.mass * speed / force[0] / 100.0;
  gasjet_rigid_body_kick kick;
  double work = 0.0, before = 0.0;
  for (int n = 0; n <= 100; ++n) {
    ASSERT_OK(gasjet_rigid_body_advance(&model, force, nullptr, before, n < 100 ? dt : 0.0, &state, &kick));
    EXPECT_NEAR(kick.acceleration[0], force[0] / model.mass, 1e-10 * force[0] / model.mass);
    // In between it is half the mass times the speeds half a step before and after.
    const double now = speed - n * dt * force[0] / model.mass,
                 half = n > 0 && n < 100 ? 0.5 * dt * force[0] / model.mass : 0.0;
    EXPECT_NEAR(kick.kinetic_energy, 0.5 * model.mass * (now * now - half * half), 1e-10);
    work += kick.load_work;
    before = dt;
  }
  gasjet_rigid_body_point point;
  ASSERT_OK(gasjet_rigid_body_evaluate(&model, &state, &point));
  EXPECT_NEAR(point.displacement, 0.5 * model.mass * speed * speed / force[0], 1e-13);
  EXPECT_NEAR(point.speed, 0.0, 1e-12);
  EXPECT_NEAR(work, -0.5 * model.mass * speed * speed, 1e-10);
}

TEST(c_rigid_body, limits_are_those_of_the_equations) {
  const gasjet_rigid_body_model rail = guided_body(), free = tumbling_body();
  double mass = 0.0, frequency = 0.0;
  ASSERT_OK(gasjet_rigid_body_limits(&rail, 0.1, 1e3, &mass, &frequency));
  EXPECT_EQ(mass, 6.8);
  EXPECT_DOUBLE_EQ(frequency, (30e3 + 2e5) / 6.8);
  ASSERT_OK(gasjet_rigid_body_limits(&free, 0.1, 1e3, &mass, &frequency));
  EXPECT_DOUBLE_EQ(mass, 1.0 / (1.0 / 4.5 + 0.01 / 0.016));
  EXPECT_DOUBLE_EQ(frequency, 1e3 * 0.1 / 0.016);
  const gasjet_impactor shapes[] = {{GASJET_SPHERE, {0.04, 0.0, 0.0}},
                                    {GASJET_ELLIPSOID, {0.04, 0.1, 0.08}},
                                    {GASJET_CYLINDER, {0.04, 0.1, 0.0}},
                                    {GASJET_DISC, {0.1, 0.04, 0.0}}};
  const double exact[] = {0.04, 0.1, 0.14, 0.14};
  for (int i = 0; i < 4; ++i) {
    double reach = 0.0;
    ASSERT_OK(gasjet_impactor_reach(&shapes[i], &reach));
    EXPECT_DOUBLE_EQ(reach, exact[i]);
  }
}

TEST(c_rigid_body, defaults_leave_out_what_must_be_given) {
  gasjet_rigid_body_model model;
  gasjet_rigid_body_state state;
  ASSERT_OK(gasjet_rigid_body_defaults(&model));
  const auto refused = [&](const char* what) {
    EXPECT_EQ(gasjet_rigid_body_start(&model, &state), GASJET_BAD_INPUT) << what;
    EXPECT_EQ(std::string(gasjet_last_error()).rfind(what, 0), 0u) << gasjet_last_error();
  };
  refused("body.mass");
  model.mass = 3.0;
  refused("body.centre");
  for (double& x : model.centre) x = 0.0;
  refused("body.inertia");
  model.motion = GASJET_ON_RAIL;
  refused("rail.direction");
  model.direction[2] = -2.0;
  ASSERT_OK(gasjet_rigid_body_start(&model, &state));
}

TEST(c_head_injury, of_a_constant_and_a_half_sine) {
  constexpr double g = 9.80665;
  const double time[] = {1.0, 1.1}, layout[] = {36.0 * g, -1.0, 48.0 * g, -1.0, 0.0, -1.0,
                                                36.0 * g, -1.0, 48.0 * g, -1.0, 0.0, -1.0};
  const int64_t stride[] = {6, 2};
  double hic = 0.0;
  // Components 36 g and 48 g: 60 g. Rounding of some 1e4 samples.
  ASSERT_OK(gasjet_head_injury_criterion(time, layout, 2, stride, 0.036, &hic));
  EXPECT_NEAR(hic, 0.036 * std::pow(60.0, 2.5), 1e-9 * hic);
  // Half a sine of 80 g in 20 ms, window T: (T w/2)^2.5 centred, from the closed form of its integral; the
  // filter of class 1000 and intervals of whole 0.1 ms give 2e-3.
  std::vector<double> t, a;
  for (int i = -200; i <= 400; ++i) {
    t.push_back(1e-4 * i);
    a.insert(a.end(),
             {0.0, i < 0 || i > 200 ? 0.0 : -80.0 * g * std::sin(std::numbers::pi * i / 200.0), 0.0});
  }
  ASSERT_OK(gasjet_head_injury_criterion(t.data(), a.data(), 601, nullptr, 0.005, &hic));
  const double mean = 80.0 * 0.04 / (std::numbers::pi * 0.005) * std::sin(std::numbers::pi * 0.005 / 0.04);
  EXPECT_NEAR(hic, 0.005 * std::pow(mean, 2.5), 2e-3 * hic);
}

}  // namespace
