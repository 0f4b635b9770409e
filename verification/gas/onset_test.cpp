// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "cases.hpp"
#include "claim.hpp"
#include "real_axis_limit.hpp"

// Flow that sets in at p_a, as the root of time if its feed starts at a value and as time itself if that
// grows from nothing, by fixed sub-steps.
namespace {

using namespace cases;

constexpr double kRunEnd = 0.01;  // [s]

/// 60 l of nitrogen at p_a behind a vent, fed with 5 g in all; ambient gas may come in.
struct Onset {
  double area;  // [m2] effective
  bool grows;   // the feed, from nothing
  double laminar_share = 1e-8;
  gas::ControlVolumeModel model() const {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    model.vents.push_back({1.0, area});
    model.inflows.push_back(steady_inflow(model.thermo, 0.5, 406.0));
    model.laminar_share = laminar_share;
    if (grows) model.inflows[0].mass_flow = gas::Curve({{0.0, 0.0}, {kRunEnd, 1.0}}, gas::Outside::held);
    return model;
  }
  /// Mass [kg] that leaves.
  double outflow(const gas::IntegratorOptions& options) const {
    const gas::ControlVolumeModel m = model();
    gas::ControlVolumeState state = gas::make_state(m, kPure, kAmbientPressure, 293.15, 0.06);
    return gas::GasIntegrator(m, options).advance(state, 0.0, kRunEnd, rigid(0.06)).vent_mass_out;
  }
};

struct OnsetOrder {
  gas::Method method;
  const char* name;
  double order, band;
  std::vector<int> steps;
};

/// 12 l at p_a that are filled within 40 us, behind a hole and a vent whose area has its first knot at p_a. A
/// sub-step that lands there is a nanosecond long: the next may not be as long as the one before it was to
/// be.
TEST(onset, steep_pulse_at_a_knot_is_right_at_any_tolerance) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.inflows.push_back(steady_inflow(model.thermo, 0.0, 600.0));
  model.inflows[0].mass_flow = gas::Curve({{0.0, 0.0}, {4e-5, 100.0}, {1e-4, 0.0}}, gas::Outside::zero);
  model.vents.push_back({0.5, 0.06});
  model.vents[0].area_of_overpressure =
      gas::Curve({{0.0, 0.0}, {8e4, 0.06}, {2e5, 0.12}}, gas::Outside::held);
  model.vents.push_back({0.5, 0.45});
  const auto mass = [&](double tolerance) {
    gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure, 420.0, 0.012);
    gas::GasIntegrator(model, {tolerance}).advance(state, 0.0, 4e-5, rigid(0.012));
    return state.masses[0];
  };
  const double exact = mass(1e-12);
  for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-8})
    EXPECT_LT(relative(mass(tolerance), exact), 10.0 * tolerance) << tolerance;
}

/// The first sub-step is one from 0 in x = sqrt(t), where what leaves is a series from x^3 on. A Runge-Kutta
/// method of order q misses its term q + 1, h^((q+1)/2); the matrix of the implicit one, zero there, all of
/// it, h^1.5.
TEST(onset, fixed_steps_have_the_order_of_the_root) {
  for (const auto& [method, name, order, band, steps] :
       {OnsetOrder{gas::Method::euler, "Euler", 1.0, 0.05, {64, 128, 256, 512}},
        OnsetOrder{gas::Method::runge_kutta_4, "Runge-Kutta 4", 2.5, 0.05, {32, 64, 128, 256}},
        OnsetOrder{gas::Method::dormand_prince_5, "Dormand-Prince 5", 3.0, 0.15, {8, 16, 32, 64}},
        OnsetOrder{gas::Method::rosenbrock_4, "Rosenbrock 4", 1.5, 0.1, {512, 1024, 2048}}}) {
    const Onset onset{6e-4, false, 0.0};  // they pass a laminar range in their first sub-step
    const double exact = onset.outflow({1e-13});
    std::vector<double> errors;
    for (const int n : steps)
      errors.push_back(onset.outflow({1e-10, 100000, method, kRunEnd / n}) / exact - 1.0);
    claim::expect_order({"G.9", std::string(name) + ", flow that sets in at p_a: what has left",
                         "the next term, sqrt(1/steps) of the leading one"},
                        errors, order - band, order + band);
  }
}

