// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "cases.hpp"

// Bad input is std::invalid_argument and names the field; a domain left at run time is DomainError.
namespace {

using namespace cases;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <class Action>
void expect_refused(Action action, const std::string& field) {
  try {
    action();
    FAIL() << field << " was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(field), std::string::npos) << error.what();
  }
}

gas::ControlVolumeModel valid_model() {
  gas::ControlVolumeModel model = closed_tank(nasa7({"N2", "O2"}));
  model.inflows.push_back(steady_inflow(model.thermo, 1.0, 400.0));
  model.vents.push_back({0.6, 1e-3});
  return model;
}

template <class Change>
void expect_model_refused(Change change, const std::string& field) {
  gas::ControlVolumeModel model = valid_model();
  EXPECT_NO_THROW(gas::GasIntegrator{model});
  change(model);
  expect_refused([&] { gas::GasIntegrator{model}; }, field);
}

TEST(input, volume_of_overpressure) {
  using Knots = std::vector<gas::Curve::Knot>;
  const auto refused = [](Knots knots, gas::Outside outside, const std::string& field) {
    expect_model_refused([&](auto& model) { model.volume_of_overpressure = gas::Curve(knots, outside); },
                         field);
  };
  refused({{0.0, 0.1}, {1e4, 0.09}}, gas::Outside::held, "must not fall");
  refused({{0.0, 0.0}, {1e4, 0.1}}, gas::Outside::held, "must be positive");
  refused({{-2e5, 0.1}, {1e4, 0.1}}, gas::Outside::held, "first overpressure");
  refused({{0.0, 0.1}}, gas::Outside::held, "at least 2");
  expect_refused(
      [] {
        gas::Curve({{1e4, 0.1}, {0.0, 0.1}}, gas::Outside::held);
      },
      "time or overpressure of a knot");
  refused({{0.0, 0.1}, {1e4, 0.1}}, gas::Outside::zero, "held outside");
}

TEST(input, enumerators) {
  gas::IntegratorOptions options;
  options.method = static_cast<gas::Method>(4);
  expect_refused([&] { gas::GasIntegrator(valid_model(), options); }, "method");
  expect_refused([] { gas::Curve({{0.0, 1.0}}, static_cast<gas::Outside>(-1)); }, "outside");
  expect_model_refused(
      [](auto& model) {
        gas::Sensor sensor;
        sensor.kind = static_cast<gas::SensorKind>(9);
        model.triggers.sensors.push_back(sensor);
      },
      "sensor.kind");
}

TEST(input, species) {
  expect_refused([] { gas::nasa7_species("Xe"); }, "Xe");
  expect_refused([] { gas::constant_cp_species("N2", 100.0); }, "temperature");
  expect_refused([] { gas::constant_cp_species("gas", -1.0, 1000.0); }, "gas_constant");
  expect_refused([] { gas::constant_cp_species("gas", 296.8, 290.0); }, "cp");
  expect_refused([] { gas::constant_cp_species("gas", 296.8, kNan); }, "cp");
  expect_refused([] { gas::Thermo({}); }, "species");
  expect_refused([] { nasa7({"N2", "N2"}); }, "twice");
}

TEST(input, composition) {
  const gas::Thermo thermo = nasa7({"N2", "O2"});
  const auto by_mole = [&](const std::vector<gas::Component>& c) { thermo.mass_fractions_by_mole(c); };
  expect_refused([&] { by_mole({{"N2", 0.5}, {"He", 0.5}}); }, "He");
  expect_refused([&] { by_mole({{"N2", 0.5}, {"N2", 0.5}}); }, "twice");
  expect_refused([&] { by_mole({{"N2", 1.5}, {"O2", -0.5}}); }, "O2");
  expect_refused([&] { by_mole({{"N2", 0.5}}); }, "sum");
  expect_refused([&] { by_mole({}); }, "sum");
}

TEST(input, model) {
  expect_model_refused([](auto& m) { m.ambient.pressure = -1.0; }, "ambient.pressure");
  expect_model_refused([](auto& m) { m.ambient.pressure = kNan; }, "ambient.pressure");
  expect_model_refused([](auto& m) { m.ambient.temperature = 0.0; }, "ambient.temperature");
  expect_model_refused([](auto& m) { m.inflows[0].mass_fractions = {1.0}; }, "mass_fractions");
  expect_model_refused([](auto& m) { m.inflows[0].mass_fractions = {0.5, 0.4}; }, "mass_fractions");
  expect_model_refused([](auto& m) { m.inflows[0].mass_fractions = {1.5, -0.5}; }, "mass_fractions");
  expect_model_refused([](auto& m) { m.inflows[0].mass_flow = gas::Curve::constant(-1.0); }, "mass_flow");
  expect_model_refused([](auto& m) { m.inflows[0].temperature = gas::Curve::constant(150.0); },
                       "temperature");
  expect_model_refused([](auto& m) { m.inflows[0].temperature = gas::Curve::constant(6001.0); },
                       "temperature");
  expect_model_refused([](auto& m) { m.inflows[0].start_time = kNan; }, "start_time");
  expect_model_refused([](auto& m) { m.vents[0].area = -1e-3; }, "vent.area");
  expect_model_refused([](auto& m) { m.vents[0].area = kInfinity; }, "vent.area");
  expect_model_refused([](auto& m) { m.vents[0].discharge_coefficient = 1.2; }, "discharge_coefficient");
}

TEST(input, options) {
  expect_refused([] { gas::GasIntegrator(valid_model(), {0.0}); }, "relative_tolerance");
  expect_refused([] { gas::GasIntegrator(valid_model(), {0.1}); }, "relative_tolerance");
  expect_refused([] { gas::GasIntegrator(valid_model(), {kNan}); }, "relative_tolerance");
  expect_refused([] { gas::GasIntegrator(valid_model(), {1e-8, 0}); }, "maximum_steps");
}

TEST(input, state_and_step) {
  const gas::Thermo thermo = nasa7({"N2", "O2"});
  const std::vector<double> fractions{0.8, 0.2};
  expect_refused([&] { gas::make_state(thermo, fractions, -1.0, 300.0, 1.0); }, "pressure");
  expect_refused([&] { gas::make_state(thermo, fractions, 1e5, 150.0, 1.0); }, "temperature");
  expect_refused([&] { gas::make_state(thermo, fractions, 1e5, 300.0, 0.0); }, "volume");
  expect_refused([&] { gas::make_state(thermo, kPure, 1e5, 300.0, 1.0); }, "mass_fractions");
  gas::ControlVolumeState state = gas::make_state(thermo, fractions, 1e5, 300.0, 0.06);
  gas::GasIntegrator integrator(valid_model());
  expect_refused([&] { integrator.advance(state, 1.0, 1.0, rigid(0.06)); }, "t1");
  expect_refused([&] { integrator.advance(state, 0.0, kNan, rigid(0.06)); }, "t1");
  gas::ControlVolumeState broken = state;
  broken.temperature = kNan;
  expect_refused([&] { integrator.advance(broken, 0.0, 1.0, rigid(0.06)); }, "temperature");
  broken = state;
  broken.masses[0] = kNan;
  expect_refused([&] { integrator.advance(broken, 0.0, 1.0, rigid(0.06)); }, "masses");
  broken.masses.pop_back();
  expect_refused([&] { integrator.advance(broken, 0.0, 1.0, rigid(0.06)); }, "masses");
}

TEST(domain, volume_and_leak_area_must_make_sense) {
  const gas::ControlVolumeModel model = valid_model();
  gas::ControlVolumeState state = gas::make_state(model.thermo, std::vector{1.0, 0.0}, 1e5, 300.0, 0.06);
  gas::GasIntegrator integrator(model);
  for (const gas::VolumePath& path : {gas::VolumePath{0.06, 0.0, 0.0, 0.0},
                                      {kNan, 0.06, 0.0, 0.0},
                                      {0.06, 0.06, -1.0, 0.0},
                                      {0.06, 0.06, 0.0, kNan},
                                      {0.06, 0.05, 0.0, 0.0, -0.05},
                                      {0.06, 0.06, 0.0, 0.0, kNan}})
    EXPECT_THROW(integrator.advance(state, 0.0, 1e-3, path), gas::DomainError);
  EXPECT_THROW(gas::evaluate(model, state, 0.0, 0.0, 0.0), gas::DomainError);
  for (const double bad : {-1e-4, kNan, kInfinity})
    EXPECT_THROW(gas::evaluate(model, state, 0.06, bad, 0.0), gas::DomainError);
}

TEST(input, state_without_the_triggers_of_its_model_is_refused) {
  gas::ControlVolumeModel model = valid_model();
  model.triggers.sensors.push_back({gas::SensorKind::time, 0.01});
  model.inflows[0].trigger = 0;
  const std::vector<double> fractions{1.0, 0.0};
  const auto bare = gas::make_state(model.thermo, fractions, 1e5, 300.0, 0.06);
  expect_refused([&] { gas::evaluate(model, bare, 0.06, 0.0, 0.0); }, "number of triggers of the state = 0");
  expect_refused([&] { gas::inflator_point(model, bare, 0, 0.0); }, "number of triggers of the state = 0");
  const auto whole = gas::make_state(model, fractions, 1e5, 300.0, 0.06);
  EXPECT_EQ(gas::evaluate(model, whole, 0.06, 0.0, 0.0).inflow, 0.0);
}

/// Expansion cools N2 below 200 K, compression heats it above 6000 K: an error, and the state as it was.
TEST(domain, temperature_out_of_range_is_an_error) {
  const gas::ControlVolumeModel model = closed_tank(nasa7({"N2"}));
  gas::GasIntegrator integrator(model);
  for (const double ratio : {4.0, 1e-5}) {
    gas::ControlVolumeState state = gas::make_state(model.thermo, kPure, 1e5, 300.0, 0.06);
    const gas::ControlVolumeState before = state;
    EXPECT_THROW(integrator.advance(state, 0.0, 1.0, {0.06, ratio * 0.06, 0.0, 0.0}), gas::DomainError);
    EXPECT_EQ(state.internal_energy, before.internal_energy);
    EXPECT_EQ(state.masses, before.masses);
  }
}

}  // namespace
