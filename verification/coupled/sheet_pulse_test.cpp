// SPDX-License-Identifier: Apache-2.0
// A pressure that the case gives over time on a free sheet: speed, energy and place are those of its impulse
// (K.41).
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "case_folder.hpp"
#include "claim.hpp"
#include "run_case.hpp"

namespace {

using coupled::scene_of_text;
using Numbers = std::vector<double>;

// A square of 1 m2, 0.31 kg.
std::string sheet() {
  std::string text;
  for (int j = 0; j <= 4; ++j)
    for (int i = 0; i <= 4; ++i) text += fmt::format("v {} {} 0\n", 0.25 * i, 0.25 * j);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const int a = 5 * j + i + 1;
      text += fmt::format("f {} {} {}\nf {} {} {}\n", a, a + 1, a + 6, a, a + 6, a + 5);
    }
  return text;
}

driver::Scene free_sheet(const coupled::Folder& folder, const std::string& pressure,
                         const std::vector<std::string>& overrides = {}) {
  std::ofstream(folder.path / "sheet.obj") << sheet();
  return scene_of_text(
      folder,
      "[scene]\nname = \"s\"\nend_time = 0.01\n[fabric]\nyoung_modulus = 60e6\npoisson_ratio = 0.3\n"
      "density = 620.0\nthickness = 0.5e-3\n[membrane]\nmesh = { file = \"sheet.obj\" }\noverpressure = " +
          pressure + "\n[output]\nhistory_every = 1e-5\n",
      overrides);
}

TEST(sheet_pulse, free_sheet_gets_the_speed_and_energy_of_any_pulse) {
  const coupled::Folder folder;
  std::mt19937 random(11);
  const auto uniform = [&] { return std::generate_canonical<double, 53>(random); };
  for (int i = 0; i < 16; ++i) {
    const double start = i == 0 ? 0.0 : 0.008 * uniform(), rise = std::pow(10.0, -8.0 + 3.0 * uniform()),
                 width = std::pow(10.0, -7.0 + 4.0 * uniform()), peak = 10.0 / (rise + width);  // 10 Pa s
    const auto run = coupled::run_of(
        free_sheet(folder, fmt::format("{{time=[{},{},{},{}],value=[0.0,{},{},0.0]}}", start, start + rise,
                                       start + rise + width, start + 2.0 * rise + width, peak, peak)));
    EXPECT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
    EXPECT_EQ(run.outcome.warning, "");
    const double speed = 10.0 / 0.31, energy = 0.5 * 0.31 * speed * speed;
    // Knots are sums of decimal numbers: to 1e-18 s of the shortest rise.
    EXPECT_NEAR(run.energy.back().at("skin_kinetic_J"), energy, 1e-9 * energy) << start;
    EXPECT_NEAR(run.energy.back().at("pressure_work_J"), energy, 1e-9 * energy) << start;
    // A free mass keeps (K.21) at every level, in the pulse too; the corners of fabric that moves as a whole
    // stay where they are by rounding alone.
    EXPECT_LT(run.state.peaks.energy_residual, 1e-9 * energy) << start << ' ' << width;
  }
}

// x after a push that has not ended: int int p / (rho h).
TEST(sheet_pulse, free_sheet_moves_with_order_2) {
  const coupled::Folder folder;
  // Parabolas between the knots, in closed form.
  const Numbers time{0.0, 0.0013, 0.0029, 0.01}, pressure{20.0, 100.0, 40.0, 150.0};
  double x = 0.0, v = 0.0;
  for (std::size_t i = 0; i + 1 < time.size(); ++i) {
    const double h = time[i + 1] - time[i], a = pressure[i] / 0.31,
                 b = (pressure[i + 1] - pressure[i]) / 0.31 / h;
    x += h * (v + h * (a / 2.0 + h * b / 6.0));
    v += h * (a + h * b / 2.0);
  }
  std::vector<double> errors;
  for (const char* step : {"time.step=4e-5", "time.step=2e-5", "time.step=1e-5"}) {
    const auto run = coupled::run_of(free_sheet(
        folder, fmt::format("{{time=[{}],value=[{}]}}", fmt::join(time, ","), fmt::join(pressure, ",")),
        {step}));
    errors.push_back(std::abs(run.history.back().at("skin_displacement_m") - x));
  }
  claim::expect_order({"K.41", "free sheet under a prescribed pressure with kinks: place at 10 ms [m]",
                       "kinks off the steps"},
                      errors, 1.9, 2.1);
}

}  // namespace
