// SPDX-License-Identifier: Apache-2.0
#include "closed_form/exchange.hpp"
#include "closed_form/gas.hpp"
#include "closed_form/orifice.hpp"
#include "entries.hpp"
#include "fields.hpp"

namespace closed_form::entries {
namespace {

const char* const kNozzle = "isentropic nozzle flow, textbook result";

auto upstream() {
  return []<class S>(Form<S>& form) {
    form.field(&S::temperature, "temperature", "T", "K", 673.0, "inside").fields(ambient_pressure());
  };
}

auto hole(double area) {
  return [area]<class S>(Form<S>& form) {
    form.field(&S::area, "area", "A", "m2", area, "area of the hole")
        .fields(discharge_coefficient("of the hole"));
  };
}

auto blowdown_tank() {
  return [](Form<Blowdown>& form) {
    form.fields(gas(), tank(0.06, 5e5, 600.0), hole(1e-3), ambient_pressure());
  };
}

auto fabric() {
  return []<class S>(Form<S>& form) {
    form.field(&S::porosity, "porosity", "eta", "1", 0.05, "porosity of the fabric")
        .field(&S::fabric_area, "fabric_area", "A_f", "m2", 1.5, "area of the fabric")
        .field(&S::law, "screen_law", "", "1", 0.0, "0: leak area eta^2 A_f as printed; 1: eta A_f");
  };
}

Columns<BlowdownTimes> instants() {
  return {{"time_constant_s", &BlowdownTimes::time_constant},
          {"unchoke_time_s", &BlowdownTimes::unchoke_time},
          {"unchoke_pressure_Pa", &BlowdownTimes::unchoke_pressure},
          {"end_time_s", &BlowdownTimes::end_time},
          {"final_temperature_K", &BlowdownTimes::final_temperature},
          {"final_gas_mass_kg", &BlowdownTimes::final_mass}};
}

GasState filled_spring_bag(const SpringBag& bag, double mass_flow, double temperature, double time) {
  check::non_negative("time", time, "mass_flow", mass_flow);
  return spring_bag_fill(bag, mass_flow * time, temperature);
}

}  // namespace

std::vector<Entry> outflow() {
  return {
      Form<Nothing>(
          "critical_flow", "Critical pressure ratio and choked flux coefficient over gamma",
          "r* = (2/(gamma+1))^(gamma/(gamma-1)); phi = sqrt(gamma) (2/(gamma+1))^((gamma+1)/(2(gamma-1)))",
          kNozzle, "1 < gamma < 3; abscissa is gamma", 15)
          .over("heat_capacity_ratio", range(1.1, 1.7, 12))
          .result("critical_pressure_ratio", critical_pressure_ratio)
          .result("choked_flux_coefficient", choked_flux_coefficient),
      Form<Orifice>(
          "orifice_flow", "Outflow through a hole over overpressure",
          "mdot = Cd A p/sqrt(R T) sqrt(2 gamma/(gamma-1) (r^(2/gamma) - r^((gamma+1)/gamma))), r = "
          "max(p_a/p, r*)",
          kNozzle, "overpressure > -p_a; no backflow", 15)
          .fields(gas(), upstream(), hole(0.085))
          .over("overpressure_Pa", range(0.0, 1e5, 100))
          .result("vent_outflow_kg_s", [](const Orifice& o, double p) { return orifice_mass_flow(o, p); }),
      Form<PorousFabric>("porous_flow", "Outflow through porous fabric over overpressure",
                         "mdot = C sqrt(2 rho (p - p_a)); C = eta^2 A_f or eta A_f",
                         "Gas Jet Model for Airbag Inflators (printed law)",
                         "overpressure > -p_a; no choking", 15)
          .fields(gas_constant(), upstream(), fabric())
          .over("overpressure_Pa", range(0.0, 1e5, 100))
          .result("fabric_outflow_kg_s",
                  [](const PorousFabric& f, double p) { return porous_mass_flow(f, p); }),
      Form<PerfectGas>(
          "bernoulli_limit", "Hole flow over its incompressible limit",
          "mdot/(A sqrt(2 rho dp)) = 1 - 3 e/(4 gamma) - (40 gamma - 29) e^2/(96 gamma^2) + ..., e = dp/p",
          "derived here", "0 < e <= 1 - r*", 15)
          .fields(heat_capacity_ratio())
          .over("relative_overpressure", {1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 0.01, 0.1, 0.4})
          .result("flow_ratio", with(bernoulli_ratio, &PerfectGas::heat_capacity_ratio, abscissa))
          .result("series_to_second_order",
                  with(bernoulli_ratio_series, &PerfectGas::heat_capacity_ratio, abscissa))};
}

std::vector<Entry> emptying_tanks() {
  return {
      Form<Blowdown>(
          "blowdown", "Adiabatic tank that empties through a hole, choked, then subsonic",
          "choked p = p0 (1 + (gamma-1) t/(2 tau))^(-2 gamma/(gamma-1)); subsonic mdot = K sqrt(T/T_f - 1)",
          "derived here; free batch expansion of transport-phenomena textbooks",
          "p0 > p_a; constant after equalisation", 13)
          .fields(blowdown_tank())
          .over("time_s", range(0.0, 0.35, 70))
          .results(blowdown, history()),
      Form<Blowdown>("blowdown_times", "Unchoking and end of the adiabatic blow-down",
                     "tau = V/(Cd A sqrt(R T0) phi); end by 2F1 of the subsonic branch", "derived here",
                     "p0 > p_a", 13)
          .fields(blowdown_tank())
          .results(blowdown_times, instants()),
      Form<Blowdown>("isothermal_blowdown",
                     "Isothermal tank that empties through a hole, choked, then subsonic",
                     "choked p = p0 exp(-t/tau); subsonic t by int (1 + v^2)^(1/(gamma-1) - 1/2) dv",
                     "derived here", "p0 > p_a; constant after equalisation", 13)
          .fields(blowdown_tank())
          .over("time_s", range(0.0, 0.4, 80))
          .results(isothermal_blowdown, history()),
      Form<Blowdown>("isothermal_blowdown_times", "Unchoking and end of the isothermal blow-down",
                     "tau = V/(Cd A sqrt(R T) phi); end by a polynomial for gamma = 7/5", "derived here",
                     "p0 > p_a", 13)
          .fields(blowdown_tank())
          .results(isothermal_blowdown_times, instants()),
      Form<PorousTank>("porous_tank_isothermal", "Isothermal tank that leaks through porous fabric",
                       "p = p_a cosh^2(u0 - k t); k = C sqrt(R T/2)/V; u0 = arcosh sqrt(p0/p_a)",
                       "derived here", "p0 > p_a; constant after u0/k", 14)
          .fields(gas_constant(), tank(0.12, 130000.0, 400.0), fabric(), ambient_pressure())
          .over("time_s", range(0.0, 0.07, 70))
          .results(porous_tank_isothermal, history())
          .constant("end_time_s", porous_tank_isothermal_end),
      Form<PorousTank>("porous_tank_adiabatic", "Adiabatic tank that leaks through porous fabric",
                       "t by int (1 + v^2)^(1/(2 gamma) - 1) dv, v = sqrt(p/p_a - 1)", "derived here",
                       "p0 > p_a; constant after the end", 13)
          .fields(gas(), tank(0.12, 130000.0, 400.0), fabric(), ambient_pressure())
          .over("time_s", range(0.0, 0.05, 50))
          .results(porous_tank_adiabatic, history())
          .constant("end_time_s", porous_tank_adiabatic_end)};
}

std::vector<Entry> exchanging_tanks() {
  return {Form<AmbientInrush>("ambient_inrush",
                              "Tank below ambient pressure that fills with ambient gas through a hole",
                              "sonic p = p0 + gamma R T_a mdot t/V; subsonic p = p_a s^(gamma/(gamma-1)), "
                              "sqrt(1 - s) linear in time",
                              "derived here", "0 <= p0 < p_a; constant after the end", 14)
              .fields(gas(), tank(0.06, 20000.0, 293.15))
              .field(&AmbientInrush::area, "area", "A", "m2", 1e-3, "Cd A of the hole")
              .fields(ambient_pressure())
              .field(&AmbientInrush::ambient_temperature, "ambient_temperature", "T_a", "K", 293.15,
                     "temperature of the ambient gas")
              .over("time_s", range(0.0, 0.3, 60))
              .results(ambient_inrush, history())
              .constant("end_time_s", ambient_inrush_end),
          Form<HeatLossFill>(
              "heat_loss_fill", "Constant inflow into a rigid tank that loses heat through its walls",
              "T - T_inf = (T0 - T_inf) (1 + mdot t/m0)^-(1 + hA/(mdot cv)); T_inf = (mdot cp T_in + hA "
              "T_ext)/(mdot cv + hA)",
              "linear energy balance, derived here", "t >= 0", 14)
              .fields(gas(), tank(0.06, 101325.0, 293.15), inflow(1.0, 700.0))
              .field(&HeatLossFill::conductance, "conductance", "hA", "W/K", 100.0,
                     "heat transfer coefficient times area")
              .field(&HeatLossFill::outside_temperature, "outside_temperature", "T_ext", "K", 293.15,
                     "temperature of the walls")
              .over("time_s", range(0.0, 0.1, 100))
              .results(heat_loss_fill, history()),
          Form<LinearFabricTank>(
              "linear_fabric_tank",
              "Adiabatic tank that leaks through fabric of velocity proportional to overpressure",
              "p = p_a/(1 - (1 - p_a/p0) exp(-gamma k C p_a t/V))", "derived here", "p0 > p_a", 14)
              .fields(gas(), tank(0.06, 130000.0, 400.0))
              .field(&LinearFabricTank::area, "area", "C", "m2", 1.5, "area of the fabric")
              .field(&LinearFabricTank::permeability, "permeability", "k", "m/(s Pa)", 1e-5,
                     "velocity through the fabric per overpressure")
              .fields(ambient_pressure())
              .over("time_s", range(0.0, 0.1, 100))
              .results(linear_fabric_tank, history())};
}

std::vector<Entry> bags() {
  return {
      Form<SpringBag>("spring_bag_fill", "Filling of a bag whose volume rises linearly with its pressure",
                      "(p V - p0 V0)/(gamma - 1) + k (p^2 - p0^2)/2 = mdot t cp T_in, V = V0 + k (p - p0)",
                      "derived here from the energy balance", "t >= 0; k = 0 is tank_fill", 15)
          .fields(gas(), tank(0.06, 101325.0, 293.15))
          .field(&SpringBag::compliance, "compliance", "k", "m3/Pa", 5e-7, "dV/dp")
          .number("mass_flow", "mdot", "kg/s", 1.0, "inflow")
          .number("inflow_temperature", "T_in", "K", 700.0, "of the inflow")
          .over("time_s", range(0.0, 0.05, 50))
          .results(with(filled_spring_bag, itself, "mass_flow", "inflow_temperature", abscissa),
                   history_with_volume()),
      Form<Blowdown>(
          "proportional_blowdown", "Choked blow-down of a bag whose volume is proportional to its pressure",
          "m/m0 = (1 - mdot0 t/(2 m0))^2, p/p0 = (m/m0)^(gamma/(gamma + 1)), T = T0 (p/p0)^((gamma-1)/gamma)",
          "derived here: what stays inside expands reversibly", "choked up to t", 15)
          .fields(gas(), tank(0.06, 5e5, 600.0), hole(1e-3),
                  ambient_pressure("ambient pressure (validity only)"))
          .over("time_s", range(0.0, 0.1, 50))
          .results(proportional_blowdown, history_with_volume())};
}

}  // namespace closed_form::entries
