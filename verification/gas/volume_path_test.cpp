// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <numbers>

#include "cases.hpp"
#include "claim.hpp"
#include "closed_form/gas.hpp"
#include "closed_form/orifice.hpp"

// Volumes that change: work exchanged with the gas.
namespace {

using namespace cases;

TEST(volume_path, adiabatic_piston_keeps_p_V_to_gamma) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    for (const double ratio : {0.125, 0.5, 3.0}) {
      gas::ControlVolumeState state = gas::make_state(model.thermo, kPure, 101325.0, 293.15, 1e-3);
      const gas::StepFluxes fluxes =
          gas::GasIntegrator(model, {tolerance}).advance(state, 0.0, 0.3, {1e-3, ratio * 1e-3, 0.0, 0.0});
      const closed_form::PistonState exact =
          closed_form::adiabatic_piston({{}, 101325.0, 293.15, 1e-3}, ratio * 1e-3);
      const char* why = "40 sub-steps of one tolerance each; compression amplifies early ones by 2.3";
      claim::expect_relative({"G.10", "adiabatic piston by ratio and tolerance: pressure [Pa]", why},
                             gas::evaluate(model, state, ratio * 1e-3, 0.0, 0.3).pressure,
                             exact.state.pressure, 20.0 * tolerance);
      claim::expect_relative({"G.10", "adiabatic piston by ratio and tolerance: work [J]", why}, fluxes.work,
                             -exact.work_on_gas, 40.0 * tolerance);
    }
  }
}

/// In pieces, with a turn in between: the reversible gas comes back.
TEST(volume_path, there_and_back_returns_the_state) {
  gas::ControlVolumeModel model = closed_tank(nasa7({"N2", "CO2"}));
  const std::vector<double> mixture{0.7, 0.3};
  gas::ControlVolumeState state = gas::make_state(model.thermo, mixture, 2e5, 700.0, 0.02);
  const gas::ControlVolumeState start = state;
  gas::GasIntegrator integrator(model, {1e-12});
  double work = 0.0, t = 0.0;
  const std::vector<double> volumes{0.02, 0.05, 0.01, 0.015, 0.02};
  for (std::size_t i = 0; i + 1 < volumes.size(); ++i, t += 0.01)
    work += integrator.advance(state, t, t + 0.01, {volumes[i], volumes[i + 1], 0.0, 0.0}).work;
  // Four calls of some 50 sub-steps at 1e-12.
  EXPECT_LT(relative(state.temperature, start.temperature), 1e-10);
  EXPECT_NEAR(work, 0.0, 1e-10 * 2e5 * 0.02);
}

double entropy(const gas::ControlVolumeModel& model, const gas::ControlVolumeState& state, double volume) {
  const gas::GasPoint point = gas::evaluate(model, state, volume, 0.0, 0.0);
  return model.thermo.entropy(state.masses, point.temperature, point.pressure);
}

/// No closed form with cp(T), but (G.15) stays: compressed, let out through a vent and through fabric.
TEST(volume_path, entropy_of_nasa7_gas_without_heat_stays) {
  for (const double opening : {0.0, 1e-3}) {
    gas::ControlVolumeModel model = closed_tank(nasa7({"N2", "CO2"}));
    model.vents.push_back({0.6, opening});
    gas::ControlVolumeState state = gas::make_state(model.thermo, std::vector{0.7, 0.3}, 5e5, 700.0, 0.02);
    const double before = entropy(model, state, 0.02), r = model.thermo.gas_constant(state.masses);
    const double end = opening > 0.0 ? 0.024 : 0.013;
    gas::GasIntegrator(model, {1e-12}).advance(state, 0.0, 0.01, {0.02, end, opening, opening});
    EXPECT_GT(std::abs(state.temperature - 700.0), 20.0);
    claim::expect_near({"G.15", "NASA-7 mixture, compressed or let out: specific entropy [J/(kg K)]",
                        "a hundred sub-steps of 1e-12 of mass and energy, each worth cp of entropy"},
                       entropy(model, state, end), before, 1e-9 * r);
  }
}

/// A bag that grows just as fast as it is filled: p constant, T mixes by enthalpy. The exact solution is
/// linear in time, so nothing is left but rounding.
TEST(volume_path, constant_pressure_filling_eq_closed_form) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.inflows.push_back(steady_inflow(model.thermo, 0.5, 700.0));
  gas::ControlVolumeState state = gas::make_state(model.thermo, kPure, 101325.0, 293.15, 0.01);
  const closed_form::ConstantPressureFill bag{{}, 101325.0, 0.01, 293.15, 0.5, 700.0};
  const closed_form::GasState exact = closed_form::constant_pressure_fill(bag, 0.1);
  EXPECT_LT(relative(exact.volume, 0.11252158894645941), 1e-14);
  gas::GasIntegrator(model).advance(state, 0.0, 0.1, {0.01, exact.volume, 0.0, 0.0});
  const gas::GasPoint point = gas::evaluate(model, state, exact.volume, 0.0, 0.1);
  const char* why = "rounding: the exact solution is linear in time";
  claim::expect_relative({"G.10", "filling at constant pressure: pressure [Pa]", why}, point.pressure,
                         101325.0, 1e-13);
  claim::expect_relative({"G.10", "filling at constant pressure: temperature [K]", why}, point.temperature,
                         623.14097435750194, 1e-13);
}

