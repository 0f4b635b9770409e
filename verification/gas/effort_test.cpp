// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "cases.hpp"

// Work where flow comes to rest at p = p_a or turns there: evaluations of the right-hand side grow as the
// order of the method asks, and no further.
namespace {

using namespace cases;

struct Work {
  int evaluations = 0;
  gas::ControlVolumeState state{};
  double pressure = 0.0;  // [Pa] at the end
};

/// `calls` steps of `length` [s] in 60 litres.
Work run(const gas::ControlVolumeModel& model, gas::ControlVolumeState state,
         const gas::IntegratorOptions& options, int calls, double length) {
  gas::GasIntegrator integrator(model, options);
  Work work;
  for (int i = 0; i < calls; ++i)
    work.evaluations += integrator.advance(state, length * i, length * (i + 1), rigid(0.06)).evaluations;
  work.pressure = gas::evaluate(model, state, 0.06, 0.0, length * calls).pressure;
  work.state = state;
  return work;
}

gas::ControlVolumeModel vented(const gas::Thermo& thermo, double effective_area, bool backflow) {
  gas::ControlVolumeModel model = closed_tank(thermo);
  model.vents.push_back({1.0, effective_area});
  model.vents.back().backflow = backflow;
  return model;
}

/// Nitrogen at 5 bar that leaves, until p = p_a.
Work vent_to_rest(const gas::IntegratorOptions& options) {
  const gas::ControlVolumeModel model = vented(nitrogen(), 1e-3, false);
  return run(model, gas::make_state(model, kPure, 5e5, 600.0, 0.06), options, 1, 0.5);
}

/// Air of one species that flows into a tank at 0.2 bar, until p = p_a.
Work inrush_to_rest(const gas::IntegratorOptions& options) {
  gas::ControlVolumeModel model = vented(nitrogen(), 1e-3, true);
  model.ambient.mass_fractions = kPure;
  return run(model, gas::make_state(model, kPure, 2e4, 350.0, 0.06), options, 1, 2.0);
}

/// cases/tank_backflow.toml: hot nitrogen leaves and cools, then air comes back, three of whose species were
/// absent.
Work cooling(const gas::IntegratorOptions& options, int calls, double length) {
  gas::ControlVolumeModel model = vented(nasa7({"N2", "O2", "Ar", "CO2"}), 4e-4, true);
  model.ambient.mass_fractions = model.thermo.mass_fractions_by_mole(gas::air_by_mole());
  model.heat_loss = {180.0, 293.15};
  return run(model, gas::make_state(model, std::vector{1.0, 0.0, 0.0, 0.0}, 2e5, 900.0, 0.06), options, calls,
             length);
}

/// What a method takes: evaluations of a trial of a sub-step, with one species and with four (the implicit
/// one has two differences for each part of the gas), and the order by which it shortens them.
struct Effort {
  gas::Method method;
  const char* name;
  double power;  // steps grow as tolerance^(-1/power)
  int trial, trial_of_four;
};

void PrintTo(const Effort& effort, std::ostream* out) {
  *out << effort.name;
}

class effort : public testing::TestWithParam<Effort> {};

/// At the loosest tolerance: two events, sonic switch and p = p_a, each of them located in at most a dozen
/// trials (which is what a bracket of 50 bits takes), ten sub-steps from end to end, and one for each further
/// call. Tighter by 1e4, at most as many times more as the order says: all that is there anyway makes it
/// less.
TEST_P(effort, of_equalisation_and_backflow_follows_the_order) {
  const auto& [method, name, power, trial, trial_of_four] = GetParam();
  const auto expect = [&, m = method, p = power](const auto& problem, double allowed) {
    const auto evaluations = [&](double tolerance) { return problem({tolerance, 100000, m}).evaluations; };
    EXPECT_LE(evaluations(1e-2), allowed);
    for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
      if (m == gas::Method::kEuler && tolerance < 1e-4) continue;  // 1e5 sub-steps
      EXPECT_LE(evaluations(1e-4 * tolerance), std::pow(1e4, 1.0 / p) * evaluations(tolerance)) << tolerance;
    }
  };
  for (const auto& problem : {vent_to_rest, inrush_to_rest}) {
    expect(problem, trial * (2 * 12 + 10));
    // The end is located to a hundred roundings of p.
    EXPECT_NEAR(problem({1e-4, 100000, method}).pressure, kAmbientPressure, 1e-12 * kAmbientPressure);
  }
  expect([](const gas::IntegratorOptions& options) { return cooling(options, 100, 5e-3); },
         trial_of_four * (2 * 12 + 10 + 100));
}

