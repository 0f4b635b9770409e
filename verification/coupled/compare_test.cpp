// SPDX-License-Identifier: Apache-2.0
// `gasjet compare` on histories whose difference is known: shifted, scaled, resampled, cut short.
#include "compare/compare.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/case_reader.hpp"

namespace {

using driver::Difference;
using driver::History;
using driver::Verdict;

constexpr double kBase = 1e5, kHeight = 2e4, kEnd = 0.1;  // a pulse on a pressure [Pa], [Pa], [s]

double pulse(double t) {
  return kBase + kHeight * std::pow(std::sin(std::numbers::pi * t / kEnd), 2);
}

// A history of `rows` equal steps over [from, to]; with a band when that is above 0.
template <typename Signal>
History sampled(const Signal& signal, int rows, double band = 0.0, double from = 0.0, double to = kEnd) {
  History history;
  history.columns.emplace_back("pressure_Pa", std::vector<double>{});
  for (int i = 0; i < rows; ++i) {
    history.time.push_back(from + (to - from) * i / (rows - 1));
    history.columns[0].second.push_back(signal(history.time.back()));
  }
  if (band > 0.0)
    history.columns.emplace_back("pressure_Pa_band", std::vector<double>(history.time.size(), band));
  return history;
}

TEST(compare, history_eq_itself) {
  const Difference d = driver::compare(sampled(pulse, 101), sampled(pulse, 101, 1.0));
  EXPECT_EQ(d.verdict, Verdict::inside) << d.reason;
  ASSERT_EQ(d.quantities.size(), 1u);
  const auto& q = d.quantities[0];
  EXPECT_EQ(q.largest.value, 0.0);
  EXPECT_EQ(q.l2, 0.0);
  EXPECT_EQ(q.share_of_band, 0.0);
  ASSERT_TRUE(q.phase_lag);
  EXPECT_EQ(*q.phase_lag, 0.0);
  EXPECT_EQ(q.mine.value, kBase + kHeight);
  EXPECT_DOUBLE_EQ(q.mine.time, 0.5 * kEnd);
}

TEST(compare, shifted_history_shows_its_lag_and_slope) {
  for (const double shift : {0.002, -0.005}) {
    const auto mine = sampled([&](double t) { return pulse(t - shift); }, 1001);
    const double slope = kHeight * std::numbers::pi / kEnd;  // steepest, of sin^2
    const Difference d = driver::compare(mine, sampled(pulse, 1001, 0.9 * slope * std::abs(shift)));
    const auto& q = d.quantities[0];
    // sin^2(a) - sin^2(a - e) = sin(e) sin(2 a - e): the largest is sin(e), e = pi shift/T.
    const double exact = kHeight * std::sin(std::numbers::pi * std::abs(shift) / kEnd);
    EXPECT_NEAR(q.largest.value / exact, 1.0, 1e-5) << shift;  // rows 1e-4 s off the steepest: (pi/1000)^2/2
    ASSERT_TRUE(q.phase_lag) << shift;
    EXPECT_NEAR(*q.phase_lag, shift, 1e-4 * kEnd)
        << shift;  // linear between cells of T/400: (pi/400)^2/8 in height
    EXPECT_EQ(d.verdict, Verdict::outside) << shift;
    EXPECT_EQ(driver::compare(mine, sampled(pulse, 1001, 1.01 * slope * std::abs(shift))).verdict,
              Verdict::inside);
  }
}

TEST(compare, scaled_history_shows_its_factor) {
  const auto mine = sampled([](double t) { return 1.01 * pulse(t); }, 101);
  const auto d = driver::compare(mine, sampled(pulse, 101, 1000.0));
  const auto& q = d.quantities[0];
  ASSERT_TRUE(q.relative);
  EXPECT_NEAR(*q.relative, 0.01, 1e-14);  // eps over 0.01
  EXPECT_NEAR(q.largest.value, 0.01 * (kBase + kHeight), 1e-10);
  EXPECT_NEAR(q.share_of_band, 1.2, 1e-12);
  EXPECT_NEAR(q.mine.value / q.reference.value, 1.01, 1e-14);
  EXPECT_EQ(d.verdict, Verdict::outside);
  EXPECT_EQ(driver::compare(mine, sampled(pulse, 101, 1201.0)).verdict, Verdict::inside);
}

TEST(compare, nothing_is_relative_to_a_signal_of_zeros) {
  const auto zeros = sampled([](double) { return 0.0; }, 101, 1.0);
  const auto d = driver::compare(sampled([](double) { return 0.5; }, 101), zeros);
  EXPECT_FALSE(d.quantities[0].relative);
  EXPECT_EQ(d.quantities[0].l2, 0.5);
  EXPECT_EQ(d.verdict, Verdict::inside) << d.reason;
}

TEST(compare, offset_is_max_and_l2_on_any_rows) {
  auto mine = sampled([](double t) { return pulse(t) + 70.0; }, 101);
  auto reference = sampled(pulse, 101, 100.0);
  // Rows that crowd at the start weigh no more in the mean over time.
  for (auto* history : {&mine, &reference})
    for (std::size_t i = 0; i < 101; ++i) history->time[i] *= std::sqrt(history->time[i] / kEnd);
  const auto d = driver::compare(mine, reference);
  EXPECT_NEAR(d.quantities[0].largest.value, 70.0, 1e-10);  // eps of 1e5
  EXPECT_NEAR(d.quantities[0].l2, 70.0, 1e-10);
}

TEST(compare, one_row_outside_is_outside) {
  auto mine = sampled(pulse, 101);
  mine.columns[0].second[37] += 51.0;
  const auto d = driver::compare(mine, sampled(pulse, 101, 50.0));
  EXPECT_EQ(d.verdict, Verdict::outside);
  EXPECT_NE(d.reason.find("1 of 101 rows outside the band, first at 0.037 s"), std::string::npos) << d.reason;
}

TEST(compare, resampled_history_is_judged_within_what_interpolation_knows) {
  // Linear interpolation of sin^2 errs by up to h^2/8 of the second derivative, 2 (pi/T)^2 of the height.
  const auto error = [](int rows) {
    const double h = kEnd / (rows - 1);
    return h * h / 8.0 * kHeight * 2.0 * std::pow(std::numbers::pi / kEnd, 2);
  };
  EXPECT_EQ(driver::compare(sampled(pulse, 743), sampled(pulse, 101, 1.05 * error(743))).verdict,
            Verdict::inside);
  EXPECT_EQ(driver::compare(sampled(pulse, 31), sampled(pulse, 101, 1.05 * error(31))).verdict,
            Verdict::inside);
  const auto coarse = driver::compare(sampled(pulse, 31), sampled(pulse, 101, 0.5 * error(31)));
  EXPECT_EQ(coarse.verdict, Verdict::undecided);
  EXPECT_NE(coarse.reason.find("sampled too coarsely"), std::string::npos) << coarse.reason;
  // What is wrong by more than that stays wrong.
  const auto wrong = sampled([](double t) { return 1.01 * pulse(t); }, 31);
  EXPECT_EQ(driver::compare(wrong, sampled(pulse, 101, 0.5 * error(31))).verdict, Verdict::outside);
}

TEST(compare, samples_an_instant_apart_leave_it_open) {
  // The cubic through them has weights beyond a double: what interpolation may err is then unknown.
  const History mine{{0.0, 1e-310, 0.5 * kEnd, kEnd},
                     {{"pressure_Pa", {kBase, kBase, pulse(0.5 * kEnd), kBase}}}};
  const auto d = driver::compare(mine, sampled(pulse, 101, 1.0));
  EXPECT_EQ(d.verdict, Verdict::undecided) << d.reason;
}

TEST(compare, cut_history_is_undecided_unless_it_is_wrong) {
  const auto reference = sampled(pulse, 101, 50.0);
  const auto cut = driver::compare(sampled(pulse, 61, 0.0, 0.0, 0.06), reference);
  EXPECT_EQ(cut.verdict, Verdict::undecided);
  EXPECT_NE(cut.reason.find("covers 0 to 0.06 s"), std::string::npos) << cut.reason;
  EXPECT_EQ(cut.time.size(), 61u);
  EXPECT_EQ(driver::compare(sampled(pulse, 61, 0.0, 0.04, 0.1), reference).verdict, Verdict::undecided);
  EXPECT_EQ(driver::compare(sampled(pulse, 301, 0.0, -0.1, 0.2), reference).verdict, Verdict::inside);
  const auto wrong = sampled([](double t) { return pulse(t) + 60.0; }, 61, 0.0, 0.0, 0.06);
  EXPECT_EQ(driver::compare(wrong, reference).verdict, Verdict::outside);
}

TEST(compare, what_cannot_be_said_is_undecided) {
  const auto mine = sampled(pulse, 101);
  const auto undecided = [&](const History& a, const History& b, const char* reason) {
    const auto d = driver::compare(a, b);
    EXPECT_EQ(d.verdict, Verdict::undecided) << reason;
    EXPECT_NE(d.reason.find(reason), std::string::npos) << d.reason;
  };
  undecided(mine, sampled(pulse, 101), "has no band");
  undecided(mine, sampled(pulse, 101, 1.0, 1.0, 2.0), "no common times");
  undecided(mine, sampled(pulse, 101, 2e4), "as wide as the signal");
  auto constant = sampled([](double) { return 300.0; }, 101);
  undecided(constant, sampled([](double) { return 300.0; }, 101, 301.0), "as wide as the signal");
  EXPECT_EQ(driver::compare(constant, sampled([](double) { return 300.0; }, 101, 1.0)).verdict,
            Verdict::inside);
  EXPECT_FALSE(driver::compare(constant, constant).quantities[0].phase_lag);
  auto reference = sampled(pulse, 101, 1.0);
  reference.columns.emplace_back("volume_m3", std::vector<double>(101, 0.06));
  EXPECT_EQ(driver::compare(mine, reference).verdict, Verdict::inside);  // without a band: shown, not judged
  reference.columns.emplace_back("volume_m3_band", std::vector<double>(101, 1e-9));
  undecided(mine, reference, "volume_m3: mine does not have it");
  EXPECT_EQ(driver::compare(mine, reference, {"pressure_Pa"}).verdict, Verdict::inside);
}

TEST(compare, outside_outranks_undecided) {
  auto reference = sampled(pulse, 101, 1.0);
  reference.columns.emplace_back("volume_m3", std::vector<double>(101, 0.06));
  reference.columns.emplace_back("volume_m3_band", std::vector<double>(101, 1e-9));
  const auto mine = sampled([](double t) { return pulse(t) + 2.0; }, 101);
  EXPECT_EQ(driver::compare(mine, reference).verdict, Verdict::outside);
}

TEST(compare, bad_reference_is_refused) {
  const auto message = [](const History& reference, const std::vector<std::string>& only) -> std::string {
    try {
      driver::compare(sampled(pulse, 101), reference, only);
    } catch (const driver::CaseError& error) {
      return error.what();
    }
    return "accepted";
  };
  auto reference = sampled(pulse, 101, 1.0);
  EXPECT_EQ(message(reference, {}), "accepted");
  EXPECT_NE(message(reference, {"volume_m3"}).find("--columns volume_m3: the reference has no"),
            std::string::npos);
  EXPECT_NE(message(reference, {"pressure_Pa_band"}).find("no such quantity"), std::string::npos);
  EXPECT_NE(message(reference, {"pressure_Pa", "pressure_Pa"}).find("--columns pressure_Pa: is given twice"),
            std::string::npos);
  reference.columns[1].second[3] = -1.0;
  EXPECT_NE(message(reference, {}).find("pressure_Pa_band: -1 at 0.003 s"), std::string::npos);
  reference.columns[1] = {"volume_m3_band", std::vector<double>(101, 1.0)};
  EXPECT_NE(message(reference, {}).find("has a band but no column volume_m3"), std::string::npos);
}

}  // namespace
