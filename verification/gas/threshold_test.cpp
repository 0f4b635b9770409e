// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "bisection.hpp"
#include "cases.hpp"
#include "claim.hpp"
#include "closed_form/gas.hpp"
#include "closed_form/orifice.hpp"
#include "closed_form/stability.hpp"
#include "gas/orifice.hpp"
#include "real_axis_limit.hpp"

// Where each method fails: the limit as a formula, the threshold as measured beside it, an error past it.
namespace {

using namespace cases;

struct Explicit {
  gas::Method method;
  const char* name;
  double limit;
};

std::vector<Explicit> explicit_methods() {
  using support::real_axis_limit;
  return {{gas::Method::euler, "explicit Euler", real_axis_limit(support::kEulerPolynomial)},
          {gas::Method::runge_kutta_4, "Runge-Kutta 4", real_axis_limit(support::kRungeKutta4Polynomial)},
          {gas::Method::dormand_prince_5, "Dormand-Prince 5",
           real_axis_limit(support::kDormandPrince5Polynomial)}};
}

/// A tank in balance: what enters leaves.
struct Balance {
  gas::ControlVolumeModel model;
  double volume, pressure, temperature, rate;  // [m3], [Pa], [K], [1/s] the faster relaxation rate
};

/// Tiny volume, choked vent: the rates of (m, U) in closed form.
Balance choked_balance() {
  const closed_form::VentedFill fill{{}, 1e-6, 0.5, 700.0, 1e-3};
  const closed_form::VentedFillSteady steady = closed_form::vented_fill_steady(fill);
  Balance b{closed_tank(nitrogen()), 1e-6, steady.state.pressure, 700.0, -steady.fast_eigenvalue};
  b.model.inflows.push_back(steady_inflow(b.model.thermo, 0.5, 700.0));
  b.model.vents.push_back({1.0, 1e-3});
  return b;
}

/// The same of a bag whose volume is proportional to its pressure.
Balance soft_balance() {
  Balance b = choked_balance();
  const double low = 0.5 * kAmbientPressure, high = 3.0 * b.pressure, per_pressure = b.volume / b.pressure;
  b.model.volume_of_overpressure = gas::Curve(
      {{low - kAmbientPressure, low * per_pressure}, {high - kAmbientPressure, high * per_pressure}},
      gas::Outside::held);
  const double mass = b.pressure * b.volume / (296.8 * b.temperature);
  b.rate = gas::outflow_relaxation_rate(1.4, 0.5 / mass, 1.0, 1.0 + 1.4);
  return b;
}

/// Weak inflow, vent just above p_a: the square root. mdot = A sqrt(2 rho dp) to dp/p.
Balance equalising_balance() {
  const double excess = 1.0, p = kAmbientPressure + excess;
  Balance b{closed_tank(nitrogen()), 0.06, p, 400.0, 0.0};
  b.model.vents.push_back({1.0, 1e-3});
  const double flow = closed_form::orifice_mass_flow({{}, 1e-3, 1.0, p, 400.0, kAmbientPressure});
  b.model.inflows.push_back(steady_inflow(b.model.thermo, flow, 400.0));
  b.rate = -closed_form::vent_eigenvalue({{}, 0.06, 1e-3, kAmbientPressure, 400.0}, excess);
  return b;
}

/// Whether a small disturbance of the balance has grown after 800 fixed steps of h, one call each.
bool grows(const Balance& b, gas::Method method, double h) {
  gas::GasIntegrator integrator(b.model, {1e-10, 100000, method, h, true});
  gas::ControlVolumeState state = gas::make_state(
      b.model, kPure, b.pressure + 1e-5 * (b.pressure - kAmbientPressure), b.temperature, b.volume);
  const auto distance = [&] {
    return std::abs(gas::evaluate(b.model, state, b.volume, 0.0, 0.0).pressure - b.pressure);
  };
  const double begin = distance();
  for (int i = 0; i < 800; ++i) {
    try {
      integrator.advance(state, h * i, h * (i + 1), rigid(b.volume));
    } catch (const gas::DomainError&) {
      return true;  // out of the gas's domain
    }
    if (distance() > 10.0 * begin) return true;  // past it the growth may end, by a switch of the flow
  }
  return distance() > begin;
}

/// Past the limit: an error that names step and limit; below: none.
void expect_refusal(const Balance& b, gas::Method method, double limit) {
  const auto run = [&](double step) {
    gas::ControlVolumeState state = gas::make_state(b.model, kPure, b.pressure, b.temperature, b.volume);
    gas::GasIntegrator(b.model, {1e-10, 100000, method, step})
        .advance(state, 0.0, 20.0 * step, rigid(b.volume));
  };
  EXPECT_NO_THROW(run(0.99 * limit));
  try {
    run(1.01 * limit);
    FAIL() << "no error";
  } catch (const gas::DomainError& error) {
    EXPECT_NE(std::string(error.what()).find("stability limit"), std::string::npos) << error.what();
  }
}

void expect_threshold(const char* failure, const char* formula, const Balance& b) {
  for (const auto& [method, name, limit] : explicit_methods()) {
    const double h = limit / b.rate;
    const double measured = claim::largest_passing(
        0.5 * h, 2.0 * h, 1e-3, [&, m = method](double step) { return !grows(b, m, step); });
    claim::expect_threshold(
        {"G.14", name,
         "bisection to 0.1 %; 800 steps tell growth from decay to 0.2 % of z, where |R'| is of order 1"},
        {failure, formula, h, measured, "s",
         "fixed sub-steps: error with step and limit; error control: smaller sub-steps; Rosenbrock: no "
         "limit"},
        1.0 - 5e-3, 1.0 + 5e-3);
    expect_refusal(b, method, h);
  }
}

TEST(threshold, tiny_volume_eq_relaxation_rate) {
  expect_threshold("vent relaxation time", "h |λ| = 2, 2.785, 3.307 by order 1, 4, 5", choked_balance());
}

TEST(threshold, soft_bag_eq_relaxation_rate) {
  expect_threshold("vent relaxation time",
                   "h |λ| = 2, 2.785, 3.307 by order 1, 4, 5, of a bag with V ~ p: c = 1 + γ",
                   soft_balance());
}

TEST(threshold, vent_near_ambient_eq_square_root_rate) {
  expect_threshold("square-root equalisation", "h |λ| = 2, 2.785, 3.307, |λ| → κ/√(p − p_a)",
                   equalising_balance());
}

/// The implicit method keeps the balance in steps fifty times the explicit limit.
TEST(threshold, implicit_method_has_none) {
  for (const Balance& b : {choked_balance(), equalising_balance()}) {
    gas::ControlVolumeState state = gas::make_state(b.model, kPure, b.pressure, b.temperature, b.volume);
    const double h = 100.0 / b.rate;
    gas::GasIntegrator(b.model, {1e-10, 100000, gas::Method::rosenbrock_4, h})
        .advance(state, 0.0, 50.0 * h, rigid(b.volume));
    // A balance is a fixed point of the method too. What moves it is rounding, and the laminar range, by
    // 1.5e-6 Pa.
    EXPECT_LT(relative(gas::evaluate(b.model, state, b.volume, 0.0, 0.0).pressure, b.pressure), 1e-10);
  }
}

/// With error control, from one call to the next, while the volume grows: few sub-steps where the explicit
/// method takes one per relaxation.
TEST(threshold, implicit_method_follows_a_stiff_balance) {
  const auto run = [](gas::Method method, int& steps) {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    model.inflows.push_back(steady_inflow(model.thermo, 0.02, 406.0));
    gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure, 293.15, 1e-4);
    gas::GasIntegrator integrator(model, {1e-6, 100000, method});
    steps = 0;
    for (int i = 0; i < 20; ++i)
      steps +=
          integrator
              .advance(state, 1e-3 * i, 1e-3 * (i + 1), {1e-4 + 5e-6 * i, 1e-4 + 5e-6 * (i + 1), 4e-3, 4e-3})
              .steps;
    return gas::evaluate(model, state, 2e-4, 4e-3, 0.0);
  };
  int implicit = 0, explicit_steps = 0;
  const gas::GasPoint point = run(gas::Method::rosenbrock_4, implicit);
  const gas::GasPoint reference = run(gas::Method::runge_kutta_4, explicit_steps);
  EXPECT_LT(4 * implicit, explicit_steps);
  // Twenty calls of a dozen sub-steps of 1e-6 each.
  EXPECT_LT(relative(point.temperature, reference.temperature), 2e-4);
  EXPECT_LT(relative(point.pressure, reference.pressure), 2e-4);
}

