// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "cases.hpp"
#include "claim.hpp"
#include "closed_form/orifice.hpp"

// Tanks that empty through a hole: choked, through the sonic switch, and with each gas's own gamma.
namespace {

using namespace cases;

struct Tank {
  gas::ControlVolumeModel model;
  closed_form::Blowdown exact;
  gas::ControlVolumeState state() const {
    return gas::make_state(model.thermo, kPure, exact.initial_pressure, exact.initial_temperature,
                           exact.volume);
  }
  double pressure(const gas::ControlVolumeState& s, double t) const {
    return gas::evaluate(model, s, exact.volume, 0.0, t).pressure;
  }
};

Tank tank(double gamma = 1.4, double cd = 1.0, double p0 = 5e5, double t0 = 600.0) {
  const double r = 296.8;
  const gas::Thermo thermo({gas::constant_cp_species("gas", r, gamma / (gamma - 1.0) * r)});
  return {{thermo, {kAmbientPressure, 293.15}, {}, {{cd, 1e-3}}},
          {{r, gamma}, 0.06, 1e-3, cd, p0, t0, kAmbientPressure}};
}

TEST(blowdown, reference_values_choked_and_subsonic) {
  const Tank t = tank();
  gas::ControlVolumeState state = t.state();
  gas::GasIntegrator integrator(t.model);
  double time = 0.0;
  for (const auto& [next, pressure] :
       std::vector<std::pair<double, double>>{{0.01, 467550.91915249028},
                                              {0.05, 359732.85620962291},
                                              {0.1, 262672.56745335721},
                                              {0.16, 183337.7831698602},
                                              {0.18, 163432.05950537481},
                                              {0.26614434361175357, 110000.0}}) {
    integrator.advance(state, time, next, rigid(0.06));
    claim::expect_relative({"G.6", "blow-down, choked to subsonic: pressure at six times [Pa]",
                            "some ten sub-steps of local tolerance 1e-10"},
                           t.pressure(state, time = next), pressure, 1e-9);
  }
}

TEST(blowdown, eq_closed_form_for_every_parameter) {
  for (const double gamma : {1.2, 1.4, 5.0 / 3.0}) {
    for (const auto& [cd, p0, t0] :
         std::vector<std::array<double, 3>>{{1.0, 5e5, 600.0}, {0.6, 3e5, 300.0}, {0.8, 1.5e5, 900.0}}) {
      const Tank t = tank(gamma, cd, p0, t0);
      const double end = closed_form::blowdown_times(t.exact).end_time;
      gas::ControlVolumeState state = t.state();
      gas::GasIntegrator integrator(t.model);
      for (int i = 0; i < 4; ++i) {
        integrator.advance(state, 0.2 * i * end, 0.2 * (i + 1) * end, rigid(0.06));
        const closed_form::GasState exact = closed_form::blowdown(t.exact, 0.2 * (i + 1) * end);
        const char* why = "sub-steps of 1e-10, with room for their growth near equalisation";
        claim::expect_relative({"G.6", "blow-down by gamma, Cd, p0, T0: pressure [Pa]", why},
                               t.pressure(state, 0.0), exact.pressure, 1e-9);
        claim::expect_relative({"G.10", "blow-down by gamma, Cd, p0, T0: temperature [K]", why},
                               state.temperature, exact.temperature, 1e-9);
        claim::expect_relative({"G.9", "blow-down by gamma, Cd, p0, T0: mass [kg]", why}, state.masses[0],
                               exact.mass, 1e-9);
      }
    }
  }
}

/// Relative error of p at the end of a choked blow-down in `calls` equal steps.
double choked_error(double tolerance, int calls, double end) {
  const Tank t = tank();
  gas::ControlVolumeState state = t.state();
  gas::GasIntegrator integrator(t.model, {tolerance});
  for (int i = 0; i < calls; ++i)
    integrator.advance(state, end * i / calls, end * (i + 1) / calls, rigid(0.06));
  return relative(t.pressure(state, end), closed_form::blowdown(t.exact, end).pressure);
}

/// With a loose tolerance each call is one sub-step: the order of Dormand and Prince's formula. (Mass,
/// temperature and their rates are all far from zero.)
TEST(blowdown, choked_order_is_five) {
  std::vector<double> errors;
  for (const int calls : {16, 32, 64}) errors.push_back(choked_error(1e-2, calls, 0.15));
  claim::expect_order({"G.10", "choked blow-down by Dormand-Prince: pressure, one sub-step a call",
                       "fifth order; the sixth's term is a share of 8 / calls"},
                      errors, 4.9, 5.25);
}

TEST(blowdown, error_follows_the_tolerance) {
  for (const double tolerance : {1e-5, 1e-7, 1e-9, 1e-11}) {
    // A handful of sub-steps, each below the tolerance, on quantities of which p is a ratio; and not far
    // below it, or work would be wasted: the step is set by the lower-order formula, one power of h apart.
    EXPECT_LT(choked_error(tolerance, 1, 0.05), 5.0 * tolerance);
    EXPECT_GT(choked_error(tolerance, 1, 0.05), 1e-3 * tolerance);
  }
}

/// Across the switch, where the second derivative jumps, the tolerance still holds.
TEST(blowdown, sonic_switch_is_located) {
  const Tank t = tank();
  for (const double tolerance : {1e-6, 1e-8, 1e-10, 1e-12}) {
    gas::ControlVolumeState state = t.state();
    gas::GasIntegrator integrator(t.model, {tolerance});
    const gas::StepFluxes fluxes = integrator.advance(state, 0.0, 0.18, rigid(0.06));
    claim::expect_relative({"G.6", "blow-down across the sonic switch by tolerance: pressure at 0.18 s [Pa]",
                            "70 sub-steps of one tolerance each, partly cancelling"},
                           t.pressure(state, 0.18), 163432.05950537481, 10.0 * tolerance);
    // Without location the sub-steps shrink at the switch: 1e-12 then needs more than a hundred.
    EXPECT_LE(fluxes.steps, 90);
  }
}

/// When the vent unchokes, as close as that is located, and when p comes to p_a: within 1e-7 of it, which dp
/// ~ (t_end - t)^2 is 6e-5 s early.
TEST(blowdown, moments_of_the_flow_eq_closed_form) {
  const Tank t = tank();
  const closed_form::BlowdownTimes exact =
      closed_form::blowdown_times({{}, 0.06, 1e-3, 1.0, 5e5, 600.0, kAmbientPressure});
  gas::ControlVolumeState state = t.state();
  gas::GasIntegrator integrator(t.model);
  const gas::StepMoments choked = integrator.advance(state, 0.0, 0.1, rigid(0.06)).moments;
  EXPECT_TRUE(std::isnan(choked.sonic_switch) && std::isnan(choked.equalisation));
  const gas::StepMoments rest = integrator.advance(state, 0.1, 0.4, rigid(0.06)).moments;
  EXPECT_NEAR(rest.sonic_switch, exact.unchoke_time, 1e-8 * exact.unchoke_time);
  EXPECT_NEAR(rest.equalisation, exact.end_time, 1e-4);
  EXPECT_LT(rest.equalisation, exact.end_time);
}

/// In one step, at any tolerance. At its end p - p_a is as the square of the time left, so that time is
/// uncertain by the root of the tolerance.
TEST(blowdown, moments_follow_the_tolerance) {
  const Tank t = tank();
  const closed_form::BlowdownTimes exact = closed_form::blowdown_times(t.exact);
  for (const double tolerance : {1e-3, 1e-4, 1e-6, 1e-8}) {
    gas::ControlVolumeState state = t.state();
    const auto moments =
        gas::GasIntegrator(t.model, {tolerance}).advance(state, 0.0, 0.5, rigid(0.06)).moments;
    EXPECT_LT(relative(moments.sonic_switch, exact.unchoke_time), std::max(tolerance, 1e-7)) << tolerance;
    EXPECT_LT(relative(moments.equalisation, exact.end_time), 2e-4 + std::sqrt(tolerance)) << tolerance;
  }
}

/// What walls bring to p_a, gas that leaves beside does not.
TEST(blowdown, cooling_through_ambient_pressure_is_no_equalisation) {
  Tank t = tank();
  t.model.vents[0].area = 1e-6;
  t.model.heat_loss = {1e4, 100.0};
  gas::ControlVolumeState state = t.state();
  const auto moments = gas::GasIntegrator(t.model).advance(state, 0.0, 0.1, rigid(0.06)).moments;
  EXPECT_LT(gas::evaluate(t.model, state, 0.06, 0.0, 0.1).pressure, 0.9 * kAmbientPressure);
  EXPECT_TRUE(std::isnan(moments.equalisation));
}

/// A step that ends as close to the switch as it is located, on either side, does not hide it.
TEST(blowdown, switch_beside_the_end_of_a_step_is_found) {
  const Tank t = tank();
  const double exact = closed_form::blowdown_times(t.exact).unchoke_time;
  for (const double beside : {-3e-5, -1e-6, 0.0, 1e-6, 3e-5}) {
    const double end = exact * (1.0 + beside);
    gas::ControlVolumeState state = t.state();
    gas::GasIntegrator integrator(t.model);
    const double first = integrator.advance(state, 0.0, end, rigid(0.06)).moments.sonic_switch;
    const double second = integrator.advance(state, end, 0.2, rigid(0.06)).moments.sonic_switch;
    EXPECT_NE(std::isnan(first), std::isnan(second)) << beside;
    EXPECT_NEAR(std::isnan(first) ? second : first, exact, 1e-4 * exact) << beside;
  }
}

/// Fabric does not choke, whatever the pressure.
TEST(blowdown, fabric_has_no_sonic_switch) {
  Tank t = tank();
  t.model.vents.clear();
  gas::ControlVolumeState state = t.state();
  const auto fluxes = gas::GasIntegrator(t.model).advance(state, 0.0, 1.0, {0.06, 0.06, 1e-3, 1e-3});
  EXPECT_GT(fluxes.fabric_mass_out, 0.1);
  EXPECT_TRUE(std::isnan(fluxes.moments.sonic_switch));
  EXPECT_FALSE(std::isnan(fluxes.moments.equalisation));
}

TEST(blowdown, into_vacuum_stays_choked) {
  Tank t = tank();
  t.model.ambient.pressure = 0.0;
  gas::ControlVolumeState state = t.state();
  gas::GasIntegrator(t.model).advance(state, 0.0, 2.0, rigid(0.06));
  // f = 1 + (gamma - 1) t/(2 tau), p = p0 f^-7.
  const double f = 1.0 + 0.2 * 2.0 / 0.20764591762951125;
  claim::expect_relative({"G.6", "blow-down into vacuum: pressure at 2 s [Pa]",
                          "some 200 sub-steps of 1e-10, relative to what is left"},
                         t.pressure(state, 2.0), 5e5 * std::pow(f, -7.0), 1e-8);
}

/// Filling against a choked vent: steady pressure, and the two decay rates of the linearised system.
TEST(blowdown, fill_with_vent_reaches_its_steady_state) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.vents.push_back({1.0, 1e-3});
  model.inflows.push_back(steady_inflow(model.thermo, 0.5, 700.0));
  gas::ControlVolumeState state = gas::make_state(model.thermo, kPure, 332836.30571198209, 690.0, 0.06);
  gas::GasIntegrator integrator(model, {1e-12});
  integrator.advance(state, 0.0, 8.0, rigid(0.06));
  const char* why = "the slow mode, 3.96/s, has decayed by 1e-14: some tolerances are left";
  claim::expect_relative({"G.9", "inflow against a choked vent: steady pressure [Pa]", why},
                         gas::evaluate(model, state, 0.06, 0.0, 8.0).pressure, 332836.30571198209, 5e-12);
  claim::expect_relative({"G.10", "inflow against a choked vent: steady temperature [K]", why},
                         state.temperature, 700.0, 5e-12);
}

