// SPDX-License-Identifier: Apache-2.0
// Bad calls of rigid bodies and of the head injury criterion.
#include <array>

#include "bad_calls.hpp"

using namespace border_test;
using bad_calls = BadCalls;

namespace {

// One member of a model each, and what the refusal begins with.
struct Spoilt {
  const char* member;
  void (*spoil)(gasjet_rigid_body_model&, double);
};

const Spoilt kSpoiltBodies[] = {
    {"body.mass", [](auto& m, double x) { m.mass = x; }},
    {"body.centre", [](auto& m, double x) { m.centre[1] = x; }},
    {"body.axes", [](auto& m, double x) { m.axes[3] = x; }},
    {"body.velocity", [](auto& m, double x) { m.velocity[2] = x; }},
    {"body.angular_velocity", [](auto& m, double x) { m.angular_velocity[0] = x; }},
    {"gravity", [](auto& m, double x) { m.gravity[0] = x; }}};

TEST_F(bad_calls, models_of_rigid_bodies) {
  gasjet_rigid_body_state state;
  const auto start = [&](gasjet_rigid_body_model given, const auto& spoil) {
    spoil(given);
    return gasjet_rigid_body_start(&given, &state);
  };
  for (const auto& good : {tumbling_body(), guided_body()}) {
    for (const Spoilt& one : kSpoiltBodies)
      each(kNotFinite, one.member, [&](double x) { return start(good, [&](auto& m) { one.spoil(m, x); }); });
    for (const double x : {0.0, -1.0}) refused(start(good, [&](auto& m) { m.mass = x; }), "body.mass");
    refused(start(good, [](auto& m) { m.axes[8] = -m.axes[8]; }), "body.axes");
    for (const int64_t motion : {int64_t{-1}, int64_t{2}, INT64_MAX})
      refused(start(good, [&](auto& m) { m.motion = motion; }), "body.motion");
    refused(gasjet_rigid_body_start(&good, nullptr), "state");
  }
  refused(gasjet_rigid_body_defaults(nullptr), "model");
  refused(gasjet_rigid_body_start(nullptr, &state), "model");
  const auto free = tumbling_body(), rail = guided_body();
  each(kNotPositive, "body.inertia",
       [&](double x) { return start(free, [&](auto& m) { m.inertia[8] = x; }); });
  each(kNotFinite, "body.inertia", [&](double x) { return start(free, [&](auto& m) { m.inertia[1] = x; }); });
  refused(start(free, [](auto& m) { m.inertia[1] = 0.0; }), "body.inertia");  // not symmetric
  refused(start(free, [](auto& m) { m.inertia[8] = 1.0; }), "body.inertia");  // of no mass
  refused(start(rail, [](auto& m) { m.direction[0] = 0.0; }), "rail.direction");
  each(kNotFinite, "rail.direction",
       [&](double x) { return start(rail, [&](auto& m) { m.direction[0] = x; }); });
  each(kNotCounted, "rail.spring.stiffness",
       [&](double x) { return start(rail, [&](auto& m) { m.springs[3].stiffness = x; }); });
  each(kNotCounted, "rail.spring.damping",
       [&](double x) { return start(rail, [&](auto& m) { m.springs[3].damping = x; }); });
  each(kNotFinite, "rail.spring.at",
       [&](double x) { return start(rail, [&](auto& m) { m.springs[0].at = x; }); });
  refused(start(rail, [](auto& m) { m.velocity[1] = 1.0; }), "body.velocity");
  refused(start(rail, [](auto& m) { m.angular_velocity[1] = 1.0; }), "body.angular_velocity");
}

TEST_F(bad_calls, motions_of_rigid_bodies) {
  const gasjet_rigid_body_model body = tumbling_body();
  gasjet_rigid_body_state good, state;
  gasjet_rigid_body_point point;
  gasjet_rigid_body_kick kick;
  kick.work = 7.0;
  ASSERT_OK(gasjet_rigid_body_start(&body, &good));
  state = good;
  const double push[] = {1.0, 2.0, 3.0}, wrong[] = {0.0, 0.0, kNan};
  const auto advance = [&](double before, double after) {
    return gasjet_rigid_body_advance(&body, push, push, before, after, &state, &kick);
  };
  refused(gasjet_rigid_body_evaluate(nullptr, &state, &point), "model");
  refused(gasjet_rigid_body_evaluate(&body, nullptr, &point), "state");
  refused(gasjet_rigid_body_evaluate(&body, &state, nullptr), "point");
  refused(gasjet_rigid_body_advance(nullptr, push, push, 0.0, 1e-3, &state, &kick), "model");
  refused(gasjet_rigid_body_advance(&body, nullptr, push, 0.0, 1e-3, &state, &kick), "force");
  refused(gasjet_rigid_body_advance(&body, wrong, push, 0.0, 1e-3, &state, &kick), "force");
  refused(gasjet_rigid_body_advance(&body, push, wrong, 0.0, 1e-3, &state, &kick), "couple");
  refused(gasjet_rigid_body_advance(&body, push, push, 0.0, 1e-3, nullptr, &kick), "state");
  each(kNotCounted, "dt_before", [&](double dt) { return advance(dt, 1e-3); });
  each(kNotCounted, "dt_after", [&](double dt) { return advance(1e-3, dt); });
  refused(advance(0.0, 0.0), "dt_after");
  EXPECT_EQ(kick.work, 7.0);
  EXPECT_EQ(state.centre[1], good.centre[1]);
  EXPECT_EQ(state.velocity[0], good.velocity[0]);
  for (const double x : kNotFinite) {
    const auto spoilt = [&](double(gasjet_rigid_body_state::*member)[3]) {
      state = good;
      (state.*member)[2] = x;
      refused(advance(0.0, 1e-3), member == &gasjet_rigid_body_state::centre     ? "state.centre"
                                  : member == &gasjet_rigid_body_state::velocity ? "state.velocity"
                                                                                 : "state.angular_momentum");
    };
    spoilt(&gasjet_rigid_body_state::centre);
    spoilt(&gasjet_rigid_body_state::velocity);
    spoilt(&gasjet_rigid_body_state::angular_momentum);
    state = good;
    state.axes[4] = x;
    refused(gasjet_rigid_body_evaluate(&body, &state, &point), "state.axes");
  }
  state = {};
  refused(advance(0.0, 1e-3), "state.axes");
}

TEST_F(bad_calls, limits_of_rigid_bodies_and_head_injury) {
  const gasjet_rigid_body_model body = tumbling_body();
  double least = 7.0, frequency = 7.0, hic = 7.0;
  each(kNotCounted, "reach",
       [&](double x) { return gasjet_rigid_body_limits(&body, x, 1.0, &least, &frequency); });
  each(kNotCounted, "contact_force",
       [&](double x) { return gasjet_rigid_body_limits(&body, 0.1, x, &least, &frequency); });
  refused(gasjet_rigid_body_limits(nullptr, 0.1, 1.0, &least, &frequency), "model");
  refused(gasjet_rigid_body_limits(&body, 0.1, 1.0, nullptr, &frequency), "effective_mass");
  refused(gasjet_rigid_body_limits(&body, 0.1, 1.0, &least, nullptr), "frequency");
  refused(gasjet_impactor_reach(nullptr, &least), "impactor");
  const gasjet_impactor flat{GASJET_DISC, {0.1, 0.0, 0.0}}, none{4, {0.1, 0.1, 0.1}},
      sphere{GASJET_SPHERE, {0.1, 0.0, 0.0}};
  refused(gasjet_impactor_reach(&flat, &least), "impactor.rim_radius");
  refused(gasjet_impactor_reach(&none, &least), "impactor.shape");
  refused(gasjet_impactor_reach(&sphere, nullptr), "reach");
  const double time[] = {0.0, 0.01, 0.02}, a[] = {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0};
  const auto criterion = [&](const double* t, const double* rows, int64_t count, double window) {
    return gasjet_head_injury_criterion(t, rows, count, nullptr, window, &hic);
  };
  refused(criterion(nullptr, a, 3, 0.015), "time");
  refused(criterion(time, nullptr, 3, 0.015), "acceleration");
  for (const int64_t count : {int64_t{-1}, int64_t{0}, int64_t{1}, INT64_MAX})
    refused(criterion(time, a, count, 0.015), "count");
  for (const double x : {kNan, kInfinity, -1.0, 0.0, 5e-5, 0.2}) refused(criterion(time, a, 3, x), "window");
  for (const double x : {kNan, kInfinity, 0.01, -1.0, 11.0}) {
    const double wrong[] = {0.0, 0.01, x};
    refused(criterion(wrong, a, 3, 0.015), "time");
  }
  for (const double x : kNotFinite) {
    const double wrong[] = {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, x, 9.0};
    refused(criterion(time, wrong, 3, 0.015), "acceleration");
  }
  refused(gasjet_head_injury_criterion(time, a, 3, nullptr, 0.015, nullptr), "criterion");
  EXPECT_EQ(least, 7.0);
  EXPECT_EQ(frequency, 7.0);
  EXPECT_EQ(hic, 7.0);
}

TEST_F(bad_calls, results_of_rigid_bodies_that_no_double_holds) {
  const double far[] = {1e308, 1e308, 1e308};
  double y = 7.0;
  const auto left = [&](int status, const std::string& result) {
    ++calls;
    EXPECT_EQ(status, GASJET_DOMAIN) << result;
    EXPECT_EQ(std::string(gasjet_last_error()).rfind(result, 0), 0u) << gasjet_last_error();
  };
  gasjet_rigid_body_model body = tumbling_body();
  gasjet_rigid_body_state fast;
  ASSERT_OK(gasjet_rigid_body_start(&body, &fast));
  fast.velocity[1] = 1e200;
  gasjet_rigid_body_point of_body;
  left(gasjet_rigid_body_evaluate(&body, &fast, &of_body), "point");
  left(gasjet_rigid_body_advance(&body, far, nullptr, 0.0, 1e-3, &fast, nullptr), "kick");
  left(gasjet_rigid_body_advance(&body, far, nullptr, 0.0, 1e10, &fast, nullptr), "impactor");
  left(gasjet_rigid_body_limits(&body, 1e10, 1e300, &y, &y), "frequency");
  const double instants[] = {0.0, 0.1};
  left(gasjet_head_injury_criterion(instants, std::array{1e300, 0.0, 0.0, 1e300, 0.0, 0.0}.data(), 2, nullptr,
                                    0.015, &y),
       "criterion");
  EXPECT_EQ(y, 7.0);
  EXPECT_EQ(fast.velocity[1], 1e200);
}

}  // namespace