/// (G.14) against the closed forms of its two ends.
TEST(threshold, relaxation_rate_eq_closed_forms) {
  for (const double gamma : {1.2, 1.4, 5.0 / 3.0}) {
    const closed_form::VentedFill fill{{296.8, gamma}, 0.06, 0.5, 700.0, 1e-3};
    const closed_form::VentedFillSteady steady = closed_form::vented_fill_steady(fill);
    // A square root and some ten roundings.
    EXPECT_LT(
        relative(gas::outflow_relaxation_rate(gamma, 0.5 / steady.state.mass, 1.0), -steady.fast_eigenvalue),
        1e-13);
    for (const double excess : {1.0, 0.01}) {
      const double p = kAmbientPressure + excess, mass = p * 0.06 / (296.8 * 400.0);
      const double flow =
          closed_form::orifice_mass_flow({{296.8, gamma}, 1e-3, 1.0, p, 400.0, kAmbientPressure});
      const double n = gas::orifice_pressure_exponent(gamma, (p - kAmbientPressure) / p);
      const double root =
          -closed_form::vent_eigenvalue({{296.8, gamma}, 0.06, 1e-3, kAmbientPressure, 400.0}, excess);
      // The square root's rate is the limit of small dp/p: off by some dp/p, and eps p/dp of rounding.
      EXPECT_LT(relative(gas::outflow_relaxation_rate(gamma, flow / mass, n), root),
                10.0 * excess / p + 1e-8);
    }
  }
}