/// Disturbed along an eigenvector of (m, U), it comes back at that eigenvalue: log-fit over one e-fold.
TEST(blowdown, fill_with_vent_decays_at_its_two_rates) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.vents.push_back({1.0, 1e-3});
  model.inflows.push_back(steady_inflow(model.thermo, 0.5, 700.0));
  const gas::ControlVolumeState steady =
      gas::make_state(model.thermo, kPure, 332836.30571198209, 700.0, 0.06);
  const double per_mass = 0.5 / steady.masses[0];
  for (const double eigenvalue : {-0.7614835192865496, -1.8385164807134504}) {
    gas::ControlVolumeState state = steady;
    // mdot ~ sqrt(m U), so that d(dm/m)/dt = -(mdot/m) (dm/m + dU/U)/2.
    state.masses[0] *= 1.0 + 1e-5;
    state.internal_energy *= 1.0 - 1e-5 * (1.0 + 2.0 * eigenvalue);
    const double time = 1.0 / (per_mass * -eigenvalue);
    gas::GasIntegrator(model, {1e-13}).advance(state, 0.0, time, rigid(0.06));
    const double decay = std::log((state.masses[0] / steady.masses[0] - 1.0) / 1e-5) / (time * per_mass);
    claim::expect_relative({"G.14", "inflow against a choked vent: the two decay rates, per mdot/m [-]",
                            "quadratic terms are 1e-5 of the linear ones; a few of them"},
                           decay, eigenvalue, 1e-4);
  }
}

