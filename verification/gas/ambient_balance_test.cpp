// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>

#include "cases.hpp"

// Balances on p_a itself, closer to it than any tolerance: nothing may flow the other way.
namespace {

using namespace cases;

/// A tank behind a wide vent that lets air of its own gas in, kept at p_a: p V and so U stay.
struct AtAmbient {
  const char* name;
  double inflow, conductance;  // [kg/s] of 300 K, [W/K]; one is zero
  gas::ControlVolumeModel model() const {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    model.vents.push_back({1.0, 0.1});
    model.vents.back().backflow = true;
    model.ambient.mass_fractions = kPure;
    if (inflow > 0.0) model.inflows.push_back(steady_inflow(model.thermo, inflow, 300.0));
    model.heat_loss = {conductance, 293.15};
    return model;
  }
  /// Time [s] in which the gas goes from `begin` to `end` [K], with cp 1038.8 J/(kg K). What an inflow brings
  /// leaves at T: m' = inflow (1 - m/M), M = m of its temperature. What walls take, air brings:
  /// cp m' = hA (M/m - 1), M = m of theirs.
  double time(double begin, double end) const {
    const double last = inflow > 0.0 ? 300.0 : 293.15;
    const double final = kAmbientPressure * 0.06 / (296.8 * last), m0 = final * last / begin,
                 m1 = final * last / end, decay = std::log((final - m0) / (final - m1));
    return inflow > 0.0 ? final / inflow * decay : (m0 - m1 + final * decay) * 1038.8 / conductance;
  }
  /// What goes the wrong way [kg] in 0.1 s, and the state then.
  gas::ControlVolumeState run(const gas::IntegratorOptions& options, double& wrong) const {
    const gas::ControlVolumeModel m = model();
    gas::GasIntegrator integrator(m, options);
    gas::ControlVolumeState state = gas::make_state(m, kPure, kAmbientPressure, 900.0, 0.06);
    for (int i = 0; i < 100; ++i) {
      const gas::StepFluxes f = integrator.advance(state, 1e-3 * i, 1e-3 * (i + 1), rigid(0.06));
      wrong += inflow > 0.0 ? f.backflow_mass : f.vent_mass_out;
    }
    return state;
  }
};

void PrintTo(const AtAmbient& balance, std::ostream* out) {
  *out << balance.name;
}

class balance_at_ambient : public testing::TestWithParam<AtAmbient> {
 protected:
  /// Nothing goes the wrong way, and T is right to `bound`, relative, and to the pressure drop at the vent,
  /// 6 Pa of p_a, that the formula leaves out.
  void expect_right(const gas::IntegratorOptions& options, double bound) const {
    double wrong = 0.0;
    const double end = GetParam().run(options, wrong).temperature;
    // p may be off by the tolerance, and by a tenth of the laminar range, 1e-9 of p_a.
    EXPECT_LT(std::abs(wrong), 0.06 * kAmbientPressure / (296.8 * 300.0) * (bound + 1e-6));
    const double slope = (GetParam().time(900.0, end * 1.001) - GetParam().time(900.0, end * 0.999)) / 0.002;
    EXPECT_NEAR((GetParam().time(900.0, end) - 0.1) / slope, 0.0, bound + 1e-4);
  }
};

/// The balance is far closer to p_a than any tolerance here, which is of p: no method may take its error for
/// flow the other way.
TEST_P(balance_at_ambient, exchanges_nothing) {
  for (const gas::Method method : kMethods)
    for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6}) {
      SCOPED_TRACE(testing::Message() << static_cast<int>(method) << " at " << tolerance);
      // As p V is held, the error of m is that of p, a sub-step's, and of the heat: some three of a
      // tolerance. Euler's two half sub-steps of h are off by h^2 x''/4 = tolerance x, x = m/M, x' = (1/x -
      // 1)/tau, tau = 0.4 s: over 0.1 s from x = 0.33 they add up to 0.96 sqrt(tolerance). Twice that, for
      // sub-steps that the balance of p keeps shorter.
      const bool first_order = method == gas::Method::euler;
      expect_right({tolerance, 100000, method}, first_order ? 2.0 * std::sqrt(tolerance) : 3.0 * tolerance);
    }
}