/// Fixed steps of explicit Euler on a vent alone end in a 2-cycle of amplitude (kappa h)^2; located, they end
/// on p_a.
TEST(threshold, chatter_of_plain_euler_is_as_its_formula_and_ours_is_none) {
  const double h = 1e-3, cv = 742.0;
  const gas::ControlVolumeModel model = [] {
    gas::ControlVolumeModel m = closed_tank(nitrogen());
    m.vents.push_back({1.0, 1e-3});
    return m;
  }();
  double mass = 1.02 * kAmbientPressure * 0.06 / (296.8 * 400.0), energy = mass * cv * 400.0, low = 1e9,
         high = 0.0;
  const double air = 296.8 * 400.0;  // what comes back is at 400 K, as the formula's gas
  for (int i = 0; i < 2000; ++i) {
    const double p = 0.4 * energy / 0.06, t = energy / (mass * cv);
    const double out = gas::orifice_mass_flow(1e-3, p, t, 296.8, 1038.8, 1.4, kAmbientPressure);
    const double back = gas::orifice_mass_flow(1e-3, kAmbientPressure, air / 296.8, 296.8, 1038.8, 1.4, p);
    mass += h * (back - out);
    energy += h * 1038.8 * (back * 400.0 - out * t);
    if (i < 1900) continue;
    low = std::min(low, p), high = std::max(high, p);
  }
  const double t_end = energy / (mass * cv);
  const closed_form::VentEqualisation vent{{}, 0.06, 1e-3, kAmbientPressure, t_end};
  claim::expect_threshold(
      {"G.21", "amplitude of plain Euler's 2-cycle", "leading term in dp/p; each half cycle has another gas"},
      {"square-root equalisation", "(κ h)²", closed_form::vent_chatter_amplitude(vent, h), 0.5 * (high - low),
       "Pa", "p = p_a is located: no cycle, every method ends on p_a"},
      0.98, 1.04);
  gas::ControlVolumeState state = gas::make_state(model, kPure, 1.02 * kAmbientPressure, 400.0, 0.06);
  gas::GasIntegrator(model, {1e-10, 100000, gas::Method::euler, h}).advance(state, 0.0, 2.0, rigid(0.06));
  EXPECT_NEAR(gas::evaluate(model, state, 0.06, 0.0, 0.0).pressure, kAmbientPressure,
              1e-8 * kAmbientPressure);
}

}  // namespace