INSTANTIATE_TEST_SUITE_P(methods, effort,
                         testing::Values(Effort{gas::Method::kDormandPrince5, "dormand_prince", 5.0, 7, 7},
                                         Effort{gas::Method::kRungeKutta4, "runge_kutta", 5.0, 12, 12},
                                         Effort{gas::Method::kEuler, "euler", 2.0, 4, 4},
                                         Effort{gas::Method::kRosenbrock4, "rosenbrock", 4.0, 13, 19}),
                         [](const auto& one) { return std::string(one.param.name); });

/// A species that is not there stays away to the bit: what a solver's rounding made of it could not leave,
/// and would stop every sub-step.
TEST(effort, absent_species_stay_absent) {
  for (const gas::Method method : kMethods) {
    const Work work = cooling({1e-6, 100000, method}, 50, 1e-3);
    EXPECT_GT(work.pressure, 1.3 * kAmbientPressure);  // still all outflow
    EXPECT_EQ(work.state.masses[1] + work.state.masses[2] + work.state.masses[3], 0.0);
  }
}

/// Backflow that fades as the walls cool the gas, in one call: a balance ever closer below p_a, which relaxes
/// ever faster. The implicit method follows it to rest.
TEST(effort, implicit_method_follows_a_fading_balance) {
  for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8}) {  // below, rounding of p - p_a sets the steps
    const Work work = cooling({tolerance, 100000, gas::Method::kRosenbrock4}, 1, 5.0);
    // Twice what it takes, some 2000 at the start and then as the order; else 100 times as many at 1e-8.
    EXPECT_LT(work.evaluations, 3000 + 100 * std::pow(tolerance, -0.25)) << tolerance;
    // At rest to the errors of the last few sub-steps; by then the gas is within 4e-6 of the walls'
    // temperature.
    EXPECT_NEAR(work.state.temperature, 293.15, 293.15 * (10.0 * tolerance + 1e-5));
    EXPECT_NEAR(work.pressure, kAmbientPressure, 10.0 * tolerance * kAmbientPressure);
  }
}

/// cases/tank_stiff.toml: a weak inflow into a tenth of a litre, 17 Pa above p_a. At a tolerance that knows
/// no difference between that and p_a the implicit method still settles there, instead of crossing p_a for
/// ever.
TEST(effort, implicit_method_settles_above_ambient_at_a_loose_tolerance) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.inflows.push_back(steady_inflow(model.thermo, 0.02, 406.0));
  for (const double tolerance : {1e-2, 1e-3}) {
    gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure, 293.15, 1e-4);
    gas::GasIntegrator integrator(model, {tolerance, 100000, gas::Method::kRosenbrock4});
    // Twice what it takes; crossing, it takes 40 times as many at 1e-2.
    EXPECT_LT(integrator.advance(state, 0.0, 0.02, rigid(1e-4, 3.75e-3)).evaluations, 1100);
    const gas::GasPoint point = gas::evaluate(model, state, 1e-4, 3.75e-3, 0.02);
    const double excess = std::pow(0.02 / 3.75e-3, 2.0) / (2.0 * point.density);
    EXPECT_NEAR(point.pressure - kAmbientPressure, excess, 0.01 * excess);  // settled: within 1 % after 20 ms
  }
}

/// A tank behind a wide vent that lets air of its own gas in, kept at p_a: p V and so U stay.
struct AtAmbient {
  const char* name;
  double inflow, conductance;  // [kg/s] of 300 K, [W/K]; one is zero
  gas::ControlVolumeModel model() const {
    gas::ControlVolumeModel model = vented(nitrogen(), 0.1, true);
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
  Work run(const gas::IntegratorOptions& options, double& wrong) const {
    const gas::ControlVolumeModel m = model();
    gas::GasIntegrator integrator(m, options);
    Work work{0, gas::make_state(m, kPure, kAmbientPressure, 900.0, 0.06)};
    for (int i = 0; i < 100; ++i) {
      const gas::StepFluxes f = integrator.advance(work.state, 1e-3 * i, 1e-3 * (i + 1), rigid(0.06));
      wrong += inflow > 0.0 ? f.backflow_mass : f.vent_mass_out;
    }
    return work;
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
    const double end = GetParam().run(options, wrong).state.temperature;
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
    // Euler's error is of the order of the step's share of the walls' tau.
    expect_right({1e-10, 100000, method, 4e-6}, 4e-6 / 0.05);
  }
}

INSTANTIATE_TEST_SUITE_P(of, balance_at_ambient,
                         testing::Values(AtAmbient{"walls", 0.0, 180.0}, AtAmbient{"inflow", 0.36, 0.0}),
                         [](const auto& one) { return std::string(one.param.name); });

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

}  // namespace
