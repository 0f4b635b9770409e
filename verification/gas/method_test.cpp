// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "cases.hpp"
#include "claim.hpp"
#include "closed_form/orifice.hpp"
#include "second_route.hpp"

// The methods behind the one interface: their orders, their tolerance, and a second route.
namespace {

using namespace cases;

constexpr double kEnd = 0.15;  // [s] choked until 0.1523 s

gas::ControlVolumeModel holed_tank() {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.vents.push_back({1.0, 1e-3});
  return model;
}

/// The same of T in a tank that fills, ever faster, and vents: the rates depend on time.
double filling_error(const gas::IntegratorOptions& options) {
  gas::ControlVolumeModel model = holed_tank();
  model.inflows.push_back(
      {kPure, gas::Curve({{0.0, 0.0}, {1.0, 50.0}}, gas::Outside::zero), gas::Curve::constant(1100.0)});
  const auto temperature = [&](const gas::IntegratorOptions& chosen) {
    gas::ControlVolumeState state = gas::make_state(model, kPure, 4e5, 700.0, 0.06);
    gas::GasIntegrator(model, chosen).advance(state, 0.0, 0.04, rigid(0.06));
    return state.temperature;
  };
  return relative(temperature(options), temperature({1e-13}));
}

/// Relative error of p after `end` in a blow-down, in one call; mass, energy and their rates are far from
/// zero.
double blowdown_error(const gas::IntegratorOptions& options, double end = kEnd) {
  const gas::ControlVolumeModel model = holed_tank();
  gas::ControlVolumeState state = gas::make_state(model, kPure, 5e5, 600.0, 0.06);
  gas::GasIntegrator(model, options).advance(state, 0.0, end, rigid(0.06));
  const closed_form::Blowdown exact{{}, 0.06, 1e-3, 1.0, 5e5, 600.0, kAmbientPressure};
  return relative(gas::evaluate(model, state, 0.06, 0.0, end).pressure,
                  closed_form::blowdown(exact, end).pressure);
}

struct Order {
  gas::Method method;
  double order;
  double excess;  // above the order on the coarsest pair: the next order's term, halved with each halving
};

class method_order : public testing::TestWithParam<Order> {};

TEST_P(method_order, of_fixed_steps) {
  const auto [method, order, excess] = GetParam();
  const std::string name = testing::UnitTest::GetInstance()->current_test_info()->value_param();
  std::vector<double> blowdown, filling;
  for (const int steps : {16, 32, 64})
    blowdown.push_back(blowdown_error({1e-10, 100000, method, kEnd / steps}));
  for (const int steps : {4, 8, 16})  // with more, the error comes to its rounding
    filling.push_back(filling_error({1e-10, 100000, method, 0.04 / steps}));
  claim::expect_order(
      {"G.10", name + ", choked blow-down: pressure", "the next order's term, halved with each halving"},
      blowdown, order - 0.1, order + 0.5 * excess);
  claim::expect_order({"G.10", name + ", inflow that grows against a vent: temperature",
                       "the next order's term, of either sign"},
                      filling, order - excess, order + excess);
}

std::string name_of(gas::Method method) {
  switch (method) {
    case gas::Method::euler:
      return "euler";
    case gas::Method::runge_kutta_4:
      return "runge_kutta";
    case gas::Method::rosenbrock_4:
      return "rosenbrock";
    case gas::Method::dormand_prince_5:
      break;
  }
  return "dormand_prince";
}

void PrintTo(const Order& one, std::ostream* out) {
  *out << name_of(one.method);
}

INSTANTIATE_TEST_SUITE_P(methods, method_order,
                         testing::Values(Order{gas::Method::euler, 1.0, 0.2},
                                         Order{gas::Method::runge_kutta_4, 4.0, 0.5},
                                         Order{gas::Method::dormand_prince_5, 5.0, 0.5},
                                         Order{gas::Method::rosenbrock_4, 4.0, 0.5}),
                         [](const auto& one) { return name_of(one.param.method); });

struct Levels {
  gas::Method method;
  double order;
  int halvings;  // until the error is near rounding, some 1e-12
};
constexpr Levels kLevels[] = {{gas::Method::euler, 1.0, 3},
                              {gas::Method::runge_kutta_4, 4.0, 3},
                              {gas::Method::dormand_prince_5, 5.0, 2},
                              {gas::Method::rosenbrock_4, 4.0, 2}};

/// The order of each method on its levels from `steps` steps to `end`; wavering by share/steps of it.
void expect_orders(double end, int steps, double share) {
  for (const auto& [method, order, halvings] : kLevels) {
    double coarse = blowdown_error({1e-10, 100000, method, end / steps}, end);
    for (int n = 2 * steps; n <= steps << halvings; n *= 2) {
      const double fine = blowdown_error({1e-10, 100000, method, end / n}, end);
      EXPECT_NEAR(std::log2(coarse / fine), order, share / n) << n << " " << static_cast<int>(method);
      coarse = fine;
    }
  }
}

/// Through the sonic switch, whose second derivative jumps: located, it costs no order.
TEST(method, sonic_switch_costs_no_order) {
  // The step that ends at the switch is a share of a step, another one each time: its error wavers by a
  // step's, 1/steps of the whole.
  expect_orders(0.18, 16, 16.0);
}

/// To 97 % of the time to equalisation, where rates go as its root: steps well below the 3 % that are left.
TEST(method, order_holds_close_to_equalisation) {
  // As above, and the steps' share of what is left: 32/steps of it, of which up to four orders enter.
  expect_orders(0.97 * 0.31877770016071139, 128, 128.0);
}

TEST(method, error_follows_the_tolerance) {
  for (const gas::Method method : kMethods) {
    for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
      // A first-order method takes 1/sqrt(tolerance) sub-steps, each with an error of one tolerance.
      const bool euler = method == gas::Method::euler;
      if (euler && tolerance < 1e-7) continue;
      const double sum = euler ? 1.0 / std::sqrt(tolerance) : 10.0;
      EXPECT_LT(blowdown_error({tolerance, 1000000, method}), sum * tolerance) << static_cast<int>(method);
    }
  }
}

