// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "cases.hpp"

// Volumes through which far more passes than they hold, and balances closer to p_a than p can tell.
namespace {

using namespace cases;

/// A weak inflow into a volume behind much porous fabric, as in cases/tank_stiff.toml.
struct Leaky {
  double volume, leak_area, mass_flow;
  static constexpr double kInflowTemperature = 406.0;

  gas::GasPoint run(const gas::IntegratorOptions& options, int calls, double length, double& mass_out) const {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    model.inflows.push_back(steady_inflow(model.thermo, mass_flow, kInflowTemperature));
    gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure, 293.15, volume);
    gas::GasIntegrator integrator(model, options);
    for (int i = 0; i < calls; ++i)
      mass_out +=
          integrator.advance(state, length * i, length * (i + 1), rigid(volume, leak_area)).fabric_mass_out;
    return gas::evaluate(model, state, volume, leak_area, 0.0);
  }
  /// Overpressure [Pa] at which what enters leaves, mdot = C sqrt(2 rho dp) with rho of p and T_in.
  double excess() const {
    const double rt = 296.8 * kInflowTemperature,
                 x = mass_flow * mass_flow * rt / (2.0 * leak_area * leak_area);
    return 2.0 * x / (kAmbientPressure + std::sqrt(kAmbientPressure * kAmbientPressure + 4.0 * x));
  }
};

TEST(stiff, implicit_method_has_the_balance_in_any_volume_at_any_tolerance) {
  for (const double volume : {1e-6, 1e-7, 1e-8})
    for (const double tolerance : {1e-4, 1e-6, 1e-9}) {
      SCOPED_TRACE(testing::Message() << volume << " m3 at " << tolerance);
      const Leaky tank{volume, 3.75e-3, 0.02};
      double out = 0.0;
      // Following the relaxation takes 1e9 sub-steps in the smallest.
      const gas::GasPoint end = tank.run({tolerance, 2000, gas::Method::rosenbrock_4}, 20, 1e-3, out);
      // Of the whole: the tolerance of a sub-step, of which the gas keeps only the last few, or the rounding
      // of what passes in a call, 2e-5 kg, some ten times.
      const double passes = 2e-5 * Leaky::kInflowTemperature * 296.8 / (kAmbientPressure * volume);
      const double bound = 5.0 * tolerance + 10.0 * kEpsilon * passes;
      EXPECT_NEAR(end.pressure - kAmbientPressure, tank.excess(), bound * kAmbientPressure);
      EXPECT_LT(relative(end.temperature, Leaky::kInflowTemperature), bound);
      EXPECT_NEAR(out, 4e-4, 4e-4 * 1e-9 + end.mass);  // all that came but what is there
    }
}

TEST(stiff, overpressure_of_a_tiny_volume_has_its_digits) {
  // At 1e-8 of p the overpressure of 17 Pa is right to 6e-5; the sub-step's tolerance is of p.
  for (const double volume : {1e-6, 1e-8, 1e-10}) {
    const Leaky tank{volume, 3.75e-3, 0.02};
    double out = 0.0;
    const gas::GasPoint end = tank.run({1e-8, 2000, gas::Method::rosenbrock_4}, 20, 1e-3, out);
    EXPECT_LT(relative(end.pressure - kAmbientPressure, tank.excess()),
              1e-8 * kAmbientPressure / tank.excess());
    EXPECT_LT(relative(end.fabric_mass_flow, 0.02), 1e-8 * kAmbientPressure / tank.excess());
  }
}

/// Inflow of 300 K into 60 litres of 900 K behind openings so wide that p stays on p_a: what comes in leaves,
/// at T. p V is held, so m' = mdot (1 - m/M), M = m at 300 K.
struct WideOpen {
  double vent, leak_area;
  double mass(double t) const {
    const double last = kAmbientPressure * 0.06 / (296.8 * 300.0);
    return last * (1.0 - std::exp(-0.36 * t / last) * (1.0 - 300.0 / 900.0));
  }
  gas::GasPoint run(const gas::IntegratorOptions& options, gas::StepFluxes& fluxes) const {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    model.inflows.push_back(steady_inflow(model.thermo, 0.36, 300.0));
    model.vents.push_back({1.0, vent});
    model.vents.push_back({0.5, vent});
    gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure, 900.0, 0.06);
    fluxes = gas::GasIntegrator(model, options).advance(state, 0.0, 0.1, rigid(0.06, leak_area));
    fluxes.inflows = fluxes.outflows = fluxes.backflows = {};
    return gas::evaluate(model, state, 0.06, leak_area, 0.1);
  }
};

