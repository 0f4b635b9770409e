// SPDX-License-Identifier: Apache-2.0
#include "closed_form/stability.hpp"
#include "entries.hpp"
#include "fields.hpp"

namespace closed_form::entries {
namespace {

double triangle_step(const Sheet& sheet, double base, double apex, double height) {
  return critical_time_step(triangle_frequency(sheet, base, apex, height));
}

double breathing_step(const EnclosedGas& gas) {
  return critical_time_step(gas_breathing_frequency(gas));
}

// The step does not depend on the moduli.
double node_step(double density, double thickness, double area, double stiffness) {
  return node_contact_time_step({1.0, 0.0, thickness, density}, area, stiffness);
}

template <double frequency(const Sheet&, double)>
double time_step_of(const Sheet& sheet, double side) {
  return critical_time_step(frequency(sheet, side));
}

}  // namespace

std::vector<Entry> time_steps() {
  return {Form<Nothing>("central_difference", "Central difference of one mode over omega dt",
                        "omega_num/omega = 2 asin(W/2)/W; stable iff W <= 2; |z| = W^2/2 - 1 + sqrt((W^2/2 - "
                        "1)^2 - 1) beyond",
                        "textbook result (T. J. R. Hughes, The Finite Element Method)", "W > 0", 14)
              .over("omega_dt", {0.1, 0.5, 1.0, 1.5, 1.9, 1.99, 2.0, 2.001, 2.1})
              .results(central_difference, {{"frequency_ratio", &CentralDifference::frequency_ratio},
                                            {"growth_per_step", &CentralDifference::growth_per_step},
                                            {"energy_amplitude", &CentralDifference::energy_amplitude}}),
          Form<Sheet>("triangle_time_step",
                      "Critical step of one free constant-strain triangle (0,0), (base,0), (apex, height)",
                      "omega^2 = (3/rho) lambda_max(D B B^T); dt = 2/omega", "derived here",
                      "lumped mass, unstretched", 14)
              .fields(sheet(), density())
              .fixed("thickness", 1.0)
              .number("base", "b", "m", 0.01, "base")
              .number("apex", "", "m", 0.005, "abscissa of the apex")
              .number("height", "", "m", 0.0086602540378443865, "height")
              .result("angular_frequency_rad_s", with(triangle_frequency, itself, "base", "apex", "height"))
              .result("critical_time_step_s", with(triangle_step, itself, "base", "apex", "height")),
          Form<Sheet>(
              "mesh_time_step", "Critical steps of elements and unbounded meshes over the side",
              "element 6 E/(rho (1-nu) a^2), mesh 16 E/(3 rho (1-nu^2) a^2); right isosceles mesh 8 E/(rho "
              "(1-nu^2) a^2)",
              "derived here (Bloch waves)", "lumped mass, unstretched", 15)
              .fields(sheet(), density())
              .fixed("thickness", 1.0)
              .over("side_m", {0.005, 0.01, 0.02, 0.04})
              .result("equilateral_element_s", time_step_of<equilateral_triangle_frequency>)
              .result("right_element_s", time_step_of<right_triangle_frequency>)
              .result("equilateral_mesh_s", time_step_of<equilateral_mesh_frequency>)
              .result("right_mesh_s", time_step_of<right_mesh_frequency>),
          Form<EnclosedGas>("gas_breathing", "Frequency and critical step of gas enclosed by a membrane",
                            "omega^2 = gamma p A/(V rho h); dt = 2/omega",
                            "derived here (rank-one gas stiffness)",
                            "smooth closed surface; a bound on a folded bag", 15)
              .fields(heat_capacity_ratio())
              .field(&EnclosedGas::pressure, "pressure", "p", "Pa", 101325.0, "absolute pressure")
              .field(&EnclosedGas::area, "area", "A", "m2", 1.2, "area of the surface")
              .field(&EnclosedGas::area_density, "area_density", "rho_h", "kg/m2", 0.31, "mass per area")
              .over("volume_m3", {1e-4, 1e-3, 1e-2, 0.12}, &EnclosedGas::volume)
              .result("angular_frequency_rad_s", gas_breathing_frequency)
              .result("critical_time_step_s", breathing_step)};
}

std::vector<Entry> drifts() {
  return {
      Form<Nothing>("lagged_pressure",
                    "Growth per step when the pressure lags by one step, over omega_gas dt",
                    "z^2 - (2 - W_s^2) z + (1 + W_g^2) = 0", "derived here", "W_s, W_g >= 0", 15)
          .number("omega_structure_dt", "W_s", "1", 0.0, "structural omega dt")
          .over("omega_gas_dt", {0.01, 0.1, 0.5, 1.0})
          .result("growth_per_step", with(lagged_pressure_growth, "omega_structure_dt", abscissa)),
      Form<PerfectGas>(
          "volume_work_drift", "Drift of ln(p V^gamma) per step of discrete p dV over dV/V",
          "Euler: ln(1 - (gamma-1) d) + (gamma-1) ln(1 + d); trapezoid: -gamma (gamma^2-1) d^3/12 + ...",
          "derived here", "-2/(gamma+1) < d < 1/(gamma-1); absolute accuracy 1e-19", 8)
          .fields(heat_capacity_ratio())
          .over("relative_volume_change", {-0.01, -0.001, 0.001, 0.01})
          .result("euler_drift", with(euler_volume_work_drift, &PerfectGas::heat_capacity_ratio, abscissa))
          .result("trapezoid_drift",
                  with(trapezoid_volume_work_drift, &PerfectGas::heat_capacity_ratio, abscissa)),
      Form<VentEqualisation>(
          "vent_equalisation", "Vent near equalisation over overpressure",
          "d sqrt(dp)/dt = -kappa; kappa = gamma p_a A/(V sqrt(2 rho)); lambda = -kappa/sqrt(dp)",
          "derived here", "dp << p_a", 15)
          .fields(gas(), volume(0.06))
          .field(&VentEqualisation::area, "area", "A", "m2", 1e-3, "Cd A of the vent")
          .fields(ambient_pressure())
          .field(&VentEqualisation::temperature, "temperature", "T", "K", 400.0, "temperature")
          .number("time_step", "dt", "s", 1e-3, "step of explicit Euler")
          .over("overpressure_Pa", {1e-3, 1.0, 1e3})
          .result("rate_sqrtPa_s", vent_equalisation_rate)
          .result("eigenvalue_1_s", vent_eigenvalue)
          .result("euler_chatter_Pa", with(vent_chatter_amplitude, itself, "time_step")),
      Form<Nothing>("node_contact_time_step",
                    "Step limit of penalty contact on one fabric node over the stiffness",
                    "dt = 2 sqrt(rho h A/k)", "textbook result", "k > 0", 15)
          .number("density", "rho", "kg/m3", 620.0, "density")
          .number("thickness", "h", "m", 0.5e-3, "thickness")
          .number("tributary_area", "A", "m2", 1e-4, "area that belongs to the node")
          .over("stiffness_N_m", {1e3, 1e4, 1e5, 1e6})
          .result("critical_time_step_s",
                  with(node_step, "density", "thickness", "tributary_area", abscissa))};
}

}  // namespace closed_form::entries
