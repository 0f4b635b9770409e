// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <functional>
#include <numeric>
#include <random>
#include <string>

#include "cases.hpp"

// Gas that starts at ambient pressure, as that of every bag does, and then cools, expands or is compressed.
namespace {

using namespace cases;

constexpr double kVolume = 0.06, kEnd = 0.05;  // [m3], [s]
constexpr int kAmbientSteps = 50;

struct Ended {
  gas::ControlVolumeState state;
  gas::GasPoint end;
  double residual;  // of mass or energy, the larger, over the sum of the terms' magnitudes
};

/// kAmbientSteps steps from p_a and `temperature`, each end looked at by evaluate() too.
Ended run(const gas::ControlVolumeModel& model, const std::vector<double>& fractions, double temperature,
          const std::function<double(double)>& volume, double leak_area) {
  gas::GasIntegrator integrator(model);
  gas::ControlVolumeState state =
      gas::make_state(model, fractions, model.ambient.pressure, temperature, volume(0.0));
  const auto mass = [&] { return std::accumulate(state.masses.begin(), state.masses.end(), 0.0); };
  double mass_sum = mass(), mass_size = mass_sum, energy_sum = state.internal_energy,
         energy_size = std::abs(energy_sum);
  gas::GasPoint point{};
  for (int i = 0; i <= kAmbientSteps; ++i) {
    const double t0 = kEnd * i / kAmbientSteps, t1 = kEnd * (i + 1) / kAmbientSteps;
    point = gas::evaluate(model, state, volume(t0), leak_area, t0);
    if (i == kAmbientSteps) break;
    const gas::StepFluxes f =
        integrator.advance(state, t0, t1, {volume(t0), volume(t1), leak_area, leak_area});
    for (const double m : {f.mass_in, f.backflow_mass, -f.vent_mass_out, -f.fabric_mass_out})
      mass_sum += m, mass_size += std::abs(m);
    for (const double e : {f.enthalpy_in, f.backflow_enthalpy, -f.enthalpy_out, -f.work, -f.heat})
      energy_sum += e, energy_size += std::abs(e);
  }
  return {state, point,
          std::max(std::abs(mass() - mass_sum) / mass_size,
                   std::abs(state.internal_energy - energy_sum) / energy_size)};
}

/// What lets gas out but not in: it must make no difference below p_a.
struct Opening {
  const char* name;
  double vent_area, leak_area;  // [m2]
};

void PrintTo(const Opening& opening, std::ostream* out) {
  *out << opening.name;
}

class start_at_ambient : public testing::TestWithParam<Opening> {
 protected:
  gas::ControlVolumeModel tank() const {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    if (GetParam().vent_area > 0.0) model.vents.push_back({1.0, GetParam().vent_area});
    return model;
  }
};

// m cv dT/dt = -h A (T - T_ext), nothing flows.
TEST_P(start_at_ambient, hot_gas_cools_exponentially) {
  gas::ControlVolumeModel model = tank();
  model.heat_loss = {50.0, 300.0};
  const double mass = kAmbientPressure * kVolume / (296.8 * 600.0);
  const double exact = 300.0 + 300.0 * std::exp(-50.0 * kEnd / (mass * 742.0));
  const Ended cooled = run(
      model, kPure, 600.0, [](double) { return kVolume; }, GetParam().leak_area);
  EXPECT_NEAR(cooled.end.temperature, exact, 1e-8 * exact);
  EXPECT_NEAR(cooled.end.pressure, kAmbientPressure * exact / 600.0, 1e-8 * kAmbientPressure);
  EXPECT_EQ(cooled.end.vent_mass_flow + cooled.end.fabric_mass_flow, 0.0);
  EXPECT_LE(cooled.residual, 1e-14);
}

// p V^gamma stays, nothing flows.
TEST_P(start_at_ambient, growing_volume_expands_isentropically) {
  const Ended grown = run(
      tank(), kPure, 600.0, [](double t) { return kVolume * (1.0 + 10.0 * t); }, GetParam().leak_area);
  EXPECT_NEAR(grown.end.pressure, kAmbientPressure * std::pow(1.5, -1.4), 1e-8 * kAmbientPressure);
  EXPECT_NEAR(grown.end.temperature, 600.0 * std::pow(1.5, -0.4), 1e-8 * 600.0);
}

// Of a volume that has to grow first, then shrinks: p comes back to p_a from below, and goes above it.
TEST_P(start_at_ambient, wave_comes_back_to_ambient_pressure) {
  const auto wave = [](double t) { return kVolume * (1.0 + 0.2 * std::sin(40.0 * M_PI * t)); };
  const Ended waved = run(tank(), kPure, 600.0, wave, GetParam().leak_area);
  const double none = GetParam().vent_area + GetParam().leak_area;
  const double mass = kAmbientPressure * kVolume / (296.8 * 600.0);
  if (none == 0.0) {
    EXPECT_NEAR(waved.end.mass, mass, 1e-14 * mass);
  } else {
    EXPECT_LT(waved.end.mass, mass);
  }
  EXPECT_LE(waved.residual, 1e-14);
}

// Below its first knot a volume by pressure is held there: a rigid one.
TEST_P(start_at_ambient, soft_volume_cools_as_a_rigid_one) {
  gas::ControlVolumeModel model = tank();
  model.heat_loss = {50.0, 300.0};
  model.volume_of_overpressure = gas::Curve({{0.0, kVolume}, {5e4, 2.0 * kVolume}}, gas::Outside::held);
  const double mass = kAmbientPressure * kVolume / (296.8 * 600.0);
  const double exact = 300.0 + 300.0 * std::exp(-50.0 * kEnd / (mass * 742.0));
  const Ended cooled = run(
      model, kPure, 600.0, [](double) { return kVolume; }, GetParam().leak_area);
  EXPECT_NEAR(cooled.end.temperature, exact, 1e-8 * exact);
}

INSTANTIATE_TEST_SUITE_P(openings, start_at_ambient,
                         testing::Values(Opening{"sealed", 0.0, 0.0}, Opening{"vent", 1e-3, 0.0},
                                         Opening{"fabric", 0.0, 1e-3}, Opening{"both", 1e-4, 1e-4}),
                         [](const auto& opening) { return std::string(opening.param.name); });

/// Random numbers whose bits no library decides.
struct Dice {
  std::mt19937_64 engine;
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
  }
  double log_between(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
  bool one_in(int n) { return engine() % static_cast<unsigned>(n) == 0; }
};

// Any tank that begins at p_a ends with its balances closed, or says that its temperature leaves the range.
TEST(random_tanks, at_ambient_pressure_end_or_name_the_temperature) {
  int done = 0;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice{std::mt19937_64(seed)};
    const gas::Thermo thermo = dice.one_in(2)   ? nasa7({"N2"})
                               : dice.one_in(2) ? nasa7({"N2", "He", "CO2"})
                                                : nitrogen();
    std::vector<double> start(thermo.size(), 0.0), air(thermo.size(), 0.0);
    start[dice.engine() % thermo.size()] = 1.0;
    air[0] = 1.0;
    gas::ControlVolumeModel model = closed_tank(thermo);
    model.ambient.temperature = dice.between(250.0, 350.0);
    const double leak_area = dice.one_in(2) ? dice.log_between(1e-6, 1e-2) : 0.0;
    for (int vents = static_cast<int>(dice.engine() % 3); vents > 0; --vents) {
      model.vents.push_back({0.7, dice.log_between(1e-6, 1e-2)});
      model.vents.back().backflow = dice.one_in(3);
      if (model.vents.back().backflow) model.ambient.mass_fractions = air;
    }
    if (dice.one_in(2)) model.heat_loss = {dice.log_between(0.1, 100.0), dice.between(250.0, 1500.0)};
    if (dice.one_in(3)) {
      model.inflows.push_back(steady_inflow(thermo, dice.log_between(1e-3, 1.0), dice.between(300.0, 900.0)));
      model.inflows.back().start_time = dice.between(0.0, kEnd);
    }
    const double size = dice.log_between(1e-3, 1.0), growth = dice.one_in(2) ? dice.between(-8.0, 8.0) : 0.0,
                 wave = dice.one_in(3) ? dice.between(-0.2, 0.2) : 0.0;
    const auto volume = [&](double t) {
      return size * (1.0 + growth * t) * (1.0 + wave * std::sin(200.0 * t));
    };
    try {
      const Ended end_state = run(model, start, dice.between(300.0, 1500.0), volume, leak_area);
      EXPECT_LE(end_state.residual, 1e-12);
      EXPECT_TRUE(std::isfinite(end_state.end.pressure) && end_state.end.pressure > 0.0);
      ++done;
    } catch (const gas::DomainError& error) {
      EXPECT_NE(std::string(error.what()).find("leaves its temperature range"), std::string::npos)
          << error.what();
    }
  }
  EXPECT_GE(done, 285);
}

