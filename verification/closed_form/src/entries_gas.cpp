// SPDX-License-Identifier: Apache-2.0
#include "closed_form/gas.hpp"
#include "closed_form/tank_test.hpp"
#include "entries.hpp"
#include "fields.hpp"

namespace closed_form::entries {
namespace {

const char* const kBalance = "energy balance of an open system, textbook result; derived here";

struct TankTest : TankTestPulse {
  PerfectGas gas, tank_gas;
};

}  // namespace

std::vector<Entry> tanks() {
  return {
      Form<TankFill>("tank_fill", "Constant inflow into a rigid adiabatic tank",
                     "p = p0 + gamma R T_in mdot t/V; m = m0 + mdot t; T = p V/(m R)", kBalance,
                     "t >= 0; p0 >= 0", 15)
          .fields(gas(), tank(0.06, 101325.0, 293.15), inflow(1.0, 700.0))
          .over("time_s", range(0.0, 0.1, 100))
          .results(tank_fill, history()),
      Form<PulseFill>(
          "tank_fill_pulse", "Sine-squared inflow pulse into a rigid adiabatic tank",
          "mdot = (2 M/t_e) sin^2(pi t/t_e); T_in = T1 + (T2 - T1) t/t_e; p = p0 + gamma R int mdot T_in/V",
          kBalance, "t >= 0; state constant after t_e", 14)
          .fields(gas(), tank(0.06, 101325.0, 293.15))
          .field(&PulseFill::total_mass, "total_mass", "M", "kg", 0.08, "mass of the pulse")
          .field(&PulseFill::duration, "duration", "t_e", "s", 0.05, "duration of the pulse")
          .field(&PulseFill::start_temperature, "start_temperature", "T1", "K", 800.0,
                 "inflow temperature at t = 0")
          .field(&PulseFill::end_temperature, "end_temperature", "T2", "K", 400.0,
                 "inflow temperature at t_e")
          .over("time_s", range(0.0, 0.05, 100))
          .results(pulse_fill, history())
          .results(pulse_flow, {{"inflow_kg_s", &PulseFlow::mass_flow},
                                {"inflow_temperature_K", &PulseFlow::temperature}}),
      Form<TwoGasFill>("two_gas_fill", "One gas added to a rigid adiabatic tank of another",
                       "(m_A cv_A + m_B cv_B) T = m_A cv_A T0 + m_B cp_B T_in; p = (m_A R_A + m_B R_B) T/V",
                       kBalance, "constant heat capacities; abscissa is the mass added", 15)
          .fields(gas(), tank(0.06, 101325.0, 293.15))
          .field(path(&TwoGasFill::inflow_gas, &PerfectGas::gas_constant), "inflow_gas_constant", "R_B",
                 "J/(kg K)", 2077.1, "specific gas constant of the inflow")
          .field(path(&TwoGasFill::inflow_gas, &PerfectGas::heat_capacity_ratio),
                 "inflow_heat_capacity_ratio", "gamma_B", "1", 5.0 / 3.0, "gamma of the inflow")
          .field(&TwoGasFill::inflow_temperature, "inflow_temperature", "T_in", "K", 700.0,
                 "temperature of the inflow")
          .over("inflow_mass_kg", range(0.0, 0.05, 50), &TwoGasFill::inflow_mass)
          .results(two_gas_fill, history(&TwoGasState::state))
          .results(two_gas_fill, {{"heat_capacity_ratio", &TwoGasState::heat_capacity_ratio},
                                  {"gas_constant_J_kg_K", &TwoGasState::gas_constant}}),
      Form<VentedFill>(
          "vented_fill_steady", "Steady state of a tank with constant inflow and choked vent",
          "T = T_in; p = mdot sqrt(R T_in)/(Cd A phi); eigenvalues of the linearised (m, U) system",
          "derived here by linearisation", "the steady vent must be choked", 14)
          .fields(gas(), inflow(0.5, 700.0), volume(0.06))
          .field(&VentedFill::vent_area, "vent_area", "A", "m2", 1e-3, "area of the vent")
          .fields(discharge_coefficient("of the vent"), ambient_pressure("ambient pressure (validity only)"))
          .results(vented_fill_steady, history(&VentedFillSteady::state))
          .results(vented_fill_steady, {{"slow_eigenvalue_1_s", &VentedFillSteady::slow_eigenvalue},
                                        {"fast_eigenvalue_1_s", &VentedFillSteady::fast_eigenvalue}}),
      Form<AdiabaticPiston>("adiabatic_piston", "Reversible adiabatic compression or expansion",
                            "p V^gamma = p0 V0^gamma", "textbook result", "V > 0", 14)
          .fields(gas(), tank(1e-3, 101325.0, 293.15))
          .over("volume_m3", range(0.125e-3, 1e-3, 70))
          .results(adiabatic_piston, history(&PistonState::state))
          .results(adiabatic_piston, {{"work_on_gas_J", &PistonState::work_on_gas}}),
      Form<ConstantPressureFill>("constant_pressure_fill", "Filling of a limp bag at constant pressure",
                                 "V = V0 + mdot R T_in t/p; temperature mixes by enthalpy", kBalance,
                                 "t >= 0", 15)
          .fields(gas_constant(), volume(0.01))
          .field(&ConstantPressureFill::pressure, "initial_pressure", "p0", "Pa", 101325.0,
                 "absolute pressure at t = 0")
          .field(&ConstantPressureFill::initial_temperature, "initial_temperature", "T0", "K", 293.15,
                 "temperature at t = 0")
          .fields(inflow(1.0, 700.0))
          .over("time_s", range(0.0, 0.05, 50))
          .results(constant_pressure_fill, history_with_volume())};
}

std::vector<Entry> tank_tests() {
  return {
      Form<AverageTemperature>("average_temperature",
                               "Tank test: mean inflow temperature and mass flow from the tank pressure",
                               "T_bar = (p_end - p0) V/(gamma R M); mdot = V p'/(gamma R T_bar)",
                               "derived here", "one gas; mdot biased by T_in/T_bar; abscissa is p'", 15)
          .fields(gas())
          .field(&AverageTemperature::volume, "volume", "V", "m3", 0.06, "volume of the tank")
          .field(&AverageTemperature::initial_pressure, "initial_pressure", "p0", "Pa", 101325.0,
                 "before firing")
          .field(&AverageTemperature::final_pressure, "final_pressure", "p_end", "Pa", 433741.0,
                 "after firing")
          .field(&AverageTemperature::total_mass, "total_mass", "M", "kg", 0.08, "known mass of the charge")
          .over("pressure_rate_Pa_s", range(0.0, 15e6, 30))
          .result("inflow_temperature_K", average_inflow_temperature)
          .result("inflow_kg_s", average_temperature_mass_flow),
      Form<DualPressure>("dual_pressure",
                         "Tank test: mass flow and temperature from chamber and tank pressure",
                         "Q = V p'/(gamma R); T = R Q^2/(A phi p_c)^2; mdot = (A phi p_c)^2/(R Q)",
                         "derived here", "choked outlet; p' > 0; abscissa is p'", 15)
          .fields(gas())
          .field(&DualPressure::volume, "volume", "V", "m3", 0.06, "volume of the tank")
          .field(&DualPressure::outlet_area, "outlet_area", "A", "m2", 2e-4, "Cd A of the outlet")
          .field(&DualPressure::chamber_pressure, "chamber_pressure", "p_c", "Pa", 5325380.8913917134,
                 "in the inflator")
          .over("pressure_rate_Pa_s", range(1e6, 15e6, 28), &DualPressure::pressure_rate)
          .results(dual_pressure, {{"inflow_kg_s", &DualPressureResult::mass_flow},
                                   {"inflow_temperature_K", &DualPressureResult::temperature}}),
      Form<TankTest>("tank_test_pulse", "Tank test: readings of tank and chamber that a known pulse makes",
                     "(m_A cv_A + m cv) T = m_A cv_A T0 + cp int mdot T_s dt; y^2 - y = q or choked outlet",
                     "energy balance of an open system and isentropic flow; derived here",
                     "t >= 0; constant heat capacities; state constant after t_e", 13)
          .fields(gas())
          .field(path(&TankTest::tank_gas, &PerfectGas::gas_constant), "tank_gas_constant", "R_A", "J/(kg K)",
                 287.0, "specific gas constant of the tank's gas")
          .field(path(&TankTest::tank_gas, &PerfectGas::heat_capacity_ratio), "tank_heat_capacity_ratio",
                 "gamma_A", "1", 1.4, "gamma of the tank's gas")
          .fields(tank(0.06, 101325.0, 293.15))
          .field(&TankTest::total_mass, "total_mass", "M", "kg", 0.08, "mass of the pulse")
          .field(&TankTest::duration, "duration", "t_e", "s", 0.05, "duration of the pulse")
          .field(&TankTest::start_temperature, "start_temperature", "T1", "K", 800.0,
                 "stagnation temperature in the chamber at t = 0")
          .field(&TankTest::end_temperature, "end_temperature", "T2", "K", 400.0, "the same at t_e")
          .field(&TankTest::outlet_area, "outlet_area", "A", "m2", 2e-4, "Cd A of the chamber's outlet")
          .over("time_s", range(0.0, 0.06, 120))
          .results(with(tank_test_pulse, &TankTest::tank_gas, &TankTest::gas, itself, abscissa),
                   {{"tank_pressure_Pa", &TankTestReadings::tank_pressure},
                    {"chamber_pressure_Pa", &TankTestReadings::chamber_pressure},
                    {"inflow_kg_s", &TankTestReadings::mass_flow},
                    {"inflow_temperature_K", &TankTestReadings::temperature}})};
}

}  // namespace closed_form::entries
