// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <numeric>

#include "bisection.hpp"
#include "cases.hpp"
#include "claim.hpp"

// Books: what is in the volume is what was there, plus what entered, minus what left.
namespace {

using namespace cases;

struct Books {
  double mass = 0.0, energy = 0.0;      // of the gas [kg], [J]
  double in = 0.0, out = 0.0;           // [kg]
  double energy_in = 0.0;               // [J]
  double energy_out = 0.0, work = 0.0;  // [J]
  double magnitude = 0.0;               // [J] sum of the energy terms' magnitudes
  void add(const gas::StepFluxes& f) {
    in += f.mass_in;
    out += f.vent_mass_out + f.fabric_mass_out;
    energy_in += f.enthalpy_in;
    energy_out += f.enthalpy_out;
    work += f.work;
    magnitude += std::abs(f.enthalpy_in) + std::abs(f.enthalpy_out) + std::abs(f.work);
  }
};

double total(const std::vector<double>& masses) {
  return std::accumulate(masses.begin(), masses.end(), 0.0);
}

/// A bag-like history: inflow of hot gas into air, a vent, a leak, a breathing volume.
struct Bag {
  gas::ControlVolumeModel model;
  gas::ControlVolumeState state;
};

Bag bag(bool constant_cp) {
  std::vector<gas::Species> species;
  for (const char* name : {"N2", "O2", "Ar", "CO2", "H2O"})
    species.push_back(constant_cp ? gas::constant_cp_species(name) : gas::nasa7_species(name));
  const gas::Thermo thermo(species);
  const std::vector<gas::Component> hot{{"N2", 0.5}, {"CO2", 0.2}, {"H2O", 0.3}};
  gas::ControlVolumeModel model = closed_tank(thermo);
  model.inflows.push_back({thermo.mass_fractions_by_mole(hot),
                           gas::Curve({{0.0, 0.0}, {0.012, 4.0}, {0.08, 0.0}}, gas::Outside::zero),
                           gas::Curve({{0.0, 500.0}, {0.03, 1400.0}, {0.09, 700.0}}, gas::Outside::held),
                           0.00123});
  model.inflows.push_back({thermo.mass_fractions_by_mole(gas::air_by_mole()),
                           gas::Curve({{0.0, 1.0}, {1e-5, 0.5}}, gas::Outside::zero),
                           gas::Curve::constant(300.0), 0.033333});
  model.vents.push_back({0.6, 2e-3});
  gas::ControlVolumeState state = gas::make_state(thermo, thermo.mass_fractions_by_mole(gas::air_by_mole()),
                                                  kAmbientPressure, 293.15, 0.012);
  return {model, state};
}

double bag_volume(double t) {
  return 0.012 + 0.1 * (1.0 - std::exp(-t / 0.03)) + 0.003 * std::sin(900.0 * t);
}

Books run(Bag& bag, double tolerance, int steps = 2000) {
  gas::GasIntegrator integrator(bag.model, {tolerance});
  Books books{total(bag.state.masses), bag.state.internal_energy};
  books.magnitude = std::abs(books.energy);
  for (int i = 0; i < steps; ++i) {
    const double t0 = 0.1 * i / steps, t1 = 0.1 * (i + 1) / steps;
    books.add(integrator.advance(bag.state, t0, t1, {bag_volume(t0), bag_volume(t1), 2e-3, 3e-3}));
  }
  return books;
}

TEST(balance, mass_and_energy_close_at_any_tolerance) {
  for (const bool constant_cp : {true, false}) {
    for (const double tolerance : {1e-3, 1e-6, 1e-10}) {
      Bag b = bag(constant_cp);
      const Books books = run(b, tolerance);
      EXPECT_GT(books.out, 0.01);
      // 2000 additions, each rounding once: 2000 eps at worst.
      EXPECT_NEAR(total(b.state.masses), books.mass + books.in - books.out, 5e-13 * (books.mass + books.in));
      EXPECT_NEAR(b.state.internal_energy, books.energy + books.energy_in - books.energy_out - books.work,
                  5e-13 * books.magnitude);
      // The inflow's curves: 4 * 0.08 / 2 kg, and 0.75e-5 kg.
      EXPECT_NEAR(books.in, 0.16 + 0.75e-5, 1e-12 * 0.16);
    }
  }
}

/// Two tolerances give the same history to the looser one, in calls that take many sub-steps each.
TEST(balance, state_converges_with_the_tolerance) {
  Bag fine = bag(false);
  run(fine, 1e-12, 20);
  for (const double tolerance : {1e-5, 1e-7, 1e-9}) {
    Bag coarse = bag(false);
    run(coarse, tolerance, 20);
    // The bag forgets: errors decay over a flushing time of at most a hundred sub-steps, each within its
    // tolerance.
    EXPECT_LT(relative(coarse.state.temperature, fine.state.temperature), 100.0 * tolerance) << tolerance;
    EXPECT_LT(relative(total(coarse.state.masses), total(fine.state.masses)), 100.0 * tolerance);
  }
}

TEST(balance, species_leave_in_the_proportion_of_the_mixture) {
  gas::ControlVolumeModel model = closed_tank(nasa7({"N2", "He", "H2O"}));
  model.vents.push_back({1.0, 1e-3});
  const std::vector<double> fractions{0.5, 0.5, 0.0};
  gas::ControlVolumeState state = gas::make_state(model.thermo, fractions, 4e5, 500.0, 0.06);
  gas::GasIntegrator(model).advance(state, 0.0, 0.1, rigid(0.06));
  // The same formula for both, so the same bits up to a rounding per sub-step.
  EXPECT_LT(relative(state.masses[0], state.masses[1]), 1e-14);
  EXPECT_EQ(state.masses[2], 0.0);
}

/// A species flushed out to nothing by another: its mass neither turns negative nor stops the integration.
TEST(balance, species_running_out_stays_non_negative) {
  gas::ControlVolumeModel model = closed_tank(nasa7({"N2", "He"}));
  model.inflows.push_back(steady_inflow(model.thermo, 1.0, 500.0));
  model.vents.push_back({1.0, 3e-3});
  for (const gas::Method method : {gas::Method::dormand_prince_5, gas::Method::rosenbrock_4}) {
    gas::ControlVolumeState state = gas::make_state(model.thermo, std::vector{0.0, 1.0}, 2e5, 400.0, 1e-3);
    gas::GasIntegrator integrator(model, {1e-6, 100000, method});
    for (int i = 0; i < 200; ++i) {
      integrator.advance(state, 1e-3 * i, 1e-3 * (i + 1), rigid(1e-3));
      ASSERT_GE(state.masses[1], 0.0);
    }
    // Flushed 60 times over and more: what remains is round-off of what was there.
    EXPECT_LT(state.masses[1], 1e-12 * state.masses[0]);
  }
}

/// First positive zero of a polynomial with the coefficients of z^k.
double first_zero(const std::vector<double>& coefficients) {
  const auto value = [&](double z) {
    double sum = 0.0, power = 1.0;
    for (const double c : coefficients) sum += c * power, power *= z;
    return sum;
  };
  double low = 0.0, high = 0.0;
  while (value(high += 0.01) > 0.0) low = high;
  for (int i = 0; i < 60; ++i) (value(0.5 * (low + high)) > 0.0 ? low : high) = 0.5 * (low + high);
  return low;
}

/// A trace flushed out in h mdot/m = z comes to zero in one stage of the method before the others: below it
/// is an error. The gas itself is stable up to 1.09 (Euler), 1.51 (RK4), 1.80 (Dormand-Prince).
TEST(threshold, species_running_out_eq_first_zero_of_a_stage) {
  gas::ControlVolumeModel model = closed_tank(nasa7({"N2", "He"}));
  model.inflows.push_back(steady_inflow(model.thermo, 0.5, 700.0));
  model.vents.push_back({1.0, 1e-3});
  gas::ControlVolumeState steady = gas::make_state(model, std::vector{1.0, 0.0}, 3.3e5, 700.0, 1e-3);
  gas::GasIntegrator(model).advance(steady, 0.0, 1.0, rigid(1e-3));
  const double residence = steady.masses[0] / 0.5;
  const auto run = [&](gas::Method method, double h) {
    gas::ControlVolumeState state = steady;
    state.masses[1] = 1e-9 * steady.masses[0];
    gas::GasIntegrator(model, {1e-10, 100000, method, h}).advance(state, 0.0, 2.0 * h, rigid(1e-3));
    return state.masses[1];
  };
  // Rosenbrock's stages are rational functions; the fifth by 16 digits of its coefficients.
  const std::vector<std::tuple<gas::Method, const char*, double>> limits{
      {gas::Method::euler, "explicit Euler", 1.0},
      {gas::Method::runge_kutta_4, "Runge-Kutta 4", first_zero({1.0, -1.0, 1.0 / 2, -1.0 / 4})},
      {gas::Method::dormand_prince_5, "Dormand-Prince 5",
       first_zero({1.0, -1.0, 1.0 / 2, -21.0 / 55, -14.0 / 275, -7.0 / 550})},
      {gas::Method::rosenbrock_4, "Rosenbrock 4", 2.453336605823764}};
  for (const auto& [method, name, limit] : limits) {
    const auto stays = [&, m = method](double ratio) {
      try {
        return run(m, ratio * residence) > 0.0;
      } catch (const gas::DomainError&) {
        return false;
      }
    };
    claim::expect_threshold(
        {"G.9", name, "1e-13 of gas and outflow counts as rounding, 3e-4 of the trace; bisection to 1e-4"},
        {"species that runs out", "h ṁ/m = first zero of a stage", limit,
         claim::largest_passing(0.5 * limit, 1.2 * limit, 1e-4, stays), "",
         "fixed sub-steps: error, never a negative mass; error control: smaller sub-steps"},
        0.999, 1.001);
  }
}

/// Past that threshold the error says which species, not that of the temperature.
TEST(balance, species_that_would_turn_negative_is_named) {
  gas::ControlVolumeModel model = closed_tank(nasa7({"N2", "He"}));
  model.inflows.push_back(steady_inflow(model.thermo, 0.5, 700.0));
  model.vents.push_back({1.0, 1e-3});
  gas::ControlVolumeState state = gas::make_state(model, std::vector{0.999, 0.001}, 3.3e5, 700.0, 1e-3);
  const double h = 1.5 * (state.masses[0] + state.masses[1]) / 0.5;  // half as much again leaves in a step
  try {
    gas::GasIntegrator(model, {1e-10, 100000, gas::Method::runge_kutta_4, h, true})
        .advance(state, 0.0, 2.0 * h, rigid(1e-3));
    FAIL() << "no error";
  } catch (const gas::DomainError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("species He runs out"), std::string::npos) << message;
    EXPECT_NE(message.find("gas_step"), std::string::npos) << message;
    EXPECT_EQ(message.find("temperature"), std::string::npos) << message;
  }
}

TEST(balance, the_same_call_gives_the_same_bits) {
  Bag one = bag(false), two = bag(false);
  run(one, 1e-8);
  run(two, 1e-8);
  EXPECT_EQ(one.state.internal_energy, two.state.internal_energy);
  EXPECT_EQ(one.state.masses, two.state.masses);
}

}  // namespace
