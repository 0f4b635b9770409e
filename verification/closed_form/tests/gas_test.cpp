// SPDX-License-Identifier: Apache-2.0
// Reference numbers: 40-digit arithmetic (mpmath), rounded to 17 digits: mass and energy balances with the
// inflow integrated by quadrature, and the explicit formulas.
#include "closed_form/gas.hpp"

#include "check.hpp"
#include "closed_form/orifice.hpp"
#include "closed_form/tank_test.hpp"

namespace {

using namespace closed_form;
using test::expect_refused;
using test::expect_relative;
using test::kAlgebra;
using test::kIntegrated;

constexpr PerfectGas kArgon{208.13, 5.0 / 3.0};

TankFill reference_fill() {
  return {{}, 0.06, 101325.0, 293.15, 1.0, 700.0};
}

PulseFill reference_pulse() {
  return {{}, 0.06, 101325.0, 293.15, 0.08, 0.05, 800.0, 400.0};
}

TEST(ClosedFormGas, tank_fill_eq_reference) {
  struct Row {
    double t, p, T, m;
  };
  for (const Row& r : {Row{0.01, 149802.33333333333, 379.14195328827001, 0.079873752570485198},
                       Row{0.05, 343711.66666666667, 579.63890406435531, 0.1198737525704852},
                       Row{0.1, 586098.33333333333, 697.47967989861025, 0.1698737525704852}}) {
    const GasState s = tank_fill(reference_fill(), r.t);
    expect_relative(s.pressure, r.p, kAlgebra);
    expect_relative(s.temperature, r.T, kAlgebra);
    expect_relative(s.mass, r.m, kAlgebra);
  }
  // T -> gamma T_in = 980 K: the initial mass is a share 0.07/1e6 of the final one.
  expect_relative(tank_fill(reference_fill(), 1e6).temperature, 980.0, 1e-6);
}

TEST(ClosedFormGas, evacuated_tank_has_gamma_times_inflow_temperature) {
  for (const PerfectGas& gas : {PerfectGas{}, kArgon})
    for (const double t : {0.0, 1e-12, 0.03}) {
      const GasState s = tank_fill({gas, 0.02, 0.0, 300.0, 2.5, 650.0}, t);
      expect_relative(s.temperature, gas.heat_capacity_ratio * 650.0, kAlgebra);
      EXPECT_EQ(s.mass, 2.5 * t);
    }
}

TEST(ClosedFormGas, pulse_fill_eq_reference) {
  struct Row {
    double t, p, T, m;
  };
  for (const Row& r : {Row{0.0125, 137868.27841308338, 361.29706308318067, 0.077141357123133571},
                       Row{0.025, 284007.40580611622, 522.54423562731905, 0.1098737525704852},
                       Row{0.05, 433741.0, 585.04900999793436, 0.1498737525704852},
                       Row{0.07, 433741.0, 585.04900999793436, 0.1498737525704852}}) {
    const GasState s = pulse_fill(reference_pulse(), r.t);
    expect_relative(s.pressure, r.p, kAlgebra);
    expect_relative(s.temperature, r.T, kAlgebra);
    expect_relative(s.mass, r.m, kAlgebra);
  }
}

TEST(ClosedFormGas, pulse_fill_eq_integrated_flow) {
  const PulseFill pulse{kArgon, 0.03, 90000.0, 310.0, 0.05, 0.04, 500.0, 900.0};
  const GasState start = pulse_fill(pulse, 0.0);
  const auto rate = [&pulse](double t, const std::vector<double>&) {
    const PulseFlow f = pulse_flow(pulse, t);
    return std::vector<double>{f.mass_flow, f.pressure_rate};
  };
  for (const double t : {0.007, 0.02, 0.04}) {
    const std::vector<double> y = test::integrate_ode(rate, {start.mass, start.pressure}, 0.0, t);
    const GasState s = pulse_fill(pulse, t);
    expect_relative(s.mass, y[0], kIntegrated);
    expect_relative(s.pressure, y[1], kIntegrated);
  }
}

TEST(ClosedFormGas, two_gas_fill_conserves_energy_and_reduces_to_one_gas) {
  const TwoGasFill tank{{}, {2077.1, 5.0 / 3.0}, 0.06, 101325.0, 293.15, 0.02, 700.0};
  const TwoGasState s = two_gas_fill(tank);
  const double mass_a = 101325.0 * 0.06 / (296.8 * 293.15);
  const double before = mass_a * 742.0 * 293.15 + 0.02 * specific_heat_cp(tank.inflow_gas) * 700.0;
  const double after = (mass_a * 742.0 + 0.02 * specific_heat_cv(tank.inflow_gas)) * s.state.temperature;
  expect_relative(after, before, kAlgebra);
  // U = p V/(gamma_mix - 1): the mixture's gamma is the ratio of the sums, not a mean of the gammas.
  expect_relative(s.state.pressure * 0.06 / (s.heat_capacity_ratio - 1.0), before, kAlgebra);
  expect_relative(s.state.pressure * 0.06, s.state.mass * s.gas_constant * s.state.temperature, kAlgebra);

  TwoGasFill same = tank;
  same.inflow_gas = same.tank_gas;
  const GasState one = tank_fill({{}, 0.06, 101325.0, 293.15, 1.0, 700.0}, 0.02);
  expect_relative(two_gas_fill(same).state.pressure, one.pressure, kAlgebra);
  expect_relative(two_gas_fill(same).state.temperature, one.temperature, kAlgebra);
}

TEST(ClosedFormGas, vented_fill_eq_reference) {
  const VentedFillSteady s = vented_fill_steady({{}, 0.06, 0.5, 700.0, 1e-3});
  expect_relative(s.state.pressure, 332836.30571198209, kAlgebra);
  expect_relative(s.state.mass, 0.096121382088558554, kAlgebra);
  expect_relative(s.slow_eigenvalue, -3.9610516554213691, kAlgebra);
  expect_relative(s.fast_eigenvalue, -9.5635145935562409, kAlgebra);
}

TEST(ClosedFormGas, vented_fill_eq_jacobian_of_rates) {
  for (const PerfectGas& gas : {PerfectGas{}, kArgon}) {
    const VentedFill tank{gas, 0.02, 0.4, 500.0, 1.2e-3, 0.7};
    const VentedFillSteady steady = vented_fill_steady(tank);
    const double cp = specific_heat_cp(gas);
    const double cv = specific_heat_cv(gas);
    const auto rates = [&](double m, double U) {
      const double T = U / (m * cv);
      const double p = m * gas.gas_constant * T / tank.volume;
      const double out = orifice_mass_flow({gas, tank.vent_area, tank.discharge_coefficient, p, T, 0.0});
      return std::pair{tank.mass_flow - out, tank.mass_flow * cp * tank.inflow_temperature - out * cp * T};
    };
    const double m = steady.state.mass;
    const double U = m * cv * steady.state.temperature;
    EXPECT_NEAR(rates(m, U).first, 0.0, kAlgebra * tank.mass_flow);
    // Central differences of step 1e-5: error 1e-10 of truncation plus 1e-16/1e-5 of round-off.
    const double dm = 1e-5 * m;
    const double dU = 1e-5 * U;
    const double a11 = (rates(m + dm, U).first - rates(m - dm, U).first) / (2 * dm);
    const double a12 = (rates(m, U + dU).first - rates(m, U - dU).first) / (2 * dU);
    const double a21 = (rates(m + dm, U).second - rates(m - dm, U).second) / (2 * dm);
    const double a22 = (rates(m, U + dU).second - rates(m, U - dU).second) / (2 * dU);
    expect_relative(a11 + a22, steady.slow_eigenvalue + steady.fast_eigenvalue, 1e-8);
    expect_relative(a11 * a22 - a12 * a21, steady.slow_eigenvalue * steady.fast_eigenvalue, 1e-8);
  }
}

TEST(ClosedFormGas, adiabatic_piston_eq_reference_and_work_eq_quadrature) {
  const AdiabaticPiston piston{{}, 101325.0, 293.15, 1e-3};
  const PistonState s = adiabatic_piston(piston, 0.125e-3);
  expect_relative(s.state.pressure, 1862269.7731211932, kAlgebra);
  expect_relative(s.state.temperature, 673.48184553476162, kAlgebra);
  expect_relative(s.work_on_gas, 328.64680410037286, kAlgebra);
  const AdiabaticPiston other{kArgon, 2e5, 400.0, 0.02};
  const auto pressure = [&other](double V) { return adiabatic_piston(other, V).state.pressure; };
  expect_relative(adiabatic_piston(other, 0.03).work_on_gas, -test::integrate(pressure, 0.02, 0.03), 1e-12);
}

TEST(ClosedFormGas, constant_pressure_fill_eq_reference_and_mixes_enthalpy) {
  const GasState s = constant_pressure_fill({{}, 101325.0, 0.01, 293.15, 0.5, 700.0}, 0.1);
  expect_relative(s.volume, 0.11252158894645941, kAlgebra);
  expect_relative(s.temperature, 623.14097435750194, kAlgebra);
  const GasState other = constant_pressure_fill({kArgon, 2e5, 0.02, 350.0, 0.3, 600.0}, 0.2);
  const double mass0 = 2e5 * 0.02 / (208.13 * 350.0);
  expect_relative(other.temperature, (mass0 * 350.0 + 0.06 * 600.0) / (mass0 + 0.06), kAlgebra);
}

TEST(ClosedFormGas, tank_tests_recover_the_pulse) {
  const AverageTemperature average{{}, 0.06, 101325.0, 433741.0, 0.08};
  expect_relative(average_inflow_temperature(average), 600.0, kAlgebra);
  expect_relative(average_temperature_mass_flow(average, 7756373.3333333333), 1.8666666666666667, kAlgebra);
  for (const PerfectGas& gas : {PerfectGas{}, kArgon})
    for (const double t : {0.0125, 0.025, 0.04}) {
      PulseFill pulse = reference_pulse();
      pulse.gas = gas;
      const PulseFlow flow = pulse_flow(pulse, t);
      // The chamber pressure that drives this flow through a choked outlet of 2e-4 m2.
      const double unit = orifice_mass_flow({gas, 2e-4, 1.0, 1.0, flow.temperature, 0.0});
      const DualPressureResult r =
          dual_pressure({gas, 0.06, 2e-4, flow.mass_flow / unit, flow.pressure_rate});
      expect_relative(r.mass_flow, flow.mass_flow, kAlgebra);
      expect_relative(r.temperature, flow.temperature, kAlgebra);
    }
  const DualPressureResult r = dual_pressure({{}, 0.06, 2e-4, 5325380.8913917134, 7756373.3333333333});
  expect_relative(r.mass_flow, 1.6, kAlgebra);
  expect_relative(r.temperature, 700.0, kAlgebra);
}

TEST(ClosedFormGas, bad_parameters_are_refused_by_name) {
  TankFill fill = reference_fill();
  fill.volume = kRequired;
  expect_refused([&] { tank_fill(fill, 0.0); }, "volume");
  expect_refused([] { tank_fill(reference_fill(), -1.0); }, "time");
  expect_refused([] { specific_heat_cp({296.8, 1.0}); }, "heat_capacity_ratio");
  expect_refused([] { vented_fill_steady({{}, 0.06, 0.01, 700.0, 1e-3}); }, "ambient_pressure");
  expect_refused([] { average_inflow_temperature({{}, 0.06, 2e5, 1e5, 0.08}); }, "final_pressure");
}

}  // namespace
