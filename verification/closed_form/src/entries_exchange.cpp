// SPDX-License-Identifier: Apache-2.0
#include "closed_form/exchange.hpp"
#include "entries.hpp"

namespace closed_form::entries {
namespace {

Entry ambient_inrush_entry() {
  return {
      "ambient_inrush",
      "Tank below ambient pressure that fills with ambient gas through a hole",
      "sonic p = p0 + gamma R T_a mdot t/V; subsonic p = p_a s^(gamma/(gamma-1)), sqrt(1 - s) linear in time",
      "derived here",
      "0 <= p0 < p_a; constant after the end",
      14,
      joined({gas_parameters(),
              tank_parameters(0.06, 20000.0, 293.15),
              {{"area", "A", "m2", 1e-3, "Cd A of the hole"},
               ambient_pressure_parameter(),
               {"ambient_temperature", "T_a", "K", 293.15, "temperature of the ambient gas"}}}),
      {"time_s", "pressure_Pa", "temperature_K", "gas_mass_kg", "end_time_s"},
      range(0.0, 0.3, 60),
      [](const ParameterMap& v, double t) {
        const AmbientInrush tank{gas_of(v),
                                 get(v, "volume"),
                                 get(v, "area"),
                                 get(v, "initial_pressure"),
                                 get(v, "initial_temperature"),
                                 get(v, "ambient_pressure"),
                                 get(v, "ambient_temperature")};
        Row row = history(ambient_inrush(tank, t));
        row.push_back(ambient_inrush_end(tank));
        return row;
      },
      {"end_time_s"}};
}

Entry heat_loss_fill_entry() {
  return {"heat_loss_fill",
          "Constant inflow into a rigid tank that loses heat through its walls",
          "T - T_inf = (T0 - T_inf) (1 + mdot t/m0)^-(1 + hA/(mdot cv)); T_inf = (mdot cp T_in + hA "
          "T_ext)/(mdot cv + hA)",
          "linear energy balance, derived here",
          "t >= 0",
          14,
          joined({gas_parameters(),
                  tank_parameters(0.06, 101325.0, 293.15),
                  {{"mass_flow", "mdot", "kg/s", 1.0, "inflow"},
                   {"inflow_temperature", "T_in", "K", 700.0, "temperature of the inflow"},
                   {"conductance", "hA", "W/K", 100.0, "heat transfer coefficient times area"},
                   {"outside_temperature", "T_ext", "K", 293.15, "temperature of the walls"}}}),
          history_columns(),
          range(0.0, 0.1, 100),
          [](const ParameterMap& v, double t) {
            return history(heat_loss_fill(
                {gas_of(v), get(v, "volume"), get(v, "initial_pressure"), get(v, "initial_temperature"),
                 get(v, "mass_flow"), get(v, "inflow_temperature"), get(v, "conductance"),
                 get(v, "outside_temperature")},
                t));
          }};
}

Entry linear_fabric_tank_entry() {
  return {"linear_fabric_tank",
          "Adiabatic tank that leaks through fabric of velocity proportional to overpressure",
          "p = p_a/(1 - (1 - p_a/p0) exp(-gamma k C p_a t/V))",
          "derived here",
          "p0 > p_a",
          14,
          joined({gas_parameters(),
                  tank_parameters(0.06, 130000.0, 400.0),
                  {{"area", "C", "m2", 1.5, "area of the fabric"},
                   {"permeability", "k", "m/(s Pa)", 1e-5, "velocity through the fabric per overpressure"},
                   ambient_pressure_parameter()}}),
          history_columns(),
          range(0.0, 0.1, 100),
          [](const ParameterMap& v, double t) {
            return history(linear_fabric_tank(
                {gas_of(v), get(v, "volume"), get(v, "area"), get(v, "permeability"),
                 get(v, "initial_pressure"), get(v, "initial_temperature"), get(v, "ambient_pressure")},
                t));
          }};
}

}  // namespace

void add_exchanging_tanks(std::vector<Entry>& list) {
  for (Entry (*entry)() : {ambient_inrush_entry, heat_loss_fill_entry, linear_fabric_tank_entry})
    list.push_back(entry());
}

}  // namespace closed_form::entries
