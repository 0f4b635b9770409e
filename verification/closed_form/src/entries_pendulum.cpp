// SPDX-License-Identifier: Apache-2.0
#include "closed_form/coupled.hpp"
#include "closed_form/pendulum.hpp"
#include "entries.hpp"
#include "fields.hpp"

namespace closed_form::entries {
namespace {

const char* const kRigid = "rigid-body mechanics, textbook result";

Columns<PendulumState> motion() {
  return {{"pendulum_angle_rad", &PendulumState::angle},
          {"pendulum_angular_velocity_rad_s", &PendulumState::angular_velocity}};
}

auto sphere_radius() {
  return [](Form<Nothing>& form) { form.number("radius", "R", "m", 0.041, "radius of the sphere"); };
}

auto cylinder(double pressure) {
  return [pressure]<class S>(Form<S>& form) {
    form.fields(heat_capacity_ratio())
        .field(&S::area, "area", "S", "m2", 0.05, "area of the piston")
        .field(&S::volume, "volume", "V", "m3", 0.06, "gas at equilibrium")
        .field(&S::pressure, "pressure", "p", "Pa", pressure, "absolute, at equilibrium");
  };
}

}  // namespace

std::vector<Entry> swings() {
  return {
      Form<Pendulum>("pendulum_constants", "Inertia, frequency, effective mass and centre of percussion",
                     "I_O = I_cg + m L^2; omega0^2 = m g L/I_O; m_eff = I_O/L_i^2; I_O/(m L)", kRigid,
                     "all > 0", 15)
          .fields(pendulum())
          .results(pendulum_constants,
                   {{"axis_inertia_kg_m2", &PendulumConstants::axis_inertia},
                    {"angular_frequency_rad_s", &PendulumConstants::angular_frequency},
                    {"small_swing_period_s", &PendulumConstants::small_swing_period},
                    {"angular_acceleration_per_force_rad_s2_N",
                     &PendulumConstants::angular_acceleration_per_force},
                    {"cg_acceleration_per_force_m_s2_N", &PendulumConstants::cg_acceleration_per_force},
                    {"impactor_acceleration_per_force_m_s2_N",
                     &PendulumConstants::impactor_acceleration_per_force},
                    {"effective_mass_kg", &PendulumConstants::effective_mass},
                    {"centre_of_percussion_m", &PendulumConstants::centre_of_percussion},
                    {"pivot_impulse_ratio", &PendulumConstants::pivot_impulse_ratio}}),
      Form<Pendulum>("pendulum_period", "Period of the pendulum over amplitude",
                     "T = 4 K(k)/omega0, k = sin(amplitude/2)",
                     "textbook result (Landau and Lifshitz, Mechanics)", "0 <= amplitude < pi", 14)
          .fields(pendulum())
          .fixed("impactor_arm", 1.0)
          .over("amplitude_rad", range(0.0, 3.0, 60))
          .result("period_s", pendulum_period),
      Form<Pendulum>("pendulum_swing", "Pendulum released at rest",
                     "theta = 2 asin(k sn(K - omega0 t)), k = sin(amplitude/2)",
                     "textbook result (Jacobi elliptic functions)", "|amplitude| < pi", 12)
          .fields(pendulum())
          .fixed("impactor_arm", 1.0)
          .number("amplitude", "theta0", "rad", 1.0471975511965976, "angle of release")
          .over("time_s", range(0.0, 2.5, 250))
          .results(with(pendulum_swing, itself, "amplitude", abscissa), motion()),
      Form<Pendulum>(
          "pendulum_impulse", "Hanging pendulum struck at the impactor, over the impulse",
          "omega = J L_i/I_O; cos(theta_max) = 1 - I_O omega^2/(2 m g L); t_max = K(k)/omega0, k = omega/(2 "
          "omega0)",
          kRigid, "J > 0, not over the top", 14)
          .fields(pendulum())
          .over("impulse_N_s", range(1.0, 60.0, 59))
          .results(pendulum_impulse, {{"pendulum_angular_velocity_rad_s", &ImpulseResponse::angular_velocity},
                                      {"kinetic_energy_J", &ImpulseResponse::kinetic_energy},
                                      {"maximum_angle_rad", &ImpulseResponse::maximum_angle},
                                      {"time_of_maximum_s", &ImpulseResponse::time_of_maximum}}),
      Form<Pendulum>("pendulum_constant_force",
                     "Greatest angle from rest under a constant horizontal force, over the force",
                     "theta_max = 2 atan(F L_i/(m g L))", "derived here from the energy integral", "F >= 0",
                     15)
          .fields(pendulum())
          .fixed("cg_inertia", 0.0)
          .over("force_N", range(0.0, 500.0, 50))
          .result("maximum_angle_rad", constant_force_maximum_angle),
      Form<Pendulum>("pendulum_half_sine", "Linearised pendulum under a half-sine force at the impactor",
                     "theta'' + omega0^2 theta = (F L_i/I_O) sin(pi t/T) for t <= T; free afterwards",
                     "textbook result", "small angles: error theta^2/6 relative; omega0 T != pi", 13)
          .fields(pendulum())
          .number("force", "F", "N", 2000.0, "peak force")
          .number("duration", "T", "s", 0.02, "duration")
          .over("time_s", range(0.0, 0.1, 100))
          .results(with(half_sine_response, itself, "force", "duration", abscissa), motion())};
}

std::vector<Entry> contact() {
  return {
      Form<Nothing>("sphere_plane_cut", "Cut of a sphere by a plane over the depth",
                    "patch pi (2 R d - d^2); cap pi d^2 (R - d/3)", "textbook result", "0 <= d <= 2 R", 15)
          .fields(sphere_radius())
          .over("depth_m", range(0.0, 0.04, 40))
          .results(
              with(sphere_plane_cut, "radius", abscissa),
              {{"patch_area_m2", &SphereContact::patch_area}, {"cap_volume_m3", &SphereContact::cap_volume}}),
      Form<Nothing>(
          "sphere_plane_contact", "Surface-integral contact of a sphere with a plane over the depth",
          "F = pi kappa d^2 (R - d); energy pi kappa d^3 (R/3 - d/4)", "derived here", "0 <= d <= R", 15)
          .fields(sphere_radius())
          .number("stiffness", "kappa", "N/m3", 1e7, "contact stiffness per area")
          .over("depth_m", range(0.0, 0.02, 20))
          .results(with(sphere_plane_contact, "radius", abscissa, "stiffness"),
                   {{"contact_force_N", &SphereForce::force}, {"contact_energy_J", &SphereForce::energy}}),
      Form<Nothing>("penalty_bounce", "Mass that bounces off a one-sided spring, over the speed",
                    "d_max = v sqrt(m/k); duration pi sqrt(m/k); F_max = v sqrt(m k); dt = 2 sqrt(m/k)",
                    "textbook result", "no gravity", 15)
          .number("mass", "m", "kg", 8.4103796398811258, "mass")
          .number("stiffness", "k", "N/m", 1e5, "spring")
          .over("speed_m_s", range(1.0, 10.0, 9))
          .results(with(penalty_bounce, "mass", "stiffness", abscissa),
                   {{"maximum_penetration_m", &PenaltyBounce::maximum_penetration},
                    {"duration_s", &PenaltyBounce::duration},
                    {"maximum_force_N", &PenaltyBounce::maximum_force},
                    {"critical_time_step_s", &PenaltyBounce::critical_time_step}})};
}

std::vector<Entry> coupled() {
  return {
      Form<GasPiston>("gas_piston", "Small oscillation of a piston on a spring and on gas",
                      "omega^2 = (k + gamma p S^2/V)/M; isothermal control with gamma = 1",
                      "derived here by linearisation", "small amplitude", 15)
          .field(&GasPiston::mass, "mass", "M", "kg", 5.0, "mass of the piston")
          .field(&GasPiston::stiffness, "stiffness", "k", "N/m", 2e4, "spring")
          .fields(cylinder(1.5e5))
          .result("angular_frequency_rad_s", gas_piston_frequency)
          .result("isothermal_angular_frequency_rad_s", gas_piston_isothermal_frequency),
      Form<GasSpring>("gas_spring", "Weight set down on a gas spring at ambient pressure, over its force",
                      "m v^2/2 = F s - int (p - p_a) S ds, p (V - S s)^gamma = p_a V^gamma; T = 2 int ds/v",
                      "derived here from the energy integral", "F > 0", 12)
          .fields(heat_capacity_ratio())
          .field(&GasSpring::mass, "mass", "m", "kg", 20.0, "mass that moves")
          .field(&GasSpring::area, "area", "S", "m2", 0.03, "area of the piston")
          .field(&GasSpring::volume, "volume", "V", "m3", 0.009, "gas at the start")
          .fields(ambient_pressure())
          .over("force_N", range(50.0, 2000.0, 39))
          .results(gas_spring, {{"depth_m", &GasSpringSwing::depth},
                                {"period_s", &GasSpringSwing::period},
                                {"peak_pressure_Pa", &GasSpringSwing::peak_pressure}}),
      Form<PendulumGasSpring>("pendulum_gas_spring", "Small oscillation of the pendulum on enclosed gas",
                              "omega^2 = (gamma p S^2 L_i^2/V + m g L)/I_O", "derived here by linearisation",
                              "small amplitude", 15)
          .fields(pendulum(), cylinder(101325.0))
          .result("angular_frequency_rad_s", pendulum_gas_spring_frequency),
      Form<SphereFill>("sphere_fill", "Elastic sphere filled slowly by gas, over the mass that entered",
                       "m_in cp T_in = (p V - p_a V0)/(gamma-1) + U + p_a (V - V0)",
                       "derived here from the energy balance",
                       "adiabatic, quasi-static; ambient gas inside at the start", 13)
          .fields(gas(), sheet(), radius(0.3), ambient_pressure())
          .field(&SphereFill::inflow_temperature, "inflow_temperature", "T_in", "K", 700.0,
                 "temperature of the inflow")
          .over("inflow_mass_kg", range(0.0, 0.1, 50))
          .results(sphere_fill_by_mass, {{"pressure_Pa", &SphereFillState::pressure},
                                         {"volume_m3", &SphereFillState::volume},
                                         {"stretch", &SphereFillState::stretch},
                                         {"strain_energy_J", &SphereFillState::strain_energy},
                                         {"ambient_work_J", &SphereFillState::ambient_work}}),
      Form<PressedBalloon>(
          "pressed_balloon",
          "Inflated elastic sphere pressed between two rigid spheres, over the patch's angle",
          "F = (p + 2 T/r) pi a^2; StVK equilibrium by shooting", "derived here (after Feng and Yang 1973)",
          "frictionless, taut; indenter at least as large as the sphere", 9)
          .fields(sheet(), radius(0.3))
          .field(&PressedBalloon::overpressure, "overpressure", "p", "Pa", 2e4, "overpressure")
          .field(&PressedBalloon::indenter_radius, "indenter_radius", "r", "m", 0.6,
                 "radius of the indenters")
          .over("patch_angle_rad", range(0.05, 0.5, 9))
          .results(pressed_balloon, {{"contact_force_N", &BalloonPress::force},
                                     {"centre_height_m", &BalloonPress::centre_height},
                                     {"patch_area_m2", &BalloonPress::patch_area},
                                     {"pole_stretch", &BalloonPress::pole_stretch},
                                     {"strain_energy_J", &BalloonPress::strain_energy},
                                     {"volume_m3", &BalloonPress::volume}}),
      Form<PressedCylinder>(
          "pressed_cylinder",
          "Inflated long cylinder pressed flat between two plates, over half their distance",
          "F/L = p w; w = pi (lambda R - r); E h lambda (lambda^2-1)/(2 (1-nu^2)) = p r",
          "derived here (St. Venant-Kirchhoff, plane stress, reference thickness)",
          "frictionless, fixed length; half distance at most the inflated radius", 14)
          .fields(sheet(), radius(0.15))
          .field(&PressedCylinder::overpressure, "overpressure", "p", "Pa", 6000.0, "overpressure")
          .over("half_distance_m", range(0.05, 0.15, 20))
          .results(pressed_cylinder, {{"force_per_length_N_m", &CylinderPress::force_per_length},
                                      {"flat_width_m", &CylinderPress::flat_width},
                                      {"hoop_stretch", &CylinderPress::hoop_stretch},
                                      {"volume_per_length_m2", &CylinderPress::volume_per_length}})};
}

}  // namespace closed_form::entries
