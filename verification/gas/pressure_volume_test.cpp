// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "cases.hpp"
#include "claim.hpp"
#include "closed_form/gas.hpp"
#include "closed_form/orifice.hpp"

// Volumes that follow the pressure: (G.18), (G.19).
namespace {

using namespace cases;

constexpr double kNotRead = 0.0;  // [m3] volumes of calls, none that a rigid volume could have

gas::Curve curve(std::vector<gas::Curve::Knot> knots) {
  return {std::move(knots), gas::Outside::held};
}

/// V = V0 + k (p - p_a) up to 20 bar.
gas::ControlVolumeModel spring_bag(const gas::Thermo& thermo, double volume, double compliance) {
  gas::ControlVolumeModel model = closed_tank(thermo);
  model.volume_of_overpressure = curve({{0.0, volume}, {2e6, volume + compliance * 2e6}});
  return model;
}

/// V = V0 p/p0 between a hundredth of an atmosphere and 10 bar.
gas::ControlVolumeModel proportional_bag(double volume, double pressure) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  const double low = 0.01 * kAmbientPressure, high = 1e6;
  model.volume_of_overpressure = curve({{low - kAmbientPressure, volume * low / pressure},
                                        {high - kAmbientPressure, volume * high / pressure}});
  return model;
}

gas::StepFluxes advance(const gas::ControlVolumeModel& model, gas::ControlVolumeState& state, double end,
                        const gas::IntegratorOptions& options = {}) {
  return gas::GasIntegrator(model, options).advance(state, 0.0, end, rigid(kNotRead));
}

gas::GasPoint point_of(const gas::ControlVolumeModel& model, const gas::ControlVolumeState& state,
                       double time) {
  return gas::evaluate(model, state, kNotRead, 0.0, time);
}

/// Nothing is stepped: rounding is all that is left, amplified little.
TEST(pressure_volume, filling_of_a_spring_bag_eq_closed_form) {
  for (const double compliance : {0.0, 1e-9, 5e-7, 1e-4}) {
    gas::ControlVolumeModel model = spring_bag(nitrogen(), 0.06, compliance);
    model.inflows.push_back(steady_inflow(model.thermo, 1.0, 700.0));
    gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure, 293.15, 0.06);
    const double before = state.internal_energy;
    const gas::StepFluxes fluxes = advance(model, state, 0.05);
    const closed_form::GasState exact =
        closed_form::spring_bag_fill({{}, kAmbientPressure, 293.15, 0.06, compliance}, 0.05, 700.0);
    const gas::GasPoint point = point_of(model, state, 0.05);
    const char* why = "rounding of some tens of operations; nothing is stepped";
    claim::expect_relative({"G.18", "bag behind a spring, filled: pressure [Pa]", why}, point.pressure,
                           exact.pressure, 1e-13);
    claim::expect_relative({"G.18", "bag behind a spring, filled: volume [m3]", why}, point.volume,
                           exact.volume, 1e-13);
    claim::expect_relative({"G.8", "bag behind a spring, filled: temperature [K]", why}, point.temperature,
                           exact.temperature, 1e-13);
    const double work =
        0.5 * compliance * (exact.pressure + kAmbientPressure) * (exact.pressure - kAmbientPressure);
    claim::expect_near({"G.19", "bag behind a spring, filled: work [J]", why}, fluxes.work, work,
                       1e-13 * fluxes.enthalpy_in);
    EXPECT_NEAR(state.internal_energy - before + fluxes.work, fluxes.enthalpy_in,
                1e-14 * state.internal_energy);
    EXPECT_EQ(fluxes.steps, 0);
  }
}

