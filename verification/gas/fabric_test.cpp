// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "cases.hpp"
#include "claim.hpp"
#include "closed_form/exchange.hpp"
#include "second_route.hpp"

// Several fabrics on one volume: shares of its leak area, each with its own law.
namespace {

using namespace cases;

gas::Curve velocity_curve(std::vector<gas::Curve::Knot> knots) {
  return gas::Curve(std::move(knots), gas::Outside::held);
}

gas::ControlVolumeModel with_fabrics(std::vector<gas::Fabric> fabrics) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.fabrics = std::move(fabrics);
  return model;
}

struct Leaked {
  gas::GasPoint point;
  std::vector<gas::StreamFlux> out;
};

/// 0.06 m3 from 130 kPa and 400 K for 50 ms; the leak area grows from `area` to twice that.
Leaked leak(const gas::ControlVolumeModel& model, double area, const gas::IntegratorOptions& options = {}) {
  gas::ControlVolumeState state = gas::make_state(model, kPure, 130000.0, 400.0, 0.06);
  gas::GasIntegrator integrator(model, options);
  const gas::StepFluxes fluxes = integrator.advance(state, 0.0, 0.05, {0.06, 0.06, area, 2.0 * area});
  return {gas::evaluate(model, state, 0.06, area, 0.05), {fluxes.outflows.begin(), fluxes.outflows.end()}};
}

TEST(fabrics, two_of_half_the_area_eq_one) {
  const std::optional<gas::Curve> laws[] = {std::nullopt,
                                            velocity_curve({{0.0, 0.0}, {1e3, 0.1}, {1e5, 1.0}})};
  for (const auto& law : laws)
    for (const gas::Method method : {gas::Method::dormand_prince_5, gas::Method::rosenbrock_4}) {
      const gas::IntegratorOptions options{1e-8, 100000, method};
      const double area = law ? 0.2 : 1e-3;
      const Leaked one = leak(with_fabrics({{1.0, law}}), area, options);
      const Leaked two = leak(with_fabrics({{0.5, law}, {0.5, law}}), area, options);
      ASSERT_EQ(one.out.size(), 1u);
      ASSERT_EQ(two.out.size(), 2u);
      EXPECT_LT(one.point.pressure, 129000.0);
      EXPECT_LT(relative(two.point.pressure, one.point.pressure), 1e-12);
      EXPECT_LT(relative(two.point.temperature, one.point.temperature), 1e-12);
      EXPECT_LT(relative(two.point.fabric_mass_flow, one.point.fabric_mass_flow), 1e-9);  // of 3e-4 of p
      EXPECT_LT(relative(2.0 * two.out[0].mass, one.out[0].mass), 1e-12);
      EXPECT_EQ(two.out[0].mass, two.out[1].mass);
      EXPECT_EQ(two.out[0].enthalpy, two.out[1].enthalpy);
    }
}

/// Linear tables of different slopes are one of the mean slope, and share what leaves as their slopes.
TEST(fabrics, of_linear_tables_eq_closed_form_of_their_mean) {
  const auto table = [](double slope) { return velocity_curve({{0.0, 0.0}, {1e6, 1e6 * slope}}); };
  const gas::ControlVolumeModel model = with_fabrics({{0.2, table(3e-5)}, {0.8, table(0.5e-5)}});
  const closed_form::LinearFabricTank exact{{}, 0.06, 1.5, 1e-5, 130000.0, 400.0, kAmbientPressure};
  gas::ControlVolumeState state = gas::make_state(model, kPure, 130000.0, 400.0, 0.06);
  gas::GasIntegrator integrator(model);
  const gas::StepFluxes fluxes = integrator.advance(state, 0.0, 0.1, rigid(0.06, 1.5));
  const closed_form::GasState expected = closed_form::linear_fabric_tank(exact, 0.1);
  const char* why = "some sub-steps of 1e-10; errors decay";
  claim::expect_relative({"G.12", "two fabrics of linear tables: pressure at 0.1 s [Pa]", why},
                         gas::evaluate(model, state, 0.06, 1.5, 0.1).pressure, expected.pressure, 1e-9);
  claim::expect_relative(
      {"G.12", "two fabrics of linear tables: mass through one over the other [-]", "some roundings"},
      fluxes.outflows[0].mass / fluxes.outflows[1].mass, 0.2 * 3.0 / (0.8 * 0.5), 1e-13);
}