/// Fixed steps too long for that balance are an error; short ones exchange nothing.
TEST_P(balance_at_ambient, fixed_steps_exchange_nothing_or_fail) {
  for (const gas::Method method :
       {gas::Method::euler, gas::Method::runge_kutta_4, gas::Method::dormand_prince_5}) {
    double wrong = 0.0;
    for (const double step : {1e-3, 1e-4, 3e-5})
      EXPECT_THROW(GetParam().run({1e-10, 100000, method, step}, wrong), gas::DomainError) << step;
    EXPECT_LT(std::abs(wrong), 1e-5);  // [kg] nor did any before it failed, but next to its limit
    // Euler's error is of the order of the step's share of the walls' tau.
    expect_right({1e-10, 1000000, method, 1e-6}, 1e-6 / 0.05);
  }
}

INSTANTIATE_TEST_SUITE_P(of, balance_at_ambient,
                         testing::Values(AtAmbient{"walls", 0.0, 180.0}, AtAmbient{"inflow", 0.36, 0.0}),
                         [](const auto& one) { return std::string(one.param.name); });

/// Walls cool the gas to the T of what comes in for it, within a thousandth of the run. Past the limit of
/// (G.16) an explicit method would let T swing about theirs by its tolerance, for ever, and gas out and in
/// with it.
TEST(onset_at_ambient, gas_at_rest_behind_strong_walls_exchanges_nothing) {
  const AtAmbient walls{"walls", 0.0, 1e6};  // hA/(m cv) is 1.9e4 to 5.8e4/s
  for (const gas::Method method :
       {gas::Method::runge_kutta_4, gas::Method::dormand_prince_5, gas::Method::rosenbrock_4})
    for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
      double wrong = 0.0;
      const gas::ControlVolumeState state = walls.run({tolerance, 100000, method}, wrong);
      EXPECT_LT(std::abs(wrong), std::min(tolerance, 1e-4) * state.masses[0])
          << static_cast<int>(method) << " at " << tolerance;
      EXPECT_LT(relative(state.temperature, 293.15), 1e-8);
    }
}

/// Flow out of a small tank sets in at p_a while its inflow grows from nothing: at the begin its slope with p
/// has no bound, and a matrix of that slope would hold p there.
TEST(onset_at_ambient, implicit_steps_follow_the_flows) {
  for (const double area : {1.4e-6, 1.4e-5, 1.4e-4}) {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    model.inflows.push_back(
        {kPure, gas::Curve({{0.0, 0.0}, {2e-3, 1.1e-3}}, gas::Outside::held), gas::Curve::constant(406.0)});
    model.vents.push_back({0.6, area});
    model.vents.back().backflow = true;
    model.ambient.mass_fractions = kPure;
    const auto run = [&](const gas::IntegratorOptions& options) {
      gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure, 293.15, 1.5e-4);
      const int steps = gas::GasIntegrator(model, options).advance(state, 0.0, 2e-4, rigid(1.5e-4)).steps;
      return std::pair{gas::evaluate(model, state, 1.5e-4, 0.0, 2e-4).pressure, steps};
    };
    const double pressure = run({1e-12}).first;
    for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
      const auto [found, steps] = run({tolerance, 100000, gas::Method::rosenbrock_4});
      // Each sub-step may be off by the tolerance.
      EXPECT_LT(relative(found, pressure), steps * tolerance) << area << ' ' << tolerance;
    }
  }
}

