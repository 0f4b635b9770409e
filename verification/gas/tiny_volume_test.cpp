// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "cases.hpp"

// Several species in volumes through which far more passes than they hold, by the implicit method.
namespace {

using namespace cases;

struct Passage {
  gas::GasPoint end{};
  std::vector<double> masses{};  // [kg]
  double mass_out = 0.0;         // [kg]
  int steps = 0;
};

/// 0.02 kg/s of nitrogen through a volume behind much porous fabric, in 20 ms; there is `first` at first.
Passage pass(double volume, const std::vector<double>& first, double tolerance) {
  gas::ControlVolumeModel model = closed_tank(nasa7({"N2", "CO2", "H2O"}));
  model.inflows.push_back(steady_inflow(model.thermo, 0.02, 406.0));
  gas::ControlVolumeState state = gas::make_state(model, first, kAmbientPressure, 500.0, volume);
  gas::GasIntegrator integrator(model, {tolerance, 20000, gas::Method::rosenbrock_4});
  Passage passage;
  for (int i = 0; i < 20; ++i) {
    const auto fluxes = integrator.advance(state, 1e-3 * i, 1e-3 * (i + 1), rigid(volume, 3.75e-3));
    passage.mass_out += fluxes.fabric_mass_out;
    passage.steps += fluxes.steps;
  }
  passage.end = gas::evaluate(model, state, volume, 3.75e-3, 0.02);
  passage.masses = state.masses;
  return passage;
}

/// What was there at first leaves within m/mdot, faster than a sub-step: it is gone to the tolerance, never
/// negative, and costs few sub-steps more than a gas of one species does.
TEST(tiny_volume, species_that_leave_cost_few_sub_steps) {
  for (const double volume : {1e-6, 1e-8, 1e-10})
    for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
      SCOPED_TRACE(testing::Message() << volume << " m3 at " << tolerance);
      const Passage pure = pass(volume, {1.0, 0.0, 0.0}, tolerance),
                    mixed = pass(volume, {0.4, 0.3, 0.3}, tolerance);
      // Composition changes by the whole where the pure gas's temperature does by a fifth: at order 4 at most
      // 5^(1/4) times as many, and those of ln(1/tolerance) residence times.
      EXPECT_LE(mixed.steps, 2.0 * pure.steps);
      for (const std::size_t k : {1, 2}) {
        EXPECT_GE(mixed.masses[k], 0.0);
        EXPECT_LE(mixed.masses[k], tolerance * mixed.end.mass);
      }
      // Of the whole: that of a few sub-steps, and ten roundings of what passes in a call, 2e-5 kg.
      const double bound = 5.0 * tolerance + 10.0 * kEpsilon * 2e-5 / mixed.end.mass;
      EXPECT_LT(relative(mixed.end.temperature, 406.0), bound);
      EXPECT_NEAR(mixed.end.pressure, pure.end.pressure, bound * kAmbientPressure);
      EXPECT_NEAR(mixed.mass_out, 4e-4, 4e-4 * 1e-9 + 2.0 * mixed.end.mass);
    }
}

/// In a tenth of a femtolitre what passes in a sub-step rounds to more than the tolerance of what is there:
/// the error names the residence time m/mdot, the limit tolerance/(100 epsilon) of it, and what is allowed.
TEST(tiny_volume, rounding_of_what_passes_is_named) {
  constexpr double kVolume = 1e-16;
  try {
    pass(kVolume, {1.0, 0.0, 0.0}, 1e-10);
    FAIL() << "no error";
  } catch (const gas::DomainError& error) {
    const std::string text = error.what();
    const auto number_after = [&](const std::string& words) {
      const std::size_t at = text.find(words);
      return at == std::string::npos ? 0.0 : std::stod(text.substr(at + words.size()));
    };
    // m of the balance, 17 Pa above p_a, R to the five digits of the gas constant.
    const double residence = 1.00017 * kAmbientPressure * kVolume / (296.8 * 406.0) / 0.02;
    EXPECT_LT(relative(number_after("is exchanged within "), residence), 1e-2) << text;
    EXPECT_LT(relative(number_after("sub-steps below "), residence * 1e-10 / (100.0 * kEpsilon)), 1e-2)
        << text;
    EXPECT_NE(text.find("use a looser gas_tolerance"), std::string::npos) << text;
  }
}