/// The law of the root beside a table: what flows at first is the sum of both, and inflow of that much at the
/// gas's own temperature keeps it at rest, however stiff.
TEST(fabrics, mixed_pair_balances_the_sum_of_its_laws) {
  constexpr double kRt = 296.8 * 400.0, kLeak = 2e-3, kExcess = 4000.0;
  const double rho = (kAmbientPressure + kExcess) / kRt;
  const double root = 0.75 * kLeak * std::sqrt(2.0 * rho * kExcess), table = 0.25 * kLeak * rho * 30.0;
  for (const double volume : {0.06, 1e-5}) {
    gas::ControlVolumeModel model =
        with_fabrics({{0.75}, {0.25, velocity_curve({{0.0, 0.0}, {2.0 * kExcess, 60.0}})}});
    gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure + kExcess, 400.0, volume);
    claim::expect_relative(
        {"G.7", "fabric by its porosity beside one by a table: flow of both [kg/s]", "some roundings"},
        gas::evaluate(model, state, volume, kLeak, 0.0).fabric_mass_flow, root + table, 1e-13);
    model.inflows.push_back(steady_inflow(model.thermo, root + table, 400.0));
    gas::GasIntegrator integrator(model);
    const gas::StepFluxes fluxes = integrator.advance(state, 0.0, 0.1, rigid(volume, kLeak));
    EXPECT_LT(relative(gas::evaluate(model, state, volume, kLeak, 0.1).pressure, kAmbientPressure + kExcess),
              1e-10);
    EXPECT_LT(relative(fluxes.outflows[0].mass, 0.1 * root), 1e-9);
    EXPECT_LT(relative(fluxes.outflows[1].mass, 0.1 * table), 1e-9);
  }
}

/// The same pair blowing down while it is filled, by GSL's msbdf.
TEST(fabrics, mixed_pair_eq_second_route) {
  second_route::Tank tank{with_fabrics({{0.75}, {0.25, velocity_curve({{0.0, 0.0}, {1e5, 100.0}})}}), {}};
  tank.model.inflows.push_back(steady_inflow(tank.model.thermo, 0.3, 600.0));
  tank.leak_area = 2e-3;
  tank.start = gas::make_state(tank.model, kPure, 150000.0, 400.0, tank.volume);
  gas::ControlVolumeState state = tank.start;
  gas::GasIntegrator(tank.model).advance(state, 0.0, second_route::kEnd, rigid(tank.volume, tank.leak_area));
  const gas::ControlVolumeState other = second_route::msbdf(tank, 1e-11).back();
  // Some hundred steps of msbdf at its tolerance.
  EXPECT_LT(relative(state.masses[0], other.masses[0]), 1e-9);
  EXPECT_LT(relative(state.internal_energy, other.internal_energy), 1e-9);
}

TEST(fabrics, shares_must_sum_to_one) {
  const auto message = [](std::vector<gas::Fabric> fabrics) -> std::string {
    try {
      gas::validate(with_fabrics(std::move(fabrics)));
      return "accepted";
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  EXPECT_EQ(message({{0.25}, {0.75}}), "accepted");
  EXPECT_EQ(message({{0.25}, {0.5}}).find("sum of fabric.share = 0.75"), 0u);
  EXPECT_EQ(message({{-0.5}, {1.5}}).find("fabric.share = -0.5"), 0u);
  EXPECT_EQ(message({{0.5}, {std::nan("")}}).find("fabric.share = nan"), 0u);
}

}  // namespace