/// Walls warm gas behind a wide vent, tens of thousands of times stiffer than its sub-steps: the books close.
TEST(onset_at_ambient, books_close_behind_a_wide_vent) {
  gas::ControlVolumeModel model = closed_tank(nasa7({"H2", "CO2", "N2"}));
  model.ambient.mass_fractions = {0.0, 0.0, 1.0};
  model.vents.push_back({0.6, 1.0});
  model.vents.back().backflow = true;
  model.heat_loss = {28.0, 400.0};
  for (const double tolerance : {1e-3, 1e-6, 1e-8}) {
    gas::ControlVolumeState state =
        gas::make_state(model, std::vector{0.5, 0.5, 0.0}, kAmbientPressure, 293.15, 2.3e-4);
    gas::GasIntegrator integrator(model, {tolerance, 100000, gas::Method::rosenbrock_4});
    const double begin = state.masses[0] + state.masses[1];
    double out = 0.0;
    for (int i = 0; i < 50; ++i) {
      const gas::StepFluxes f = integrator.advance(state, 2e-4 * i, 2e-4 * (i + 1), rigid(2.3e-4));
      out += f.vent_mass_out - f.backflow_mass;
    }
    // Some thousand sub-steps of a rounding each.
    EXPECT_LT(std::abs(begin - out - state.masses[0] - state.masses[1] - state.masses[2]), 1e-13 * begin)
        << tolerance;
  }
}

/// Gas that walls cool from just above p_a is below it within one fixed step, whose method lets the flow turn
/// round in a vent that lets nothing in.
TEST(onset_at_ambient, fixed_step_that_turns_the_flow_round_is_refused) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.vents.push_back({0.6, 1e-6});
  model.heat_loss = {50.0, 293.15};
  gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure * (1.0 + 1e-4), 900.0, 1e-3);
  try {
    gas::GasIntegrator(model, {1e-6, 1000, gas::Method::rosenbrock_4, 1e-3})
        .advance(state, 0.0, 1e-3, rigid(1e-3));
    FAIL() << "no error";
  } catch (const gas::DomainError& error) {
    EXPECT_NE(std::string(error.what()).find("the wrong way"), std::string::npos) << error.what();
  }
}

/// Hot helium runs out to p_a through a vent that would let cold nitrogen in, which would lower p further:
/// beyond p_a rest is unstable. What only runs out stays above, to the tolerance.
TEST(rest_at_ambient, hot_light_gas_that_runs_out_draws_nothing_in) {
  gas::ControlVolumeModel model = closed_tank(nasa7({"He", "N2"}));
  model.ambient = {kAmbientPressure, 293.15, {0.0, 1.0}};
  model.vents.push_back({0.8, 1e-4});
  model.vents[0].backflow = true;
  for (const gas::Method method : {gas::Method::dormand_prince_5, gas::Method::rosenbrock_4})
    for (const double tolerance : {1e-3, 1e-4, 1e-6, 1e-8}) {
      gas::ControlVolumeState state = gas::make_state(model, std::vector{1.0, 0.0}, 1.3e5, 1500.0, 1e-3);
      const gas::StepFluxes f =
          gas::GasIntegrator(model, {tolerance, 100000, method}).advance(state, 0.0, 0.05, rigid(1e-3));
      EXPECT_LT(f.backflow_mass, tolerance * state.masses[0])
          << static_cast<int>(method) << " at " << tolerance;
      // Isentropic to p_a; some ten sub-steps of a tolerance.
      const double exact = 1500.0 * std::pow(kAmbientPressure / 1.3e5, 0.4);
      EXPECT_LT(relative(state.temperature, exact), 10.0 * tolerance + 1e-8) << tolerance;
    }
}

/// Ambient gas fills a tank through a vent, past fabric that would let it out again: it comes to p_a from
/// below, and no more than the tolerance leaves.
TEST(rest_at_ambient, inrush_lets_nothing_out) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.ambient.mass_fractions = kPure;
  model.vents.push_back({0.8, 2e-2});
  model.vents[0].backflow = true;
  for (const double tolerance : {1e-3, 1e-4, 1e-6, 1e-8}) {
    gas::ControlVolumeState state = gas::make_state(model, kPure, 5e3, 400.0, 0.05);
    const gas::StepFluxes f =
        gas::GasIntegrator(model, {tolerance}).advance(state, 0.0, 0.5, rigid(0.05, 0.5));
    EXPECT_LT(f.vent_mass_out + f.fabric_mass_out, tolerance * state.masses[0]) << tolerance;
    EXPECT_LT(f.steps, 40 + 4.0 * std::pow(tolerance, -0.2)) << tolerance;
  }
}

}  // namespace
