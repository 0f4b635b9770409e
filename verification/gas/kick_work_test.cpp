// SPDX-License-Identifier: Apache-2.0
#include "gas/kick_work.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace {

// Energy that has left the gas [J] at each level, if the kicks work at `power` [W] of time [s].
template <class Power>
std::vector<double> taken(const std::vector<double>& steps, Power power) {
  gas::KickWork kicks;
  gas::ControlVolumeState state{.masses = {}, .internal_energy = 0.0, .temperature = 300.0};
  std::vector<double> energy{0.0};
  double time = 0.0, before = 0.0;
  for (const double after : steps) {
    kicks.take(0.5 * (before + after) * power(time), before, after, state);
    energy.push_back(-state.internal_energy);
    time += after;
    before = after;
  }
  return energy;
}

}  // namespace

TEST(kick_work, constant_power_takes_power_times_time_at_every_level) {
  const std::vector<double> steps{1.0, 0.5, 2.0, 0.25, 4.0};
  const std::vector<double> energy = taken(steps, [](double) { return 3.0; });
  double time = 0.0;
  for (std::size_t n = 0; n < steps.size(); ++n) {
    time += steps[n];
    // A kick's part is work times a ratio of steps, which rounds twice.
    EXPECT_NEAR(energy[n + 1], 3.0 * time, 4e-15 * 3.0 * time);
  }
}

// With even steps the kicks are a midpoint rule, and half a step of the last one's rate is taken ahead:
// it lacks h^2/2 of a power that rises by 1 W/s, at the end.
TEST(kick_work, rising_power_errs_in_second_order) {
  for (const int count : {10, 20, 40}) {
    const double h = 1.0 / count;
    const std::vector<double> steps(static_cast<std::size_t>(count), h);
    EXPECT_NEAR(taken(steps, [](double t) { return t; }).back(), 0.5 - 0.5 * h * h, 1e-14);
  }
}
