// SPDX-License-Identifier: Apache-2.0
#include "closed_form/tank_test.hpp"
#include "entries.hpp"

namespace closed_form::entries {
namespace {

TankTestPulse pulse_of(const ParameterMap& v) {
  return {get(v, "volume"),          get(v, "initial_pressure"), get(v, "initial_temperature"),
          get(v, "total_mass"),      get(v, "duration"),         get(v, "start_temperature"),
          get(v, "end_temperature"), get(v, "outlet_area")};
}

Entry tank_test_pulse_entry() {
  return {"tank_test_pulse",
          "Tank test: readings of tank and chamber that a known pulse makes",
          "(m_A cv_A + m cv) T = m_A cv_A T0 + cp int mdot T_s dt; y^2 - y = q or choked outlet",
          "energy balance of an open system and isentropic flow; derived here",
          "t >= 0; constant heat capacities; state constant after t_e",
          13,
          joined({gas_parameters(),
                  {{"tank_gas_constant", "R_A", "J/(kg K)", 287.0, "specific gas constant of the tank's gas"},
                   {"tank_heat_capacity_ratio", "gamma_A", "1", 1.4, "gamma of the tank's gas"}},
                  tank_parameters(0.06, 101325.0, 293.15),
                  {{"total_mass", "M", "kg", 0.08, "mass of the pulse"},
                   {"duration", "t_e", "s", 0.05, "duration of the pulse"},
                   {"start_temperature", "T1", "K", 800.0, "stagnation temperature in the chamber at t = 0"},
                   {"end_temperature", "T2", "K", 400.0, "the same at t_e"},
                   {"outlet_area", "A", "m2", 2e-4, "Cd A of the chamber's outlet"}}}),
          {"time_s", "tank_pressure_Pa", "chamber_pressure_Pa", "inflow_kg_s", "inflow_temperature_K"},
          range(0.0, 0.06, 120),
          [](const ParameterMap& v, double t) {
            const PerfectGas tank{get(v, "tank_gas_constant"), get(v, "tank_heat_capacity_ratio")};
            const TankTestReadings r = tank_test_pulse(tank, gas_of(v), pulse_of(v), t);
            return Row{r.tank_pressure, r.chamber_pressure, r.mass_flow, r.temperature};
          }};
}

}  // namespace

void add_tank_test_readings(std::vector<Entry>& list) {
  list.push_back(tank_test_pulse_entry());
}

}  // namespace closed_form::entries