/// With cp(T) and across three knots: the books, with p dV by the trapezia of the knots passed.
TEST(pressure_volume, nasa7_books_close_across_knots) {
  gas::ControlVolumeModel model = closed_tank(nasa7({"N2", "CO2"}));
  const std::vector<gas::Curve::Knot> knots{{0.0, 0.01}, {100.0, 0.1}, {5e3, 0.12}, {3e5, 0.15}};
  model.volume_of_overpressure = curve(knots);
  const std::vector<double> mixture{0.7, 0.3};
  model.inflows.push_back({mixture, gas::Curve::constant(1.0), gas::Curve::constant(900.0)});
  gas::ControlVolumeState state = gas::make_state(model, mixture, kAmbientPressure, 293.15, 0.01);
  gas::GasIntegrator integrator(model);
  const double start = state.internal_energy;
  double supplied = 0.0, work = 0.0, expected = 0.0;
  for (int i = 0; i < 20; ++i) {
    const gas::StepFluxes fluxes = integrator.advance(state, 4e-3 * i, 4e-3 * (i + 1), rigid(kNotRead));
    supplied += fluxes.enthalpy_in;
    work += fluxes.work;
  }
  const gas::GasPoint end = point_of(model, state, 0.08);
  ASSERT_GT(end.pressure, kAmbientPressure + knots[2].time);
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const double p = std::min(knots[i + 1].time, end.pressure - kAmbientPressure);
    const double v = std::min(knots[i + 1].value, end.volume);
    expected += (v - knots[i].value) * (kAmbientPressure + 0.5 * (knots[i].time + p));
  }
  const double scale = model.thermo.cv(mixture, end.temperature) * end.mass * end.temperature;
  const char* why = "rounding of twenty calls";
  claim::expect_near({"G.19", "NASA-7 gas opens a bag: work along four knots [J]", why}, work, expected,
                     1e-12 * scale);
  claim::expect_near({"G.10", "NASA-7 gas opens a bag: energy residual [J]", why},
                     state.internal_energy - start + work - supplied, 0.0, 1e-12 * scale);
  EXPECT_NEAR(end.pressure * end.volume, end.mass * model.thermo.gas_constant(mixture) * end.temperature,
              1e-13 * end.pressure * end.volume);
}

struct Emptied {
  double error;  // relative, of p
  int steps;
};

/// 0.1 s of a choked blow-down.
Emptied empty_the_bag(const gas::IntegratorOptions& options) {
  constexpr double volume = 0.06, pressure = 5e5, end = 0.1;
  gas::ControlVolumeModel model = proportional_bag(volume, pressure);
  model.vents.push_back({1.0, 1e-3});
  gas::ControlVolumeState state = gas::make_state(model, kPure, pressure, 600.0, volume);
  const int steps = advance(model, state, end, options).steps;
  const closed_form::Blowdown bag{{}, volume, 1e-3, 1.0, pressure, 600.0, kAmbientPressure};
  return {
      relative(point_of(model, state, end).pressure, closed_form::proportional_blowdown(bag, end).pressure),
      steps};
}

struct OrderInP {
  gas::Method method;
  const char* name;
  double order, band;
};

TEST(pressure_volume, blowdown_of_a_proportional_bag_has_each_methods_order) {
  for (const auto& [method, name, order, band] :
       {OrderInP{gas::Method::euler, "Euler", 1.0, 0.1},
        OrderInP{gas::Method::runge_kutta_4, "Runge-Kutta 4", 4.0, 0.3},
        OrderInP{gas::Method::dormand_prince_5, "Dormand-Prince 5", 5.0, 0.3},
        OrderInP{gas::Method::rosenbrock_4, "Rosenbrock 4(3)", 4.0, 0.3}}) {
    std::vector<double> errors;
    for (const int steps : {8, 16, 32})
      errors.push_back(empty_the_bag({1e-10, 100000, method, 0.1 / steps}).error);
    claim::expect_order({"G.18", std::string(name) + ", blow-down of a bag, V ~ p: pressure",
                         "the next order's term, halved with each halving"},
                        errors, order - band, order + band);
    // One tolerance a sub-step; Euler's are too many at 1e-10.
    const double tolerance = method == gas::Method::euler ? 1e-6 : 1e-10;
    const Emptied run = empty_the_bag({tolerance, 100000, method});
    EXPECT_LT(run.error, run.steps * tolerance) << name;
  }
}

/// What stays inside expands reversibly across all knots, let out through a vent and through fabric.
TEST(pressure_volume, entropy_of_nasa7_gas_stays_across_knots) {
  gas::ControlVolumeModel model = closed_tank(nasa7({"N2", "CO2"}));
  model.volume_of_overpressure = curve({{0.0, 0.02}, {200.0, 0.1}, {2e4, 0.11}, {1e5, 0.13}, {5e5, 0.14}});
  model.vents.push_back({0.6, 2e-3});
  const std::vector<double> mixture{0.7, 0.3};
  gas::ControlVolumeState state =
      gas::make_state(model, mixture, kAmbientPressure + 3e5, 700.0, 0.13 + 0.01 * 0.5);
  const auto entropy = [&](double time) {
    const gas::GasPoint point = point_of(model, state, time);
    return model.thermo.entropy(state.masses, point.temperature, point.pressure);
  };
  const double before = entropy(0.0);
  const double end = 0.4;
  gas::GasIntegrator(model, {1e-12}).advance(state, 0.0, end, rigid(kNotRead, 1e-3));
  EXPECT_LT(point_of(model, state, end).pressure, kAmbientPressure + 200.0);  // past the last knot but one
  claim::expect_near({"G.15", "NASA-7 gas leaves a bag that closes: specific entropy [J/(kg K)]",
                      "some hundred sub-steps of 1e-12 of mass and energy, each worth cp of entropy"},
                     entropy(end), before, 1e-9 * model.thermo.gas_constant(mixture));
}

