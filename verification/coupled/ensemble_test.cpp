// SPDX-License-Identifier: Apache-2.0
// The paper's scene as an ensemble: the jet's effect against the scatter of a chaotic scene.
#include "many_runs/ensemble.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "run_case.hpp"

namespace {

driver::EnsembleResult ensemble(const char* name, int threads) {
  driver::EnsembleOptions options;
  options.runs = 16;
  options.quiet = true;
  return driver::run_ensemble(coupled::case_file(name), {}, options, threads);
}

TEST(ensemble, jet_effect_on_angle_and_first_contact_exceeds_five_standard_errors) {
  const auto with = ensemble("passenger_pendulum", 2);
  const auto without = ensemble("passenger_pendulum_no_jet", 2);
  EXPECT_TRUE(with.failures.empty());
  EXPECT_TRUE(without.failures.empty());
  int found = 0;
  for (const auto& effect : driver::effects(with, without)) {
    found += effect.quantity == "final_angle_rad" || effect.quantity == "first_contact_s";
    if (effect.quantity == "final_angle_rad") {
      EXPECT_GT(effect.difference, 0.0);
      EXPECT_TRUE(effect.decided());
    }
    if (effect.quantity == "first_contact_s") {
      EXPECT_LT(effect.difference, 0.0);
      EXPECT_TRUE(effect.decided());
    }
  }
  EXPECT_EQ(found, 2);
}

TEST(ensemble, statistics_of_known_numbers) {
  const auto s = driver::statistics({1.0, 2.0, 3.0, 4.0});
  EXPECT_DOUBLE_EQ(s.mean, 2.5);
  EXPECT_DOUBLE_EQ(s.standard_error, std::sqrt(5.0 / 3.0 / 4.0));  // sample variance 5/3 over n
  EXPECT_EQ(s.minimum, 1.0);
  EXPECT_EQ(s.maximum, 4.0);
}

}  // namespace