TEST(rest_at_ambient, wide_openings_keep_ambient_pressure) {
  for (const auto& [vent, leak] : {std::pair{200.0, 0.0}, {0.0, 200.0}, {100.0, 100.0}})
    for (const gas::Method method : {gas::Method::dormand_prince_5, gas::Method::rosenbrock_4}) {
      SCOPED_TRACE(testing::Message()
                   << vent << " m2, " << leak << " m2, method " << static_cast<int>(method));
      const WideOpen tank{vent, leak};
      const double tolerance = 1e-10;
      gas::StepFluxes f{};
      // Explicit sub-steps at the balance would be 1e-11 s.
      const gas::GasPoint end = tank.run({tolerance, 5000, method}, f);
      // p V stays, so errors of m damp as m itself, t/tau = 0.5: at most some hundred sub-steps times the
      // tolerance; and 1e-8, the laminar range.
      EXPECT_LT(relative(end.mass, tank.mass(0.1)), 100.0 * tolerance + 1e-8);
      EXPECT_NEAR(end.pressure, kAmbientPressure, 1e-8 * kAmbientPressure);
      EXPECT_GT(end.pressure, kAmbientPressure);
      // The books: what came less what is there; vents and fabric by their areas, two vents and a half of
      // one.
      const double out = 0.036 + tank.mass(0.0) - end.mass;
      EXPECT_NEAR(f.vent_mass_out + f.fabric_mass_out, out, 1e-12);
      EXPECT_NEAR(f.vent_mass_out, out * 1.5 * vent / (1.5 * vent + leak), 1e-9 * out);
    }
}

/// The instant's outflow, which a difference of 1e-4 Pa drives, is still what comes in: to the rounding of p
/// in it, which laminar flow doubles.
TEST(rest_at_ambient, outflow_of_the_instant_is_what_comes_in) {
  gas::StepFluxes f{};
  const gas::GasPoint end = WideOpen{200.0, 0.0}.run({1e-10, 5000}, f);
  // 0.36 kg/s of 300 K drive out as much volume, so mass 300/T of it.
  const double flow = 0.36 * 300.0 / end.temperature, excess = end.pressure - kAmbientPressure;
  EXPECT_LT(relative(end.vent_mass_flow, flow), 2.0 * 10.0 * kEpsilon * kAmbientPressure / excess);
}

/// An inflow that grows from nothing and fades again, through openings that carry it at the end of the
/// laminar range: p follows the balance, up and down.
TEST(rest_at_ambient, balance_follows_a_pulse) {
  for (const gas::Method method : {gas::Method::dormand_prince_5, gas::Method::rosenbrock_4}) {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    model.vents.push_back({1.0, 0.02});
    gas::Inflow inflow = steady_inflow(model.thermo, 0.0, 300.0);
    inflow.mass_flow = gas::Curve({{0.0, 0.0}, {0.01, 1e-3}, {0.02, 0.0}}, gas::Outside::zero);
    model.inflows.push_back(inflow);
    gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure, 300.0, 0.06);
    gas::GasIntegrator integrator(model, {1e-12, 100000, method});
    const double density = kAmbientPressure / (296.8 * 300.0);
    for (int i = 0; i < 4; ++i) {
      const double begin = 5e-3 * i, end = 5e-3 * (i + 1);
      const gas::StepFluxes f = integrator.advance(state, begin, end, rigid(0.06));
      const double flow = 0.1 * std::min(end, 0.02 - end),
                   excess = laminar(std::pow(flow / 0.02, 2.0) / (2.0 * density));
      // p lags by (p - p_a)/growth V, some 1e-5 s, in which the flow changes by less than 1 %.
      EXPECT_NEAR(gas::evaluate(model, state, 0.06, 0.0, end).pressure - kAmbientPressure, excess,
                  0.02 * excess + 1e-9 * kAmbientPressure)
          << i;
      const double in = i == 0 || i == 3 ? 1.25e-6 : 3.75e-6;
      EXPECT_NEAR(f.mass_in, in, 1e-12 * in);
      EXPECT_NEAR(f.vent_mass_out, in, 1e-8 * 0.06 * density) << i;
    }
  }
}

/// Walls cool the gas behind a vent with backflow to their temperature, cases/tank_backflow.toml in small:
/// air comes in until both are alike. Once m cv/(hA) has passed many times over p = p_a and T = T_w, to a
/// tenth of the laminar range.
TEST(rest_at_ambient, backflow_fades_to_rest_in_any_volume) {
  for (const double volume : {1e-3, 1e-6, 1e-9})
    for (const double tolerance : {1e-4, 1e-6, 1e-9}) {
      SCOPED_TRACE(testing::Message() << volume << " m3 at " << tolerance);
      gas::ControlVolumeModel model = closed_tank(nitrogen());
      model.ambient.mass_fractions = kPure;
      model.vents.push_back({0.8, 5e-4});
      model.vents.back().backflow = true;
      model.heat_loss = {180.0, 293.15};
      gas::ControlVolumeState state = gas::make_state(model, kPure, 2e5, 900.0, volume);
      gas::GasIntegrator integrator(model, {tolerance, 2000, gas::Method::rosenbrock_4});
      for (int i = 0; i < 50; ++i) integrator.advance(state, 1e-2 * i, 1e-2 * (i + 1), rigid(volume));
      EXPECT_LT(relative(state.temperature, 293.15), 1e-9);
      EXPECT_LT(relative(gas::evaluate(model, state, volume, 0.0, 0.5).pressure, kAmbientPressure), 1e-9);
    }
}

