// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <boost/numeric/odeint/stepper/euler.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <numbers>
#include <string>

#include "cases.hpp"
#include "claim.hpp"
#include "closed_form/orifice.hpp"
#include "gas/orifice.hpp"
#include "rosenbrock_step.hpp"

// What the library avoids: schemes written out here, each beside the formula of its failure, and the
// library's own answer on the same problem.
namespace {

using namespace cases;

constexpr double kGamma = 1.4;

struct Wave {
  double mean = 0.06, amplitude = 0.3, frequency = 20.0;  // [m3], of the mean, [Hz]
  int steps = 200;                                        // a period
  double step() const { return 1.0 / (frequency * steps); }
  double volume(double t) const {
    return mean * (1.0 + amplitude * std::sin(2.0 * std::numbers::pi * frequency * t));
  }
};

/// ln(p V^gamma) that gas with U' = U - p dV, p of the step's start, loses in one period.
double explicit_work_loss(const Wave& wave) {
  double energy = 1.0;  // of any gas: the scheme is linear in U
  for (int i = 0; i < wave.steps; ++i) {
    const double v = wave.volume(wave.step() * i);
    energy -= (kGamma - 1.0) * energy / v * (wave.volume(wave.step() * (i + 1)) - v);
  }
  return -std::log(energy);
}

TEST(failing_scheme, explicit_work_loses_entropy_at_first_order) {
  for (const int steps : {100, 200, 400}) {
    const Wave wave{.steps = steps};
    // (G.20) summed over a period: int (V'/V)^2 dt = 2 pi omega (1/sqrt(1 - a^2) - 1).
    const double circle = 2.0 * std::numbers::pi, a = wave.amplitude;
    const double predicted = 0.5 * kGamma * (kGamma - 1.0) * wave.step() * circle * circle * wave.frequency *
                             (1.0 / std::sqrt(1.0 - a * a) - 1.0);
    claim::expect_threshold(
        {"G.20", "ln(p V^γ) lost in a period of " + std::to_string(steps) + " steps",
         "terms of third order cancel over a period; those of fourth are (2 pi a/steps)^2 of it, 4e-4 at "
         "most"},
        {"explicit p dV", "γ (γ − 1) δ²/2 a step, δ = dV/V", predicted, explicit_work_loss(wave), "",
         "p dV is integrated inside the step: the loss is the gas stepper's tolerance"},
        1.0 - 1e-3, 1.0 + 1e-3);
  }
  const Wave wave{.steps = 100};
  const gas::ControlVolumeModel model = closed_tank(nitrogen());
  gas::ControlVolumeState state = gas::make_state(model, kPure, 2e5, 400.0, wave.mean);
  gas::GasIntegrator integrator(model);
  for (int i = 0; i < wave.steps; ++i) {
    const double t0 = wave.step() * i, t1 = wave.step() * (i + 1);
    integrator.advance(state, t0, t1, {wave.volume(t0), wave.volume(t1), 0.0, 0.0});
    const double p = gas::evaluate(model, state, wave.volume(t1), 0.0, 0.0).pressure;
    // At most a hundred steps of the tolerance, 1e-10.
    EXPECT_LT(relative(p * std::pow(wave.volume(t1) / wave.mean, kGamma), 2e5), 1e-8);
  }
}

/// Relative error of p after a blow-down through the switch at 0.1523 s, by a stepper that steps over it.
template <class Stepper>
double unlocated_error(int steps) {
  using State = std::array<double, 2>;  // mass, energy
  constexpr double end = 0.18, volume = 0.06, cv = 742.0;
  const auto rates = [](const State& x, State& rate, double) {
    const double t = x[1] / (x[0] * cv), p = 0.4 * x[1] / volume;
    const double flow = gas::orifice_mass_flow(1e-3, p, t, 296.8, 1038.8, kGamma, kAmbientPressure);
    rate = {-flow, -flow * 1038.8 * t};
  };
  const double mass = 5e5 * volume / (296.8 * 600.0), h = end / steps;
  State x{mass, mass * cv * 600.0};
  Stepper stepper;
  for (int i = 0; i < steps; ++i) stepper.do_step(rates, x, i * h, h);
  const closed_form::Blowdown exact{{}, volume, 1e-3, 1.0, 5e5, 600.0, kAmbientPressure};
  return relative(0.4 * x[1] / volume, closed_form::blowdown(exact, end).pressure);
}

struct Rosenbrock4 {
  template <class Rates>
  void do_step(const Rates& rates, std::array<double, 2>& x, double, double h) {
    x = rosenbrock_step(rates, x, h);
  }
};

/// Mean over a quarter more steps: the switch falls anywhere in its step.
template <class Stepper>
double mean_error(int steps) {
  double sum = 0.0;
  for (int n = steps; n < steps + steps / 4; ++n) sum += unlocated_error<Stepper>(n);
  return sum / (steps / 4);
}

template <class Stepper>
void expect_order(const std::string& method, double order, const char* formula) {
  for (const int steps : {128, 256}) {
    const double measured = std::log2(mean_error<Stepper>(steps) / mean_error<Stepper>(2 * steps));
    claim::expect_threshold(
        {"G.6",
         "order of " + method + " between " + std::to_string(steps) + " and " + std::to_string(2 * steps) +
             " steps",
         "means over a quarter of the range, 32 places of the switch in its step or more"},
        {"sonic switch", formula, order, measured, "",
         "the switch is located and ends a sub-step: every method keeps its order"},
        0.95, 1.05);
  }
}

TEST(failing_scheme, stepping_over_the_sonic_switch_costs_order) {
  // The flux has a continuous slope: a step over the jump of its second derivative errs by h^3, once.
  using State = std::array<double, 2>;
  namespace odeint = boost::numeric::odeint;
  expect_order<odeint::euler<State>>("Euler", 1.0, "order 1: below that of the jump");
  expect_order<odeint::runge_kutta4<State>>("Runge-Kutta 4", 3.0, "order 3: the second derivative jumps");
  expect_order<odeint::runge_kutta_dopri5<State>>("Dormand-Prince 5", 3.0,
                                                  "order 3: the second derivative jumps");
  expect_order<Rosenbrock4>("Rosenbrock 4", 3.0, "order 3: the second derivative jumps");
}

}  // namespace
