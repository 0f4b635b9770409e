// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "cases.hpp"

// Volumes through which far more passes than they hold.
namespace {

using namespace cases;

/// A weak inflow of nitrogen into a volume behind much porous fabric, as in cases/tank_stiff.toml; the gas
/// there may be half carbon dioxide at first.
struct Leaky {
  double volume, leak_area, mass_flow;
  bool mixed = false;
  static constexpr double kInflowTemperature = 406.0;

  gas::Thermo thermo() const { return mixed ? nasa7({"N2", "CO2"}) : nitrogen(); }
  gas::GasPoint run(const gas::IntegratorOptions& options, int calls, double length, double& mass_out,
                    int& steps) const {
    gas::ControlVolumeModel model = closed_tank(thermo());
    model.inflows.push_back(steady_inflow(model.thermo, mass_flow, kInflowTemperature));
    const std::vector<double> begin = mixed ? std::vector{0.5, 0.5} : kPure;
    gas::ControlVolumeState state = gas::make_state(model, begin, kAmbientPressure, 293.15, volume);
    gas::GasIntegrator integrator(model, options);
    for (int i = 0; i < calls; ++i) {
      const gas::StepFluxes f =
          integrator.advance(state, length * i, length * (i + 1), rigid(volume, leak_area));
      mass_out += f.fabric_mass_out;
      steps += f.steps;
    }
    if (mixed) {
      EXPECT_LT(state.masses[1], options.relative_tolerance * state.masses[0]);
    }
    return gas::evaluate(model, state, volume, leak_area, 0.0);
  }
  /// Overpressure [Pa] at which what enters leaves, mdot = C sqrt(2 rho dp) with rho of p and T_in.
  double excess() const {
    const double rt = thermo().gas_constant(0) * kInflowTemperature,
                 x = mass_flow * mass_flow * rt / (2.0 * leak_area * leak_area);
    return 2.0 * x / (kAmbientPressure + std::sqrt(kAmbientPressure * kAmbientPressure + 4.0 * x));
  }
};

TEST(stiff, implicit_method_has_the_balance_in_any_volume_at_any_tolerance) {
  for (const bool mixed : {false, true})
    for (const double tolerance : {1e-4, 1e-6, 1e-9}) {
      int of_largest = 0;
      for (const double volume : {1e-6, 1e-8, 1e-10, 1e-12, 1e-15}) {
        SCOPED_TRACE(testing::Message() << mixed << ' ' << volume << " m3 at " << tolerance);
        const Leaky tank{volume, 3.75e-3, 0.02, mixed};
        double out = 0.0;
        int steps = 0;
        const gas::GasPoint end =
            tank.run({tolerance, 100000, gas::Method::kRosenbrock4}, 20, 1e-3, out, steps);
        // Of the whole: the tolerance of a sub-step, of which the gas keeps only the last few.
        EXPECT_NEAR(end.pressure - kAmbientPressure, tank.excess(), 5.0 * tolerance * kAmbientPressure);
        EXPECT_LT(relative(end.temperature, Leaky::kInflowTemperature), 5.0 * tolerance);
        EXPECT_NEAR(out, 4e-4, 4e-4 * 1e-12 + end.mass);  // all that came but what is there
        // Each call begins within the relaxation, 1/V of it, from where sub-steps grow by 5 at most: half as
        // many again for those that the error lets grow by less. Following it takes 1e15 sub-steps in the
        // smallest.
        if (volume == 1e-6) of_largest = steps;
        EXPECT_LE(steps, of_largest + 20 * 1.5 * std::log(1e-6 / volume) / std::log(5.0));
      }
    }
}

TEST(stiff, overpressure_of_a_tiny_volume_has_its_digits) {
  // At 1e-8 of p the overpressure of 17 Pa is right to 6e-5; the sub-step's tolerance is of p.
  for (const double volume : {1e-6, 1e-8, 1e-10}) {
    const Leaky tank{volume, 3.75e-3, 0.02};
    double out = 0.0;
    int steps = 0;
    const gas::GasPoint end = tank.run({1e-8, 2000, gas::Method::kRosenbrock4}, 20, 1e-3, out, steps);
    EXPECT_LT(relative(end.pressure - kAmbientPressure, tank.excess()),
              1e-8 * kAmbientPressure / tank.excess());
    EXPECT_LT(relative(end.fabric_mass_flow, 0.02), 1e-8 * kAmbientPressure / tank.excess());
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
    gas::GasIntegrator integrator(model, {1e-10, 100000, gas::Method::kEuler, share * limit});
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
      EXPECT_NE(std::string(error.what()).find("stability limit"), std::string::npos) << error.what();
    }
  }
}

/// At the very ends of the range of the coefficients, from where the walls lead inward; in a rigid volume and
/// in one that gives way.
TEST(range_end, every_method_starts_there) {
  for (const auto& [begin, walls, pressure, soft] : {std::tuple{200.0, 1000.0, 1.0, false},
                                                     {6000.0, 300.0, 1.0, false},
                                                     {200.0, 1000.0, 1.2, true},
                                                     {6000.0, 300.0, 1.0, true}}) {
    gas::ControlVolumeModel model = closed_tank(nasa7({"N2", "CO2"}));
    model.vents.push_back({1.0, 1e-3});
    model.heat_loss = {180.0, walls};
    if (soft) model.volume_of_overpressure = gas::Curve({{0.0, 0.06}, {1e6, 0.6}}, gas::Outside::kHeld);
    const std::vector<double> half{0.5, 0.5};
    std::vector<double> ends;
    for (const gas::Method method : kMethods) {
      gas::ControlVolumeState state = gas::make_state(model, half, pressure * kAmbientPressure, begin, 0.06);
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
  gas::GasIntegrator integrator(model, {1e-4, 100000, gas::Method::kRosenbrock4});
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
