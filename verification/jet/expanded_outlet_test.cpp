// SPDX-License-Identifier: Apache-2.0
// The notional nozzle of an outlet above bag pressure, (J.12).
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "claim.hpp"
#include "closed_form/jet.hpp"
#include "jet/outlet.hpp"
#include "rounding.hpp"

namespace {

using support::kEps;
using Law = jet::OutletLaw;
using Temperature = jet::OutletTemperature;
constexpr double kThroat = 5e-3;        // [m2]
constexpr double kBagPressure = 1.3e5;  // [Pa]
constexpr double kRest = 700.0;         // [K]
constexpr jet::OutletModel kExpanded{Law::expanded, Temperature::stagnation, kThroat};
constexpr jet::OutletModel kMatched{Law::pressure_matched, Temperature::stagnation, kThroat};
const closed_form::PerfectGas kGases[] = {{296.8, 1.4}, {2077.0, 5.0 / 3.0}, {188.9, 1.3}, {300.0, 1.02}};

closed_form::ExpandedOutlet outlet_at(const closed_form::PerfectGas& gas, double pressure_ratio) {
  return {gas, kRest, kThroat, kBagPressure, pressure_ratio};
}

jet::OutletInput input(const closed_form::PerfectGas& gas, double mass_flow,
                       double bag_pressure = kBagPressure) {
  return {mass_flow, kRest, closed_form::specific_heat_cp(gas), gas.gas_constant, bag_pressure};
}

void expect_same_bits(const jet::OutletState& a, const jet::OutletState& b) {
  for (const auto member :
       {&jet::OutletState::velocity, &jet::OutletState::density, &jet::OutletState::pressure,
        &jet::OutletState::temperature, &jet::OutletState::area_ratio, &jet::OutletState::reflected})
    EXPECT_EQ(a.*member, b.*member);
}

TEST(expanded_outlet, state_eq_closed_form) {
  const char* why = "balances against ratios, 20 operations each; T is a difference that keeps 1/gamma^2";
  for (const auto& gas : kGases)
    for (const double n : {1.0 + 1e-6, 1.01, 1.5, 2.0, 3.2, 5.0, 20.0, 1e3}) {
      const auto exact = closed_form::expanded_outlet(outlet_at(gas, n));
      const jet::OutletState state = jet::outlet_state(kExpanded, input(gas, exact.mass_flow));
      struct Row {
        const char* what;
        double computed, exact;
      };
      const double sonic =
          closed_form::sonic_outlet({gas, kRest, true, exact.mass_flow, kThroat}).velocity / exact.velocity;
      for (const Row& row :
           {Row{"velocity [m/s]", state.velocity, exact.velocity},
            Row{"density [kg/m3]", state.density, exact.density},
            Row{"temperature [K]", state.temperature, exact.temperature},
            Row{"area over the outlet's [-]", state.area_ratio, exact.area_ratio},
            Row{"thrust mdot V0 + (pe - p) A [N]", jet::momentum_flux(state, kThroat), exact.thrust},
            Row{"velocity in the outlet over its own [-]", state.reflected, sonic}})
        claim::expect_relative(
            {"J.12", std::string("expanded outlet by gas and pressure ratio: ") + row.what, why},
            row.computed, row.exact, 64 * kEps);
      EXPECT_EQ(state.pressure, kBagPressure);
    }
}

TEST(expanded_outlet, at_or_below_bag_pressure_has_the_bits_of_the_matched_one) {
  for (const auto& gas : kGases) {
    const double flow = closed_form::expanded_outlet(outlet_at(gas, 1.0)).mass_flow;
    const auto sonic = jet::outlet_state({Law::sonic, Temperature::stagnation, kThroat}, input(gas, flow));
    for (const double above : {1.0, 1.0 + kEps, 1.001, 2.0, 1e3}) {
      const auto at = input(gas, flow, sonic.pressure * above);
      const auto state = jet::outlet_state(kExpanded, at);
      expect_same_bits(state, jet::outlet_state(kMatched, at));
      EXPECT_EQ(state.area_ratio, 1.0);
      EXPECT_EQ(state.reflected, 1.0);
    }
    expect_same_bits(jet::outlet_state(kExpanded, input(gas, flow, sonic.pressure)), sonic);
  }
}

TEST(expanded_outlet, is_continuous_where_the_expansion_ends) {
  for (const auto& gas : kGases) {
    const double flow = closed_form::expanded_outlet(outlet_at(gas, 1.0)).mass_flow;
    const double p =
        jet::outlet_state({Law::sonic, Temperature::stagnation, kThroat}, input(gas, flow)).pressure;
    const double step = 1e-9;  // relative; the state's slopes with bag pressure are of order one
    const auto matched = jet::outlet_state(kExpanded, input(gas, flow, p));
    for (const double side : {-1.0, 1.0}) {
      const auto state = jet::outlet_state(kExpanded, input(gas, flow, p * (1.0 + side * step)));
      for (const auto member :
           {&jet::OutletState::velocity, &jet::OutletState::density, &jet::OutletState::pressure,
            &jet::OutletState::temperature, &jet::OutletState::area_ratio, &jet::OutletState::reflected})
        EXPECT_NEAR(state.*member / (matched.*member), 1.0, 10 * step) << side;
      EXPECT_EQ(state.velocity > matched.velocity, side < 0.0);
      EXPECT_EQ(state.reflected < 1.0, side < 0.0);
    }
    // The last bit above bag pressure: the balances' differences are rounding.
    const auto next = jet::outlet_state(kExpanded, input(gas, flow, std::nextafter(p, 0.0)));
    EXPECT_NEAR(next.area_ratio, 1.0, 64 * kEps);
    EXPECT_NEAR(next.velocity, matched.velocity, 4 * kEps * matched.velocity);
  }
}

TEST(expanded_outlet, without_flow_is_the_matched_one) {
  const auto none = input(kGases[0], 0.0);
  const auto state = jet::outlet_state(kExpanded, none);
  expect_same_bits(state, jet::outlet_state(kMatched, none));
  EXPECT_EQ(state.velocity, 0.0);
  EXPECT_EQ(jet::momentum_flux(state, kThroat), 0.0);
}

TEST(expanded_outlet, far_above_bag_pressure_keeps_its_limits) {
  for (const auto& gas : kGases)
    for (const double n : {1e3, 1e6, 1e12}) {
      const double flow = closed_form::expanded_outlet(outlet_at(gas, n)).mass_flow;
      const double gamma = gas.heat_capacity_ratio;
      const auto state = jet::outlet_state(kExpanded, input(gas, flow));
      EXPECT_GT(state.temperature, kRest / (gamma * gamma) * (1.0 - 8 * kEps));
      EXPECT_LT(state.temperature, kRest / (gamma * gamma) * (1.0 + 4.0 / n));
      EXPECT_NEAR(1.0 / state.reflected, 1.0 + 1.0 / gamma, 2.0 / n + 8 * kEps);
      EXPECT_GT(state.density, 0.0);
    }
}

TEST(expanded_outlet, refuses_what_is_out_of_range) {
  EXPECT_NO_THROW(jet::validate(kExpanded));
  EXPECT_THROW(jet::validate({Law::expanded, Temperature::static_value, kThroat}), std::invalid_argument);
  for (const int law : {-1, 3})
    EXPECT_THROW(jet::validate({static_cast<Law>(law), Temperature::stagnation, kThroat}),
                 std::invalid_argument);
  EXPECT_THROW(jet::validate({Law::expanded, static_cast<Temperature>(2), kThroat}), std::invalid_argument);
  const double flow = closed_form::expanded_outlet(outlet_at(kGases[0], 2.0)).mass_flow;
  for (double jet::OutletInput::*member :
       {&jet::OutletInput::mass_flow, &jet::OutletInput::temperature, &jet::OutletInput::cp,
        &jet::OutletInput::gas_constant, &jet::OutletInput::bag_pressure})
    for (const double bad : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
      jet::OutletInput wrong = input(kGases[0], flow);
      wrong.*member = bad;
      EXPECT_THROW(jet::outlet_state(kExpanded, wrong), jet::DomainError);
    }
  EXPECT_THROW(jet::outlet_state(kExpanded, input(kGases[0], flow, 0.0)), jet::DomainError);
}

}  // namespace