/// Of a mixture of other formation enthalpies than the air's some is driven out through a wide vent and
/// replaced by air: what an error of a species takes along is no error of the temperature.
TEST(tiny_volume, formation_enthalpies_cost_no_sub_steps) {
  const auto steps = [](const gas::Thermo& thermo) {
    gas::ControlVolumeModel model = closed_tank(thermo);
    model.ambient.mass_fractions = {0.0, 0.0, 0.77, 0.23};
    model.vents.push_back({0.6, 1.0});
    model.vents.back().backflow = true;
    gas::ControlVolumeState state =
        gas::make_state(model, std::vector{0.6, 0.4, 0.0, 0.0}, kAmbientPressure, 250.0, 4.8e-5);
    gas::GasIntegrator integrator(model, {1e-10, 200000, gas::Method::rosenbrock_4});
    const int squeezed = integrator.advance(state, 0.0, 2e-5, {4.8e-5, 4.6e-5, 0.0, 0.0}).steps;
    return squeezed + integrator.advance(state, 2e-5, 4e-5, {4.6e-5, 4.8e-5, 0.0, 0.0}).steps;
  };
  const int alike = steps(nasa7({"Ar", "He", "N2", "O2"}));
  EXPECT_LE(steps(nasa7({"CO2", "H2O", "N2", "O2"})), 2 * alike);
}

/// A volume so soft next to p_a that p, rounded, does not tell the overpressure which drives the flow.
TEST(tiny_volume, soft_volume_knows_its_overpressure) {
  for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
    SCOPED_TRACE(tolerance);
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    model.volume_of_overpressure =
        gas::Curve({{-1e3, 4e-9}, {0.0, 4e-8}, {1e-4, 1.2e-7}, {1e3, 1.6e-7}}, gas::Outside::held);
    model.inflows.push_back(steady_inflow(model.thermo, 1e-5, 406.0));
    model.vents.push_back({0.6, 1.0});
    model.laminar_share = 0.0;  // far above what holds the balance here
    gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure + 1e-5, 2000.0, 4.8e-8);
    gas::GasIntegrator integrator(model, {tolerance, 2000, gas::Method::rosenbrock_4});
    gas::StepFluxes fluxes{};
    for (int i = 0; i < 20; ++i) fluxes = integrator.advance(state, 5e-3 * i, 5e-3 * (i + 1), rigid(1.0));
    const gas::GasPoint end = gas::evaluate(model, state, 1.0, 0.0, 0.1);
    // Some twenty times m/mdot = 3e-3 s have passed; the balance is 2e-10 Pa above p_a, less than p tells.
    EXPECT_LT(relative(end.temperature, 406.0), 10.0 * tolerance);
    const double excess = std::pow(1e-5 / 0.6, 2.0) / (2.0 * kAmbientPressure / (296.8 * 406.0));
    EXPECT_LT(relative(end.volume, 4e-8 + 8e-4 * excess), 10.0 * tolerance);
    EXPECT_LT(relative(fluxes.vent_mass_out, 5e-8), 10.0 * tolerance);
  }
}

/// What leaves a tiny volume may do so within the rounding of a late time: sub-steps count from the begin of
/// the call, where they have their digits. Both ends are at p_a, 1e4 s or none after t = 0.
TEST(tiny_volume, late_start_is_that_of_a_start_at_zero) {
  constexpr double kVolume = 1e-16;
  const gas::ControlVolumeModel model = closed_tank(nitrogen());
  for (const gas::Method method : {gas::Method::dormand_prince_5, gas::Method::rosenbrock_4}) {
    double masses[2]{};
    for (const double begin : {0.0, 1e4}) {
      gas::ControlVolumeState state = gas::make_state(model, kPure, 2e5, 293.15, kVolume);
      gas::GasIntegrator(model, {1e-6, 100000, method})
          .advance(state, begin, begin + 1.0, rigid(kVolume, 0.05));
      masses[begin > 0.0] = state.masses[0];
    }
    // Both lengths are exact, and so is all that follows.
    EXPECT_EQ(masses[0], masses[1]);
  }
}

/// p passes a sensor's threshold in a volume where walls leave p uncertain by more than the sensor's
/// rounding: the vent opens there all the same, and not when the call ends.
TEST(tiny_volume, threshold_is_passed_by_whatever_rounding) {
  constexpr double kVolume = 2.2e-14;
  gas::ControlVolumeModel model = closed_tank(nasa7({"He", "N2"}));
  model.ambient.pressure = 5e4;
  model.inflows.push_back({{0.0, 1.0}, gas::Curve::constant(9.6e-7), gas::Curve::constant(1200.0)});
  model.heat_loss = {0.1, 1500.0};
  model.triggers.sensors.push_back({});
  model.triggers.sensors[0].kind = gas::SensorKind::pressure;
  model.vents.push_back({0.6, 3.4e-10});
  model.vents[0].trigger = 0;
  for (int i = 0; i < 200; ++i) {
    model.triggers.sensors[0].threshold = 1e4 + 37.0 * i;
    gas::ControlVolumeState state = gas::make_state(model, std::vector{1.0, 0.0}, 5e4, 5999.0, kVolume);
    gas::GasIntegrator integrator(model, {1e-6, 10000, gas::Method::rosenbrock_4});
    EXPECT_GT(integrator.advance(state, 0.0, 2e-8, rigid(kVolume)).vent_mass_out, 0.0) << i;
  }
}

