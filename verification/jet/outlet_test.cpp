// SPDX-License-Identifier: Apache-2.0
// Gas state in the outlet, (J.1) and (J.2).
#include "jet/outlet.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "claim.hpp"
#include "closed_form/jet.hpp"
#include "rounding.hpp"

namespace {

using support::kEps;
constexpr double kNitrogen = 296.8;              // [J/(kg K)]
constexpr double kNitrogenCp = 3.5 * kNitrogen;  // [J/(kg K)] gamma = 7/5
constexpr double kArea = 5e-3;                   // [m2]

struct Case {
  double mass_flow, temperature;
};
constexpr Case kCases[] = {{2.0, 406.0}, {0.1, 673.0}, {4.0, 1200.0}, {1e-6, 300.0}};

jet::OutletInput input(const Case& c, double bag_pressure = 101325.0) {
  return {c.mass_flow, c.temperature, kNitrogenCp, kNitrogen, bag_pressure};
}

closed_form::OutletState exact(const Case& c, bool stagnation) {
  closed_form::SonicOutlet outlet;
  outlet.gas.heat_capacity_ratio = 1.4;
  outlet.gas.gas_constant = kNitrogen;
  outlet.temperature = c.temperature;
  outlet.stagnation = stagnation;
  outlet.mass_flow = c.mass_flow;
  outlet.area = kArea;
  return closed_form::sonic_outlet(outlet);
}

constexpr double kFormula = 16 * kEps;

void expect_sonic_state(const Case& c, jet::OutletTemperature meaning) {
  const jet::OutletModel model{jet::OutletLaw::sonic, meaning, kArea};
  const jet::OutletState state = jet::outlet_state(model, input(c));
  const closed_form::OutletState reference = exact(c, meaning == jet::OutletTemperature::stagnation);
  const char* why = "ten operations and a square root in each of two routes: 16 eps";
  claim::expect_relative({"J.1", "sonic outlet by flow and temperature: velocity [m/s]", why}, state.velocity,
                         reference.velocity, kFormula);
  claim::expect_relative({"J.2", "sonic outlet by flow and temperature: density [kg/m3]", why}, state.density,
                         reference.density, kFormula);
  claim::expect_relative({"J.1", "sonic outlet by flow and temperature: static pressure [Pa]", why},
                         state.pressure, reference.static_pressure, kFormula);
}

TEST(outlet, sonic_state_eq_closed_form) {
  for (const Case& c : kCases) {
    expect_sonic_state(c, jet::OutletTemperature::static_value);
    expect_sonic_state(c, jet::OutletTemperature::stagnation);
  }
}

TEST(outlet, momentum_flux_eq_mass_flow_times_velocity) {
  for (const Case& c : kCases) {
    for (const double bag_pressure : {5e4, 1e5, 3e5}) {
      const jet::OutletModel model{jet::OutletLaw::pressure_matched, jet::OutletTemperature::stagnation,
                                   kArea};
      const jet::OutletState state = jet::outlet_state(model, input(c, bag_pressure));
      const double expected = c.mass_flow * state.velocity;
      claim::expect_relative({"J.2", "outlet, sonic or pressure-matched: momentum flux, mdot V [N]",
                              "the subsonic root is well conditioned: a few roundings in V, T, rho"},
                             jet::momentum_flux(state, kArea), expected, 64 * kEps);
    }
  }
}

TEST(outlet, subsonic_state_conserves_energy_at_bag_pressure) {
  const jet::OutletModel model{jet::OutletLaw::pressure_matched, jet::OutletTemperature::stagnation, kArea};
  int subsonic = 0;
  for (const Case& c : kCases) {
    const jet::OutletState state = jet::outlet_state(model, input(c, 3e5));
    const double sound = std::sqrt(1.4 * kNitrogen * state.temperature);
    const double total = state.temperature + state.velocity * state.velocity / (2.0 * kNitrogenCp);
    claim::expect_relative(
        {"J.1", "pressure-matched outlet: total temperature [K]", "16 eps, as the sonic outlet"}, total,
        c.temperature, kFormula);
    EXPECT_LE(state.velocity, sound * (1.0 + kFormula));
    const bool choked = state.velocity > 0.99 * sound;
    EXPECT_NEAR(state.pressure, choked ? exact(c, true).static_pressure : 3e5, kFormula * state.pressure);
    subsonic += !choked;
  }
  EXPECT_GE(subsonic, 3);
}

TEST(outlet, pressure_matched_state_is_continuous_where_choking_ends) {
  const jet::OutletModel model{jet::OutletLaw::pressure_matched, jet::OutletTemperature::stagnation, kArea};
  const Case c{2.0, 406.0};
  const double p = exact(c, true).static_pressure;
  const double step = 1e-9;  // relative; the state's slopes with bag pressure are of order one
  const jet::OutletState choked = jet::outlet_state(model, input(c, p * (1.0 - step)));
  const jet::OutletState free = jet::outlet_state(model, input(c, p * (1.0 + step)));
  EXPECT_NEAR(free.velocity / choked.velocity, 1.0, 10 * step);
  EXPECT_NEAR(free.density / choked.density, 1.0, 10 * step);
  EXPECT_LT(free.velocity, choked.velocity);
}

TEST(outlet, no_mass_flow_gives_no_momentum) {
  const Case none{0.0, 406.0};
  for (const auto law : {jet::OutletLaw::sonic, jet::OutletLaw::pressure_matched}) {
    const jet::OutletState state =
        jet::outlet_state({law, jet::OutletTemperature::stagnation, kArea}, input(none));
    EXPECT_EQ(jet::momentum_flux(state, kArea), 0.0);
    EXPECT_TRUE(std::isfinite(state.velocity));
  }
}

TEST(outlet, refuses_what_is_out_of_range) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using Law = jet::OutletLaw;
  using Temperature = jet::OutletTemperature;
  for (const double area : {0.0, -1.0, nan}) {
    EXPECT_THROW(jet::validate({Law::sonic, Temperature::static_value, area}), std::invalid_argument);
  }
  EXPECT_THROW(jet::validate({Law::pressure_matched, Temperature::static_value, 1.0}), std::invalid_argument);
  const jet::OutletModel model{Law::pressure_matched, Temperature::stagnation, kArea};
  const jet::OutletInput good = input(kCases[0]);
  for (double jet::OutletInput::*member :
       {&jet::OutletInput::mass_flow, &jet::OutletInput::temperature, &jet::OutletInput::cp,
        &jet::OutletInput::gas_constant, &jet::OutletInput::bag_pressure}) {
    for (const double bad : {-1.0, nan}) {
      jet::OutletInput wrong = good;
      wrong.*member = bad;
      EXPECT_THROW(jet::outlet_state(model, wrong), jet::DomainError);
    }
  }
}

}  // namespace