/// Gas that leaves its range behind an open vent.
std::string refusal(gas::Method method, double pressure, double temperature, double conductance) {
  gas::ControlVolumeModel model = closed_tank(nasa7({"N2"}));
  model.vents.push_back({1.0, 1e-3});
  model.heat_loss = {conductance, 7000.0};
  gas::IntegratorOptions options;
  options.method = method;
  gas::GasIntegrator integrator(model, options);
  gas::ControlVolumeState state = gas::make_state(model, kPure, pressure, temperature, kVolume);
  try {
    for (int i = 0; i < 1000; ++i) integrator.advance(state, 1e-3 * i, 1e-3 * (i + 1), rigid(kVolume));
  } catch (const gas::DomainError& error) {
    return error.what();
  }
  return "none";
}

TEST(range, left_with_a_vent_open_is_named) {
  for (const gas::Method method : kMethods) {
    SCOPED_TRACE(static_cast<int>(method));
    EXPECT_NE(
        refusal(method, 20e5, 300.0, 0.0).find("leaves its temperature range, 200 to 6000 K, at t = 0.33"),
        std::string::npos);
    EXPECT_NE(refusal(method, kAmbientPressure, 5500.0, 100.0).find("leaves its temperature range"),
              std::string::npos);
  }
}

TEST(range, energy_outside_is_named) {
  for (const bool constant : {true, false}) {
    gas::ControlVolumeModel model = closed_tank(constant ? nitrogen() : nasa7({"N2"}));
    model.vents.push_back({1.0, 1e-3});
    gas::GasIntegrator integrator(model);
    gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure, 300.0, kVolume);
    state.internal_energy = -1e9;
    try {
      integrator.advance(state, 0.0, 1e-3, rigid(kVolume));
      ADD_FAILURE() << "accepted";
    } catch (const gas::DomainError& error) {
      EXPECT_NE(std::string(error.what()).find("temperature range"), std::string::npos) << error.what();
    }
  }
}