/// Behind walls, sealed, V ~ p: p dV = m R dT/2, so that T - T_ext decays as exp(-t h A/(m (cv + R/2))).
TEST(pressure_volume, walls_cool_gas_with_half_its_work) {
  gas::ControlVolumeModel model = proportional_bag(0.06, 3e5);
  model.heat_loss = {20.0, 300.0};
  for (const gas::Method method : kMethods) {
    gas::ControlVolumeState state = gas::make_state(model, kPure, 3e5, 600.0, 0.06);
    const double rate = 20.0 / (state.masses[0] * (742.0 + 0.5 * 296.8)), end = 1.0 / rate;
    const double tolerance = method == gas::Method::euler ? 1e-6 : 1e-10;
    const int steps = advance(model, state, end, {tolerance, 100000, method}).steps;
    claim::expect_relative(
        {"G.11", "sealed bag behind walls, V ~ p: temperature [K]", "one tolerance a sub-step"},
        point_of(model, state, end).temperature, 300.0 + 300.0 * std::exp(-1.0), steps * tolerance);
  }
}

/// A limp bag gives its gas back at next to no overpressure, and stays on p_a.
TEST(pressure_volume, opening_bag_empties_to_ambient_pressure) {
  gas::ControlVolumeModel model = closed_tank(nitrogen());
  model.volume_of_overpressure = curve({{0.0, 0.02}, {100.0, 0.12}, {1e5, 0.13}});
  model.vents.push_back({0.6, 5e-3});
  for (const gas::Method method : kMethods) {
    gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure + 50.0, 300.0, 0.07);
    const gas::StepFluxes fluxes = advance(model, state, 5.0, {1e-8, 100000, method});
    const gas::GasPoint end = point_of(model, state, 5.0);
    EXPECT_NEAR(end.pressure, kAmbientPressure, 1e-8 * kAmbientPressure);  // the laminar range
    // Reversibly, down to V(p_a) at p_a; the mass left is as good as the sub-steps' tolerance.
    const double begin = (kAmbientPressure + 50.0) * 0.07 / (296.8 * 300.0);
    const double cooled = 300.0 * std::pow(kAmbientPressure / (kAmbientPressure + 50.0), 2.0 / 7.0);
    EXPECT_NEAR(fluxes.vent_mass_out, begin - kAmbientPressure * 0.02 / (296.8 * cooled), 1e-7 * begin);
    EXPECT_NEAR(end.volume, 0.02, 1e-8);                 // 1e-3 m3/Pa times 1e-12 p_a, tenfold
    EXPECT_LT(relative(end.temperature, cooled), 1e-7);  // as the mass
  }
}

TEST(pressure_volume, past_the_last_knot_is_an_error) {
  for (const bool open : {false, true}) {
    gas::ControlVolumeModel model = closed_tank(nitrogen());
    model.volume_of_overpressure = curve({{0.0, 0.06}, {5e4, 0.07}});
    model.inflows.push_back(steady_inflow(model.thermo, 1.0, 700.0));
    if (open) model.vents.push_back({1.0, 1e-6});
    for (const double fixed : {0.0, 1e-3}) {
      gas::ControlVolumeState state = gas::make_state(model, kPure, kAmbientPressure, 293.15, 0.06);
      const gas::ControlVolumeState before = state;
      try {
        advance(model, state, 0.1, {1e-10, 100000, gas::Method::dormand_prince_5, fixed});
        FAIL() << "no error";
      } catch (const gas::DomainError& error) {
        EXPECT_NE(std::string(error.what()).find("passes 50000 Pa"), std::string::npos) << error.what();
      }
      EXPECT_EQ(state.internal_energy, before.internal_energy);
    }
  }
}

}  // namespace
