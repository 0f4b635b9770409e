// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <random>

#include "cases.hpp"
#include "claim.hpp"

// Evacuated tanks with walls, into which gas jumps on late: the same as if it did so at t = 0. The first gas
// has no heat capacity, and relaxes with the walls within far less than the rounding of a late time.
namespace {

using namespace cases;
using gas::Curve;
using gas::Outside;

struct Tank {
  gas::ControlVolumeModel model;  // its inflow starts at t = 0
  double volume, end;             // [m3], [s] of what is computed, from the jump on
};

class Dice {
 public:
  explicit Dice(unsigned seed) : generator_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(generator_() >> 11) * 0x1p-53;
  }
  double by_ratio(double low, double high) { return low * std::pow(high / low, between(0.0, 1.0)); }
  bool chance(double share) { return between(0.0, 1.0) < share; }

 private:
  std::mt19937_64 generator_;
};

/// 1 to 100 litres, walls of 0.1 to 100 W/K, one or two inflows of 1 g/s to 1 kg/s that last 1 to 50 ms and
/// jump or ramp on, a vent in half of them, gas of constant cp in a third.
Tank random_tank(unsigned seed) {
  Dice dice(seed);
  const bool constant = dice.chance(0.33);
  gas::ControlVolumeModel model =
      closed_tank(constant ? gas::Thermo({gas::constant_cp_species("N2", 296.8, 1038.8),
                                          gas::constant_cp_species("He", 2077.1, 5192.8)})
                           : nasa7({"N2", "He"}));
  model.ambient.pressure = dice.chance(0.5) ? 0.0 : 1e5;
  model.heat_loss = {dice.by_ratio(0.1, 100.0), dice.between(250.0, 600.0)};
  const double duration = dice.by_ratio(1e-3, 0.05);
  const int inflows = dice.chance(0.3) ? 2 : 1;
  for (int i = 0; i < inflows; ++i) {
    const double flow = dice.by_ratio(1e-3, 1.0), share = dice.between(0.0, 1.0);
    const double first = dice.chance(0.75) ? flow : 0.0;
    model.inflows.push_back(
        {{share, 1.0 - share},
         Curve({{0.0, first}, {dice.between(0.1, 0.9) * duration, flow}, {duration, 0.0}}, Outside::zero),
         Curve({{0.0, dice.between(300.0, 1100.0)}, {duration, dice.between(300.0, 1100.0)}},
               Outside::held)});
  }
  if (dice.chance(0.5)) {
    gas::Vent vent{0.6, dice.by_ratio(1e-6, 1e-3)};
    model.vents.push_back(vent);
  }
  return {model, dice.by_ratio(1e-3, 0.1), 3.0 * duration};
}

struct Ended {
  gas::GasPoint point;
  gas::StepFluxes fluxes;
};

/// From t = 0 to `start` nothing flows; then the tank's inflow begins.
Ended run(const Tank& tank, double start) {
  gas::ControlVolumeModel model = tank.model;
  for (gas::Inflow& inflow : model.inflows) inflow.start_time = start;
  gas::ControlVolumeState state =
      gas::make_state(model.thermo, std::vector<double>{1.0, 0.0}, 0.0, 300.0, tank.volume);
  gas::GasIntegrator integrator(model);
  if (start > 0.0) integrator.advance(state, 0.0, 0.5 * start, rigid(tank.volume));
  const double end = start + tank.end;
  const gas::StepFluxes fluxes = integrator.advance(state, 0.5 * start, end, rigid(tank.volume));
  return {gas::evaluate(model, state, tank.volume, 0.0, end), fluxes};
}

/// 80 tanks at four starts. A sub-step errs by 1e-10 of the gas, and the order of a hundred of them are
/// taken; where they end differs with the rounding of the start.
TEST(late_jump, evacuated_tank_is_that_of_a_start_at_zero) {
  constexpr double kTolerance = 1e-8;
  for (unsigned seed = 1; seed <= 80; ++seed) {
    const Tank tank = random_tank(seed);
    const Ended zero = run(tank, 0.0);
    for (const double start : {5e-3, 0.0123456789, 1.0, 1000.0}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", start " << start);
      try {
        const Ended late = run(tank, start);
        // The rounding of the start moves what is seen of a gas that still changes.
        const double rounding = 10.0 * kEpsilon * start / tank.end;
        EXPECT_LT(relative(late.point.pressure, zero.point.pressure), kTolerance + rounding);
        EXPECT_LT(relative(late.point.temperature, zero.point.temperature), kTolerance + rounding);
        EXPECT_LT(relative(late.fluxes.mass_in, zero.fluxes.mass_in), 1e-12);
      } catch (const std::exception& error) {
        ADD_FAILURE() << error.what();
      }
    }
  }
}

/// 0.06 m3, walls of 20 W/K at 300 K, 0.1 kg/s of nitrogen at 700 K that fall to zero in 10 ms. The reference
/// is SciPy's Radau at 1e-12, from t = 0.
TEST(late_jump, tank_of_nitrogen_eq_reference) {
  gas::ControlVolumeModel model = closed_tank(nasa7({"N2"}));
  model.heat_loss = {20.0, 300.0};
  model.inflows.push_back({kPure, Curve({{0.0, 0.1}, {0.01, 0.0}}, Outside::zero), Curve::constant(700.0)});
  for (const double start : {0.0, 0.01, 0.3, 1e4}) {
    model.inflows[0].start_time = start;
    gas::ControlVolumeState state = gas::make_state(model.thermo, kPure, 0.0, 300.0, 0.06);
    gas::GasIntegrator(model).advance(state, start - 0.01, start + 0.05, rigid(0.06));
    const gas::GasPoint end = gas::evaluate(model, state, 0.06, 0.0, start + 0.05);
    const double tolerance = 1e-8 + 10.0 * kEpsilon * start / 0.05;
    EXPECT_LT(relative(end.pressure, 867.66275499), tolerance) << start;
    EXPECT_LT(relative(end.temperature, 350.81095), tolerance) << start;
  }
}

/// Gas that comes in too hot leaves the range of its polynomials, whatever else the tank has.
TEST(late_jump, gas_too_hot_is_beyond_its_range) {
  for (const double start : {0.0, 0.01, 10.0})
    for (const double walls : {0.0, 0.01, 20.0})
      for (const double vent : {0.0, 1e-4, 1e-2})
        for (const double ambient : {0.0, 1e5}) {
          gas::ControlVolumeModel model = closed_tank(nasa7({"N2"}));
          model.ambient.pressure = ambient;
          model.heat_loss = {walls, 300.0};
          model.inflows.push_back(
              {kPure, Curve({{0.0, 0.5}, {0.01, 0.5}}, Outside::zero), Curve::constant(5900.0), start});
          if (vent > 0.0) model.vents.push_back({0.6, vent});
          gas::ControlVolumeState state = gas::make_state(model.thermo, kPure, 0.0, 300.0, 0.06);
          SCOPED_TRACE(testing::Message() << start << ' ' << walls << ' ' << vent << ' ' << ambient);
          try {
            gas::GasIntegrator(model).advance(state, 0.0, start + 0.05, rigid(0.06));
            ADD_FAILURE() << "no error";
          } catch (const gas::DomainError& error) {
            EXPECT_NE(std::string(error.what()).find("temperature range, 200 to 6000 K"), std::string::npos)
                << error.what();
          }
        }
}

}  // namespace
