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
    EXPECT_EQ(wrong, 0.0);
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
      const bool first_order = method == gas::Method::kEuler;
      expect_right({tolerance, 100000, method}, first_order ? 2.0 * std::sqrt(tolerance) : 3.0 * tolerance);
    }
}

/// Fixed steps too long for that balance are an error; short ones exchange nothing.
TEST_P(balance_at_ambient, fixed_steps_exchange_nothing_or_fail) {
  for (const gas::Method method :
       {gas::Method::kEuler, gas::Method::kRungeKutta4, gas::Method::kDormandPrince5}) {
    double wrong = 0.0;
    for (const double step : {1e-3, 1e-4, 3e-5})
      EXPECT_THROW(GetParam().run({1e-10, 100000, method, step}, wrong), gas::DomainError) << step;
    EXPECT_EQ(wrong, 0.0);  // nor did any before it failed
    // Euler's error is of the order of the step's share of the walls' tau.
    expect_right({1e-10, 100000, method, 4e-6}, 4e-6 / 0.05);
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
       {gas::Method::kEuler, gas::Method::kRungeKutta4, gas::Method::kDormandPrince5})
    for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
      double wrong = 0.0;
      const gas::ControlVolumeState state = walls.run({tolerance, 100000, method}, wrong);
      // Each of the 100 calls puts p on its balance to the 1e-10 to which it is held.
      EXPECT_LT(std::abs(wrong), 1e-8 * state.masses[0]) << static_cast<int>(method) << " at " << tolerance;
      EXPECT_LT(relative(state.temperature, 293.15), 1e-10);
    }
}

TEST(effort, too_stiff_a_backflow_names_its_relaxation) {
  const AtAmbient walls{"walls", 0.0, 180.0};
  try {
    double wrong = 0.0;
    walls.run({1e-3, 100}, wrong);
    FAIL();
  } catch (const gas::DomainError& error) {
    const std::string text = error.what(), words = "relaxes within ";
    ASSERT_NE(text.find(words), std::string::npos) << text;
    // Air of m' = hA (T - T_a)/(cp T_a) falls through (m'/C)^2/(2 rho), and raises p by gamma R T_a m'/V:
    // that of the balance, which p swings about by as much.
    const double flow = 180.0 * (900.0 - 293.15) / (1038.8 * 293.15), rt = 296.8 * 293.15;
    const double drop = flow * flow / 0.01 / (2.0 * kAmbientPressure / rt);
    const double time = 2.0 * drop * 0.06 / (1038.8 / 742.0 * rt * flow);
    const double named = std::stod(text.substr(text.find(words) + words.size()));
    EXPECT_LT(std::abs(std::log(named / time)), std::log(4.0)) << text;
  }
}

/// Flow out of a small tank sets in at p_a while its inflow grows from nothing: at the begin its slope with p
/// has no bound, and a matrix of that slope would hold p there.
TEST(onset_at_ambient, implicit_steps_follow_the_flows) {
  for (const double area : {1.4e-6, 1.4e-5, 1.4e-4}) {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    model.inflows.push_back(
        {kPure, gas::Curve({{0.0, 0.0}, {2e-3, 1.1e-3}}, gas::Outside::kHeld), gas::Curve::constant(406.0)});
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
      const auto [found, steps] = run({tolerance, 100000, gas::Method::kRosenbrock4});
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
    gas::GasIntegrator integrator(model, {tolerance, 100000, gas::Method::kRosenbrock4});
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
    gas::GasIntegrator(model, {1e-6, 1000, gas::Method::kRosenbrock4, 1e-3})
        .advance(state, 0.0, 1e-3, rigid(1e-3));
    FAIL() << "no error";
  } catch (const gas::DomainError& error) {
    EXPECT_NE(std::string(error.what()).find("the wrong way"), std::string::npos) << error.what();
  }
}

/// Where p is held within 1e-12 of p_a, the flows at a moment are those that a step carries: of inflow
/// through a vent and fabric, of walls that cool and of a volume that grows through a vent that lets gas in.
TEST(held_flow, at_a_moment_eq_what_a_step_carries) {
  gas::ControlVolumeModel inflow = closed_tank(nitrogen()), walls = inflow;
  inflow.vents.push_back({1.0, 10.0});
  inflow.inflows.push_back(steady_inflow(inflow.thermo, 1e-3, 406.0));
  walls.vents.push_back({1.0, 10.0});
  walls.vents.back().backflow = true;
  walls.ambient.mass_fractions = kPure;
  gas::ControlVolumeModel growing = walls;
  walls.heat_loss = {0.1, 293.15};
  struct Held {
    gas::ControlVolumeModel model;
    double growth, leak_area;  // [m3/s], [m2]
  };
  for (const auto& [model, growth, leak_area] :
       {Held{inflow, 0.0, 5.0}, Held{walls, 0.0, 0.0}, Held{growing, 1e-3, 0.0}}) {
    constexpr double kStep = 1e-3, kVolume = 1e-3;
    gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure, 600.0, kVolume);
    const gas::GasPoint begin = gas::evaluate(model, state, kVolume, leak_area, 0.0, growth);
    const double end_volume = kVolume + growth * kStep;
    const gas::StepFluxes f = gas::GasIntegrator(model, {1e-12, 100000, gas::Method::kRosenbrock4})
                                  .advance(state, 0.0, kStep, {kVolume, end_volume, leak_area, leak_area});
    const gas::GasPoint end = gas::evaluate(model, state, end_volume, leak_area, kStep, growth);
    const auto expect_mean = [&](double from, double to, double carried) {
      // The trapezium's error, (h mdot/m)^2/12 of some 1e-3 each.
      EXPECT_NEAR(0.5 * kStep * (from + to), carried, 1e-6 * carried);
    };
    expect_mean(begin.vent_mass_flow, end.vent_mass_flow, f.vent_mass_out);
    expect_mean(begin.fabric_mass_flow, end.fabric_mass_flow, f.fabric_mass_out);
    expect_mean(begin.backflow, end.backflow, f.backflow_mass);
    EXPECT_GT(f.vent_mass_out + f.backflow_mass, 0.0);
  }
}

}  // namespace
