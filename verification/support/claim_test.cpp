// SPDX-License-Identifier: Apache-2.0
#include "claim.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

// The checks behind docs/verification.md and docs/stability.md can fail, and write what they saw.
namespace {

const int kNoRows = unsetenv("GASJET_CLAIMS");  // what fails here is no claim
const claim::Claim kClaim{"G.1", "some quantity [m]", "a reason"};

TEST(claim_near, fails_past_its_tolerance_and_on_nan) {
  claim::expect_near(kClaim, 2.0, 1.5, 0.5);  // the tolerance belongs to what is allowed
  claim::expect_relative(kClaim, -2.5, -2.0, 0.25);
  EXPECT_NONFATAL_FAILURE(claim::expect_near(kClaim, 2.0, 1.5, 0.4999), "some quantity [m]: 2, exact 1.5");
  EXPECT_NONFATAL_FAILURE(claim::expect_relative(kClaim, -2.5, -2.0, 0.2499), "differs by 0.5");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NONFATAL_FAILURE(claim::expect_near(kClaim, nan, 1.0, 1.0), "nan");
  EXPECT_NONFATAL_FAILURE(claim::expect_near(kClaim, 1.0, nan, 1.0), "nan");
  EXPECT_NONFATAL_FAILURE(claim::expect_near(kClaim, 1.0, 1.0, nan), "nan");
}

TEST(claim_order, fails_on_either_side_of_its_band_and_where_an_error_changes_sign) {
  claim::expect_order(kClaim, {16.0, 4.0, 1.0}, 1.9, 2.1);
  claim::expect_order(kClaim, {-9.0, -3.0, -1.0}, 0.9, 1.1, 3.0);
  EXPECT_NONFATAL_FAILURE(claim::expect_order(kClaim, {16.0, 4.0, 2.0}, 1.1, 3.0),
                          "order 1 from error 4 to 2");
  EXPECT_NONFATAL_FAILURE(claim::expect_order(kClaim, {16.0, 4.0, 0.5}, 1.0, 2.1),
                          "order 3 from error 4 to 0.5");
  EXPECT_NONFATAL_FAILURE(claim::expect_order(kClaim, {16.0, 4.0, -1.0}, 1.0, 3.0), "nan from error 4 to -1");
  EXPECT_NONFATAL_FAILURE(claim::expect_order(kClaim, {16.0, 4.0}, 1.0, 3.0), "three errors");
}

TEST(claim_threshold, fails_on_either_side_of_its_band) {
  const claim::Threshold limit{"a failure", "a formula", 2.0, 2.2, "s", "what is done"};
  claim::expect_threshold(kClaim, limit, 1.0, 1.2);
  EXPECT_NONFATAL_FAILURE(claim::expect_threshold(kClaim, limit, 1.11, 1.2), "ratio 1.1");
  EXPECT_NONFATAL_FAILURE(claim::expect_threshold(kClaim, limit, 1.0, 1.09), "ratio 1.1");
}

std::string rows_of(const std::filesystem::path& folder) {
  std::ifstream in(folder / "claim_rows.are_written_once.tsv");
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(claim_rows, are_written_once) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "gasjet_claim_rows";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "claim_rows.are_written_once.tsv") << "of an earlier run\n";
  ASSERT_EQ(kNoRows, 0);
  setenv("GASJET_CLAIMS", folder.c_str(), 1);
  claim::expect_near(kClaim, 0.1, 0.125, 0.5);
  claim::expect_order(kClaim, {4.0, 2.0, 1.0}, 0.5, 1.5);
  unsetenv("GASJET_CLAIMS");
  const std::string head =
      "\tclaim_rows.are_written_once\tverification/support/claim_test.cpp\tG.1\tsome quantity [m]\ta "
      "reason\t";
  EXPECT_EQ(rows_of(folder),
            "near" + head + "0.10000000000000001\t0.125\t0.5\norder" + head + "4 2 1\t1 1\t0.5\t1.5\n");
  std::filesystem::remove_all(folder);
}

}  // namespace