TEST(range, guess_that_is_no_number_is_refused) {
  const gas::Thermo thermo = nasa7({"N2"});
  const double energy = thermo.internal_energy(kPure, 300.0);
  EXPECT_NEAR(thermo.temperature_from_internal_energy(kPure, energy, 5000.0), 300.0, 1e-9);
  for (const double guess : {std::nan(""), HUGE_VAL})
    EXPECT_THROW(thermo.temperature_from_internal_energy(kPure, energy, guess), std::invalid_argument);
}

// The inflator fires at 2 ms, which a sum of 200 steps misses by rounding. Gas that walls hold at their
// balance with what flows in, the same for any steps.
TEST(evacuated, volume_with_walls_fills_alike_for_any_steps) {
  gas::ControlVolumeModel model = closed_tank(nasa7({"N2"}));
  model.heat_loss = {50.0, 293.15};
  model.inflows.push_back(
      {kPure, gas::Curve({{0.0, 0.0}, {0.01, 2.0}}, gas::Outside::zero), gas::Curve::constant(700.0), 0.002});
  double before = 0.0;
  for (const int steps : {10, 100, 1000, 3000}) {
    gas::GasIntegrator integrator(model);
    gas::ControlVolumeState state = gas::make_state(model, kPure, 0.0, 300.0, kVolume);
    double t = 0.0;
    for (int i = 0; i < steps; ++i, t += 0.01 / steps)
      integrator.advance(state, t, t + 0.01 / steps, rigid(kVolume));
    const double temperature = gas::evaluate(model, state, kVolume, 0.0, 0.01).temperature;
    if (before > 0.0) {
      EXPECT_NEAR(temperature, before, 1e-8 * before) << steps;
    }
    before = temperature;
  }
}

}  // namespace
