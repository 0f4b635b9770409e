// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "gas/integrator.hpp"
#include "tank_test_cases.hpp"

// Records of libgas's own forward model with cp(T): small tanks, cold and hot gases.
namespace {

using namespace cases;

struct Gas {
  const char* name;
  std::vector<gas::Component> composition;  // by mass
  double temperature;                       // [K]
};
void PrintTo(const Gas& gas, std::ostream* out) {
  *out << gas.name;
}

constexpr double kVolume = 0.0283, kMass = 0.07, kOutlet = 1e-4;

gas::TankTest test_of(const Gas& sent) {
  const gas::Thermo thermo = nasa7({"N2", "O2", "Ar", "CO2", "H2O", "CO", "He"});
  return {thermo,
          kVolume,
          293.15,
          thermo.mass_fractions_by_mole(gas::air_by_mole()),
          thermo.mass_fractions_by_mass(sent.composition),
          kMass};
}

/// 3.5 kg/s at 10 ms, none at 0 and from 40 ms on; readings of 60 ms at 10 kHz.
Record forward_record(const gas::TankTest& test, double temperature) {
  const gas::Curve flow({{0.0, 0.0}, {0.01, 3.5}, {0.04, 0.0}}, gas::Outside::zero);
  gas::ControlVolumeModel model{test.thermo, {0.0, test.initial_temperature}, {}, {}};
  model.inflows.push_back({test.inflator_fractions, flow,
                           gas::Curve({{0.0, temperature}, {1.0, temperature}}, gas::Outside::held)});
  gas::ControlVolumeState state =
      gas::make_state(model.thermo, test.tank_fractions, 101325.0, test.initial_temperature, kVolume);
  gas::GasIntegrator integrator(model);
  const closed_form::PerfectGas gas{test.thermo.gas_constant(test.inflator_fractions),
                                    test.thermo.gamma(test.inflator_fractions, temperature)};
  Record record(
      [](double) {
        return closed_form::TankTestReadings{101325.0, 101325.0, 0.0, 0.0};
      },
      0.06, 601);
  for (std::size_t i = 1; i < record.times.size(); ++i) {
    integrator.advance(state, record.times[i - 1], record.times[i], rigid(kVolume));
    record.tank[i] = gas::evaluate(model, state, kVolume, 0.0, record.times[i]).pressure;
    const double mdot = flow.value(record.times[i]);
    record.chamber[i] = mdot > 0.0
                            ? closed_form::chamber_pressure(gas, kOutlet, mdot, temperature, record.tank[i])
                            : record.tank[i];
  }
  return record;
}

class identify_forward : public testing::TestWithParam<Gas> {};

/// 1e-4: the corner of the curve at 10 ms, over four readings of the spline.
TEST_P(identify_forward, exact_record_gives_mass_and_temperature) {
  const gas::TankTest test = test_of(GetParam());
  const Record record = forward_record(test, GetParam().temperature);
  for (const bool dual : {false, true}) {
    const gas::Identified found = gas::identify(test, dual ? record.dual() : record.average(), {.draws = 40});
    EXPECT_LT(relative(found.mean_temperature, GetParam().temperature), 1e-4);
    EXPECT_EQ(found.misfits, 0);
    if (dual) {
      EXPECT_LT(relative(found.effective_area, kOutlet), 2e-3);
    }
  }
}

/// 1 % noise: no draw ends the analysis; nearly all are inside the range.
TEST_P(identify_forward, noisy_records_are_analysed) {
  const gas::TankTest test = test_of(GetParam());
  for (unsigned seed = 1; seed <= 3; ++seed) {
    Record record = forward_record(test, GetParam().temperature);
    record.add_noise(0.01, seed);
    const gas::Identified found = gas::identify(test, record.average(), {.points = 101, .draws = 100});
    EXPECT_LT(relative(found.mean_temperature, GetParam().temperature), 0.05);
    EXPECT_TRUE(found.bands) << found.misfits;
  }
}

INSTANTIATE_TEST_SUITE_P(
    gases, identify_forward,
    testing::Values(Gas{"CO2_at_500", {{"CO2", 1.0}}, 500.0}, Gas{"CO2_at_800", {{"CO2", 1.0}}, 800.0},
                    Gas{"CO2_at_1200", {{"CO2", 1.0}}, 1200.0}, Gas{"H2O", {{"H2O", 1.0}}, 800.0},
                    Gas{"He_at_400", {{"He", 1.0}}, 400.0}, Gas{"N2_He", {{"N2", 0.5}, {"He", 0.5}}, 600.0},
                    Gas{"CO2_H2O", {{"CO2", 0.5}, {"H2O", 0.5}}, 900.0},
                    Gas{"CO_CO2_H2O", {{"CO", 0.3}, {"CO2", 0.3}, {"H2O", 0.4}}, 900.0}),
    [](const auto& one) { return std::string(one.param.name); });

/// A gauge's noise in per cent of full scale is the same over the record: at rest, where both pressures are
/// equal, that of the chamber's gauge is a multiple of the tank's pressure.
TEST(identify_noise, of_full_scale_is_taken) {
  for (const double share : {1e-6, 1e-3, 0.005}) {
    Record record(one_gas_truth(1e-4), 0.06, 601);
    std::mt19937_64 generator(1);
    std::normal_distribution<double> normal;
    const double tank = *std::ranges::max_element(record.tank),
                 chamber = *std::ranges::max_element(record.chamber);
    for (double& p : record.tank) p += share * tank * normal(generator);
    for (double& p : record.chamber) p += share * chamber * normal(generator);
    const auto found = [&](gas::Noise noise) {
      return gas::identify(one_gas_test(), record.dual(), {.points = 101, .draws = 100, .noise = noise});
    };
    const gas::Identified good = found(gas::Noise::of_full_scale);
    EXPECT_LT(relative(good.tank.noise, share), 0.12 + 5.0 * share);  // and the largest reading's own
    EXPECT_LT(relative(good.mean_temperature, 600.0), 5.0 * share + 1e-4);
    EXPECT_LT(relative(good.effective_area, 1e-4), 5.0 * share + 1e-3);
    if (share < 1e-5) continue;  // there the bends of the chamber's pressure are larger than its noise
    EXPECT_LT(relative(good.chamber.noise, share), 0.12 + 5.0 * share);
    EXPECT_THROW(found(gas::Noise::of_reading), gas::ReadingError) << share;
  }
}

}  // namespace
