// SPDX-License-Identifier: Apache-2.0
#include "entries.hpp"

#include <cmath>

#include "check.hpp"

namespace closed_form::entries {

double get(const ParameterMap& values, const char* name) {
  return values.at(name);
}

int whole(const ParameterMap& values, const char* name) {
  return whole_abscissa(name, get(values, name));
}

int whole_abscissa(const char* name, double value) {
  if (!(std::abs(value) <= 1e6) || value != std::floor(value))
    check::refuse(name, value, "must be a whole number of magnitude <= 1e6");
  return static_cast<int>(value);
}

Row range(double first, double last, int n) {
  Row values;
  for (int i = 0; i <= n; ++i) values.push_back(i == n ? last : first + (last - first) * i / n);
  return values;
}

Parameters joined(std::initializer_list<Parameters> lists) {
  Parameters all;
  for (const Parameters& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

Parameters gas_constant_parameter() {
  return {{"gas_constant", "R", "J/(kg K)", PerfectGas{}.gas_constant, "specific gas constant"}};
}

PerfectGas gas_of_constant(const ParameterMap& values) {
  return {get(values, "gas_constant"), PerfectGas{}.heat_capacity_ratio};
}

Parameters gas_parameters() {
  Parameters list = gas_constant_parameter();
  list.push_back({"heat_capacity_ratio", "gamma", "1", PerfectGas{}.heat_capacity_ratio,
                  "ratio of heat capacities, 1 < gamma < 3"});
  return list;
}

PerfectGas gas_of(const ParameterMap& values) {
  return {get(values, "gas_constant"), get(values, "heat_capacity_ratio")};
}

Parameter ambient_pressure_parameter() {
  return {"ambient_pressure", "p_a", "Pa", 101325.0, "ambient pressure"};
}

std::vector<std::string> history_columns() {
  return {"time_s", "pressure_Pa", "temperature_K", "gas_mass_kg"};
}

Row history(const GasState& state) {
  return {state.pressure, state.temperature, state.mass};
}

Parameters tank_parameters(double volume, double pressure, double temperature) {
  return {{"volume", "V", "m3", volume, "volume"},
          {"initial_pressure", "p0", "Pa", pressure, "absolute pressure at t = 0"},
          {"initial_temperature", "T0", "K", temperature, "temperature at t = 0"}};
}

Parameters sheet_parameters(bool with_density) {
  Parameters list{{"young_modulus", "E", "Pa", 60e6, "Young's modulus"},
                  {"poisson_ratio", "nu", "1", 0.3, "Poisson's ratio"},
                  {"thickness", "h", "m", 0.5e-3, "thickness"}};
  if (with_density) list.push_back({"density", "rho", "kg/m3", 620.0, "density"});
  return list;
}

Sheet sheet_of(const ParameterMap& values, bool with_density) {
  return {get(values, "young_modulus"), get(values, "poisson_ratio"), get(values, "thickness"),
          with_density ? get(values, "density") : kRequired};
}

Parameters pendulum_parameters() {
  const Pendulum paper = paper_pendulum();
  return {{"mass", "m", "kg", paper.mass, "mass"},
          {"cg_inertia", "I_cg", "kg m2", paper.cg_inertia, "moment of inertia about the c.g."},
          {"cg_arm", "L", "m", paper.cg_arm, "axis to c.g."},
          {"impactor_arm", "L_i", "m", paper.impactor_arm, "axis to impactor centre"},
          {"gravity", "g", "m/s2", paper.gravity, "acceleration of gravity"}};
}

Pendulum pendulum_of(const ParameterMap& values) {
  return {get(values, "mass"), get(values, "cg_inertia"), get(values, "cg_arm"), get(values, "impactor_arm"),
          get(values, "gravity")};
}

}  // namespace closed_form::entries
