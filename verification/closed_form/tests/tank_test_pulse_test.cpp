// SPDX-License-Identifier: Apache-2.0
#include "check.hpp"
#include "closed_form/gas.hpp"
#include "closed_form/orifice.hpp"
#include "closed_form/tank_test.hpp"

namespace {

using namespace closed_form;
using test::expect_refused;
using test::expect_relative;
using test::kAlgebra;

const TankTestPulse kPulse{0.06, 101325.0, 293.15, 0.08, 0.05, 800.0, 400.0, 2e-4};
const PerfectGas kHelium{2077.1, 5.0 / 3.0};

TEST(ClosedFormTankTest, chamber_pressure_is_the_inverse_of_the_outlet_flow) {
  for (const PerfectGas& gas : {PerfectGas{}, kHelium})
    for (const double flow : {1e-4, 1e-2, 0.047, 0.05, 0.108, 0.118, 0.5, 5.0}) {
      const double p = chamber_pressure(gas, 2e-4, flow, 700.0, 2e5);
      EXPECT_GT(p, 2e5);
      // The flow goes with the root of the pressure difference: its relative error is that of p times p/(2
      // dp).
      const double condition = 1.0 + p / (2.0 * (p - 2e5));
      expect_relative(orifice_mass_flow({gas, 2e-4, 1.0, p, 700.0, 2e5}), flow, kAlgebra * condition);
    }
  EXPECT_EQ(chamber_pressure({}, 2e-4, 0.0, 700.0, 2e5), 2e5);
}

TEST(ClosedFormTankTest, one_gas_is_the_pulse_fill_and_its_reference_digits) {
  for (const double t : {0.0, 0.0125, 0.03, 0.05, 0.07}) {
    const PulseFill fill{{}, 0.06, 101325.0, 293.15, 0.08, 0.05, 800.0, 400.0};
    // Integrals are taken back out of a state that the tank's own gas dominates at first.
    expect_relative(tank_test_pulse({}, {}, kPulse, t).tank_pressure, pulse_fill(fill, t).pressure,
                    10.0 * kAlgebra);
  }
  expect_relative(tank_test_pulse({}, {}, kPulse, 0.0125).chamber_pressure, 5325380.8913917134, kAlgebra);
}

TEST(ClosedFormTankTest, two_gases_end_as_one_filling_of_the_mean_enthalpy) {
  const TwoGasState end =
      two_gas_fill({{}, kHelium, 0.06, 101325.0, 293.15, 0.08, 600.0});  // mean of T_s over the pulse
  expect_relative(tank_test_pulse({}, kHelium, kPulse, 0.05).tank_pressure, end.state.pressure,
                  10.0 * kAlgebra);
}

/// Coefficients of a constant cp must give the closed form; the temperature is found by bisection to 1e-13.
TEST(ClosedFormTankTest, nasa7_with_constant_cp_eq_closed_form) {
  const auto constant = [](double R, double gamma) {
    const std::array<double, 7> a{gamma / (gamma - 1.0), 0, 0, 0, 0, 0, 0};
    return Nasa7Gas{{0.25, R, a, a}, {0.75, R, a, a}};
  };
  for (const double t : {0.01, 0.025, 0.05}) {
    const TankTestReadings closed = tank_test_pulse({}, kHelium, kPulse, t);
    const TankTestReadings found =
        nasa7_tank_test_pulse(constant(296.8, 1.4), constant(2077.1, 5.0 / 3.0), kPulse, t);
    expect_relative(found.tank_pressure, closed.tank_pressure, 1e-12);
    expect_relative(found.chamber_pressure, closed.chamber_pressure, 1e-12);
  }
}

/// h is the integral of cp: the coefficients 1, 2, 3, 4, 5, 6 of a made-up gas, by hand at 2 K.
TEST(ClosedFormTankTest, nasa7_enthalpy_by_hand) {
  const Nasa7Gas gas{{0.5, 10.0, {1, 2, 3, 4, 5, 6, 0}, {}}, {0.5, 20.0, {1, 0, 0, 0, 0, 0, 0}, {}}};
  EXPECT_DOUBLE_EQ(nasa7_enthalpy(gas, 2.0), 5.0 * (6 + 2 + 4 + 8 + 16 + 32) + 10.0 * 2.0);
}

TEST(ClosedFormTankTest, bad_parameters_are_refused_by_name) {
  expect_refused([] { chamber_pressure({}, 0.0, 1.0, 700.0, 1e5); }, "outlet_area");
  expect_refused([] { tank_test_pulse({}, {}, {}, 0.0); }, "volume");
  expect_refused([] { tank_test_pulse({}, {}, kPulse, -1.0); }, "time");
}

}  // namespace
