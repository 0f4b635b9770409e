// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "closed_form/common.hpp"
#include "closed_form/membrane.hpp"
#include "closed_form/pendulum.hpp"
#include "form.hpp"

// Groups of parameters and of columns that several closed forms share. Defaults are the reference cases of
// the suite.
namespace closed_form::entries {

/// The gas of the arguments.
template <class S>
auto gas_member() {
  if constexpr (std::is_base_of_v<PerfectGas, S>)
    return itself;
  else if constexpr (requires { &S::gas; })
    return &S::gas;
  else
    return &S::tank_gas;
}

/// For formulas without gamma.
inline auto gas_constant() {
  return []<class S>(Form<S>& form) {
    form.field(path(gas_member<S>(), &PerfectGas::gas_constant), "gas_constant", "R", "J/(kg K)",
               PerfectGas{}.gas_constant, "specific gas constant");
  };
}
/// For formulas without R.
inline auto heat_capacity_ratio(const char* meaning = "ratio of heat capacities") {
  return [meaning]<class S>(Form<S>& form) {
    form.field(path(gas_member<S>(), &PerfectGas::heat_capacity_ratio), "heat_capacity_ratio", "gamma", "1",
               PerfectGas{}.heat_capacity_ratio, meaning);
  };
}
inline auto gas() {
  return [](auto& form) {
    form.fields(gas_constant(), heat_capacity_ratio("ratio of heat capacities, 1 < gamma < 3"));
  };
}

inline auto volume(double value) {
  return [value]<class S>(Form<S>& form) {
    if constexpr (requires { &S::volume; })
      form.field(&S::volume, "volume", "V", "m3", value, "volume");
    else
      form.field(&S::initial_volume, "volume", "V", "m3", value, "volume");
  };
}

inline auto tank(double initial_volume, double pressure, double temperature) {
  return [=]<class S>(Form<S>& form) {
    form.fields(volume(initial_volume))
        .field(&S::initial_pressure, "initial_pressure", "p0", "Pa", pressure, "absolute pressure at t = 0")
        .field(&S::initial_temperature, "initial_temperature", "T0", "K", temperature,
               "temperature at t = 0");
  };
}

inline auto inflow(double mass_flow, double temperature) {
  return [=]<class S>(Form<S>& form) {
    form.field(&S::mass_flow, "mass_flow", "mdot", "kg/s", mass_flow, "inflow")
        .field(&S::inflow_temperature, "inflow_temperature", "T_in", "K", temperature,
               "temperature of the inflow");
  };
}

inline auto ambient_pressure(const char* meaning = "ambient pressure") {
  return [meaning]<class S>(Form<S>& form) {
    if constexpr (requires { &S::ambient_pressure; })
      form.field(&S::ambient_pressure, "ambient_pressure", "p_a", "Pa", 101325.0, meaning);
    else
      form.number("ambient_pressure", "p_a", "Pa", 101325.0, meaning);
  };
}

inline auto discharge_coefficient(const char* meaning) {
  return [meaning]<class S>(Form<S>& form) {
    form.field(&S::discharge_coefficient, "discharge_coefficient", "Cd", "1", 1.0, meaning);
  };
}

/// Columns of a tank's history; `state` leads from the result to its GasState.
template <class Result>
Columns<Result> history(GasState Result::*state) {
  return {{"pressure_Pa", path(state, &GasState::pressure)},
          {"temperature_K", path(state, &GasState::temperature)},
          {"gas_mass_kg", path(state, &GasState::mass)}};
}
inline Columns<GasState> history() {
  return {{"pressure_Pa", &GasState::pressure},
          {"temperature_K", &GasState::temperature},
          {"gas_mass_kg", &GasState::mass}};
}
inline Columns<GasState> history_with_volume() {
  auto columns = history();
  columns.push_back({"volume_m3", &GasState::volume});
  return columns;
}

/// The sheet of the arguments: they are one, have one, or have a sphere made of one.
template <class S>
auto sheet_member() {
  if constexpr (std::is_base_of_v<Sheet, S>)
    return itself;
  else if constexpr (requires { &S::sheet; })
    return &S::sheet;
  else
    return path(&S::sphere, &StretchedSphere::sheet);
}

inline auto sheet() {
  return []<class S>(Form<S>& form) {
    const auto sheet = sheet_member<S>();
    form.field(path(sheet, &Sheet::young_modulus), "young_modulus", "E", "Pa", 60e6, "Young's modulus")
        .field(path(sheet, &Sheet::poisson_ratio), "poisson_ratio", "nu", "1", 0.3, "Poisson's ratio")
        .field(path(sheet, &Sheet::thickness), "thickness", "h", "m", 0.5e-3, "thickness");
  };
}

inline auto density() {
  return []<class S>(Form<S>& form) {
    form.field(path(sheet_member<S>(), &Sheet::density), "density", "rho", "kg/m3", 620.0, "density");
  };
}

/// Unstretched radius of the arguments or of their sphere.
inline auto radius(double value, const char* meaning = "unstretched radius") {
  return [=]<class S>(Form<S>& form) {
    if constexpr (requires { &S::radius; })
      form.field(&S::radius, "radius", "R0", "m", value, meaning);
    else
      form.field(path(&S::sphere, &StretchedSphere::radius), "radius", "R0", "m", value, meaning);
  };
}

template <class S>
auto pendulum_member() {
  if constexpr (std::is_base_of_v<Pendulum, S>)
    return itself;
  else
    return &S::pendulum;
}

inline auto pendulum() {
  return []<class S>(Form<S>& form) {
    const Pendulum paper = paper_pendulum();
    const auto pendulum = pendulum_member<S>();
    form.field(path(pendulum, &Pendulum::mass), "mass", "m", "kg", paper.mass, "mass")
        .field(path(pendulum, &Pendulum::cg_inertia), "cg_inertia", "I_cg", "kg m2", paper.cg_inertia,
               "moment of inertia about the c.g.")
        .field(path(pendulum, &Pendulum::cg_arm), "cg_arm", "L", "m", paper.cg_arm, "axis to c.g.")
        .field(path(pendulum, &Pendulum::impactor_arm), "impactor_arm", "L_i", "m", paper.impactor_arm,
               "axis to impactor centre")
        .field(path(pendulum, &Pendulum::gravity), "gravity", "g", "m/s2", paper.gravity,
               "acceleration of gravity");
  };
}

}  // namespace closed_form::entries