/// A balance by backflow relaxes as one by outflow does: a fixed step past the limit is refused with it.
TEST(stiff, fixed_steps_past_the_limit_of_backflow_are_refused) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.ambient.mass_fractions = kPure;
  model.vents.push_back({1.0, 1e-3});
  model.vents.back().backflow = true;
  // A volume that grows by 1e-3 m3/s draws in as much air, through the hole at (Q/A)^2 rho/2 = 0.6 Pa below
  // p_a.
  const double rt = 296.8 * 293.15, density = kAmbientPressure / rt, drop = 0.5 * density;
  const double limit = 2.0 / (1.4 * kAmbientPressure * 1e-3 / (2.0 * drop * 0.06));  // V dp/dt = gamma p Q
  for (const double share : {0.8, 1.2}) {
    gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure - drop, 293.15, 0.06);
    gas::GasIntegrator integrator(model, {1e-10, 100000, gas::Method::euler, share * limit});
    const auto run = [&] {
      integrator.advance(state, 0.0, 20.0 * limit, {0.06, 0.06 + 0.02 * limit, 0.0, 0.0});
    };
    if (share < 1.0) {
      EXPECT_NO_THROW(run());
      continue;
    }
    try {
      run();
      FAIL() << "no error";
    } catch (const gas::DomainError& error) {
      const std::string text = error.what(), words = "stability limit ";
      ASSERT_NE(text.find(words), std::string::npos) << text;
      const double named = std::stod(text.substr(text.find(words) + words.size()));
      EXPECT_LE(named, limit) << text;  // three digits, rounded down
      EXPECT_GE(named, 0.99 * limit) << text;
    }
  }
}

/// At the very ends of the range of the coefficients, from where the walls lead inward.
TEST(range_end, every_method_starts_there) {
  for (const auto& [begin, walls] : {std::pair{200.0, 1000.0}, {6000.0, 300.0}}) {
    gas::ControlVolumeModel model = closed_tank(nasa7({"N2", "CO2"}));
    model.vents.push_back({1.0, 1e-3});
    model.heat_loss = {180.0, walls};
    const std::vector<double> half{0.5, 0.5};
    std::vector<double> ends;
    for (const gas::Method method : kMethods) {
      gas::ControlVolumeState state = gas::make_state(model, half, kAmbientPressure, begin, 0.06);
      gas::GasIntegrator(model, {1e-8, 1000000, method}).advance(state, 0.0, 0.01, rigid(0.06));
      ends.push_back(state.temperature);
    }
    // Euler's sub-steps of 1e-4 are the fewest digits; the others' some ten of 1e-8 each.
    EXPECT_LT(relative(ends[1], ends[0]), 1e-6);
    EXPECT_LT(relative(ends[3], ends[0]), 1e-6);
    EXPECT_LT(relative(ends[2], ends[0]), 1e-3);
  }
}

/// The streams carry the mass that the gas loses, however stiff: the implicit method knows its matrix to 1e-7
/// only.
TEST(stiff, streams_add_up) {
  gas::ControlVolumeModel model = closed_tank(nasa7({"N2", "CO2"}));
  model.inflows.push_back({{0.4, 0.6}, gas::Curve::constant(0.5), gas::Curve::constant(900.0)});
  for (const double area : {1.0, 0.2}) model.vents.push_back({0.7, area});
  gas::ControlVolumeState state =
      gas::make_state(model, std::vector{1.0, 0.0}, kAmbientPressure, 300.0, 0.06);
  double mass = state.masses[0] + state.masses[1], energy = state.internal_energy, scale = 0.0;
  gas::GasIntegrator integrator(model, {1e-4, 100000, gas::Method::rosenbrock_4});
  for (int i = 0; i < 50; ++i) {
    const gas::StepFluxes f = integrator.advance(state, 2e-3 * i, 2e-3 * (i + 1), rigid(0.06, 0.5));
    mass += f.mass_in - f.vent_mass_out - f.fabric_mass_out;
    energy += f.enthalpy_in - f.enthalpy_out;
    scale += std::abs(f.enthalpy_in) + std::abs(f.enthalpy_out);
    // Areas 1 to 0.2: as well as the matrix is known, 1e-7, of the 1 % by which the gas changes in a
    // sub-step.
    EXPECT_NEAR(f.outflows[0].mass, 5.0 * f.outflows[1].mass, 1e-9 * f.outflows[0].mass);
  }
  // A thousand roundings of what passed.
  EXPECT_NEAR(state.masses[0] + state.masses[1], mass, 1e-13 * 0.05);
  EXPECT_NEAR(state.internal_energy, energy, 1e-13 * scale);
}

}  // namespace