/// The filled and vented tank of the benchmark by GSL's msbdf, which knows the gas by its pointwise laws
/// alone.
TEST(method, all_methods_eq_the_second_route) {
  const second_route::Tank tank = second_route::benchmark_tank();
  const gas::ControlVolumeState reference = second_route::msbdf(tank, 1e-11).back();
  for (const gas::Method method : kMethods) {
    const double tolerance = method == gas::Method::euler ? 1e-6 : 1e-10;
    gas::ControlVolumeState state = tank.start;
    gas::GasIntegrator(tank.model, {tolerance, 10000000, method})
        .advance(state, 0.0, second_route::kEnd, rigid(second_route::kVolume));
    // msbdf's global error is some hundred tolerances of its own; Euler's a thousand, see above.
    const double allowed = method == gas::Method::euler ? 1e-3 : 5e-9;
    EXPECT_LT(relative(state.temperature, reference.temperature), allowed) << static_cast<int>(method);
    for (std::size_t k = 0; k < state.masses.size(); ++k)
      EXPECT_LT(relative(state.masses[k], reference.masses[k]), allowed) << static_cast<int>(method);
  }
}

/// From an evacuated tank and through a step that is one sub-step of the method: T = gamma T_in by all of
/// them.
TEST(method, evacuated_fill_is_exact_by_any_method) {
  gas::ControlVolumeModel model = holed_tank();
  model.inflows.push_back(steady_inflow(model.thermo, 1.0, 700.0));
  for (const gas::Method method : kMethods) {
    gas::ControlVolumeState state = gas::make_state(model, kPure, 0.0, 293.15, 0.06);
    gas::GasIntegrator(model, {1e-6, 1000, method, 1e-3}).advance(state, 0.0, 5e-3, rigid(0.06));
    EXPECT_LT(relative(state.temperature, 980.0), 1e-13);  // sums of two products, and their quotient
  }
}

/// A weak inflow into a tenth of a litre behind much fabric (cases/tank_stiff.toml): from the onset of
/// outflow at p = p_a to a balance that relaxes within microseconds and changes over milliseconds. The
/// implicit method follows the latter alone, at any tolerance.
TEST(method, implicit_steps_follow_the_slow_balance) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.inflows.push_back(steady_inflow(model.thermo, 0.02, 406.0));
  const auto run = [&](const gas::IntegratorOptions& options) {
    gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure, 293.15, 1e-4);
    const int steps =
        gas::GasIntegrator(model, options).advance(state, 0.0, 0.02, rigid(1e-4, 3.75e-3)).steps;
    return std::pair{gas::evaluate(model, state, 1e-4, 3.75e-3, 0.02).pressure - kAmbientPressure, steps};
  };
  const double overpressure = run({1e-13}).first;
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    const auto [found, steps] = run({tolerance, 100000, gas::Method::rosenbrock_4});
    // The last step's tolerance of p is p/(p - p_a) = 6000 times as much of p - p_a; earlier errors are
    // damped.
    EXPECT_NEAR(found, overpressure, 6000.0 * tolerance * overpressure) << tolerance;
    // Order 4: ten times as many steps for 1e-4 of the error, no more; some 40 at 1e-4. Steps that stay in
    // the root of time, or slopes of first order, take 500 to 100 000 at 1e-8 and below.
    EXPECT_LT(steps, 40.0 * std::pow(1e-4 / tolerance, 0.25) + 40.0) << tolerance;
  }
}

/// Heated through 1000 K, where cp and u jump by 1e-9 of their size and the slope of cp by more, with a vent
/// open: the tolerance holds.
TEST(method, joint_of_cp_is_passed_within_the_tolerance) {
  const auto run = [](gas::Method method, double tolerance, int& evaluations) {
    gas::ControlVolumeModel model = closed_tank(nasa7({"N2"}));
    model.inflows.push_back(steady_inflow(model.thermo, 1.0, 1100.0));
    model.vents.push_back({1.0, 1e-3});
    gas::ControlVolumeState state = gas::make_state(model, kPure, 4e5, 950.0, 0.06);
    const auto fluxes =
        gas::GasIntegrator(model, {tolerance, 100000, method}).advance(state, 0.0, 0.02, rigid(0.06));
    evaluations = fluxes.evaluations;
    EXPECT_GT(state.temperature, 1010.0);
    return state.temperature;
  };
  int evaluations = 0;
  const double exact = run(gas::Method::dormand_prince_5, 1e-13, evaluations);
  for (const gas::Method method : kMethods) {
    for (const double tolerance : {1e-5, 1e-7, 1e-9, 1e-10}) {
      const bool euler = method == gas::Method::euler;
      if (euler && tolerance < 1e-8) continue;
      claim::expect_relative(
          {"G.4", name_of(method) + ", vented nitrogen heated through 1000 K, by tolerance: temperature [K]",
           "some ten to a hundred sub-steps of a tolerance; of first order, 1/sqrt(tolerance)"},
          run(method, tolerance, evaluations), exact,
          (euler ? 1.0 / std::sqrt(tolerance) : 20.0) * tolerance);
      EXPECT_LT(evaluations, 20000);
    }
  }
}

}  // namespace
