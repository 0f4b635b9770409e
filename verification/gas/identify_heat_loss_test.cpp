// SPDX-License-Identifier: Apache-2.0
#include "identify_heat_loss.hpp"

#include <string>

// A tank test whose tank loses heat: the loss and the flow come back.
namespace {

using namespace cases;

/// Loss, flow and temperature come back to what smoothing and the spacing of the points leave: 1e-3.
TEST(identify_heat_loss, fit_finds_the_loss_of_a_record_without_noise) {
  const gas::Thermo real = nasa7({"N2", "CO2"});
  const gas::TankTest tests[] = {small_test(),
                                 {real, 0.06, 293.15, std::vector{1.0, 0.0}, std::vector{0.4, 0.6}, 0.034}};
  for (const auto& test : tests)
    for (const double loss : {10.0, 90.0}) {
      const Record record = record_with_loss(test, loss, 901);
      const auto found = gas::identify(test, record.average(), fitted());
      EXPECT_NEAR(found.heat_loss, loss, 1e-3 * loss);
      EXPECT_NEAR(found.mean_temperature, kLossTemperature, 1e-3 * kLossTemperature);
      EXPECT_GE(found.tail_start, 0.045);
      EXPECT_TRUE(found.fits);
      const auto given =
          gas::identify(test, record.average(), {.points = 301, .draws = 40, .heat_loss = loss});
      EXPECT_EQ(given.heat_loss, loss);
      EXPECT_NEAR(given.mean_temperature, kLossTemperature, 1e-3 * kLossTemperature);
      EXPECT_TRUE(given.fits);
      // Without the term the record does not fit, and the gas seems colder.
      const auto without = gas::identify(test, record.average(), {.points = 301, .draws = 40});
      EXPECT_FALSE(without.fits);
      EXPECT_LT(without.mean_temperature, kLossTemperature - 0.1 * loss);
    }
}

TEST(identify_heat_loss, dual_pressure_takes_the_loss_into_account) {
  const Record record = record_with_loss(small_test(), 90.0, 3001);
  const auto found = gas::identify(small_test(), record.dual(), fitted(601));
  EXPECT_NEAR(found.mean_temperature, kLossTemperature, 1e-3 * kLossTemperature);
  EXPECT_NEAR(found.effective_area, 1e-5, 0.01 * 1e-5);  // corners of the pulse
  EXPECT_TRUE(found.fits);
  for (const auto& point : found.points)
    if (!point.masked && point.time > 0.02 && point.time < 0.035) {
      EXPECT_NEAR(point.temperature, kLossTemperature, 0.02 * kLossTemperature) << point.time;
    }
}

std::string refusal(const gas::TankTest& test, const Record& record) {
  try {
    gas::identify(test, record.average(), fitted());
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

TEST(identify_heat_loss, a_tail_that_says_too_little_is_refused) {
  const auto has = [](const std::string& text, const char* part) { return text.find(part) != text.npos; };
  const std::string brief = refusal(small_test(), record_with_loss(small_test(), 90.0, 41, 0.047));
  EXPECT_TRUE(has(brief, "heat_loss = fit: after the rise the record has ")) << brief;
  EXPECT_TRUE(has(brief, "or more over ")) << brief;
  EXPECT_TRUE(has(brief, "; give its value [W/K] instead")) << brief;
  const std::string flowing = refusal(small_test(), record_with_loss(small_test(), 90.0, 401, 0.047));
  EXPECT_TRUE(has(flowing, "does not fall as a loss to the walls makes it fall, at no start up to "))
      << flowing;
  // Cold at its end.
  const std::string cold = refusal(small_test(), record_with_loss(small_test(), 4000.0, 901));
  EXPECT_TRUE(has(cold, "K above the walls, needed: 20 K or more; use a shorter record")) << cold;
  // A tail that grows instead.
  Record rising = record_with_loss(small_test(), 0.0, 901);
  for (std::size_t i = 0; i < rising.times.size(); ++i)
    if (rising.times[i] > 0.045) rising.tank[i] *= 1.0 + 0.2 * (rising.times[i] - 0.045);
  rising.add_noise(0.003, 1);
  const std::string grown = refusal(small_test(), rising);
  EXPECT_TRUE(has(grown, "after the flow the pressure rises, as if the walls gave ") ||
              has(grown, "does not fall as a loss to the walls makes it fall"))
      << grown;
  gas::IdentifyOptions negative{.heat_loss = -1.0};
  EXPECT_THROW(gas::identify(small_test(), rising.average(), negative), std::invalid_argument);
}

}  // namespace
