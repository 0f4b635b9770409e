// SPDX-License-Identifier: Apache-2.0
#include "closed_form/gas.hpp"
#include "entries.hpp"

namespace closed_form::entries {
namespace {

const char* const kBalance = "energy balance of an open system, textbook result; derived here";

Parameters inflow_parameters(double mass_flow, double temperature) {
  return {{"mass_flow", "mdot", "kg/s", mass_flow, "inflow"},
          {"inflow_temperature", "T_in", "K", temperature, "temperature of the inflow"}};
}

Entry tank_fill_entry() {
  return {"tank_fill",
          "Constant inflow into a rigid adiabatic tank",
          "p = p0 + gamma R T_in mdot t/V; m = m0 + mdot t; T = p V/(m R)",
          kBalance,
          "t >= 0; p0 >= 0",
          15,
          joined({gas_parameters(), tank_parameters(0.06, 101325.0, 293.15), inflow_parameters(1.0, 700.0)}),
          history_columns(),
          range(0.0, 0.1, 100),
          [](const ParameterMap& v, double t) {
            return history(
                tank_fill({gas_of(v), get(v, "volume"), get(v, "initial_pressure"),
                           get(v, "initial_temperature"), get(v, "mass_flow"), get(v, "inflow_temperature")},
                          t));
          }};
}

Entry tank_fill_pulse_entry() {
  return {"tank_fill_pulse",
          "Sine-squared inflow pulse into a rigid adiabatic tank",
          "mdot = (2 M/t_e) sin^2(pi t/t_e); T_in = T1 + (T2 - T1) t/t_e; p = p0 + gamma R int mdot T_in/V",
          kBalance,
          "t >= 0; state constant after t_e",
          14,
          joined({gas_parameters(),
                  tank_parameters(0.06, 101325.0, 293.15),
                  {{"total_mass", "M", "kg", 0.08, "mass of the pulse"},
                   {"duration", "t_e", "s", 0.05, "duration of the pulse"},
                   {"start_temperature", "T1", "K", 800.0, "inflow temperature at t = 0"},
                   {"end_temperature", "T2", "K", 400.0, "inflow temperature at t_e"}}}),
          {"time_s", "pressure_Pa", "temperature_K", "gas_mass_kg", "inflow_kg_s", "inflow_temperature_K"},
          range(0.0, 0.05, 100),
          [](const ParameterMap& v, double t) {
            const PulseFill pulse{gas_of(v),
                                  get(v, "volume"),
                                  get(v, "initial_pressure"),
                                  get(v, "initial_temperature"),
                                  get(v, "total_mass"),
                                  get(v, "duration"),
                                  get(v, "start_temperature"),
                                  get(v, "end_temperature")};
            Row row = history(pulse_fill(pulse, t));
            const PulseFlow flow = pulse_flow(pulse, t);
            row.insert(row.end(), {flow.mass_flow, flow.temperature});
            return row;
          }};
}

Entry two_gas_fill_entry() {
  return {"two_gas_fill",
          "One gas added to a rigid adiabatic tank of another",
          "(m_A cv_A + m_B cv_B) T = m_A cv_A T0 + m_B cp_B T_in; p = (m_A R_A + m_B R_B) T/V",
          kBalance,
          "constant heat capacities; abscissa is the mass added",
          15,
          joined({gas_parameters(),
                  tank_parameters(0.06, 101325.0, 293.15),
                  {{"inflow_gas_constant", "R_B", "J/(kg K)", 2077.1, "specific gas constant of the inflow"},
                   {"inflow_heat_capacity_ratio", "gamma_B", "1", 5.0 / 3.0, "gamma of the inflow"},
                   {"inflow_temperature", "T_in", "K", 700.0, "temperature of the inflow"}}}),
          {"inflow_mass_kg", "pressure_Pa", "temperature_K", "gas_mass_kg", "heat_capacity_ratio",
           "gas_constant_J_kg_K"},
          range(0.0, 0.05, 50),
          [](const ParameterMap& v, double mass) {
            const PerfectGas inflow{get(v, "inflow_gas_constant"), get(v, "inflow_heat_capacity_ratio")};
            const TwoGasState s =
                two_gas_fill({gas_of(v), inflow, get(v, "volume"), get(v, "initial_pressure"),
                              get(v, "initial_temperature"), mass, get(v, "inflow_temperature")});
            return Row{s.state.pressure, s.state.temperature, s.state.mass, s.heat_capacity_ratio,
                       s.gas_constant};
          }};
}

Entry vented_fill_steady_entry() {
  return {"vented_fill_steady",
          "Steady state of a tank with constant inflow and choked vent",
          "T = T_in; p = mdot sqrt(R T_in)/(Cd A phi); eigenvalues of the linearised (m, U) system",
          "derived here by linearisation",
          "the steady vent must be choked",
          14,
          joined({gas_parameters(),
                  inflow_parameters(0.5, 700.0),
                  {{"volume", "V", "m3", 0.06, "volume"},
                   {"vent_area", "A", "m2", 1e-3, "area of the vent"},
                   {"discharge_coefficient", "Cd", "1", 1.0, "of the vent"},
                   {"ambient_pressure", "p_a", "Pa", 101325.0, "ambient pressure (validity only)"}}}),
          {"pressure_Pa", "temperature_K", "gas_mass_kg", "slow_eigenvalue_1_s", "fast_eigenvalue_1_s"},
          {},
          [](const ParameterMap& v, double) {
            const VentedFillSteady s = vented_fill_steady(
                {gas_of(v), get(v, "volume"), get(v, "mass_flow"), get(v, "inflow_temperature"),
                 get(v, "vent_area"), get(v, "discharge_coefficient"), get(v, "ambient_pressure")});
            Row row = history(s.state);
            row.insert(row.end(), {s.slow_eigenvalue, s.fast_eigenvalue});
            return row;
          }};
}

Entry adiabatic_piston_entry() {
  return {"adiabatic_piston",
          "Reversible adiabatic compression or expansion",
          "p V^gamma = p0 V0^gamma",
          "textbook result",
          "V > 0",
          15,
          joined({gas_parameters(), tank_parameters(1e-3, 101325.0, 293.15)}),
          {"volume_m3", "pressure_Pa", "temperature_K", "gas_mass_kg", "work_on_gas_J"},
          range(0.125e-3, 1e-3, 70),
          [](const ParameterMap& v, double volume) {
            const PistonState s = adiabatic_piston(
                {gas_of(v), get(v, "initial_pressure"), get(v, "initial_temperature"), get(v, "volume")},
                volume);
            Row row = history(s.state);
            row.push_back(s.work_on_gas);
            return row;
          }};
}

Entry constant_pressure_fill_entry() {
  return {"constant_pressure_fill",
          "Filling of a limp bag at constant pressure",
          "V = V0 + mdot R T_in t/p; temperature mixes by enthalpy",
          kBalance,
          "t >= 0",
          15,
          joined({gas_constant_parameter(), tank_parameters(0.01, 101325.0, 293.15),
                  inflow_parameters(1.0, 700.0)}),
          {"time_s", "pressure_Pa", "temperature_K", "gas_mass_kg", "volume_m3"},
          range(0.0, 0.05, 50),
          [](const ParameterMap& v, double t) {
            const GasState s = constant_pressure_fill(
                {gas_of_constant(v), get(v, "initial_pressure"), get(v, "volume"),
                 get(v, "initial_temperature"), get(v, "mass_flow"), get(v, "inflow_temperature")},
                t);
            return Row{s.pressure, s.temperature, s.mass, s.volume};
          }};
}

Entry average_temperature_entry() {
  return {"average_temperature",
          "Tank test: mean inflow temperature and mass flow from the tank pressure",
          "T_bar = (p_end - p0) V/(gamma R M); mdot = V p'/(gamma R T_bar)",
          "derived here",
          "one gas; mdot biased by T_in/T_bar; abscissa is p'",
          15,
          joined({gas_parameters(),
                  {{"volume", "V", "m3", 0.06, "volume of the tank"},
                   {"initial_pressure", "p0", "Pa", 101325.0, "before firing"},
                   {"final_pressure", "p_end", "Pa", 433741.0, "after firing"},
                   {"total_mass", "M", "kg", 0.08, "known mass of the charge"}}}),
          {"pressure_rate_Pa_s", "inflow_temperature_K", "inflow_kg_s"},
          range(0.0, 15e6, 30),
          [](const ParameterMap& v, double rate) {
            const AverageTemperature tank{gas_of(v), get(v, "volume"), get(v, "initial_pressure"),
                                          get(v, "final_pressure"), get(v, "total_mass")};
            return Row{average_inflow_temperature(tank), average_temperature_mass_flow(tank, rate)};
          }};
}

Entry dual_pressure_entry() {
  return {"dual_pressure",
          "Tank test: mass flow and temperature from chamber and tank pressure",
          "Q = V p'/(gamma R); T = R Q^2/(A phi p_c)^2; mdot = (A phi p_c)^2/(R Q)",
          "derived here",
          "choked outlet; p' > 0; abscissa is p'",
          15,
          joined({gas_parameters(),
                  {{"volume", "V", "m3", 0.06, "volume of the tank"},
                   {"outlet_area", "A", "m2", 2e-4, "Cd A of the outlet"},
                   {"chamber_pressure", "p_c", "Pa", 5325380.8913917134, "in the inflator"}}}),
          {"pressure_rate_Pa_s", "inflow_kg_s", "inflow_temperature_K"},
          range(1e6, 15e6, 28),
          [](const ParameterMap& v, double rate) {
            const DualPressureResult r = dual_pressure(
                {gas_of(v), get(v, "volume"), get(v, "outlet_area"), get(v, "chamber_pressure"), rate});
            return Row{r.mass_flow, r.temperature};
          }};
}

}  // namespace

void add_tanks(std::vector<Entry>& list) {
  for (Entry (*entry)() : {tank_fill_entry, tank_fill_pulse_entry, two_gas_fill_entry,
                           vented_fill_steady_entry, adiabatic_piston_entry, constant_pressure_fill_entry})
    list.push_back(entry());
}

void add_tank_tests(std::vector<Entry>& list) {
  list.push_back(average_temperature_entry());
  list.push_back(dual_pressure_entry());
}

}  // namespace closed_form::entries
