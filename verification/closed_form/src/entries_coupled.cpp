// SPDX-License-Identifier: Apache-2.0
#include "closed_form/coupled.hpp"
#include "entries.hpp"

namespace closed_form::entries {
namespace {

Entry sphere_cut_entry() {
  return {"sphere_plane_cut",
          "Cut of a sphere by a plane over the depth",
          "patch pi (2 R d - d^2); cap pi d^2 (R - d/3)",
          "textbook result",
          "0 <= d <= 2 R",
          15,
          {{"radius", "R", "m", 0.041, "radius of the sphere"}},
          {"depth_m", "patch_area_m2", "cap_volume_m3"},
          range(0.0, 0.04, 40),
          [](const ParameterMap& v, double depth) {
            const SphereContact c = sphere_plane_cut(get(v, "radius"), depth);
            return Row{c.patch_area, c.cap_volume};
          }};
}

Entry sphere_contact_entry() {
  return {"sphere_plane_contact",
          "Surface-integral contact of a sphere with a plane over the depth",
          "F = pi kappa d^2 (R - d); energy pi kappa d^3 (R/3 - d/4)",
          "derived here",
          "0 <= d <= R",
          15,
          {{"radius", "R", "m", 0.041, "radius of the sphere"},
           {"stiffness", "kappa", "N/m3", 1e7, "contact stiffness per area"}},
          {"depth_m", "contact_force_N", "contact_energy_J"},
          range(0.0, 0.02, 20),
          [](const ParameterMap& v, double depth) {
            const SphereForce f = sphere_plane_contact(get(v, "radius"), depth, get(v, "stiffness"));
            return Row{f.force, f.energy};
          }};
}

Entry bounce_entry() {
  return {"penalty_bounce",
          "Mass that bounces off a one-sided spring, over the speed",
          "d_max = v sqrt(m/k); duration pi sqrt(m/k); F_max = v sqrt(m k); dt = 2 sqrt(m/k)",
          "textbook result",
          "no gravity",
          15,
          {{"mass", "m", "kg", 8.4103796398811258, "mass"}, {"stiffness", "k", "N/m", 1e5, "spring"}},
          {"speed_m_s", "maximum_penetration_m", "duration_s", "maximum_force_N", "critical_time_step_s"},
          range(1.0, 10.0, 9),
          [](const ParameterMap& v, double speed) {
            const PenaltyBounce b = penalty_bounce(get(v, "mass"), get(v, "stiffness"), speed);
            return Row{b.maximum_penetration, b.duration, b.maximum_force, b.critical_time_step};
          }};
}

Parameters cylinder_parameters(double pressure) {
  return {{"heat_capacity_ratio", "gamma", "1", 1.4, "ratio of heat capacities"},
          {"area", "S", "m2", 0.05, "area of the piston"},
          {"volume", "V", "m3", 0.06, "gas at equilibrium"},
          {"pressure", "p", "Pa", pressure, "absolute, at equilibrium"}};
}

PerfectGas cylinder_gas(const ParameterMap& v) {
  return {PerfectGas{}.gas_constant, get(v, "heat_capacity_ratio")};
}

Entry gas_piston_entry() {
  Parameters own{{"mass", "M", "kg", 5.0, "mass of the piston"}, {"stiffness", "k", "N/m", 2e4, "spring"}};
  return {"gas_piston",
          "Small oscillation of a piston on a spring and on gas",
          "omega^2 = (k + gamma p S^2/V)/M; isothermal control with gamma = 1",
          "derived here by linearisation",
          "small amplitude",
          15,
          joined({own, cylinder_parameters(1.5e5)}),
          {"angular_frequency_rad_s", "isothermal_angular_frequency_rad_s"},
          {},
          [](const ParameterMap& v, double) {
            const GasPiston piston{cylinder_gas(v),  get(v, "mass"),     get(v, "area"),
                                   get(v, "volume"), get(v, "pressure"), get(v, "stiffness")};
            return Row{gas_piston_frequency(piston), gas_piston_isothermal_frequency(piston)};
          }};
}

Entry pendulum_gas_spring_entry() {
  return {"pendulum_gas_spring",
          "Small oscillation of the pendulum on enclosed gas",
          "omega^2 = (gamma p S^2 L_i^2/V + m g L)/I_O",
          "derived here by linearisation",
          "small amplitude",
          15,
          joined({pendulum_parameters(), cylinder_parameters(101325.0)}),
          {"angular_frequency_rad_s"},
          {},
          [](const ParameterMap& v, double) {
            return Row{pendulum_gas_spring_frequency(
                {cylinder_gas(v), pendulum_of(v), get(v, "area"), get(v, "volume"), get(v, "pressure")})};
          }};
}

Entry sphere_fill_entry() {
  return {"sphere_fill",
          "Elastic sphere filled slowly by gas, over the mass that entered",
          "m_in cp T_in = (p V - p_a V0)/(gamma-1) + U + p_a (V - V0)",
          "derived here from the energy balance",
          "adiabatic, quasi-static; ambient gas inside at the start",
          13,
          joined({gas_parameters(),
                  sheet_parameters(false),
                  {{"radius", "R0", "m", 0.3, "unstretched radius"},
                   ambient_pressure_parameter(),
                   {"inflow_temperature", "T_in", "K", 700.0, "temperature of the inflow"}}}),
          {"inflow_mass_kg", "pressure_Pa", "volume_m3", "stretch", "strain_energy_J", "ambient_work_J"},
          range(0.0, 0.1, 50),
          [](const ParameterMap& v, double mass) {
            const SphereFill scene{gas_of(v),
                                   {sheet_of(v, false), get(v, "radius")},
                                   get(v, "ambient_pressure"),
                                   get(v, "inflow_temperature")};
            const double stretch = sphere_fill_stretch(scene, mass);
            const SphereFillState s = sphere_fill(scene, stretch);
            return Row{s.pressure, s.volume, stretch, s.strain_energy, s.ambient_work};
          }};
}

Entry pressed_balloon_entry() {
  return {"pressed_balloon",
          "Inflated elastic sphere pressed between two rigid spheres, over the patch's angle",
          "F = (p + 2 T/r) pi a^2; StVK equilibrium by shooting",
          "derived here (after Feng and Yang 1973)",
          "frictionless, taut; indenter at least as large as the sphere",
          9,
          joined({sheet_parameters(false),
                  {{"radius", "R0", "m", 0.3, "unstretched radius"},
                   {"overpressure", "p", "Pa", 2e4, "overpressure"},
                   {"indenter_radius", "r", "m", 0.6, "radius of the indenters"}}}),
          {"patch_angle_rad", "contact_force_N", "centre_height_m", "patch_area_m2", "pole_stretch",
           "strain_energy_J", "volume_m3"},
          range(0.05, 0.5, 9),
          [](const ParameterMap& v, double angle) {
            const BalloonPress b = pressed_balloon(
                {{sheet_of(v, false), get(v, "radius")}, get(v, "overpressure"), get(v, "indenter_radius")},
                angle);
            return Row{b.force, b.centre_height, b.patch_area, b.pole_stretch, b.strain_energy, b.volume};
          }};
}

}  // namespace

void add_contact_and_coupled(std::vector<Entry>& list) {
  for (Entry (*entry)() : {sphere_cut_entry, sphere_contact_entry, bounce_entry, gas_piston_entry,
                           pendulum_gas_spring_entry, sphere_fill_entry, pressed_balloon_entry})
    list.push_back(entry());
}

}  // namespace closed_form::entries
