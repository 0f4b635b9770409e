// SPDX-License-Identifier: Apache-2.0
// Gas, outflow and tank.
#include <sstream>

#include "module.hpp"

namespace {

Owner gas(const std::string& composition, double constant_cp_at) {
  gasjet_handle handle = 0;
  check(gasjet_gas_create(composition.c_str(), constant_cp_at, &handle));
  return std::make_unique<Handle>(handle);
}

Owner ideal_gas(double gas_constant, double cp) {
  gasjet_handle handle = 0;
  check(gasjet_gas_create_ideal(gas_constant, cp, &handle));
  return std::make_unique<Handle>(handle);
}

py::dict gas_values(const Handle& gas, double temperature) {
  gasjet_gas_values v;
  check(gasjet_gas_evaluate(gas.value, temperature, &v));
  py::dict all;
  all["gas_constant_J_kgK"] = v.gas_constant;
  all["cp_J_kgK"] = v.cp;
  all["cv_J_kgK"] = v.cv;
  all["gamma"] = v.gamma;
  all["enthalpy_J_kg"] = v.enthalpy;
  all["internal_energy_J_kg"] = v.internal_energy;
  all["speed_of_sound_m_s"] = v.speed_of_sound;
  return all;
}

double gas_temperature(const Handle& gas, double internal_energy) {
  double temperature = 0.0;
  check(gasjet_gas_temperature(gas.value, internal_energy, &temperature));
  return temperature;
}

double gas_entropy(const Handle& gas, double temperature, double pressure) {
  double entropy = 0.0;
  check(gasjet_gas_entropy(gas.value, temperature, pressure, &entropy));
  return entropy;
}

double orifice(double area, double pressure, double temperature, double gas_constant, double cp,
               double ambient) {
  double flow = 0.0;
  check(gasjet_orifice(area, pressure, temperature, gas_constant, cp, ambient, &flow));
  return flow;
}

double fabric(double leak_area, double density, double overpressure) {
  double flow = 0.0;
  check(gasjet_fabric(leak_area, density, overpressure, &flow));
  return flow;
}

Owner tank(const Handle& gas, double pressure, double temperature, double volume, double ambient,
           double tolerance) {
  gasjet_handle handle = 0;
  check(gasjet_tank_create(gas.value, pressure, temperature, volume, ambient, tolerance, &handle));
  return std::make_unique<Handle>(handle);
}

void add_inflow(const Handle& tank, const Handle& gas, const Numbers& time, const Numbers& mass_flow,
                const Numbers& temperature, double start_time) {
  if (mass_flow.size() != time.size() || temperature.size() != time.size())
    wrong_type("time, mass_flow, temperature",
               "have " + std::to_string(time.size()) + ", " + std::to_string(mass_flow.size()) + " and " +
                   std::to_string(temperature.size()) + " numbers, allowed: equal numbers of each");
  check(gasjet_tank_add_inflow(tank.value, gas.value, time.size(), time.data(), mass_flow.data(),
                               temperature.data(), start_time));
}

void add_vent(const Handle& tank, double discharge_coefficient, double area, double opens_at) {
  check(gasjet_tank_add_vent(tank.value, discharge_coefficient, area, opens_at));
}

void add_fabric(const Handle& tank, double leak_area) {
  check(gasjet_tank_add_fabric(tank.value, leak_area));
}

void add_backflow(const Handle& tank, int64_t vent, const Handle& gas, double temperature) {
  check(gasjet_tank_add_backflow(tank.value, vent, gas.value, temperature));
}

void set_vent(const Handle& tank, int64_t vent, double area) {
  check(gasjet_tank_set_vent(tank.value, vent, area));
}

void set_heat_loss(const Handle& tank, double conductance, double outside_temperature) {
  check(gasjet_tank_set_heat_loss(tank.value, conductance, outside_temperature));
}

// Name, mass and amount of each species.
py::list species(const Handle& tank) {
  int64_t size = 0;
  check(gasjet_tank_species(tank.value, nullptr, 0, &size));
  std::string names(static_cast<std::size_t>(size), '\0');
  check(gasjet_tank_species(tank.value, names.data(), size, &size));
  names.pop_back();
  const auto count = 1 + std::count(names.begin(), names.end(), '\n');
  std::vector<double> mass(static_cast<std::size_t>(count)), amount(mass.size());
  check(gasjet_tank_masses(tank.value, mass.data(), amount.data(), count));
  py::list all;
  std::istringstream lines(names);
  for (std::string name; std::getline(lines, name);)
    all.append(py::make_tuple(name, mass[all.size()], amount[all.size()]));
  return all;
}

void advance(const Handle& tank, double time, double volume) {
  unlocked([&] { return gasjet_tank_advance(tank.value, time, volume); });
}

}  // namespace

