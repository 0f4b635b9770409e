// SPDX-License-Identifier: Apache-2.0
#include "check.hpp"
#include "closed_form/orifice.hpp"
#include "entries.hpp"

namespace closed_form::entries {
namespace {

const char* const kNozzle = "isentropic nozzle flow, textbook result";

Parameters upstream_parameters() {
  return {{"temperature", "T", "K", 673.0, "inside"}, ambient_pressure_parameter()};
}

Parameters blowdown_parameters() {
  return joined({gas_parameters(),
                 tank_parameters(0.06, 5e5, 600.0),
                 {{"area", "A", "m2", 1e-3, "area of the hole"},
                  {"discharge_coefficient", "Cd", "1", 1.0, "of the hole"},
                  ambient_pressure_parameter()}});
}

Blowdown blowdown_of(const ParameterMap& v) {
  return {gas_of(v),
          get(v, "volume"),
          get(v, "area"),
          get(v, "discharge_coefficient"),
          get(v, "initial_pressure"),
          get(v, "initial_temperature"),
          get(v, "ambient_pressure")};
}

Parameters fabric_parameters() {
  return {{"porosity", "eta", "1", 0.05, "porosity of the fabric"},
          {"fabric_area", "A_f", "m2", 1.5, "area of the fabric"},
          {"screen_law", "", "1", 0.0, "0: leak area eta^2 A_f as printed; 1: eta A_f"}};
}

PorosityLaw law_of(const ParameterMap& v) {
  const int law = check::integer_within("screen_law", whole(v, "screen_law"), 0, 1);
  return law == 0 ? PorosityLaw::printed : PorosityLaw::screen;
}

Parameters porous_tank_parameters() {
  return joined(
      {tank_parameters(0.12, 130000.0, 400.0), fabric_parameters(), {ambient_pressure_parameter()}});
}

PorousTank porous_tank_of(const PerfectGas& gas, const ParameterMap& v) {
  return {gas,
          get(v, "volume"),
          get(v, "porosity"),
          get(v, "fabric_area"),
          law_of(v),
          get(v, "initial_pressure"),
          get(v, "initial_temperature"),
          get(v, "ambient_pressure")};
}

std::vector<std::string> times_columns() {
  return {"time_constant_s", "unchoke_time_s",      "unchoke_pressure_Pa",
          "end_time_s",      "final_temperature_K", "final_gas_mass_kg"};
}

Row times(const BlowdownTimes& t) {
  return {t.time_constant, t.unchoke_time, t.unchoke_pressure, t.end_time, t.final_temperature, t.final_mass};
}

Entry critical_flow_entry() {
  return {"critical_flow",
          "Critical pressure ratio and choked flux coefficient over gamma",
          "r* = (2/(gamma+1))^(gamma/(gamma-1)); phi = sqrt(gamma) (2/(gamma+1))^((gamma+1)/(2(gamma-1)))",
          kNozzle,
          "1 < gamma < 3; abscissa is gamma",
          15,
          {},
          {"heat_capacity_ratio", "critical_pressure_ratio", "choked_flux_coefficient"},
          range(1.1, 1.7, 12),
          [](const ParameterMap&, double gamma) {
            return Row{critical_pressure_ratio(gamma), choked_flux_coefficient(gamma)};
          }};
}

Entry orifice_flow_entry() {
  return {"orifice_flow",
          "Outflow through a hole over overpressure",
          "mdot = Cd A p/sqrt(R T) sqrt(2 gamma/(gamma-1) (r^(2/gamma) - r^((gamma+1)/gamma))), r = "
          "max(p_a/p, r*)",
          kNozzle,
          "overpressure > -p_a; no backflow",
          15,
          joined({gas_parameters(),
                  upstream_parameters(),
                  {{"area", "A", "m2", 0.085, "area of the hole"},
                   {"discharge_coefficient", "Cd", "1", 1.0, "of the hole"}}}),
          {"overpressure_Pa", "vent_outflow_kg_s"},
          range(0.0, 1e5, 100),
          [](const ParameterMap& v, double overpressure) {
            const double ambient = get(v, "ambient_pressure");
            return Row{orifice_mass_flow({gas_of(v), get(v, "area"), get(v, "discharge_coefficient"),
                                          ambient + overpressure, get(v, "temperature"), ambient})};
          }};
}

Entry porous_flow_entry() {
  return {"porous_flow",
          "Outflow through porous fabric over overpressure",
          "mdot = C sqrt(2 rho (p - p_a)); C = eta^2 A_f or eta A_f",
          "Gas Jet Model for Airbag Inflators (printed law)",
          "overpressure > -p_a; no choking",
          15,
          joined({gas_constant_parameter(), upstream_parameters(), fabric_parameters()}),
          {"overpressure_Pa", "fabric_outflow_kg_s"},
          range(0.0, 1e5, 100),
          [](const ParameterMap& v, double overpressure) {
            const double ambient = get(v, "ambient_pressure");
            return Row{porous_mass_flow({gas_of_constant(v), get(v, "porosity"), get(v, "fabric_area"),
                                         law_of(v), ambient + overpressure, get(v, "temperature"), ambient})};
          }};
}

Entry bernoulli_limit_entry() {
  return {"bernoulli_limit",
          "Hole flow over its incompressible limit",
          "mdot/(A sqrt(2 rho dp)) = 1 - 3 e/(4 gamma) - (40 gamma - 29) e^2/(96 gamma^2) + ..., e = dp/p",
          "derived here",
          "0 < e <= 1 - r*",
          15,
          {{"heat_capacity_ratio", "gamma", "1", 1.4, "ratio of heat capacities"}},
          {"relative_overpressure", "flow_ratio", "series_to_second_order"},
          {1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 0.01, 0.1, 0.4},
          [](const ParameterMap& v, double e) {
            const double gamma = get(v, "heat_capacity_ratio");
            return Row{bernoulli_ratio(gamma, e), bernoulli_ratio_series(gamma, e)};
          }};
}

Entry blowdown_entry() {
  return {"blowdown",
          "Adiabatic tank that empties through a hole, choked, then subsonic",
          "choked p = p0 (1 + (gamma-1) t/(2 tau))^(-2 gamma/(gamma-1)); subsonic mdot = K sqrt(T/T_f - 1)",
          "derived here; free batch expansion of transport-phenomena textbooks",
          "p0 > p_a; constant after equalisation",
          13,
          blowdown_parameters(),
          history_columns(),
          range(0.0, 0.35, 70),
          [](const ParameterMap& v, double t) { return history(blowdown(blowdown_of(v), t)); }};
}

Entry isothermal_blowdown_entry() {
  return {"isothermal_blowdown",
          "Isothermal tank that empties through a hole, choked, then subsonic",
          "choked p = p0 exp(-t/tau); subsonic t by int (1 + v^2)^(1/(gamma-1) - 1/2) dv",
          "derived here",
          "p0 > p_a; constant after equalisation",
          13,
          blowdown_parameters(),
          history_columns(),
          range(0.0, 0.4, 80),
          [](const ParameterMap& v, double t) { return history(isothermal_blowdown(blowdown_of(v), t)); }};
}

Entry blowdown_times_entry() {
  return {"blowdown_times",
          "Unchoking and end of the adiabatic blow-down",
          "tau = V/(Cd A sqrt(R T0) phi); end by 2F1 of the subsonic branch",
          "derived here",
          "p0 > p_a",
          13,
          blowdown_parameters(),
          times_columns(),
          {},
          [](const ParameterMap& v, double) { return times(blowdown_times(blowdown_of(v))); }};
}

Entry isothermal_blowdown_times_entry() {
  return {"isothermal_blowdown_times",
          "Unchoking and end of the isothermal blow-down",
          "tau = V/(Cd A sqrt(R T) phi); end by a polynomial for gamma = 7/5",
          "derived here",
          "p0 > p_a",
          13,
          blowdown_parameters(),
          times_columns(),
          {},
          [](const ParameterMap& v, double) { return times(isothermal_blowdown_times(blowdown_of(v))); }};
}

Entry porous_isothermal_entry() {
  return {"porous_tank_isothermal",
          "Isothermal tank that leaks through porous fabric",
          "p = p_a cosh^2(u0 - k t); k = C sqrt(R T/2)/V; u0 = arcosh sqrt(p0/p_a)",
          "derived here",
          "p0 > p_a; constant after u0/k",
          14,
          joined({gas_constant_parameter(), porous_tank_parameters()}),
          {"time_s", "pressure_Pa", "temperature_K", "gas_mass_kg", "end_time_s"},
          range(0.0, 0.07, 70),
          [](const ParameterMap& v, double t) {
            Row row = history(porous_tank_isothermal(porous_tank_of(gas_of_constant(v), v), t));
            row.push_back(porous_tank_isothermal_end(porous_tank_of(gas_of_constant(v), v)));
            return row;
          },
          {"end_time_s"}};
}

Entry porous_adiabatic_entry() {
  return {"porous_tank_adiabatic",
          "Adiabatic tank that leaks through porous fabric",
          "t by int (1 + v^2)^(1/(2 gamma) - 1) dv, v = sqrt(p/p_a - 1)",
          "derived here",
          "p0 > p_a; constant after the end",
          13,
          joined({gas_parameters(), porous_tank_parameters()}),
          {"time_s", "pressure_Pa", "temperature_K", "gas_mass_kg", "end_time_s"},
          range(0.0, 0.05, 50),
          [](const ParameterMap& v, double t) {
            Row row = history(porous_tank_adiabatic(porous_tank_of(gas_of(v), v), t));
            row.push_back(porous_tank_adiabatic_end(porous_tank_of(gas_of(v), v)));
            return row;
          },
          {"end_time_s"}};
}

}  // namespace

void add_outflow(std::vector<Entry>& list) {
  for (Entry (*entry)() : {critical_flow_entry, orifice_flow_entry, porous_flow_entry, bernoulli_limit_entry})
    list.push_back(entry());
}

void add_emptying_tanks(std::vector<Entry>& list) {
  for (Entry (*entry)() : {blowdown_entry, blowdown_times_entry, isothermal_blowdown_entry,
                           isothermal_blowdown_times_entry, porous_isothermal_entry, porous_adiabatic_entry})
    list.push_back(entry());
}

}  // namespace closed_form::entries