/// An opening whose area grows from nothing with the overpressure, and a feed that grows from nothing later.
TEST(onset, area_that_grows_from_nothing_is_stepped_by_every_method) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.vents.push_back({0.6, 0.0, {}, gas::Curve({{0.0, 0.0}, {14000.0, 1e-3}}, gas::Outside::held)});
  model.inflows.push_back({kPure, gas::Curve({{0.0, 0.0}, {kRunEnd, 1.0}}, gas::Outside::zero),
                           gas::Curve::constant(406.0), 0.00615});
  const auto outflow = [&](const gas::IntegratorOptions& options) {
    gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure, 293.15, 0.06);
    return gas::GasIntegrator(model, options).advance(state, 0.0, 0.02, rigid(0.06)).vent_mass_out;
  };
  const double exact = outflow({1e-12});
  for (const gas::Method method : kMethods) {
    // 139 sub-steps and those of the onset. What leaves is a series in t from its fourth power on: order 4,
    // and of Euler, which is late by half a sub-step, 2/139.
    const double bound = method == gas::Method::euler ? 2.0 / 139.0 : std::pow(139.0, -4.0);
    EXPECT_LT(relative(outflow({1e-10, 100000, method, 1e-4}), exact), bound) << static_cast<int>(method);
  }
}

/// Cold carbon dioxide comes in where hot hydrogen is a millionth short of p_a, cools it, and so draws in
/// more, until an inflow drives both out: at tolerances that do not tell the first millionth nothing is right
/// but the books.
TEST(onset, books_close_at_tolerances_that_miss_it) {
  gas::ControlVolumeModel model = closed_tank(nasa7({"H2", "CO2", "N2"}));
  model.ambient.mass_fractions = {0.0, 1.0, 0.0};
  for (int i = 0; i < 2; ++i) {
    model.vents.push_back({1.0, 1.2492266940693954e-10});
    model.vents.back().backflow = true;
  }
  model.inflows.push_back(
      {{0.0, 0.0, 1.0},
       gas::Curve({{0.0, 0.0}, {0.010000000000000002, 2.121841451939262e-09}, {0.025, 0.0}},
                  gas::Outside::zero),
       gas::Curve::constant(1200.0)});
  for (const gas::Method method : kMethods)
    for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
      gas::ControlVolumeState state =
          gas::make_state(model, std::vector{1.0, 0.0, 0.0}, 101324.898675, 1500.0, 1.2753625081983947e-09);
      gas::GasIntegrator integrator(model, {tolerance, 100000, method});
      double came = state.masses[0], left = 0.0;
      for (int i = 0; i < 20; ++i) {
        const gas::StepFluxes f =
            integrator.advance(state, 2.5e-3 * i, 2.5e-3 * (i + 1), rigid(1.2753625081983947e-09));
        came += f.mass_in + f.backflow_mass;
        left += f.vent_mass_out;
      }
      // Some hundred sub-steps of a rounding each.
      EXPECT_LT(std::abs(came - left - state.masses[0] - state.masses[1] - state.masses[2]), 1e-13 * came)
          << static_cast<int>(method) << " at " << tolerance;
    }
}

/// The same after a blow-down through it, which comes to p_a as the inverse square of time: within rounding
/// of p_a, the opening still opens.
TEST(onset, area_that_ended_a_blow_down_opens_again) {
  constexpr double kVolume = 5e-6, kTemperature = 514.0, kPressure = 2.5e5;
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.ambient = {kAmbientPressure, 293.15, kPure};
  model.vents.push_back({0.15, 0.0, {}, gas::Curve({{0.0, 0.0}, {5700.0, 7e-5}}, gas::Outside::held), true});
  model.inflows.push_back({kPure, gas::Curve({{0.0, 0.0}, {0.011, 2.8e-4}}, gas::Outside::zero),
                           gas::Curve::constant(900.0), 0.75});
  const auto fill = [&](double pressure, double temperature, double begin,
                        const gas::IntegratorOptions& options) {
    gas::ControlVolumeState state = gas::make_state(model, kPure, pressure, temperature, kVolume);
    gas::GasIntegrator(model, options).advance(state, begin, 0.761, rigid(kVolume));
    return gas::evaluate(model, state, kVolume, 0.0, 0.761).pressure;
  };
  // Isentropic from the begin to p_a; from there 1e-8 of p_a, the rest of the blow-down, aside.
  const double exact =
      fill(kAmbientPressure, kTemperature * std::pow(kAmbientPressure / kPressure, 0.4 / 1.4), 0.75, {1e-12});
  for (const gas::Method method : {gas::Method::dormand_prince_5, gas::Method::rosenbrock_4})
    for (const double tolerance : {1e-3, 1e-4, 1e-6, 1e-8})
      EXPECT_LT(relative(fill(kPressure, kTemperature, 0.0, {tolerance, 100000, method}), exact),
                10.0 * tolerance + 1e-8)  // some ten sub-steps, and the rest
          << static_cast<int>(method) << ' ' << tolerance;
}

}  // namespace