py::dict dict_of(const gasjet_tank_state& s) {
  py::dict all;
  all["time_s"] = s.time;
  all["pressure_Pa"] = s.pressure;
  all["temperature_K"] = s.temperature;
  all["volume_m3"] = s.volume;
  all["gas_mass_kg"] = s.mass;
  all["internal_energy_J"] = s.internal_energy;
  all["density_kg_m3"] = s.density;
  all["gamma"] = s.gamma;
  all["cp_J_kgK"] = s.cp;
  all["gas_constant_J_kgK"] = s.gas_constant;
  all["inflow_kg_s"] = s.inflow;
  all["vent_outflow_kg_s"] = s.vent_outflow;
  all["fabric_outflow_kg_s"] = s.fabric_outflow;
  all["backflow_kg_s"] = s.backflow;
  all["heat_loss_W"] = s.heat_loss;
  return all;
}

namespace {

py::dict tank_state(const Handle& tank) {
  gasjet_tank_state s;
  check(gasjet_tank_read(tank.value, &s));
  return dict_of(s);
}

py::dict tank_balance(const Handle& tank) {
  gasjet_tank_balance b;
  check(gasjet_tank_read_balance(tank.value, &b));
  py::dict all;
  all["mass_in_kg"] = b.mass_in;
  all["enthalpy_in_J"] = b.enthalpy_in;
  all["backflow_mass_kg"] = b.backflow_mass;
  all["backflow_energy_J"] = b.backflow_energy;
  all["vent_mass_out_kg"] = b.vent_mass_out;
  all["fabric_mass_out_kg"] = b.fabric_mass_out;
  all["enthalpy_out_J"] = b.enthalpy_out;
  all["work_J"] = b.work;
  all["heat_J"] = b.heat;
  all["mass_residual_kg"] = b.mass_residual;
  all["energy_residual_J"] = b.energy_residual;
  all["substeps"] = b.substeps;
  return all;
}

}  // namespace

void add_gas(py::module_& m) {
  def(m, "gas", &gas, {"composition", "constant_cp_at"});
  def(m, "ideal_gas", &ideal_gas, {"gas_constant", "cp"});
  def(m, "gas_values", &gas_values, {"gas", "temperature"});
  def(m, "gas_temperature", &gas_temperature, {"gas", "internal_energy"});
  def(m, "gas_entropy", &gas_entropy, {"gas", "temperature", "pressure"});
  def(m, "orifice", &orifice,
      {"effective_area", "pressure", "temperature", "gas_constant", "cp", "ambient_pressure"});
  def(m, "fabric", &fabric, {"leak_area", "density", "overpressure"});
  def(m, "tank", &tank, {"gas", "pressure", "temperature", "volume", "ambient_pressure", "tolerance"});
  def(m, "tank_add_inflow", &add_inflow, {"tank", "gas", "time", "mass_flow", "temperature", "start_time"});
  def(m, "tank_add_vent", &add_vent, {"tank", "discharge_coefficient", "area", "opens_at"});
  def(m, "tank_add_backflow", &add_backflow, {"tank", "vent", "gas", "temperature"});
  def(m, "tank_set_vent", &set_vent, {"tank", "vent", "area"});
  def(m, "tank_set_heat_loss", &set_heat_loss, {"tank", "conductance", "outside_temperature"});
  def(m, "tank_species", &species, {"tank"});
  def(m, "tank_add_fabric", &add_fabric, {"tank", "leak_area"});
  def(m, "tank_advance", &advance, {"tank", "time", "volume"});
  def(m, "tank_state", &tank_state, {"tank"});
  def(m, "tank_balance", &tank_balance, {"tank"});
}
