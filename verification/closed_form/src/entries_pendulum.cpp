// SPDX-License-Identifier: Apache-2.0
#include "closed_form/pendulum.hpp"
#include "entries.hpp"

namespace closed_form::entries {
namespace {

const char* const kRigid = "rigid-body mechanics, textbook result";

Entry constants_entry() {
  return {"pendulum_constants",
          "Inertia, frequency, effective mass and centre of percussion",
          "I_O = I_cg + m L^2; omega0^2 = m g L/I_O; m_eff = I_O/L_i^2; I_O/(m L)",
          kRigid,
          "all > 0",
          15,
          pendulum_parameters(),
          {"axis_inertia_kg_m2", "angular_frequency_rad_s", "small_swing_period_s",
           "angular_acceleration_per_force_rad_s2_N", "cg_acceleration_per_force_m_s2_N",
           "impactor_acceleration_per_force_m_s2_N", "effective_mass_kg", "centre_of_percussion_m",
           "pivot_impulse_ratio"},
          {},
          [](const ParameterMap& v, double) {
            const PendulumConstants c = pendulum_constants(pendulum_of(v));
            return Row{c.axis_inertia,
                       c.angular_frequency,
                       c.small_swing_period,
                       c.angular_acceleration_per_force,
                       c.cg_acceleration_per_force,
                       c.impactor_acceleration_per_force,
                       c.effective_mass,
                       c.centre_of_percussion,
                       c.pivot_impulse_ratio};
          }};
}

// Plain swings do not depend on the impactor.
Parameters swing_parameters() {
  Parameters list = pendulum_parameters();
  std::erase_if(list, [](const Parameter& p) { return p.name == "impactor_arm"; });
  return list;
}

Pendulum swing_of(const ParameterMap& v) {
  return {get(v, "mass"), get(v, "cg_inertia"), get(v, "cg_arm"), 1.0, get(v, "gravity")};
}

Entry period_entry() {
  return {"pendulum_period",
          "Period of the pendulum over amplitude",
          "T = 4 K(k)/omega0, k = sin(amplitude/2)",
          "textbook result (Landau and Lifshitz, Mechanics)",
          "0 <= amplitude < pi",
          14,
          swing_parameters(),
          {"amplitude_rad", "period_s"},
          range(0.0, 3.0, 60),
          [](const ParameterMap& v, double a) { return Row{pendulum_period(swing_of(v), a)}; }};
}

Entry swing_entry() {
  return {
      "pendulum_swing",
      "Pendulum released at rest",
      "theta = 2 asin(k sn(K - omega0 t)), k = sin(amplitude/2)",
      "textbook result (Jacobi elliptic functions)",
      "|amplitude| < pi",
      13,
      joined({swing_parameters(), {{"amplitude", "theta0", "rad", 1.0471975511965976, "angle of release"}}}),
      {"time_s", "pendulum_angle_rad", "pendulum_angular_velocity_rad_s"},
      range(0.0, 2.5, 250),
      [](const ParameterMap& v, double t) {
        const PendulumState s = pendulum_swing(swing_of(v), get(v, "amplitude"), t);
        return Row{s.angle, s.angular_velocity};
      }};
}

Entry impulse_entry() {
  return {"pendulum_impulse",
          "Hanging pendulum struck at the impactor, over the impulse",
          "omega = J L_i/I_O; cos(theta_max) = 1 - I_O omega^2/(2 m g L); t_max = K(k)/omega0, k = omega/(2 "
          "omega0)",
          kRigid,
          "J > 0, not over the top",
          14,
          pendulum_parameters(),
          {"impulse_N_s", "pendulum_angular_velocity_rad_s", "kinetic_energy_J", "maximum_angle_rad",
           "time_of_maximum_s"},
          range(1.0, 60.0, 59),
          [](const ParameterMap& v, double impulse) {
            const ImpulseResponse r = pendulum_impulse(pendulum_of(v), impulse);
            return Row{r.angular_velocity, r.kinetic_energy, r.maximum_angle, r.time_of_maximum};
          }};
}

Entry constant_force_entry() {
  // The greatest angle of a constant force is static: it does not depend on the inertia.
  Parameters list = pendulum_parameters();
  std::erase_if(list, [](const Parameter& p) { return p.name == "cg_inertia"; });
  return {"pendulum_constant_force",
          "Greatest angle from rest under a constant horizontal force, over the force",
          "theta_max = 2 atan(F L_i/(m g L))",
          "derived here from the energy integral",
          "F >= 0",
          15,
          list,
          {"force_N", "maximum_angle_rad"},
          range(0.0, 500.0, 50),
          [](const ParameterMap& v, double force) {
            const Pendulum pendulum{get(v, "mass"), 0.0, get(v, "cg_arm"), get(v, "impactor_arm"),
                                    get(v, "gravity")};
            return Row{constant_force_maximum_angle(pendulum, force)};
          }};
}

Entry half_sine_entry() {
  return {"pendulum_half_sine",
          "Linearised pendulum under a half-sine force at the impactor",
          "theta'' + omega0^2 theta = (F L_i/I_O) sin(pi t/T) for t <= T; free afterwards",
          "textbook result",
          "small angles: error theta^2/6 relative; omega0 T != pi",
          13,
          joined({pendulum_parameters(),
                  {{"force", "F", "N", 2000.0, "peak force"}, {"duration", "T", "s", 0.02, "duration"}}}),
          {"time_s", "pendulum_angle_rad", "pendulum_angular_velocity_rad_s"},
          range(0.0, 0.1, 100),
          [](const ParameterMap& v, double t) {
            const PendulumState s =
                half_sine_response(pendulum_of(v), get(v, "force"), get(v, "duration"), t);
            return Row{s.angle, s.angular_velocity};
          }};
}

}  // namespace

void add_pendulum(std::vector<Entry>& list) {
  for (Entry (*entry)() :
       {constants_entry, period_entry, swing_entry, impulse_entry, constant_force_entry, half_sine_entry})
    list.push_back(entry());
}

}  // namespace closed_form::entries
