// SPDX-License-Identifier: Apache-2.0
#include "closed_form/exchange.hpp"

#include "check.hpp"
#include "closed_form/gas.hpp"
#include "closed_form/orifice.hpp"

namespace {

using namespace closed_form;
using test::expect_refused;
using test::expect_relative;
using test::kAlgebra;
using test::kIntegrated;

std::vector<AmbientInrush> inrushes() {
  return {{{}, 0.06, 1e-3, 0.0, 293.15, 101325.0, 293.15},            // evacuated: sonic, then subsonic
          {{208.13, 5.0 / 3.0}, 0.02, 2e-3, 3e4, 350.0, 9e4, 280.0},  // sonic at first
          {{287.05, 1.3}, 0.1, 5e-3, 8e4, 250.0, 101325.0, 320.0}};   // subsonic from the start
}

TEST(ClosedFormExchange, inrush_eq_integrated_rate) {
  for (const AmbientInrush& tank : inrushes()) {
    // V dp/dt = gamma R T_a mdot, whatever is in the tank.
    const auto [R, gamma] = tank.gas;
    const double growth = gamma * R * tank.ambient_temperature / tank.volume;
    const test::Rate rate = [&](double, const std::vector<double>& p) {
      return std::vector<double>{growth * orifice_mass_flow({tank.gas, tank.area, 1.0, tank.ambient_pressure,
                                                             tank.ambient_temperature, p[0]})};
    };
    for (const double part : {0.2, 0.5, 0.9}) {
      const double t = part * ambient_inrush_end(tank);
      const double p = test::integrate_ode(rate, {tank.initial_pressure}, 0.0, t)[0];
      // The switch inside a step costs the integrator one order there: 1e-10 observed at most.
      expect_relative(ambient_inrush(tank, t).pressure, p, 1e-9);
    }
  }
}

TEST(ClosedFormExchange, inrush_ends_on_ambient_pressure_with_its_enthalpy) {
  for (const AmbientInrush& tank : inrushes()) {
    const GasState end = ambient_inrush(tank, 2.0 * ambient_inrush_end(tank));
    expect_relative(end.pressure, tank.ambient_pressure, kAlgebra);
    // m cv T = m0 cv T0 + (m - m0) cp T_a.
    const double cv = specific_heat_cv(tank.gas), cp = specific_heat_cp(tank.gas);
    const double before = ambient_inrush(tank, 0.0).mass;
    expect_relative(
        end.mass * cv * end.temperature,
        before * cv * tank.initial_temperature + (end.mass - before) * cp * tank.ambient_temperature,
        10.0 * kAlgebra);
  }
  expect_relative(ambient_inrush(inrushes()[0], 1.0).temperature, 1.4 * 293.15, kAlgebra);
}

TEST(ClosedFormExchange, heat_loss_fill_eq_integrated_rates) {
  for (const double flow : {0.0, 0.3, 2.0}) {
    const HeatLossFill tank{{}, 0.06, 2e5, 600.0, flow, 700.0, 150.0, 310.0};
    const double cv = specific_heat_cv(tank.gas), cp = specific_heat_cp(tank.gas);
    const double mass = heat_loss_fill(tank, 0.0).mass;
    const test::Rate rate = [&](double t, const std::vector<double>& energy) {
      const double temperature = energy[0] / ((mass + flow * t) * cv);
      return std::vector<double>{flow * cp * 700.0 - 150.0 * (temperature - 310.0)};
    };
    for (const double t : {0.01, 0.1, 1.0}) {
      const double energy = test::integrate_ode(rate, {mass * cv * 600.0}, 0.0, t)[0];
      const GasState state = heat_loss_fill(tank, t);
      expect_relative(state.mass * cv * state.temperature, energy, kIntegrated);
      expect_relative(state.pressure * 0.06, state.mass * 296.8 * state.temperature, kAlgebra);
    }
  }
}

/// The end temperature depends on hA/(mdot cv) and the two temperatures alone; it is the inflow's own where
/// the walls take what filling adds, hA (T_in - T_ext) = mdot R T_in.
TEST(ClosedFormExchange, heat_loss_fill_ends_at_a_temperature_without_scale) {
  for (const double scale : {1e-3, 1.0, 1e3}) {
    for (const double ratio : {0.1, 1.0, 3.3, 10.0}) {
      const double flow = 0.5 * scale, conductance = ratio * flow * 742.0;
      // The start is forgotten as (1 + mdot t/m0)^-(1 + ratio): 1e-16 of it is left.
      const HeatLossFill tank{{}, 0.06, 1e3, 300.0, flow, 700.0, conductance, 310.0};
      const double t = 1e15 * heat_loss_fill(tank, 0.0).mass / flow;
      expect_relative(heat_loss_fill(tank, t).temperature, (1.4 * 700.0 + ratio * 310.0) / (1.0 + ratio),
                      1e-13);
    }
    const double flow = 0.5 * scale, conductance = flow * 296.8 * 700.0 / (700.0 - 310.0);
    const HeatLossFill even{{}, 0.06, 1e5, 700.0, flow, 700.0, conductance, 310.0};
    for (const double t : {0.1, 10.0})
      expect_relative(heat_loss_fill(even, t / scale).temperature, 700.0, kAlgebra);
  }
}

TEST(ClosedFormExchange, linear_fabric_tank_eq_integrated_rates) {
  const LinearFabricTank tank{{208.13, 5.0 / 3.0}, 0.06, 1.5, 2e-5, 3e5, 400.0, 9e4};
  const double cv = specific_heat_cv(tank.gas), cp = specific_heat_cp(tank.gas);
  const test::Rate rate = [&](double, const std::vector<double>& y) {
    const double temperature = y[1] / (y[0] * cv), density = y[0] / tank.volume;
    const double out = 1.5 * density * 2e-5 * (density * 208.13 * temperature - 9e4);
    return std::vector<double>{-out, -out * cp * temperature};
  };
  const double mass = linear_fabric_tank(tank, 0.0).mass;
  for (const double t : {1e-3, 5e-3, 2e-2}) {
    const std::vector<double> y = test::integrate_ode(rate, {mass, mass * cv * 400.0}, 0.0, t);
    expect_relative(linear_fabric_tank(tank, t).mass, y[0], kIntegrated);
    expect_relative(linear_fabric_tank(tank, t).temperature, y[1] / (y[0] * cv), kIntegrated);
  }
}

TEST(ClosedFormExchange, bad_parameters_are_refused_by_name) {
  AmbientInrush inrush = inrushes()[0];
  inrush.initial_pressure = 2e5;
  expect_refused([&] { ambient_inrush(inrush, 0.0); }, "initial_pressure");
  expect_refused([] { ambient_inrush(inrushes()[0], -1.0); }, "time");
  expect_refused([] { heat_loss_fill({{}, 0.06, 1e5, 300.0, 1.0, 700.0, -1.0, 300.0}, 0.0); }, "conductance");
  expect_refused([] { linear_fabric_tank({{}, 0.06, 1.5, 0.0, 3e5, 400.0, 1e5}, 0.0); }, "permeability");
}

}  // namespace
