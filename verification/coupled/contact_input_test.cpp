// SPDX-License-Identifier: Apache-2.0
// Bad input of [pendulum] and [contact]: refused where it stands.
#include <gtest/gtest.h>

#include "case_folder.hpp"
#include "fault.hpp"

namespace {

using coupled::Fault;

class bad_contact_input : public testing::TestWithParam<Fault> {};

TEST_P(bad_contact_input, is_refused_where_it_stands) {
  coupled::expect_refused_where_it_stands(GetParam());
}

const Fault kContactFaults[] = {
    {"stiffness_nan", "ball_impact", "friction = 0.3", "stiffness = nan", "contact.stiffness", "is nan",
     "stiffness = nan"},
    {"stiffness_negative", "ball_impact", "friction = 0.3", "stiffness = -1e9", "contact.stiffness",
     "above 0", "stiffness = -1e9"},
    {"share_zero", "ball_impact", "friction = 0.3", "stiffness_share = 0.0", "contact.stiffness_share",
     "above 0", "stiffness_share = 0.0"},
    {"share_beyond_all", "ball_impact", "friction = 0.3", "stiffness_share = 1e300",
     "contact.stiffness_share", "at most 1e20", "stiffness_share = 1e300"},
    {"friction_of_glue", "ball_impact", "friction = 0.3", "friction = 11.0", "contact.friction",
     "from 0 to 10", "friction = 11.0"},
    {"angle_beyond_digits", "pendulum_swing", "initial_angle = 1.0471975511965976", "initial_angle = 1e15",
     "pendulum.initial_angle", "-1000 to 1000", "initial_angle = 1e15"},
    {"mass_zero", "ball_impact", "mass = 10.9 ", "mass = 0.0 ", "pendulum.mass", "above 0", "mass = 0.0"},
    {"axis_zero", "ball_impact", "axis = [0.0, -1.0, 0.0]", "axis = [0.0, 0.0, 0.0]", "pendulum",
     "pendulum.axis = [0, 0, 0]", "[pendulum]"},
    {"rest_along_axis", "ball_impact", "rest_direction = [0.0, 0.0, -1.0]",
     "rest_direction = [0.0, -1.0, 0.0]", "pendulum", "normal to the axis", "[pendulum]"},
    {"impactor_holds_pivot", "ball_impact", "impactor_radius = 0.041", "impactor_radius = 1.32", "pendulum",
     "at most impactor_distance", "[pendulum]"},
    {"impactor_too_small", "contact_vent", "impactor_radius = 0.041", "impactor_radius = 1e-4",
     "pendulum.impactor_radius", "skin element 0 = 0.0963", "impactor_radius = 1e-4"},
    {"contact_without_bag", "rigid_tank", "[scene]", "[contact]\n[scene]", "contact",
     "needs [membrane], and [pendulum] or [impactor]", "contact]"}};

INSTANTIATE_TEST_SUITE_P(Faults, bad_contact_input, testing::ValuesIn(kContactFaults),
                         [](const auto& fault) { return std::string(fault.param.name); });

}  // namespace