/// Gas that comes to rest at p_a with the walls behind a vent that lets nothing out or in there, but out
/// above: nothing could hold p, and nothing has to.
TEST(rest_at_ambient, vent_shut_where_p_would_fall) {
  for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
    gas::ControlVolumeModel model = closed_tank(nasa7({"N2", "CO2"}));
    gas::Vent shut{0.6, 0.0};
    shut.area_of_overpressure = gas::Curve({{0.0, 0.0}, {20.0, 1.3e-10}}, gas::Outside::held);
    shut.backflow = true;
    model.vents = {{0.6, 1.3e-10}, shut};
    model.ambient.mass_fractions = {1.0, 0.0};
    model.heat_loss = {0.0328, 293.15};
    gas::ControlVolumeState state =
        gas::make_state(model, std::vector{0.5, 0.5}, kAmbientPressure + 1e-4, 200.5, 2e-11);
    gas::GasIntegrator integrator(model, {tolerance, 100000, gas::Method::rosenbrock_4});
    for (int i = 0; i < 50; ++i) integrator.advance(state, 1e-3 * i, 1e-3 * (i + 1), rigid(2e-11));
    // At rest, m cv/(hA) = 5e-7 s, but for the last sub-steps' errors; p to a few errors of T before, which
    // let out gas that does not come back.
    EXPECT_LT(relative(state.temperature, 293.15), tolerance);
    EXPECT_NEAR(gas::evaluate(model, state, 2e-11, 0.0, 0.0).pressure, kAmbientPressure,
                (1e-10 + 3.0 * tolerance) * kAmbientPressure);
  }
}

/// Hot helium that comes in and leaves through a tiny volume, then rests: cold nitrogen drawn in would lower
/// p further, so that a p_a missed by rounding would let in more and more of it.
TEST(rest_at_ambient, hot_light_gas_draws_no_cold_gas_in) {
  gas::ControlVolumeModel model = closed_tank(nasa7({"He", "N2"}));
  model.ambient = {kAmbientPressure, 293.15, {0.0, 1.0}};
  model.volume_of_overpressure =
      gas::Curve({{0.0, 2.2e-14}, {2.7e-3, 2.6e-14}, {10.0, 4.5e-14}, {400.0, 1.6e-13}, {1e9, 1.6e-9}},
                 gas::Outside::held);
  model.inflows.push_back({{1.0, 0.0},
                           gas::Curve({{0.0, 5.55e-5}, {0.01, 5.55e-5}, {0.025, 0.0}}, gas::Outside::zero),
                           gas::Curve::constant(1200.0)});
  model.vents.push_back({0.6, 1.14e-8});
  model.vents[0].backflow = true;
  for (const double tolerance : {1e-6, 1e-7, 1e-8, 1e-9, 1e-10}) {
    gas::ControlVolumeState state =
        gas::make_state(model, std::vector{0.0, 1.0}, kAmbientPressure + 2.7e-3, 1500.0, 2.6e-14);
    gas::GasIntegrator integrator(model, {tolerance, 100000, gas::Method::rosenbrock_4});
    double drawn_in = 0.0;
    for (int i = 0; i < 50; ++i)
      drawn_in += integrator.advance(state, 1e-3 * i, 1e-3 * (i + 1), rigid(1.0)).backflow_mass;
    // At rest: p has come down by 20 Pa, the outflow's, of which gas takes 2e-4/gamma along in T.
    EXPECT_NEAR(state.temperature, 1200.0, 1200.0 * 1e-3) << tolerance;
    EXPECT_LT(drawn_in, 1e-3 * state.masses[0]) << tolerance;
  }
}

/// A wide vent that closes just as the inflow fades: at the end there is neither flow nor opening.
TEST(rest_at_ambient, vent_that_closes_as_the_inflow_fades) {
  for (const gas::Method method : {gas::Method::dormand_prince_5, gas::Method::rosenbrock_4}) {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    model.inflows.push_back(steady_inflow(model.thermo, 0.0, 300.0));
    model.inflows[0].mass_flow = gas::Curve({{0.0, 0.01}, {0.01, 0.0}}, gas::Outside::zero);
    model.vents.push_back({1.0, 0.0});
    model.vents[0].area_of_time = gas::Curve({{0.0, 20.0}, {0.01, 0.0}}, gas::Outside::held);
    gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure, 300.0, 0.06);
    const gas::StepFluxes fluxes =
        gas::GasIntegrator(model, {1e-8, 1000, method}).advance(state, 0.0, 0.02, rigid(0.06));
    // To the tolerance, 1e-8: of the mass, 0.07 kg, and of T.
    EXPECT_NEAR(fluxes.vent_mass_out, 5e-5, 1e-8 * 0.07);
    EXPECT_LT(relative(state.temperature, 300.0), 1e-8);
  }
}

}  // namespace