/// Leak area and volume vary linearly inside the step: one step equals many on the same lines.
TEST(volume_path, one_step_eq_many_on_the_same_line) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.inflows.push_back(steady_inflow(model.thermo, 1.0, 500.0));
  model.vents.push_back({0.6, 2e-3});
  const auto advance = [&](int n) {
    gas::GasIntegrator integrator(model, {1e-11});
    gas::ControlVolumeState state = gas::make_state(model.thermo, kPure, 1.2e5, 400.0, 0.06);
    const auto at = [](double x) { return std::pair{0.06 + 0.04 * x, 1e-3 + 4e-3 * x}; };
    for (int i = 0; i < n; ++i) {
      const double x = static_cast<double>(i) / n, y = static_cast<double>(i + 1) / n;
      integrator.advance(state, 0.05 * x, 0.05 * y, {at(x).first, at(y).first, at(x).second, at(y).second});
    }
    return state;
  };
  const gas::ControlVolumeState one = advance(1), many = advance(37);
  // Some 40 sub-steps of 1e-11 each.
  EXPECT_LT(relative(many.internal_energy, one.internal_energy), 4e-10);
  EXPECT_LT(relative(many.masses[0], one.masses[0]), 4e-10);
}

/// Sinusoidal volume V0 (1 + a sin(w t)) with a vent that stays choked. Entropy stays, so dm/dt = -k
/// (m/V)^((gamma + 1)/2) with k of the closed form at the start: (m/m0)^-0.2 = 1 + 0.2 f int (V0/V)^1.2 dt, f
/// = mdot0/m0, by Simpson's rule.
struct BreathingTank {
  static constexpr double kVolume = 1e-3, kAmplitude = 0.3, kFrequency = 50.0, kEnd = 0.013;
  static double volume(double t) {
    return kVolume * (1.0 + kAmplitude * std::sin(2.0 * std::numbers::pi * kFrequency * t));
  }
  static double mass_left() {
    constexpr int n = 2000;  // Simpson's error here: (kEnd/n w)^4/180 = 1e-13
    double sum = 0.0;
    for (int i = 0; i <= n; ++i)
      sum += (i == 0 || i == n ? 1.0
              : i % 2 == 1     ? 4.0
                               : 2.0) *
             std::pow(kVolume / volume(kEnd * i / n), 1.2);
    const double flow = closed_form::orifice_mass_flow({{}, 5e-5, 1.0, 6e5, 600.0, 0.0});
    const double mass = 6e5 * kVolume / (296.8 * 600.0);
    return std::pow(1.0 + 0.2 * flow / mass * sum * kEnd / (3.0 * n), -5.0);
  }
  /// Relative error of the mass left, on n chords of the path or on n parabolas.
  static double error(int n, bool parabolas) {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    model.vents.push_back({1.0, 5e-5});
    gas::ControlVolumeState state = gas::make_state(model.thermo, kPure, 6e5, 600.0, kVolume);
    const double start = state.masses[0];
    gas::GasIntegrator integrator(model, {1e-13});
    for (int i = 0; i < n; ++i) {
      const double t0 = kEnd * i / n, t1 = kEnd * (i + 1) / n, v0 = volume(t0), v1 = volume(t1);
      const double bulge = parabolas ? volume(0.5 * (t0 + t1)) - 0.5 * (v0 + v1) : 0.0;
      integrator.advance(state, t0, t1, {v0, v1, 0.0, 0.0, bulge});
    }
    EXPECT_GT(gas::evaluate(model, state, volume(kEnd), 0.0, kEnd).pressure, 2.0 * kAmbientPressure);
    return relative(state.masses[0] / start, mass_left());
  }
};

/// What leaves while the volume breathes: second order on chords, fourth on parabolas, whose error is odd
/// about the middle.
TEST(volume_path, breathing_volume_with_a_vent_converges_with_its_pieces) {
  const char* why = "the next term is (w h)^2 of the first: at 16 pieces a sixteenth";
  for (const auto& [parabolas, order] : {std::pair{false, 2.0}, {true, 4.0}}) {
    const char* what = parabolas ? "breathing volume with a vent, on parabolas: mass left"
                                 : "breathing volume with a vent, on chords: mass left";
    std::vector<double> errors;
    for (const int n : {16, 32, 64}) errors.push_back(BreathingTank::error(n, parabolas));
    claim::expect_order({"G.17", what, why}, errors, order - 0.125, order + 0.125);
  }
}

