// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "identify_pulses.hpp"

// Tank tests whose gauge is cut off at the end of its range: recognised, named, and nothing is claimed.
namespace {

using namespace cases;

constexpr gas::IdentifyOptions kClippedBands{.points = 101, .draws = 40};

double largest(const std::vector<double>& readings) {
  return *std::max_element(readings.begin(), readings.end());
}

void cut_off(std::vector<double>& readings, double share) {
  const double top = share * largest(readings);
  for (double& p : readings) p = std::min(p, top);
}

/// To steps of the gauge [Pa].
void round_to(std::vector<double>& readings, double step) {
  for (double& p : readings) p = step * std::round(p / step);
}

bool claims(const gas::Identified& found) {
  return found.bands || std::ranges::any_of(found.points, &gas::IdentifiedPoint::band_claimed);
}

struct Gauge {
  double noise, step;  // [-] of the reading, [Pa] of the gauge (0: none)
};
const Gauge kGauges[] = {{0.01, 0.0}, {0.01, 1.0}, {0.002, 1e3}, {1e-3, 100.0}, {0.0, 0.0}, {0.0, 100.0}};

Record measured(const Gauge& gauge, double end, int count, unsigned seed) {
  Record record(one_gas_truth(1e-4), end, count);
  if (gauge.noise > 0.0) record.add_noise(gauge.noise, seed);
  return record;
}

TEST(identify_clipping, chamber_gauge_is_named_and_nothing_is_claimed) {
  unsigned seed = 0;
  for (const auto& gauge : kGauges)
    for (const double share : {0.4, 0.7, 0.9, 0.97}) {
      SCOPED_TRACE(testing::Message() << gauge.noise << ' ' << gauge.step << ' ' << share);
      Record record = measured(gauge, 0.06, 601, ++seed);
      cut_off(record.chamber, share);
      if (gauge.step > 0.0)
        for (auto* readings : {&record.tank, &record.chamber}) round_to(*readings, gauge.step);
      const gas::Identified found = gas::identify(one_gas_test(), record.dual(), kClippedBands);
      ASSERT_TRUE(found.chamber_clipping);
      EXPECT_EQ(found.chamber_clipping->pressure, largest(record.chamber));
      EXPECT_FALSE(found.tank_clipping);
      EXPECT_FALSE(claims(found));
    }
}

TEST(identify_clipping, tank_gauge_is_named_and_nothing_is_claimed_by_either_method) {
  unsigned seed = 0;
  for (const auto& gauge : kGauges)
    for (const double share : {0.5, 0.8, 0.95}) {
      SCOPED_TRACE(testing::Message() << gauge.noise << ' ' << gauge.step << ' ' << share);
      Record record = measured(gauge, 0.06, 601, ++seed);
      cut_off(record.tank, share);
      if (gauge.step > 0.0) round_to(record.tank, gauge.step);
      for (const auto& readings : {record.average(), record.dual()}) {
        const gas::Identified found = gas::identify(one_gas_test(), readings, kClippedBands);
        ASSERT_TRUE(found.tank_clipping);
        EXPECT_EQ(found.tank_clipping->pressure, largest(record.tank));
        EXPECT_FALSE(claims(found));
      }
    }
}

/// Gauges wide enough: rounded, noisy, slow or fast, at rest at the end or not.
TEST(identify_clipping, wide_gauges_are_not_cut_off) {
  unsigned seed = 0;
  for (const double noise : {0.0, 1e-3, 0.01})
    for (const double step : {0.0, 1.0, 100.0, 2e3})
      for (const double end : {0.045, 0.051, 0.06})
        for (const int count : {101, 601}) {
          SCOPED_TRACE(testing::Message() << noise << ' ' << step << ' ' << end << ' ' << count);
          Record record = measured({noise, step}, end, count, ++seed);
          if (step > 0.0)
            for (auto* readings : {&record.tank, &record.chamber}) round_to(*readings, step);
          const gas::TankReadings readings = record.dual();
          // No draws are needed to see it: the least number of them, and of points.
          const gas::Identified found =
              gas::identify(one_gas_test(), {readings.times, readings.tank, {}}, {.points = 20, .draws = 40});
          EXPECT_FALSE(found.tank_clipping);
          if (count == 601 && step < 1e3) {
            EXPECT_FALSE(
                gas::identify(one_gas_test(), readings, {.points = 20, .draws = 40}).chamber_clipping);
          }
        }
}

/// While the chamber's gauge is cut off the tank's pressure still gives mdot T_s; T_s is held between the
/// rows beside, 6 % off at most for a third of the range lost.
TEST(identify_clipping, flow_while_the_chamber_gauge_is_cut_off_follows_from_the_tank) {
  const Truth truth = one_gas_truth(1e-4);
  Record record(truth, 0.06, 601);
  cut_off(record.chamber, 0.65);
  const gas::Identified found = gas::identify(one_gas_test(), record.dual(), kClippedBands);
  for (const auto& point : found.points) {
    if (point.time < found.chamber_clipping->first || point.time > found.chamber_clipping->last) continue;
    EXPECT_TRUE(point.masked);
    EXPECT_LT(relative(point.mass_flow, truth(point.time).mass_flow), 0.15) << point.time;
  }
}

/// Gas that would have to be hotter than its polynomials allow, or colder: what stands there is the end of
/// their range, and no band is claimed.
TEST(identify_clipping, temperature_at_the_end_of_the_range_is_not_claimed) {
  const gas::TankTest test = nasa7_test();
  Record record(nasa7_truth(test), 0.06, 601);
  record.add_noise(0.01, 5);
  for (std::size_t i = 0; i < record.times.size(); ++i)  // a chamber gauge that reads too little late
    if (record.times[i] > 0.03) record.chamber[i] = std::max(record.tank[i], 0.2 * record.chamber[i]);
  const gas::Identified found = gas::identify(test, record.dual(), kClippedBands);
  int ends = 0;
  for (const auto& point : found.points) {
    const bool at_end = point.temperature <= 200.0 || point.temperature >= 6000.0 ||
                        point.temperature_band.low <= 200.0 || point.temperature_band.high >= 6000.0;
    ends += at_end;
    if (at_end) {
      EXPECT_FALSE(point.band_claimed) << point.time;
    }
  }
  EXPECT_GT(ends, 10);
}

}  // namespace
