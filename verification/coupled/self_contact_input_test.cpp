// SPDX-License-Identifier: Apache-2.0
// Bad input of [membrane.self_contact]: refused where it stands.
#include <gtest/gtest.h>

#include "fault.hpp"

namespace {

using coupled::Fault;

class bad_self_contact_input : public testing::TestWithParam<Fault> {};

TEST_P(bad_self_contact_input, is_refused_where_it_stands) {
  coupled::expect_refused_where_it_stands(GetParam());
}

const Fault kFaults[] = {
    {"thickness_missing", "flattened_sphere", "flatten = 0.1", "self_contact = {}",
     "membrane.self_contact.thickness", "is missing", "{}"},
    {"thickness_zero", "flattened_sphere", "flatten = 0.1", "self_contact.thickness = 0.0",
     "membrane.self_contact.thickness", "above 0", "thickness = 0.0"},
    {"thickness_of_an_element", "flattened_sphere", "flatten = 0.1", "self_contact.thickness = 0.068",
     "membrane.self_contact.thickness",
     "is 0.068 m, allowed: up to 0.0672 m, the smallest altitude of element", "thickness = 0.068"},
    {"stiffness_negative", "flattened_sphere", "flatten = 0.1",
     "self_contact = { thickness = 1e-3, stiffness = -1.0 }", "membrane.self_contact.stiffness", "above 0",
     "stiffness = -1.0"},
    {"share_zero", "flattened_sphere", "flatten = 0.1",
     "self_contact = { thickness = 1e-3, stiffness_share = 0.0 }", "membrane.self_contact.stiffness_share",
     "above 0", "stiffness_share = 0.0"},
    {"friction_of_glue", "flattened_sphere", "flatten = 0.1",
     "self_contact = { thickness = 1e-3, friction = 11.0 }", "membrane.self_contact.friction", "from 0 to 10",
     "friction = 11.0"},
    {"stiffness_and_share", "flattened_sphere", "flatten = 0.1",
     "self_contact = { thickness = 1e-3, stiffness = 1e9, stiffness_share = 5.0 }",
     "membrane.self_contact.stiffness_share",
     "stands beside stiffness, allowed: one of them; leave out stiffness to", "stiffness_share = 5.0"},
    {"no_mesh", "rigid_tank", "[[inflator]]", "[membrane.self_contact]\nthickness = 2e-3\n[[inflator]]",
     "membrane.self_contact", "needs membrane.mesh", "self_contact]"},
    {"unknown_key", "flattened_sphere", "flatten = 0.1", "self_contact = { thickness = 1e-3, gap = 11.0 }",
     "membrane.self_contact.gap", "unknown key", "gap = 11.0"}};

INSTANTIATE_TEST_SUITE_P(Faults, bad_self_contact_input, testing::ValuesIn(kFaults),
                         [](const auto& fault) { return std::string(fault.param.name); });

}  // namespace
