// SPDX-License-Identifier: Apache-2.0
#include "gas_problems.hpp"

#include "closed_form/orifice.hpp"

namespace benchmarks {
namespace {

using second_route::Tank;

constexpr double kAmbient = 101325.0;  // [Pa]

gas::ControlVolumeModel nitrogen_tank() {
  return {gas::Thermo({gas::constant_cp_species("N2", 296.8, 1038.8)}), {kAmbient, 293.15}, {}, {}};
}

/// Without outflow the mass and the energy that came in are known: U = U0 + int mdot h dt.
GasProblem sealed() {
  const Tank tank = second_route::benchmark_tank(0.0);
  return {"filled_sealed", tank, {second_route::kEnd}, [tank](double) {
            const gas::Inflow& in = tank.model.inflows.front();
            const double mass = second_route::kFilled * in.mass_flow.value(0.0);
            auto y = second_route::unknowns(tank.start);
            for (std::size_t k = 0; k + 1 < y.size(); ++k) y[k] += mass * in.mass_fractions[k];
            y.back() += mass * tank.model.thermo.enthalpy(in.mass_fractions, in.temperature.value(0.0));
            return observe(tank, second_route::state_of(tank, y), second_route::kEnd);
          }};
}

GasProblem vented() {
  return {"filled_vented", second_route::benchmark_tank(), {second_route::kEnd}};
}

/// 60 litres of nitrogen at 5 bar and 600 K that leave through 1e-3 m2.
GasProblem blowdown(const char* name, std::vector<double> observed) {
  Tank tank{nitrogen_tank(), {}};
  tank.model.vents.push_back({1.0, 1e-3});
  tank.start = gas::make_state(tank.model.thermo, std::vector{1.0}, 5e5, 600.0, tank.volume);
  tank.stops = observed;
  const closed_form::Blowdown exact{{}, tank.volume, 1e-3, 1.0, 5e5, 600.0, kAmbient};
  return {name, tank, std::move(observed), [exact](double time) {
            const closed_form::GasState state = closed_form::blowdown(exact, time);
            return PressureTemperature{state.pressure, state.temperature};
          }};
}

/// A weak inflow into a tenth of a litre behind much porous fabric, 20 Pa above ambient
/// (cases/tank_stiff.toml).
GasProblem tiny() {
  Tank tank{nitrogen_tank(), {}, 1e-4, 1.5 * 0.05 * 0.05, {0.02}};
  tank.model.inflows.push_back({{1.0}, gas::Curve::constant(0.02), gas::Curve::constant(406.0)});
  tank.start = gas::make_state(tank.model.thermo, std::vector{1.0}, kAmbient, 293.15, tank.volume);
  return {"tiny_volume", tank, {0.02}, {}, true};
}

/// The vented tank of air, but three short pulses of gas: 3, 2 and 4 ms, ever colder.
GasProblem pulses() {
  GasProblem problem{"three_pulses", second_route::benchmark_tank(), {second_route::kEnd}};
  const gas::Inflow long_one = problem.tank.model.inflows.front();
  problem.tank.model.inflows.clear();
  problem.tank.stops.clear();
  struct Pulse {
    double begin, length, mass_flow, temperature;  // [s], [s], [kg/s], [K]
  };
  for (const auto& [begin, length, flow, temperature] :
       {Pulse{0.0, 3e-3, 5.0, 1200.0}, Pulse{0.02, 2e-3, 8.0, 1000.0}, Pulse{0.045, 4e-3, 3.0, 800.0}}) {
    problem.tank.model.inflows.push_back({long_one.mass_fractions,
                                          gas::Curve({{0.0, flow}, {length, flow}}, gas::Outside::zero),
                                          gas::Curve::constant(temperature), begin});
    if (begin > 0.0) problem.tank.stops.push_back(begin);
    problem.tank.stops.push_back(begin + length);
  }
  problem.tank.stops.push_back(second_route::kEnd);
  return problem;
}

}  // namespace

PressureTemperature observe(const Tank& tank, const gas::ControlVolumeState& state, double time) {
  const gas::GasPoint point = gas::evaluate(tank.model, state, tank.volume, tank.leak_area, time);
  return {point.pressure, point.temperature};
}

std::vector<GasProblem> gas_problems() {
  // The blow-down is choked until 0.152 s and at rest from 0.3188 s: seen at nine tenths of that, and at
  // rest.
  return {sealed(), vented(), blowdown("choked_blowdown", {0.15}), blowdown("equalisation", {0.287, 0.35}),
          tiny(),   pulses()};
}

}  // namespace benchmarks
