// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include "cases.hpp"
#include "claim.hpp"
#include "second_route.hpp"

// No inflow is stepped over and none loses mass or energy, however short, late or steep.
namespace {

using namespace cases;

const std::vector<double> kStarts{0.0, 1e-7, 0.1, 1.0 / 3.0, 0.5, 0.7123456789, 0.99999};

gas::Inflow pulse(double start_time) {
  return {kPure, gas::Curve({{0.0, 3.0}, {1e-5, 5.0}}, gas::Outside::zero), gas::Curve::constant(900.0),
          start_time};
}

/// A pulse of 10 microseconds in one step of a second: its mass to the rounding of the tank's mass.
TEST(inflow, short_pulse_anywhere_adds_its_mass) {
  for (const double start : kStarts) {
    for (const double tolerance : {1e-2, 1e-6, 1e-12}) {
      for (const bool open : {false, true}) {
        gas::ControlVolumeModel model = closed_tank(nitrogen());
        model.inflows.push_back(pulse(start));
        if (open) model.vents.push_back({0.6, 1e-4});
        gas::GasIntegrator integrator(model, {tolerance});
        gas::ControlVolumeState state = gas::make_state(model.thermo, kPure, kAmbientPressure, 293.15, 0.06);
        const double before = state.masses[0];
        const gas::StepFluxes fluxes = integrator.advance(state, 0.0, 1.0, rigid(0.06));
        const char* why = "knots a few ulp exact, product of two numbers";
        claim::expect_relative(
            {"G.9", "pulse of 10 microseconds anywhere in a step of a second: mass [kg]", why},
            fluxes.mass_in, 4e-5, 1e-14);
        claim::expect_relative(
            {"G.10", "pulse of 10 microseconds anywhere in a step of a second: enthalpy [J]", why},
            fluxes.enthalpy_in, 4e-5 * 1038.8 * 900.0, 1e-14);
        EXPECT_NEAR(state.masses[0] - before, 4e-5 - fluxes.vent_mass_out, 4.0 * kEpsilon * before);
      }
    }
  }
}

/// The same by every method: error control at any tolerance, fixed sub-steps of which none ends where the
/// pulse begins, closed or blowing down at 5 bar (no limit of stability is near).
TEST(inflow, short_pulse_adds_its_mass_by_every_method_and_step) {
  for (const gas::Method method : kMethods)
    for (const gas::IntegratorOptions& options : {gas::IntegratorOptions{1e-2, 100000, method},
                                                  {1e-6, 100000, method},
                                                  {1e-10, 10000000, method},
                                                  {1e-6, 100000, method, 0.07},
                                                  {1e-6, 100000, method, 1e-3}}) {
      if (method == gas::Method::euler && options.relative_tolerance < 1e-6) continue;  // 1e5 sub-steps
      for (const double start : kStarts)
        for (const double area : {0.0, 1e-4}) {
          SCOPED_TRACE(testing::Message() << static_cast<int>(method) << " at " << options.relative_tolerance
                                          << ", " << options.fixed_step << " s, from " << start);
          gas::ControlVolumeModel model = closed_tank(nitrogen());
          model.inflows.push_back(pulse(start));
          model.vents.push_back({0.6, area});
          gas::ControlVolumeState state = gas::make_state(model.thermo, kPure, 5e5, 293.15, 0.06);
          const double before = state.masses[0];
          const gas::StepFluxes fluxes =
              gas::GasIntegrator(model, options).advance(state, 0.0, 1.0, rigid(0.06));
          claim::expect_relative({"G.9", "the same by each method, at its tolerance or step: mass [kg]",
                                  "knots a few ulp exact, product of two numbers"},
                                 fluxes.mass_in, 4e-5, 1e-14);
          // What is there: a rounding of the whole in each sub-step, and four.
          EXPECT_NEAR(state.masses[0] - before, 4e-5 - fluxes.vent_mass_out,
                      (fluxes.steps + 4.0) * kEpsilon * before);
        }
    }
}

/// GSL's msbdf with the inflow in closed form, too. Stepped as a rate like all others the pulse is lost
/// without a word: what free steps do, and the control of all that is said here.
TEST(inflow, short_pulse_adds_its_mass_by_the_second_route) {
  using second_route::Inflow;
  for (const double start : kStarts)
    for (const double tolerance : {1e-2, 1e-6, 1e-10}) {
      SCOPED_TRACE(testing::Message() << start << " s at " << tolerance);
      second_route::Tank tank{closed_tank(nitrogen()), {}};
      tank.model.inflows.push_back(pulse(start));
      tank.model.ambient.pressure = 0.0;
      tank.start = gas::make_state(tank.model, kPure, 1e4, 293.15, tank.volume);
      tank.stops = {1.1};
      const auto gained = [&](Inflow inflow) {
        return second_route::msbdf(tank, tolerance, inflow).back().masses[0] - tank.start.masses[0];
      };
      // A few roundings of the whole, 170 times the pulse.
      EXPECT_LT(relative(gained(Inflow::closed_form), 4e-5), 1e-12);
      if (start > 1e-3) {
        EXPECT_EQ(gained(Inflow::stepped), 0.0);
      }
      // Open, what left besides is what a run of the library lets out, to the tolerance of either.
      tank.model.vents.push_back({0.6, 1e-4});
      gas::ControlVolumeState state = tank.start;
      const double out =
          gas::GasIntegrator(tank.model, {1e-12}).advance(state, 0.0, 1.1, rigid(tank.volume)).vent_mass_out;
      EXPECT_NEAR(gained(Inflow::closed_form), 4e-5 - out, 100.0 * tolerance * tank.start.masses[0]);
    }
}

TEST(inflow, pulse_is_the_same_in_one_step_or_many) {
  for (const double start : kStarts) {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    model.inflows.push_back(pulse(start));
    gas::GasIntegrator integrator(model);
    gas::ControlVolumeState state = gas::make_state(model.thermo, kPure, kAmbientPressure, 293.15, 0.06);
    double mass = 0.0;
    const int steps = 40000;
    for (int i = 0; i < steps; ++i)
      mass += integrator.advance(state, i * 2.5e-5, (i + 1) * 2.5e-5, rigid(0.06)).mass_in;
    // Where a step cuts the pulse, the cut's time carries eps * t over 1e-5 s of pulse: 1e-11.
    EXPECT_LT(relative(mass, 4e-5), 1e-10) << start;
  }
}

TEST(inflow, before_firing_and_never_fired_add_nothing) {
  for (const double start : {2.0, std::numeric_limits<double>::infinity()}) {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    model.inflows.push_back(pulse(start));
    gas::ControlVolumeState state = gas::make_state(model.thermo, kPure, kAmbientPressure, 293.15, 0.06);
    EXPECT_EQ(gas::GasIntegrator(model).advance(state, 0.0, 1.0, rigid(0.06)).mass_in, 0.0);
    EXPECT_EQ(gas::inflator_point(model, 0, 1.0).mass_flow, 0.0);
  }
}

/// Enthalpy of a falling flow whose temperature rises through 1000 K, cp(T): against Simpson's rule on each
/// side of the joint.
/// A call that ends a rounding past the firing, with a flow out: the new species is there only after it.
TEST(inflow, firing_a_rounding_before_the_end_of_a_call) {
  gas::ControlVolumeModel model = closed_tank(nasa7({"N2", "He"}));
  model.inflows.push_back({{0.0, 1.0},
                           gas::Curve({{0.0, 0.0}, {2e-4, 0.03}, {5e-4, 0.0}}, gas::Outside::zero),
                           gas::Curve({{0.0, 406.0}}, gas::Outside::held),
                           1e-4});
  model.vents.push_back({1.0, 5e-5});
  for (const gas::Method method : kMethods) {
    gas::ControlVolumeState state = gas::make_state(model.thermo, std::vector{1.0, 0.0}, 2e5, 293.15, 1e-3);
    gas::GasIntegrator integrator(model, {1e-6, 100000, method});
    const double past = std::nextafter(1e-4, 1.0);
    integrator.advance(state, 0.0, past, rigid(1e-3));
    EXPECT_GE(state.masses[1], 0.0);
    EXPECT_LE(state.masses[1], 0.5 * 150.0 * std::pow(past - 1e-4, 2));  // what flows in within that rounding
    const gas::StepFluxes fluxes = integrator.advance(state, past, 2e-4, rigid(1e-3));
    // Half the ramp, 0.03 (1e-4)^2/(2 2e-4); its begin is as good as the rounding of 1e-4 s.
    EXPECT_LT(relative(fluxes.mass_in, 7.5e-7), 1e-13);
    EXPECT_LE(state.masses[1], fluxes.mass_in);
  }
}

TEST(inflow, nasa7_enthalpy_of_linear_curves_is_exact) {
  const gas::Thermo thermo = nasa7({"N2", "H2O", "CO2"});
  const std::vector<double> fractions{0.6, 0.15, 0.25};
  gas::ControlVolumeModel model = closed_tank(thermo);
  const gas::Curve flow({{0.0, 2.0}, {0.04, 0.5}}, gas::Outside::zero);
  const gas::Curve temperature({{0.0, 600.0}, {0.03, 1500.0}, {0.05, 1300.0}}, gas::Outside::held);
  model.inflows.push_back({fractions, flow, temperature});
  gas::ControlVolumeState state = gas::make_state(thermo, fractions, 1e5, 300.0, 0.06);
  const double enthalpy = gas::GasIntegrator(model).advance(state, 0.0, 0.1, rigid(0.06)).enthalpy_in;
  double expected = 0.0, magnitude = 0.0;
  const std::vector<double> pieces{0.0, 0.03 * 400.0 / 900.0, 0.03, 0.04};
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    const int n = 400;
    const double h = (pieces[i + 1] - pieces[i]) / n;
    for (int j = 0; j <= n; ++j) {
      const double t = pieces[i] + j * h, weight = h / 3.0 * (j == 0 || j == n ? 1 : j % 2 ? 4 : 2);
      // The joint's jump is 1e-3 J/kg of 1e6: nothing at this tolerance.
      expected += weight * flow.value(t) * thermo.enthalpy(fractions, temperature.value(t));
      magnitude += weight * flow.value(t) * std::abs(thermo.enthalpy(fractions, temperature.value(t)));
    }
  }
  claim::expect_near(
      {"G.2", "NASA-7 inflow across 1000 K on linear curves: enthalpy [J]",
       "Simpson's error with 400 pieces, and the joint's jump: each 1e-11 of the sum of magnitudes"},
      enthalpy, expected, 3e-11 * magnitude);
}

}  // namespace
