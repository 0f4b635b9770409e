// SPDX-License-Identifier: Apache-2.0
// Which rungs a ladder runs, and where it stops.
#include <gtest/gtest.h>

#include <algorithm>

#include "driver/ladder.hpp"
#include "run_case.hpp"

namespace {

using coupled::case_file;
using driver::LadderRung;
using driver::Verdict;
using Texts = std::vector<std::string>;

driver::LadderOptions options_of(const char* quantity) {
  return {quantity, 0.02, {}, 16, 1, true};
}

struct Nothing {
  const char* name;
  const char* scene;
  const char* quantity;
  Texts settings;
  const char* reason;
};

class ladder_without_size : public testing::TestWithParam<Nothing> {};

TEST_P(ladder_without_size, is_told_from_the_full_case_alone) {
  const Nothing& p = GetParam();
  const auto result = driver::run_ladder(case_file(p.scene), p.settings, options_of(p.quantity));
  EXPECT_NE(result.reason.find(p.reason), std::string::npos) << result.reason;
  EXPECT_EQ(result.rungs.size(), 1u) << "no other rung is run";
  EXPECT_EQ(result.verdict, Verdict::not_judged);
}

INSTANTIATE_TEST_SUITE_P(
    quantities, ladder_without_size,
    testing::Values(Nothing{"seed_without_contact",
                            "passenger_pendulum",
                            "first_contact",
                            {"scene.end_time=1e-4"},
                            "seed 1 of rung \"full\", to which all are compared: the run has no such event"},
                    Nothing{"pendulum_at_rest",
                            "passenger_pendulum",
                            "pendulum_angle",
                            {"scene.end_time=1e-4"},
                            "pendulum_angle_rad is 0 in the full case"},
                    Nothing{"jet_not_fired",
                            "plate_jet",
                            "jet_force",
                            {"target.columns=20", "target.rows=20", "inflator.0.start_time=5"},
                            "jet_force_N is 0 in the full case"},
                    Nothing{"tank_at_ambient_pressure",
                            "rigid_tank",
                            "pressure",
                            {"inflator.0.start_time=5"},
                            "pressure_Pa is 101325 in the full case"}),
    [](const auto& test) { return std::string(test.param.name); });

// Of the case's own constant heat capacities the full case makes NASA-7, and one rung takes that back.
TEST(ladder, case_as_it_is_runs_once) {
  const auto result = driver::run_ladder(case_file("tank_stiff"), {}, options_of("pressure"));
  const auto is_own = [](const LadderRung& r) { return r.overrides.empty(); };
  EXPECT_EQ(std::count_if(result.rungs.begin(), result.rungs.end(), is_own), 1);
  EXPECT_EQ(std::find_if(result.rungs.begin(), result.rungs.end(), is_own)->name, "as it is: cp constant");
}

}  // namespace
