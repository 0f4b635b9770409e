// SPDX-License-Identifier: Apache-2.0
// Measured curves of fabric in the measures of a deck.
#include "export/deck_fabric.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using driver::DeckCurve;

const DeckCurve kNominal{{0.0, 0.0}, {0.01, 2e5}, {0.05, 1.1e6}, {0.2, 9e6}, {0.6, 1e7}};
constexpr double kShare = 1e-4;

double work(const DeckCurve& curve) {
  double sum = 0.0;
  for (std::size_t k = 1; k < curve.size(); ++k)
    sum += 0.5 * (curve[k][1] + curve[k - 1][1]) * (curve[k][0] - curve[k - 1][0]);
  return sum;
}

// Both pairs of measures are conjugate: S dE = P/(1 + e) (1 + e) de. The lines between knots are off by the
// share of the last stress at most, and the strain goes to 0.78.
TEST(deck_fabric, work_is_kept) {
  EXPECT_NEAR(work(driver::green_lagrange(kNominal, kShare)), work(kNominal), kShare * 1e7 * 0.78);
}

TEST(deck_fabric, points_of_the_case_are_exact) {
  const DeckCurve curve = driver::green_lagrange(kNominal, kShare);
  for (const auto& [strain, stress] : kNominal) {
    const double green = strain + 0.5 * strain * strain;
    EXPECT_DOUBLE_EQ(driver::value_on(curve, green) * (1.0 + strain), stress);
  }
}

TEST(deck_fabric, between_them_it_is_within_the_share_and_a_coarser_one_has_fewer_knots) {
  double worst = 0.0;
  const DeckCurve curve = driver::green_lagrange(kNominal, kShare);
  for (int i = 0; i <= 6000; ++i) {
    const double strain = 1e-4 * i, stretch = 1.0 + strain;
    const double exact = driver::value_on(kNominal, strain) / stretch;
    worst = std::max(worst, std::abs(driver::value_on(curve, strain + 0.5 * strain * strain) - exact));
  }
  EXPECT_LE(worst, kShare * 1e7);
  EXPECT_GT(worst, 0.2 * kShare * 1e7);  // knots are not many more than it takes
  EXPECT_LT(driver::green_lagrange(kNominal, 1e-2).size(), curve.size() / 3);
}

TEST(deck_fabric, first_and_last_pieces_go_on) {
  EXPECT_DOUBLE_EQ(driver::value_on({{0.0, 1.0}, {1.0, 3.0}, {2.0, 4.0}}, -1.0), -1.0);
  EXPECT_DOUBLE_EQ(driver::value_on({{0.0, 1.0}, {1.0, 3.0}, {2.0, 4.0}}, 4.0), 6.0);
}

}  // namespace
