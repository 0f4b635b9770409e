// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "bisection.hpp"
#include "cases.hpp"
#include "claim.hpp"
#include "gas/orifice.hpp"

// How small a volume each method bears under error control: a balance of inflow and choked vent, T = 406 K.
namespace {

using namespace cases;

constexpr double kFlow = 0.02, kArea = 1e-5, kTemperature = 406.0, kTime = 1e-3;  // [kg/s], [m2], [K], [s]

double balance_pressure() {
  return kFlow / gas::orifice_mass_flow(kArea, 1e6, kTemperature, 296.8, 1038.8, 1.4, kAmbientPressure) * 1e6;
}

double mass(double volume) {
  return balance_pressure() * volume / (296.8 * kTemperature);
}

/// Relative error of p after kTime; negative if that is refused.
double error(double volume, const gas::IntegratorOptions& options) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.inflows.push_back(steady_inflow(model.thermo, kFlow, kTemperature));
  model.vents.push_back({1.0, kArea});
  gas::ControlVolumeState state = gas::make_state(model, kPure, balance_pressure(), kTemperature, volume);
  try {
    gas::GasIntegrator(model, options).advance(state, 0.0, kTime, rigid(volume));
  } catch (const gas::DomainError&) {
    return -1.0;
  }
  return relative(gas::evaluate(model, state, volume, 0.0, kTime).pressure, balance_pressure());
}

struct Limit {
  gas::Method method;
  const char* name;
};

constexpr Limit kExplicit[] = {{gas::Method::euler, "explicit Euler"},
                               {gas::Method::runge_kutta_4, "Runge-Kutta 4"}};
constexpr int kSteps = 2000;

/// [m3] where a call takes all its sub-steps, at the method's limit.
double smallest_at_limit(const Limit& limit) {
  const double rate = gas::outflow_relaxation_rate(1.4, kFlow / mass(1.0), 1.0);
  return kTime * rate / gas::stability_limit(limit.method) / kSteps;
}

/// [m3] where it takes all of them for the rounding of what passes.
double smallest_by_rounding(double tolerance) {
  return 100.0 * kEpsilon * kFlow * kTime / (tolerance * mass(1.0) * kSteps);
}

/// Each method is right to some tolerances down to the formula's volume, and below it right or refused: what
/// passes through in the call is up to 2e7 times what is there.
TEST(femtolitre, is_right_or_refused) {
  for (const gas::Method method : kMethods)
    for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
      double smallest = smallest_by_rounding(tolerance);
      for (const Limit& limit : kExplicit)
        if (limit.method == method) smallest = std::max(smallest, smallest_at_limit(limit));
      // Twice the formula's: up to half of the sub-steps are repeated.
      for (double volume = 2e3 * smallest; volume > 1e-15; volume *= 0.1) {
        const double wrong = error(volume, {tolerance, kSteps, method});
        // A sub-step's error, of which the balance forgets what is older than a few.
        EXPECT_LT(wrong, 3.0 * tolerance) << static_cast<int>(method) << " at " << tolerance;
        if (volume > 1.9 * smallest) {
          EXPECT_GE(wrong, 0.0) << static_cast<int>(method) << " at " << tolerance << ", " << volume << " m3";
        }
      }
      EXPECT_LT(error(1e-21, {tolerance, kSteps, method}), 0.0);
    }
}

TEST(femtolitre, smallest_volume_eq_formula) {
  constexpr double kTolerance = 1e-8;
  const auto measured = [&](gas::Method method, double predicted) {
    return 1.0 / claim::largest_passing(0.2 / predicted, 5.0 / predicted, 1e-3, [&](double inverse) {
             return error(1.0 / inverse, {kTolerance, kSteps, method}) >= 0.0;
           });
  };
  for (const Limit& limit : kExplicit) {
    const double predicted = smallest_at_limit(limit);
    claim::expect_threshold(
        {"G.14", limit.name, "error control keeps to the limit; a first sub-step and a last"},
        {"tiny volume: sub-steps of a call", "t |λ| / z = maximum_steps; z = 2, 2.785 by order 1, 4",
         predicted, measured(limit.method, predicted), "m³",
         "error that names 1/|λ| and the method without that limit"},
        0.98, 1.02);
  }
  const double predicted = smallest_by_rounding(kTolerance);
  claim::expect_threshold(
      {"G.9", "Rosenbrock 4",
       "bisection to 0.1 %; a first sub-step, that grows fivefold up to the limit, and a last"},
      {"tiny volume: rounding of what passes", "t = maximum_steps τ m/(100 ε ṁ)", predicted,
       measured(gas::Method::rosenbrock_4, predicted), "m³",
       "error that names m/ṁ, the limit, and a looser tolerance"},
      1.0 - 1e-3, 1.02);
}

}  // namespace
