// SPDX-License-Identifier: Apache-2.0
#include "closed_form/stability.hpp"
#include "entries.hpp"

namespace closed_form::entries {
namespace {

Entry central_difference_entry() {
  return {
      "central_difference",
      "Central difference of one mode over omega dt",
      "omega_num/omega = 2 asin(W/2)/W; stable iff W <= 2; |z| = W^2/2 - 1 + sqrt((W^2/2 - 1)^2 - 1) beyond",
      "textbook result (T. J. R. Hughes, The Finite Element Method)",
      "W > 0",
      14,
      {},
      {"omega_dt", "frequency_ratio", "growth_per_step", "energy_amplitude"},
      {0.1, 0.5, 1.0, 1.5, 1.9, 1.99, 2.0, 2.001, 2.1},
      [](const ParameterMap&, double w) {
        const CentralDifference c = central_difference(w);
        return Row{c.frequency_ratio, c.growth_per_step, c.energy_amplitude};
      }};
}

Parameters elastic_parameters() {
  return {{"young_modulus", "E", "Pa", 60e6, "Young's modulus"},
          {"poisson_ratio", "nu", "1", 0.3, "Poisson's ratio"},
          {"density", "rho", "kg/m3", 620.0, "density"}};
}

Sheet elastic_of(const ParameterMap& v) {
  return {get(v, "young_modulus"), get(v, "poisson_ratio"), 1.0, get(v, "density")};
}

Entry triangle_entry() {
  return {"triangle_time_step",
          "Critical step of one free constant-strain triangle (0,0), (base,0), (apex, height)",
          "omega^2 = (3/rho) lambda_max(D B B^T); dt = 2/omega",
          "derived here",
          "lumped mass, unstretched",
          14,
          joined({elastic_parameters(),
                  {{"base", "b", "m", 0.01, "base"},
                   {"apex", "", "m", 0.005, "abscissa of the apex"},
                   {"height", "", "m", 0.0086602540378443865, "height"}}}),
          {"angular_frequency_rad_s", "critical_time_step_s"},
          {},
          [](const ParameterMap& v, double) {
            const double w =
                triangle_frequency(elastic_of(v), get(v, "base"), get(v, "apex"), get(v, "height"));
            return Row{w, critical_time_step(w)};
          }};
}

Entry mesh_entry() {
  return {"mesh_time_step",
          "Critical steps of elements and unbounded meshes over the side",
          "element 6 E/(rho (1-nu) a^2), mesh 16 E/(3 rho (1-nu^2) a^2); right isosceles mesh 8 E/(rho "
          "(1-nu^2) a^2)",
          "derived here (Bloch waves)",
          "lumped mass, unstretched",
          15,
          elastic_parameters(),
          {"side_m", "equilateral_element_s", "right_element_s", "equilateral_mesh_s", "right_mesh_s"},
          {0.005, 0.01, 0.02, 0.04},
          [](const ParameterMap& v, double side) {
            const Sheet sheet = elastic_of(v);
            return Row{critical_time_step(equilateral_triangle_frequency(sheet, side)),
                       critical_time_step(right_triangle_frequency(sheet, side)),
                       critical_time_step(equilateral_mesh_frequency(sheet, side)),
                       critical_time_step(right_mesh_frequency(sheet, side))};
          }};
}

Entry gas_entry() {
  return {"gas_breathing",
          "Frequency and critical step of gas enclosed by a membrane",
          "omega^2 = gamma p A/(V rho h); dt = 2/omega",
          "derived here (rank-one gas stiffness)",
          "smooth closed surface; a bound on a folded bag",
          15,
          {{"heat_capacity_ratio", "gamma", "1", 1.4, "ratio of heat capacities"},
           {"pressure", "p", "Pa", 101325.0, "absolute pressure"},
           {"area", "A", "m2", 1.2, "area of the surface"},
           {"area_density", "rho_h", "kg/m2", 0.31, "mass per area"}},
          {"volume_m3", "angular_frequency_rad_s", "critical_time_step_s"},
          {1e-4, 1e-3, 1e-2, 0.12},
          [](const ParameterMap& v, double volume) {
            const PerfectGas gas{PerfectGas{}.gas_constant, get(v, "heat_capacity_ratio")};
            const double w = gas_breathing_frequency(
                {gas, get(v, "pressure"), volume, get(v, "area"), get(v, "area_density")});
            return Row{w, critical_time_step(w)};
          }};
}

Entry lagged_entry() {
  return {"lagged_pressure",
          "Growth per step when the pressure lags by one step, over omega_gas dt",
          "z^2 - (2 - W_s^2) z + (1 + W_g^2) = 0",
          "derived here",
          "W_s, W_g >= 0",
          15,
          {{"omega_structure_dt", "W_s", "1", 0.0, "structural omega dt"}},
          {"omega_gas_dt", "growth_per_step"},
          {0.01, 0.1, 0.5, 1.0},
          [](const ParameterMap& v, double wg) {
            return Row{lagged_pressure_growth(get(v, "omega_structure_dt"), wg)};
          }};
}

Entry drift_entry() {
  return {"volume_work_drift",
          "Drift of ln(p V^gamma) per step of discrete p dV over dV/V",
          "Euler: ln(1 - (gamma-1) d) + (gamma-1) ln(1 + d); trapezoid: -gamma (gamma^2-1) d^3/12 + ...",
          "derived here",
          "-2/(gamma+1) < d < 1/(gamma-1); absolute accuracy 1e-19",
          8,
          {{"heat_capacity_ratio", "gamma", "1", 1.4, "ratio of heat capacities"}},
          {"relative_volume_change", "euler_drift", "trapezoid_drift"},
          {-0.01, -0.001, 0.001, 0.01},
          [](const ParameterMap& v, double d) {
            const double gamma = get(v, "heat_capacity_ratio");
            return Row{euler_volume_work_drift(gamma, d), trapezoid_volume_work_drift(gamma, d)};
          }};
}

Entry vent_entry() {
  return {"vent_equalisation",
          "Vent near equalisation over overpressure",
          "d sqrt(dp)/dt = -kappa; kappa = gamma p_a A/(V sqrt(2 rho)); lambda = -kappa/sqrt(dp)",
          "derived here",
          "dp << p_a",
          15,
          joined({gas_parameters(),
                  {{"volume", "V", "m3", 0.06, "volume"},
                   {"area", "A", "m2", 1e-3, "Cd A of the vent"},
                   ambient_pressure_parameter(),
                   {"temperature", "T", "K", 400.0, "temperature"},
                   {"time_step", "dt", "s", 1e-3, "step of explicit Euler"}}}),
          {"overpressure_Pa", "rate_sqrtPa_s", "eigenvalue_1_s", "euler_chatter_Pa"},
          {1e-3, 1.0, 1e3},
          [](const ParameterMap& v, double dp) {
            const VentEqualisation vent{gas_of(v), get(v, "volume"), get(v, "area"),
                                        get(v, "ambient_pressure"), get(v, "temperature")};
            return Row{vent_equalisation_rate(vent), vent_eigenvalue(vent, dp),
                       vent_chatter_amplitude(vent, get(v, "time_step"))};
          }};
}

Entry node_contact_entry() {
  return {"node_contact_time_step",
          "Step limit of penalty contact on one fabric node over the stiffness",
          "dt = 2 sqrt(rho h A/k)",
          "textbook result",
          "k > 0",
          15,
          {{"density", "rho", "kg/m3", 620.0, "density"},
           {"thickness", "h", "m", 0.5e-3, "thickness"},
           {"tributary_area", "A", "m2", 1e-4, "area that belongs to the node"}},
          {"stiffness_N_m", "critical_time_step_s"},
          {1e3, 1e4, 1e5, 1e6},
          [](const ParameterMap& v, double k) {
            return Row{node_contact_time_step({1.0, 0.0, get(v, "thickness"), get(v, "density")},
                                              get(v, "tributary_area"), k)};
          }};
}

}  // namespace

void add_stability(std::vector<Entry>& list) {
  for (Entry (*entry)() : {central_difference_entry, triangle_entry, mesh_entry, gas_entry, lagged_entry,
                           drift_entry, vent_entry, node_contact_entry})
    list.push_back(entry());
}

}  // namespace closed_form::entries
