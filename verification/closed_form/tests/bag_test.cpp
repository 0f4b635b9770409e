// SPDX-License-Identifier: Apache-2.0
#include "check.hpp"
#include "closed_form/gas.hpp"
#include "closed_form/orifice.hpp"

namespace {

using namespace closed_form;
using test::expect_refused;
using test::expect_relative;
using test::kAlgebra;
using test::kIntegrated;

constexpr PerfectGas kBagGas{208.13, 5.0 / 3.0};

TEST(ClosedFormBag, rigid_spring_bag_eq_tank_fill) {
  const GasState bag = spring_bag_fill({{}, 101325.0, 293.15, 0.06, 0.0}, 0.05, 700.0);
  const GasState tank = tank_fill({{}, 0.06, 101325.0, 293.15, 1.0, 700.0}, 0.05);
  expect_relative(bag.pressure, tank.pressure, kAlgebra);
  expect_relative(bag.temperature, tank.temperature, kAlgebra);
}

TEST(ClosedFormBag, spring_bag_fill_closes_the_energy_balance) {
  for (const PerfectGas& gas : {PerfectGas{}, kBagGas})
    for (const double k : {1e-9, 5e-7, 1e-4}) {
      const SpringBag bag{gas, 1.2e5, 350.0, 0.02, k};
      const GasState s = spring_bag_fill(bag, 0.03, 800.0);
      const double mass = 1.2e5 * 0.02 / (gas.gas_constant * 350.0);
      const auto pressure = [&](double v) { return 1.2e5 + (v - 0.02) / k; };
      const double work = test::integrate(pressure, 0.02, s.volume);
      const double cv = specific_heat_cv(gas), supplied = 0.03 * specific_heat_cp(gas) * 800.0;
      expect_relative(s.mass * cv * s.temperature - mass * cv * 350.0 + work, supplied, 1e-12);
      expect_relative(s.volume, 0.02 + k * (s.pressure - 1.2e5), kAlgebra);
    }
}

// dm/dt and dU/dt in (m, U), where p^2 = (gamma - 1) U p0/V0 and p dV = dU (gamma - 1)/2.
TEST(ClosedFormBag, proportional_blowdown_eq_integrated_rates) {
  for (const PerfectGas& gas : {PerfectGas{}, kBagGas}) {
    const Blowdown bag{gas, 0.06, 1e-3, 0.7, 5e5, 600.0, 101325.0};
    const double g1 = gas.heat_capacity_ratio - 1.0, cv = specific_heat_cv(gas);
    const auto rates = [&](const std::vector<double>& y) {
      const double temperature = y[1] / (y[0] * cv), p = std::sqrt(g1 * y[1] * 5e5 / 0.06);
      const double flow = orifice_mass_flow({gas, 1e-3, 0.7, p, temperature, 101325.0});
      return std::vector<double>{-flow, -flow * specific_heat_cp(gas) * temperature / (1.0 + 0.5 * g1)};
    };
    const double mass = 5e5 * 0.06 / (gas.gas_constant * 600.0);
    const auto y = test::integrate_ode([&](double, const std::vector<double>& v) { return rates(v); },
                                       {mass, mass * cv * 600.0}, 0.0, 0.1);
    const GasState s = proportional_blowdown(bag, 0.1);
    expect_relative(s.mass, y[0], kIntegrated);
    expect_relative(s.mass * cv * s.temperature, y[1], kIntegrated);
    expect_relative(s.volume / s.pressure, 0.06 / 5e5, kAlgebra);
  }
}

TEST(ClosedFormBag, bad_parameters_are_refused_by_name) {
  expect_refused([] { spring_bag_fill({{}, 101325.0, 293.15, 0.06, -1.0}, 0.05, 700.0); }, "compliance");
  expect_refused([] { spring_bag_fill({{}, 101325.0, 293.15, 0.06, 0.0}, -0.05, 700.0); }, "inflow_mass");
  const Blowdown bag{{}, 0.06, 1e-3, 1.0, 5e5, 600.0, 101325.0};
  expect_refused([&] { proportional_blowdown(bag, 10.0); }, "time");
  expect_refused([&] { proportional_blowdown({{}, 0.06}, 0.1); }, "area");
}

}  // namespace
