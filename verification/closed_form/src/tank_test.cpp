// SPDX-License-Identifier: Apache-2.0
#include "check.hpp"
#include "closed_form/gas.hpp"
#include "closed_form/orifice.hpp"

namespace closed_form {

double average_inflow_temperature(const AverageTemperature& tank) {
  check::gas(tank.gas);
  check::positive("volume", tank.volume);
  check::non_negative("initial_pressure", tank.initial_pressure);
  check::positive("final_pressure", tank.final_pressure);
  check::positive("total_mass", tank.total_mass);
  if (tank.final_pressure <= tank.initial_pressure)
    check::refuse("final_pressure", tank.final_pressure, "must be > initial_pressure");
  const auto [R, gamma] = tank.gas;
  return (tank.final_pressure - tank.initial_pressure) * tank.volume / (gamma * R * tank.total_mass);
}

double average_temperature_mass_flow(const AverageTemperature& tank, double pressure_rate) {
  check::non_negative("pressure_rate", pressure_rate);
  const auto [R, gamma] = tank.gas;
  return tank.volume * pressure_rate / (gamma * R * average_inflow_temperature(tank));
}

DualPressureResult dual_pressure(const DualPressure& test) {
  check::gas(test.gas);
  check::positive("volume", test.volume);
  check::positive("outlet_area", test.outlet_area);
  check::positive("chamber_pressure", test.chamber_pressure);
  check::positive("pressure_rate", test.pressure_rate);
  const auto [R, gamma] = test.gas;
  const double enthalpy_flow = test.volume * test.pressure_rate / (gamma * R);  // mdot T
  const double choked = test.outlet_area * choked_flux_coefficient(gamma) * test.chamber_pressure;
  const double ratio = enthalpy_flow / choked;
  return {choked / (R * ratio), R * ratio * ratio};
}

}  // namespace closed_form
