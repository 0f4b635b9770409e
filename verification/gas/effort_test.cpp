// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "cases.hpp"
#include "gas/orifice.hpp"

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
Work cooling(const gas::IntegratorOptions& options, int calls, double length, double effective_area = 4e-4) {
  gas::ControlVolumeModel model = vented(nasa7({"N2", "O2", "Ar", "CO2"}), effective_area, true);
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
/// trials, sixteen sub-steps from end to end, and one for each further
/// call. Tighter by 1e4, at most as many times more as the order says: all that is there anyway makes it
/// less.
TEST_P(effort, of_equalisation_and_backflow_follows_the_order) {
  const auto& [method, name, power, trial, trial_of_four] = GetParam();
  const auto expect = [&, m = method, p = power](const auto& problem, double allowed) {
    const auto evaluations = [&](double tolerance) { return problem({tolerance, 100000, m}).evaluations; };
    EXPECT_LE(evaluations(1e-2), allowed);
    for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
      if (m == gas::Method::euler && tolerance < 1e-4) continue;  // 1e5 sub-steps
      EXPECT_LE(evaluations(1e-4 * tolerance), std::pow(1e4, 1.0 / p) * evaluations(tolerance)) << tolerance;
    }
  };
  for (const auto& problem : {vent_to_rest, inrush_to_rest}) {
    expect(problem, trial * (2 * 12 + 16));
    // It ends in the laminar range.
    EXPECT_NEAR(problem({1e-4, 100000, method}).pressure, kAmbientPressure, 1e-8 * kAmbientPressure);
  }
  expect([](const gas::IntegratorOptions& options) { return cooling(options, 100, 5e-3); },
         trial_of_four * (2 * 12 + 10 + 100));
}

INSTANTIATE_TEST_SUITE_P(methods, effort,
                         testing::Values(Effort{gas::Method::dormand_prince_5, "dormand_prince", 5.0, 7, 7},
                                         Effort{gas::Method::runge_kutta_4, "runge_kutta", 5.0, 12, 12},
                                         Effort{gas::Method::euler, "euler", 2.0, 4, 4},
                                         Effort{gas::Method::rosenbrock_4, "rosenbrock", 4.0, 13, 19}),
                         [](const auto& one) { return std::string(one.param.name); });

/// Fabric whose table curves upward relaxes faster than its flow: the stiff balance is seen, and stepped
/// over.
TEST(effort, of_a_balance_by_a_convex_table_of_fabric) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.fabrics = {{1.0, gas::Curve({{0.0, 0.0}, {5e3, 0.0}, {1e4, 50.0}}, gas::Outside::held)}};
  model.inflows.push_back(steady_inflow(model.thermo, 0.01, 300.0));
  gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure + 5e3, 300.0, 0.06);
  const auto fluxes = gas::GasIntegrator(model, {1e-6}).advance(state, 0.0, 1.0, rigid(0.06, 0.1));
  // It relaxes within 0.4 ms: explicit sub-steps would be 750, of six evaluations each.
  EXPECT_LT(fluxes.evaluations, 750);
}

/// A species that is not there stays away to the bit: what a solver's rounding made of it could not leave,
/// and would stop every sub-step.
TEST(effort, absent_species_stay_absent) {
  for (const gas::Method method : kMethods) {
    const Work work = cooling({1e-6, 100000, method}, 50, 1e-3);
    EXPECT_GT(work.pressure, 1.3 * kAmbientPressure);  // still all outflow
    EXPECT_EQ(work.state.masses[1] + work.state.masses[2] + work.state.masses[3], 0.0);
  }
}

/// Sub-steps of a fourth-order method from one state to rest, (tolerance/d)^(1/4) of a time constant each as
/// the distance d fades from 1: int (d/tolerance)^(1/4) dt.
double steps_to_rest(double tolerance) {
  return 4.0 * std::pow(tolerance, -0.25);
}

/// Backflow that fades as the walls cool the gas, in one call: a balance ever closer below p_a, which relaxes
/// ever faster. The implicit method follows it to rest.
TEST(effort, implicit_method_follows_a_fading_balance) {
  // Its stages are linear in p, so a sub-step in which the flow more than halves takes the root past zero and
  // p past p_a: repeated at a quarter. Accepted ones, then at least a quarter of that long, grow fivefold at
  // most: log 5/log 4 rejected for each. p is held from 1e-10 of p_a on; where backflow is greatest p - p_a
  // is 0.13 of it, and goes as the square of the flow.
  const double halvings = 0.5 * std::log2(0.13 / 1e-10),
               fading = 4.0 * halvings * (1.0 + std::log(5.0) / std::log(4.0));
  for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8}) {  // below, rounding of p - p_a sets the steps
    const Work work = cooling({tolerance, 100000, gas::Method::rosenbrock_4}, 1, 5.0);
    // Two events as above, 19 evaluations a trial.
    EXPECT_LT(work.evaluations, 19 * (2 * 12 + steps_to_rest(tolerance) + fading)) << tolerance;
    // The last sub-steps are quarters of a halving or longer, over each of which the walls damp an error as
    // they do the flow: 1/(1 - 2^(-1/4)) = 6.3 of a sub-step's are left; and e^(-5 s/0.395 s) of 607 K.
    const double errors = 6.3 * tolerance;
    EXPECT_NEAR(work.state.temperature, 293.15, 293.15 * (errors + 1e-5));
    EXPECT_NEAR(work.pressure, kAmbientPressure, errors * kAmbientPressure);
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
    gas::GasIntegrator integrator(model, {tolerance, 100000, gas::Method::rosenbrock_4});
    const int evaluations = integrator.advance(state, 0.0, 0.02, rigid(1e-4, 3.75e-3)).evaluations;
    const gas::GasPoint point = gas::evaluate(model, state, 1e-4, 3.75e-3, 0.02);
    const double excess = std::pow(0.02 / 3.75e-3, 2.0) / (2.0 * point.density);
    // Down in quarters from 20 ms to the time of relaxation (G.14), up again fivefold, and what the gas takes
    // that follows slowly. Explicit sub-steps would be 5600.
    const double times =
        0.02 * gas::outflow_relaxation_rate(1.4, 0.02 / point.mass, 0.5 + 0.5 * point.pressure / excess);
    EXPECT_GT(times, 1e4);
    EXPECT_LT(evaluations, 13 * (std::log(times) / std::log(4.0) + std::log(times) / std::log(5.0) +
                                 steps_to_rest(tolerance)));
    // The gas is renewed once in m/mdot = 4.2 ms: T is off 406 K by e^-4.8 of 113 K, and the flow's square by
    // twice as much, 0.7 %.
    EXPECT_NEAR(point.pressure - kAmbientPressure, excess, 0.01 * excess);
  }
}

}  // namespace
