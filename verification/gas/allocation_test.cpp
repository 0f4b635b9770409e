// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "cases.hpp"
#include "support/allocation_counter.hpp"

namespace {

using namespace cases;

/// Inflow knots, sonic switch, equalisation and evaluation included; 1e-6, for Euler's many sub-steps.
void expect_no_allocation(gas::Method method) {
  gas::ControlVolumeModel model = closed_tank(nasa7({"N2", "CO2"}));
  model.vents.push_back({1.0, 1e-3});
  model.inflows.push_back({{0.5, 0.5},
                           gas::Curve({{0.0, 0.0}, {0.01, 20.0}, {0.05, 0.0}}, gas::Outside::zero),
                           gas::Curve({{0.0, 600.0}, {0.02, 1200.0}}, gas::Outside::held)});
  gas::GasIntegrator integrator(model, {.relative_tolerance = 1e-6, .method = method});
  gas::ControlVolumeState state =
      gas::make_state(model.thermo, std::vector{1.0, 0.0}, 101325.0, 293.15, 0.06);
  const long before = support::allocations();
  double peak = 0.0, pressure = 0.0;
  for (int i = 0; i < 100; ++i) {
    integrator.advance(state, 0.01 * i, 0.01 * (i + 1), {0.06 + 1e-5 * i, 0.06 + 1e-5 * (i + 1), 1e-3, 1e-3});
    pressure = gas::evaluate(model, state, 0.06 + 1e-5 * (i + 1), 1e-3, 0.01 * (i + 1)).pressure;
    peak = std::max(peak, pressure);
  }
  EXPECT_EQ(support::allocations() - before, 0) << "method " << static_cast<int>(method);
  EXPECT_GT(peak, 2.0 * kAmbientPressure);  // the run was choked
  EXPECT_LT(pressure, 1.001 * kAmbientPressure);
}

TEST(allocation, none_in_advance_and_evaluate) {
  for (const gas::Method method : kMethods) expect_no_allocation(method);
  const long counted = support::allocations();
  { std::vector<double> control(10); }
  EXPECT_GT(support::allocations() - counted, 0) << "the counter counts";
}

}  // namespace
