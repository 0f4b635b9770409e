// SPDX-License-Identifier: Apache-2.0
// Reference numbers: 40-digit arithmetic (mpmath), rounded to 17 digits: quadratures of V dp / (gamma R T
// mdot) along the isentrope or isotherm, roots of them for p(t), and the explicit formulas of the choked
// part.
#include <gsl/gsl_sf_hyperg.h>

#include "check.hpp"
#include "closed_form/orifice.hpp"

namespace {

using namespace closed_form;
using test::expect_refused;
using test::expect_relative;
using test::kAlgebra;
using test::kIntegrated;
using test::kInverted;

Blowdown reference_tank() {
  return {{}, 0.06, 1e-3, 1.0, 5e5, 600.0, 101325.0};
}

PorousTank reference_porous() {
  return {{}, 0.12, 0.05, 1.5, PorosityLaw::printed, 130000.0, 400.0, 101325.0};
}

std::vector<Blowdown> tanks() {
  return {reference_tank(),
          {{208.13, 5.0 / 3.0}, 0.02, 2e-3, 0.6, 9e5, 350.0, 90000.0},
          {{287.05, 1.3}, 0.1, 5e-3, 0.8, 1.5e5, 500.0, 101325.0}};  // starts unchoked
}

TEST(ClosedFormEmptying, choked_blowdown_eq_reference) {
  struct Row {
    double t, p, T, m;
  };
  for (const Row& r : {Row{0.01, 467550.91915249028, 588.60673199247388, 0.16057984855631492},
                       Row{0.05, 359732.85620962291, 546.13120702398068, 0.13315898190538939},
                       Row{0.1, 262672.56745335721, 499.20429328143878, 0.106371127120276}}) {
    const GasState s = blowdown(reference_tank(), r.t);
    expect_relative(s.pressure, r.p, kAlgebra);
    expect_relative(s.temperature, r.T, kAlgebra);
    expect_relative(s.mass, r.m, kAlgebra);
  }
  const BlowdownTimes times = blowdown_times(reference_tank());
  expect_relative(times.time_constant, 0.20764591762951125, kAlgebra);
  expect_relative(times.unchoke_time, 0.15229666654881087, kAlgebra);
  expect_relative(times.unchoke_pressure, 191801.04700911307, kAlgebra);
}

TEST(ClosedFormEmptying, subsonic_blowdown_eq_reference) {
  const BlowdownTimes times = blowdown_times(reference_tank());
  expect_relative(times.end_time - times.unchoke_time, 0.16648103361190052, kInverted);
  expect_relative(times.end_time, 0.31877770016071139, kInverted);
  expect_relative(times.final_temperature, 380.25843168753486, kAlgebra);
  expect_relative(times.final_mass, 0.053867288294265585, kAlgebra);
  expect_relative(blowdown(reference_tank(), 0.16).pressure, 183337.7831698602, kInverted);
  expect_relative(blowdown(reference_tank(), 0.16).temperature, 450.46430717463775, kInverted);
  expect_relative(blowdown(reference_tank(), 0.18).pressure, 163432.05950537481, kInverted);
  struct Row {
    double p, t;
  };
  for (const Row& r : {Row{150000.0, 0.1955217750508754}, Row{120000.0, 0.24179703304397069},
                       Row{110000.0, 0.26614434361175357}, Row{103000.0, 0.29559514491266321},
                       Row{101500.0, 0.31128047097707361}})
    expect_relative(blowdown_time_of_pressure(reference_tank(), r.p), r.t, kInverted);
}

TEST(ClosedFormEmptying, free_batch_expansion_eq_reference) {
  // 10 ft3 of air at 100 atm and 300 K through 0.1 ft2, Bird, Stewart and Lightfoot's problem data.
  const double foot = 0.3048;
  const Blowdown tank{{287.05, 1.4}, 10 * foot * foot * foot, 0.1 * foot * foot, 1.0, 100 * 101325.0, 300.0,
                      101325.0};
  expect_relative(blowdown_times(tank).end_time, 0.76522724537623921, kInverted);
  expect_relative(blowdown_times(tank).final_temperature, 80.480873858391772, kAlgebra);
}

TEST(ClosedFormEmptying, isothermal_blowdown_eq_reference) {
  const BlowdownTimes times = isothermal_blowdown_times(reference_tank());
  expect_relative(times.time_constant, 0.20764591762951125, kAlgebra);
  expect_relative(times.unchoke_time, 0.1989558274046831, kAlgebra);
  expect_relative(times.end_time - times.unchoke_time, 0.19200838556111596, kInverted);
  expect_relative(isothermal_blowdown(reference_tank(), 0.05).pressure, 393001.55708981881, kAlgebra);
}

TEST(ClosedFormEmptying, pressure_is_continuous_at_the_switch_and_constant_at_the_end) {
  for (const Blowdown& tank : tanks())
    for (const bool isothermal : {false, true}) {
      const auto state = [&](double t) {
        return isothermal ? isothermal_blowdown(tank, t) : blowdown(tank, t);
      };
      const BlowdownTimes times = isothermal ? isothermal_blowdown_times(tank) : blowdown_times(tank);
      expect_relative(state(0.0).pressure, tank.initial_pressure, kInverted);
      expect_relative(state(times.unchoke_time).pressure, times.unchoke_pressure, kInverted);
      expect_relative(state(times.unchoke_time * (1 + 1e-12) + 1e-15).pressure, times.unchoke_pressure,
                      1e-11);
      expect_relative(state(times.end_time * (1 + 1e-12)).pressure, tank.ambient_pressure, kAlgebra);
      expect_relative(state(2 * times.end_time).mass, times.final_mass, kInverted);
    }
}

// dm/dt and dU/dt of the tank through an orifice, state (m, U) or m alone.
TEST(ClosedFormEmptying, blowdown_eq_integrated_rates) {
  for (const Blowdown& tank : tanks()) {
    const double cp = specific_heat_cp(tank.gas);
    const double cv = specific_heat_cv(tank.gas);
    const auto outflow = [&tank](double p, double T) {
      return orifice_mass_flow(
          {tank.gas, tank.area, tank.discharge_coefficient, p, T, tank.ambient_pressure});
    };
    const test::Rate adiabatic = [&](double, const std::vector<double>& y) {
      const double T = y[1] / (y[0] * cv);
      const double out = outflow(y[0] * tank.gas.gas_constant * T / tank.volume, T);
      return std::vector<double>{-out, -out * cp * T};
    };
    const test::Rate isothermal = [&](double, const std::vector<double>& y) {
      const double T = tank.initial_temperature;
      return std::vector<double>{-outflow(y[0] * tank.gas.gas_constant * T / tank.volume, T)};
    };
    const double mass = blowdown(tank, 0.0).mass;
    for (const double part : {0.3, 0.6, 0.9}) {
      const double t = part * blowdown_times(tank).end_time;
      const double T0 = tank.initial_temperature;
      const std::vector<double> y = test::integrate_ode(adiabatic, {mass, mass * cv * T0}, 0.0, t);
      // The switch inside a step costs the integrator one order there: 1e-10 observed at most.
      expect_relative(blowdown(tank, t).mass, y[0], 1e-9);
      expect_relative(blowdown(tank, t).temperature, y[1] / (y[0] * cv), 1e-9);
      const double t_iso = part * isothermal_blowdown_times(tank).end_time;
      expect_relative(isothermal_blowdown(tank, t_iso).mass,
                      test::integrate_ode(isothermal, {mass}, 0.0, t_iso)[0], 1e-9);
    }
  }
}

TEST(ClosedFormEmptying, subsonic_duration_eq_hypergeometric_series) {
  for (const double gamma : {1.25, 1.4, 5.0 / 3.0}) {
    Blowdown tank = reference_tank();
    tank.gas.heat_capacity_ratio = gamma;
    const BlowdownTimes t = blowdown_times(tank);
    const double K = tank.area * tank.ambient_pressure / std::sqrt(296.8 * t.final_temperature) *
                     std::sqrt(2 * gamma / (gamma - 1));
    const double z = 0.5 * (gamma - 1);  // y* - 1
    const double exact = t.final_mass / ((gamma - 1) * K) * 2 * std::sqrt(z) *
                         gsl_sf_hyperg_2F1(-(2 - gamma) / (gamma - 1), 0.5, 1.5, -z);
    expect_relative(t.end_time - t.unchoke_time, exact, kInverted);
  }
}

TEST(ClosedFormEmptying, porous_tank_eq_reference) {
  const PorousTank tank = reference_porous();
  expect_relative(porous_tank_isothermal_end(tank), 0.066935616233913197, kAlgebra);
  expect_relative(porous_tank_isothermal(tank, 0.01).pressure, 121588.46551630102, kAlgebra);
  expect_relative(porous_tank_isothermal(tank, 0.02).pressure, 114824.70715404161, kAlgebra);
  expect_relative(porous_tank_adiabatic_end(tank), 0.048952700161241547, kInverted);
  expect_relative(porous_tank_adiabatic(tank, 0.01).pressure, 118759.40296999072, kInverted);
  expect_relative(porous_tank_adiabatic(tank, 0.02).pressure, 110661.71823484026, kInverted);
  expect_relative(porous_tank_parabola_end(tank), 0.051716528677852684, kAlgebra);
}

TEST(ClosedFormEmptying, porous_tank_eq_integrated_rates) {
  PorousTank tank = reference_porous();
  tank.gas = {208.13, 5.0 / 3.0};
  tank.law = PorosityLaw::screen;
  tank.initial_pressure = 4e5;  // v0 = 1.7: beyond the circle of convergence of the 2F1 series
  const double cv = specific_heat_cv(tank.gas);
  const double cp = specific_heat_cp(tank.gas);
  const auto outflow = [&tank](double p, double T) {
    return porous_mass_flow(
        {tank.gas, tank.porosity, tank.fabric_area, tank.law, p, T, tank.ambient_pressure});
  };
  const test::Rate adiabatic = [&](double, const std::vector<double>& y) {
    const double T = y[1] / (y[0] * cv);
    const double out = outflow(y[0] * tank.gas.gas_constant * T / tank.volume, T);
    return std::vector<double>{-out, -out * cp * T};
  };
  const test::Rate isothermal = [&](double, const std::vector<double>& y) {
    return std::vector<double>{-outflow(y[0] * tank.gas.gas_constant * 400.0 / tank.volume, 400.0)};
  };
  const double mass = porous_tank_adiabatic(tank, 0.0).mass;
  const double t = 0.7 * porous_tank_adiabatic_end(tank);
  const std::vector<double> y = test::integrate_ode(adiabatic, {mass, mass * cv * 400.0}, 0.0, t);
  expect_relative(porous_tank_adiabatic(tank, t).mass, y[0], kIntegrated);
  expect_relative(porous_tank_adiabatic(tank, t).temperature, y[1] / (y[0] * cv), kIntegrated);
  expect_relative(porous_tank_isothermal(tank, t).mass, test::integrate_ode(isothermal, {mass}, 0.0, t)[0],
                  kIntegrated);
  EXPECT_EQ(porous_tank_adiabatic(tank, 10.0).pressure, tank.ambient_pressure);
  EXPECT_EQ(porous_tank_isothermal(tank, 10.0).pressure, tank.ambient_pressure);
}

TEST(ClosedFormEmptying, parabola_is_the_limit_of_small_overpressure) {
  PorousTank tank = reference_porous();
  for (const double relative : {1e-2, 1e-4, 1e-6}) {
    tank.initial_pressure = tank.ambient_pressure * (1 + relative);
    // (1 + v^2)^b with |b| < 1: the two differ by less than v^2 = relative.
    expect_relative(porous_tank_adiabatic_end(tank), porous_tank_parabola_end(tank), relative);
  }
}

TEST(ClosedFormEmptying, bad_parameters_are_refused_by_name) {
  Blowdown tank = reference_tank();
  tank.initial_pressure = 1e5;
  expect_refused([&] { blowdown(tank, 0.0); }, "initial_pressure");
  expect_refused([] { blowdown_time_of_pressure(reference_tank(), 6e5); }, "pressure");
  PorousTank porous = reference_porous();
  porous.porosity = 0.0;
  expect_refused([&] { porous_tank_adiabatic_end(porous); }, "porosity");
}

}  // namespace
