// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>

#include "claim.hpp"
#include "tank_test_cases.hpp"

// Round trips of the inverse tank test without noise: closed form -> readings -> identified curves.
namespace {

using namespace cases;
using closed_form::PerfectGas;

constexpr gas::IdentifyOptions kFewDraws{.draws = 40};  // bands are not what is tested here
const PerfectGas kAir{287.0, 1.4};

constexpr double kAverage = 1e-6;
const char* const kWhy = "slope of the spline through 2000 readings: 1e-7 of the largest";

TEST(identify, average_temperature_recovers_product_and_mean_and_states_its_bias) {
  const Truth truth = one_gas_truth(2e-4);
  const Record record(truth, 0.05, 2001);
  const gas::Identified found = gas::identify(one_gas_test(), record.average(), kFewDraws);
  claim::expect_relative({"G.35", "tank test by mean temperature: mean temperature [K]", kWhy},
                         found.mean_temperature, 600.0, kAverage);
  EXPECT_EQ(found.effective_area, 0.0);
  for (const auto& point : found.points) {
    const auto exact = truth(point.time);
    // Peak product 1920 kg K/s.
    claim::expect_near({"G.34", "tank test by mean temperature: product mdot T [kg K/s]", kWhy},
                       point.mass_flow * point.temperature, exact.mass_flow * exact.temperature,
                       kAverage * 1920.0);
    EXPECT_EQ(point.temperature, found.mean_temperature);
    if (!point.masked) {
      EXPECT_LT(relative(point.mass_flow / exact.mass_flow, exact.temperature / 600.0), 20.0 * kAverage);
    }
  }
  // A quarter through the burn 1.6 kg/s of 700 K show as 1.8667 kg/s: bias T/T_mean.
  claim::expect_relative(
      {"G.35", "tank test by mean temperature: its bias at a quarter of the burn [kg/s]", kWhy},
      found.points[125].mass_flow, 1.8666666666666667, kAverage);
}

/// Helium into air: the tank's own gas counts. Taking the tank to hold helium too is the control.
TEST(identify, average_temperature_with_the_tanks_own_air) {
  const PerfectGas helium{2077.1, 5.0 / 3.0};
  auto sent = pulse(2e-4);
  sent.total_mass = 0.02;
  const Truth truth = [&](double t) { return closed_form::tank_test_pulse(kAir, helium, sent, t); };
  const Record record(truth, 0.05, 2001);
  const gas::Thermo thermo(
      {gas::constant_cp_species("air", 287.0, 1004.5), gas::constant_cp_species("He", 2077.1, 2.5 * 2077.1)});
  gas::TankTest test{thermo, 0.06, 293.15, {1.0, 0.0}, {0.0, 1.0}, 0.02};
  const gas::Identified found = gas::identify(test, record.average(), kFewDraws);
  claim::expect_relative({"G.33", "tank test of helium into air: mean temperature [K]", kWhy},
                         found.mean_temperature, 600.0, kAverage);
  test.tank_fractions = {0.0, 1.0};
  const double without = gas::identify(test, record.average(), kFewDraws).mean_temperature;
  EXPECT_GT(relative(without, 600.0), 0.01) << without;
}

struct Outlet {
  const char* name;
  double area;       // [m2]
  double threshold;  // of |K|
};
void PrintTo(const Outlet& outlet, std::ostream* out) {
  *out << outlet.name;
}

class identify_dual : public testing::TestWithParam<Outlet> {};

/// Largest errors where the analysis does not mask, as claims with `scene` in their words.
void expect_recovered(const std::string& scene, const Errors& error, double effective_area, double area) {
  // Theory, below (G.37).
  const char* why = "held temperature of masked points in Cd A; spline at the corner of p_c";
  claim::expect_near({"G.36", scene + ": largest relative error of mass flow", why}, error.mass_flow, 0.0,
                     1e-4);
  claim::expect_near({"G.36", scene + ": largest relative error of temperature", why}, error.temperature, 0.0,
                     1e-4);
  claim::expect_relative({"G.36", scene + ": effective area [m2]", why}, effective_area, area, 1e-4);
}

TEST_P(identify_dual, recovers_both_curves) {
  const auto [name, area, threshold] = GetParam();
  const Truth truth = one_gas_truth(area);
  const Record record(truth, 0.05, 2001);
  const gas::Identified found =
      gas::identify(one_gas_test(), record.dual(), {.threshold = threshold, .draws = 40});
  const Errors error = errors(found, truth);
  expect_recovered("dual-pressure tank test, outlet choked or not", error, found.effective_area, area);
  EXPECT_GT(error.points, 400);
  for (const auto& point : found.points)
    EXPECT_EQ(point.masked, std::abs(point.enthalpy_flow) < found.threshold) << point.time;
}

INSTANTIATE_TEST_SUITE_P(outlets, identify_dual,
                         testing::Values(Outlet{"choked", 1e-4, 0.05},
                                         Outlet{"choked_then_subsonic", 1e-3, 0.02},
                                         Outlet{"subsonic", 4e-3, 0.02}),
                         [](const auto& one) { return std::string(one.param.name); });

/// With the choked formula throughout, a subsonic outlet is misread.
TEST(identify, subsonic_outlet_is_not_choked) {
  const auto reading = one_gas_truth(4e-3)(0.042);
  const double rate =
      closed_form::pulse_flow({{}, 0.06, 101325.0, 293.15, 0.08, 0.05, 800.0, 400.0}, 0.042).pressure_rate;
  const auto choked = closed_form::dual_pressure({{}, 0.06, 4e-3, reading.chamber_pressure, rate});
  EXPECT_GT(relative(choked.temperature, reading.temperature), 0.05);
}

/// cp(T), air in the tank, a mixture that comes in across 1000 K; the readings by an oracle of its own.
TEST(identify, nasa7_gas_into_air_recovers_both_curves) {
  const gas::TankTest test = nasa7_test();
  const Truth truth = nasa7_truth(test);
  const closed_form::TankTestPulse sent = nasa7_pulse();
  const Record record(truth, 0.05, 2001);
  const gas::Identified found = gas::identify(test, record.dual(), {.threshold = 0.05, .draws = 40});
  const Errors error = errors(found, truth);
  expect_recovered("dual-pressure tank test, cp(T), mixture into air", error, found.effective_area, 1e-4);
  // The mean is that of the enthalpy, 950 K but for the curvature of h(T).
  EXPECT_NEAR(found.mean_temperature, 950.0, 5.0);
  const auto gas = shares(test.thermo, test.inflator_fractions);
  double enthalpy = 0.0;
  constexpr int steps = 2000;  // trapezoidal rule of a periodic pulse: far below 1e-6
  for (int i = 0; i < steps; ++i) {
    const double t = sent.duration * i / steps;
    const auto flow = closed_form::pulse_flow({{}, 0.06, 101325.0, 293.15, 0.05, 0.05, 1200.0, 700.0}, t);
    enthalpy += flow.mass_flow * closed_form::nasa7_enthalpy(gas, flow.temperature) * sent.duration / steps;
  }
  EXPECT_LT(relative(closed_form::nasa7_enthalpy(gas, found.mean_temperature), enthalpy / sent.total_mass),
            kAverage);
}

/// libgas's own forward model as the source: a curve of 2000 pieces, second order in them (4e-7 of p).
TEST(identify, forward_model_and_analysis_are_inverse) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  std::vector<gas::Curve::Knot> flow, temperature;
  const Truth truth = one_gas_truth(2e-4);
  for (int i = 0; i <= 2000; ++i) {
    const double t = 0.05 * i / 2000.0;
    flow.push_back({t, truth(t).mass_flow});
    temperature.push_back({t, truth(t).temperature});
  }
  model.inflows.push_back(
      {kPure, gas::Curve(flow, gas::Outside::zero), gas::Curve(temperature, gas::Outside::held)});
  gas::GasIntegrator integrator(model);
  gas::ControlVolumeState state = gas::make_state(model.thermo, kPure, 101325.0, 293.15, 0.06);
  Record record(truth, 0.05, 1001);
  for (std::size_t i = 1; i < record.times.size(); ++i) {
    integrator.advance(state, record.times[i - 1], record.times[i], rigid(0.06));
    record.tank[i] = gas::evaluate(model, state, 0.06, 0.0, record.times[i]).pressure;
  }
  const gas::Identified found = gas::identify(one_gas_test(), record.average(), kFewDraws);
  EXPECT_LT(relative(found.mean_temperature, 600.0), 1e-5);
  for (const auto& point : found.points) {
    const auto exact = truth(point.time);
    EXPECT_NEAR(point.mass_flow * point.temperature, exact.mass_flow * exact.temperature, 1e-5 * 1920.0);
  }
}

}  // namespace
