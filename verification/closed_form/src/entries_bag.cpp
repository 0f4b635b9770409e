// SPDX-License-Identifier: Apache-2.0
// Bags whose volume follows their pressure.
#include "check.hpp"
#include "closed_form/gas.hpp"
#include "closed_form/orifice.hpp"
#include "entries.hpp"

namespace closed_form::entries {
namespace {

std::vector<std::string> bag_columns(const char* abscissa) {
  return {abscissa, "pressure_Pa", "temperature_K", "gas_mass_kg", "volume_m3"};
}

Row bag_row(const GasState& s) {
  return {s.pressure, s.temperature, s.mass, s.volume};
}

Entry spring_bag_entry() {
  return {
      "spring_bag_fill",
      "Filling of a bag whose volume rises linearly with its pressure",
      "(p V - p0 V0)/(gamma - 1) + k (p^2 - p0^2)/2 = mdot t cp T_in, V = V0 + k (p - p0)",
      "derived here from the energy balance",
      "t >= 0; k = 0 is tank_fill",
      15,
      joined({gas_parameters(),
              tank_parameters(0.06, 101325.0, 293.15),
              {{"compliance", "k", "m3/Pa", 5e-7, "dV/dp"},
               {"mass_flow", "mdot", "kg/s", 1.0, "inflow"},
               {"inflow_temperature", "T_in", "K", 700.0, "of the inflow"}}}),
      bag_columns("time_s"),
      range(0.0, 0.05, 50),
      [](const ParameterMap& v, double t) {
        check::non_negative("time", t);
        check::non_negative("mass_flow", get(v, "mass_flow"));
        return bag_row(spring_bag_fill({gas_of(v), get(v, "initial_pressure"), get(v, "initial_temperature"),
                                        get(v, "volume"), get(v, "compliance")},
                                       get(v, "mass_flow") * t, get(v, "inflow_temperature")));
      }};
}

Entry proportional_blowdown_entry() {
  return {"proportional_blowdown",
          "Choked blow-down of a bag whose volume is proportional to its pressure",
          "m/m0 = (1 - mdot0 t/(2 m0))^2, p/p0 = (m/m0)^(gamma/(gamma + 1)), T = T0 (p/p0)^((gamma-1)/gamma)",
          "derived here: what stays inside expands reversibly",
          "choked up to t",
          15,
          joined({gas_parameters(),
                  tank_parameters(0.06, 5e5, 600.0),
                  {{"area", "A", "m2", 1e-3, "area of the hole"},
                   {"discharge_coefficient", "Cd", "1", 1.0, "of the hole"},
                   {"ambient_pressure", "p_a", "Pa", 101325.0, "ambient pressure (validity only)"}}}),
          bag_columns("time_s"),
          range(0.0, 0.1, 50),
          [](const ParameterMap& v, double t) {
            return bag_row(proportional_blowdown(
                {gas_of(v), get(v, "volume"), get(v, "area"), get(v, "discharge_coefficient"),
                 get(v, "initial_pressure"), get(v, "initial_temperature"), get(v, "ambient_pressure")},
                t));
          }};
}

}  // namespace

void add_bags(std::vector<Entry>& list) {
  list.push_back(spring_bag_entry());
  list.push_back(proportional_blowdown_entry());
}

}  // namespace closed_form::entries
