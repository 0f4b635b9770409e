// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "gas/integrator.hpp"
#include "tank_test_cases.hpp"

// Records of libgas's own forward model in a tank that loses heat to its walls.
namespace cases {

inline constexpr double kLossTemperature = 900.0, kLossLength = 0.3;  // [K], [s]

inline gas::TankTest small_test() {
  return {nitrogen(), 0.06, 293.15, kPure, kPure, 0.034};
}

/// 34 g of 900 K in a triangle of 40 ms after 5 ms, then a tail; `count` readings.
inline Record record_with_loss(const gas::TankTest& test, double conductance, int count,
                               double length = kLossLength, double outlet = 1e-5) {
  const gas::Curve flow({{0.005, 0.0}, {0.015, 1.7}, {0.045, 0.0}}, gas::Outside::zero);
  gas::ControlVolumeModel model{test.thermo, {0.0, test.initial_temperature}, {}, {}};
  model.heat_loss = {conductance, test.initial_temperature};
  model.inflows.push_back(
      {test.inflator_fractions, flow,
       gas::Curve({{0.0, kLossTemperature}, {1.0, kLossTemperature}}, gas::Outside::held)});
  gas::ControlVolumeState state =
      gas::make_state(model.thermo, test.tank_fractions, 101325.0, test.initial_temperature, test.volume);
  gas::GasIntegrator integrator(model);
  const closed_form::PerfectGas gas{test.thermo.gas_constant(test.inflator_fractions),
                                    test.thermo.gamma(test.inflator_fractions, kLossTemperature)};
  Record record(
      [](double) {
        return closed_form::TankTestReadings{101325.0, 101325.0, 0.0, 0.0};
      },
      length, count);
  for (std::size_t i = 1; i < record.times.size(); ++i) {
    integrator.advance(state, record.times[i - 1], record.times[i], rigid(test.volume));
    record.tank[i] = gas::evaluate(model, state, test.volume, 0.0, record.times[i]).pressure;
    const double mdot = flow.value(record.times[i]);
    record.chamber[i] =
        mdot > 0.0 ? closed_form::chamber_pressure(gas, outlet, mdot, kLossTemperature, record.tank[i])
                   : record.tank[i];
  }
  return record;
}

inline gas::IdentifyOptions fitted(int points = 301, int draws = 40) {
  return {.points = points, .draws = draws, .fit_heat_loss = true};
}

}  // namespace cases
