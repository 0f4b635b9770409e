// SPDX-License-Identifier: Apache-2.0
// Same case, same build: same bits, for any number of threads.
#include <gtest/gtest.h>

#include <cstring>

#include "run_case.hpp"

namespace {

using coupled::run_case;

void expect_same_bits(const coupled::CaseRun& a, const coupled::CaseRun& b) {
  ASSERT_EQ(a.history.size(), b.history.size());
  for (std::size_t i = 0; i < a.history.size(); ++i) {
    ASSERT_EQ(std::memcmp(&a.history[i], &b.history[i], sizeof a.history[i]), 0) << "row " << i;
    ASSERT_EQ(std::memcmp(&a.energy[i], &b.energy[i], sizeof a.energy[i]), 0) << "row " << i;
  }
}

TEST(same_bits, for_one_two_and_three_threads) {
  // 10 976 elements: enough blocks for the threads to share.
  const std::vector<std::string> overrides{"scene.end_time=0.002", "membrane.mesh.refine=1"};
  driver::set_threads(1);
  const auto one = run_case("passenger_pendulum_no_jet", overrides);
  driver::set_threads(2);
  const auto two = run_case("passenger_pendulum_no_jet", overrides);
  driver::set_threads(3);
  const auto three = run_case("passenger_pendulum_no_jet", overrides);
  driver::set_threads(1);
  expect_same_bits(one, two);
  expect_same_bits(one, three);
  EXPECT_GT(one.history.size(), 10u);
}

TEST(same_bits, perturbation_of_1e_12_m_is_another_run) {
  const auto base = run_case("passenger_pendulum", {"scene.end_time=0.004"});
  const auto other = run_case("passenger_pendulum", {"scene.end_time=0.004", "membrane.perturbation=1e-12"});
  EXPECT_NE(base.history.back().volume_m3, other.history.back().volume_m3);
  EXPECT_NEAR(base.history.back().volume_m3 / other.history.back().volume_m3, 1.0,
              1e-6);  // chaos takes longer
}

}  // namespace