/// Walls so strong that the gas keeps their temperature: off from the isothermal closed forms by what the
/// heat needs to pass, first order in 1/(hA).
TEST(blowdown, strong_walls_make_it_isothermal) {
  const auto error = [](double conductance, double leak_area, double p0, double t0, double volume,
                        double exact) {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    if (leak_area == 0.0) model.vents.push_back({1.0, 1e-3});
    model.heat_loss = {conductance, t0};
    gas::ControlVolumeState state = gas::make_state(model, kPure, p0, t0, volume);
    const double time = leak_area == 0.0 ? 0.05 : 0.01;
    gas::GasIntegrator(model, {1e-10, 100000, gas::Method::rosenbrock_4})
        .advance(state, 0.0, time, rigid(volume, leak_area));
    return std::abs(gas::evaluate(model, state, volume, leak_area, time).pressure / exact - 1.0);
  };
  const auto hole = [&](double conductance) {
    return error(conductance, 0.0, 5e5, 600.0, 0.06, 393001.55708981881);
  };
  const auto fabric = [&](double conductance) {
    return error(conductance, 0.0025 * 1.5, 130000.0, 400.0, 0.12, 121588.46551630102);
  };
  const auto converges = [](const char* what, const auto& one) {
    const std::vector<double> errors{one(1e6), one(2e6), one(4e6), one(8e6)};
    claim::expect_order({"G.11", what, "the next order in 1/(hA) is a thousandth"}, errors, 0.95, 1.05);
    EXPECT_LT(errors.back(), 1e-4);
  };
  converges("blow-down, choked, with ever stronger walls against the isothermal one: pressure", hole);
  converges("leak through fabric with ever stronger walls against the isothermal one: pressure", fabric);
}

}  // namespace