/// Expansion through p_a and compression back: outflow stops and starts again.
TEST(volume_path, expansion_below_ambient_closes_the_vent) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.vents.push_back({1.0, 1e-3});
  gas::ControlVolumeState state = gas::make_state(model.thermo, kPure, 1.1e5, 300.0, 0.06);
  gas::GasIntegrator integrator(model);
  EXPECT_GT(integrator.advance(state, 0.0, 0.01, {0.06, 0.09, 0.0, 0.0}).vent_mass_out, 0.0);
  EXPECT_EQ(integrator.advance(state, 0.01, 0.02, {0.09, 0.08, 0.0, 0.0}).vent_mass_out, 0.0);
  EXPECT_GT(integrator.advance(state, 0.02, 0.03, {0.08, 0.05, 0.0, 0.0}).vent_mass_out, 0.0);
  EXPECT_GT(gas::evaluate(model, state, 0.05, 0.0, 0.03).pressure, kAmbientPressure);
}

/// p below p_a at both ends of one step and above it in between (a falling inflow, a growing volume): the
/// outflow in the middle is not stepped over.
TEST(volume_path, peak_inside_one_step_is_found) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.inflows.push_back(
      {kPure, gas::Curve({{0.0, 0.1}, {0.01, 0.0}}, gas::Outside::zero), gas::Curve::constant(400.0)});
  model.vents.push_back({1.0, 1e-3});
  const double growth = 0.1 * 296.8 * 400.0 / (2.0 * kAmbientPressure);  // [m3/s] turns p after 5 ms
  int steps = 0;
  const auto outflow = [&](int n, double tolerance) {
    gas::GasIntegrator integrator(model, {tolerance});
    gas::ControlVolumeState state =
        gas::make_state(model.thermo, kPure, kAmbientPressure - 200.0, 300.0, 0.06);
    double out = 0.0;
    for (int i = 0; i < n; ++i) {
      const double t0 = 0.01 * i / n, t1 = 0.01 * (i + 1) / n;
      const gas::StepFluxes fluxes =
          integrator.advance(state, t0, t1, {0.06 + growth * t0, 0.06 + growth * t1, 0.0, 0.0});
      out += fluxes.vent_mass_out;
      steps = fluxes.steps;
    }
    EXPECT_LT(gas::evaluate(model, state, 0.06 + growth * 0.01, 0.0, 0.01).pressure, kAmbientPressure);
    return out;
  };
  const double fine = outflow(200, 1e-11), mass = 0.068;
  EXPECT_GT(fine, 1e-4 * mass);
  for (const double tolerance : {1e-5, 1e-7, 1e-9}) {
    const double coarse = outflow(1, tolerance);
    // Each sub-step within its tolerance of the mass; the error estimate, made for smooth rates, falls short
    // by up to 3 where the outflow begins as a square root.
    EXPECT_NEAR(coarse, fine, 3.0 * steps * tolerance * mass) << tolerance;
    EXPECT_LT(steps, 60);
  }
}

/// Relative error of p where vent, leak area, volume, inflow and walls all move: the implicit method's matrix
/// and its derivative with time meet every term.
double moving_error(const gas::IntegratorOptions& options) {
  gas::ControlVolumeModel model = closed_tank(nasa7({"N2", "CO2"}));
  model.vents.push_back({0.8, 0.0, gas::Curve({{0.0, 2e-4}, {1.0, 1e-2}}, gas::Outside::held)});
  model.inflows.push_back({{0.3, 0.7},
                           gas::Curve({{0.0, 0.2}, {1.0, 4.0}}, gas::Outside::zero),
                           gas::Curve({{0.0, 700.0}, {1.0, 900.0}}, gas::Outside::held)});
  model.heat_loss = {300.0, 400.0};
  const auto pressure = [&](const gas::IntegratorOptions& chosen) {
    gas::ControlVolumeState state = gas::make_state(model, std::vector{0.6, 0.4}, 5e5, 800.0, 0.06);
    gas::GasIntegrator(model, chosen).advance(state, 0.0, 0.05, {0.06, 0.08, 1e-4, 2e-3, 0.002});
    return gas::evaluate(model, state, 0.08, 2e-3, 0.05).pressure;
  };
  return relative(pressure(options), pressure({1e-13}));
}

TEST(volume_path, implicit_order_holds_where_everything_moves) {
  std::vector<double> errors;
  for (const int steps : {16, 32, 64})
    errors.push_back(moving_error({1e-10, 100000, gas::Method::rosenbrock_4, 0.05 / steps}));
  claim::expect_order({"G.23", "Rosenbrock 4, vent, leak, volume, inflow and walls that move: pressure",
                       "the fifth order's term is a share of 1 / steps"},
                      errors, 3.8, 4.3);
}

}  // namespace
