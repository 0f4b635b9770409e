// SPDX-License-Identifier: Apache-2.0
// Whole runs of the scenes without a mesh, against their closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "claim.hpp"
#include "closed_form/gas.hpp"
#include "closed_form/orifice.hpp"
#include "run_case.hpp"

namespace {

using coupled::run_case;
constexpr double kGasConstant = 296.8, kModelGamma = 1.4;  // the cases' model nitrogen

TEST(tank_scene, rigid_tank_eq_linear_pressure) {
  const auto run = run_case("rigid_tank");
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done);
  closed_form::TankFill tank{{kGasConstant, kModelGamma}, 0.06, 101325.0, 293.15, 1.0, 700.0};
  for (const auto& row : run.history) {
    const auto exact = closed_form::tank_fill(tank, row.at("time_s"));
    const char* why = "linear in the state: the sum over 100 steps rounds";
    claim::expect_relative({"G.8", "case rigid_tank, every row: pressure [Pa]", why}, row.at("pressure_Pa"),
                           exact.pressure, 1e-13);
    claim::expect_relative({"G.10", "case rigid_tank, every row: temperature [K]", why},
                           row.at("temperature_K"), exact.temperature, 1e-13);
    claim::expect_relative({"G.9", "case rigid_tank, every row: gas mass [kg]", why}, row.at("gas_mass_kg"),
                           exact.mass, 1e-13);
  }
  EXPECT_EQ(run.history.size(), 101u);
}

TEST(tank_scene, rigid_tank_reaches_its_parameters) {
  // Twice the flow into twice the volume: the same pressure; a parameter that never arrives would show.
  const auto base = run_case("rigid_tank");
  const auto twice = run_case("rigid_tank", {"tank.volume=0.12", "inflator.0.mass_flow=2.0"});
  const auto hotter = run_case("rigid_tank", {"inflator.0.temperature=1400.0"});
  const double rise = base.history.back().at("pressure_Pa") - 101325.0;
  EXPECT_NEAR(twice.history.back().at("pressure_Pa"), base.history.back().at("pressure_Pa"), 1e-6);
  EXPECT_NEAR(hotter.history.back().at("pressure_Pa") - 101325.0, 2.0 * rise, 1e-12 * rise * 100);
}

/// Whatever an inflator names is in the gas, also what nothing named before: its share of what came in, to
/// the rounding of the sum.
TEST(tank_scene, every_species_that_enters_is_there) {
  const std::vector<std::string> changes{"inflator.0.composition={ NH3=0.5, H2=0.5 }",
                                         "inflator.1.composition={ He=1.0 }",
                                         "sensor.2.overpressure=1e9",
                                         "sensor.3.overpressure=1e9",
                                         "sensor.4.overpressure=1e9",
                                         "sensor.4.reset=1e8"};  // vents stay shut
  const auto run = run_case("tank_triggers", changes);
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  const auto scene = coupled::scene_of("tank_triggers", changes);
  const gas::Thermo& thermo = scene.gas->model.thermo;
  ASSERT_EQ(thermo.size(), 7u);  // those of air, and three
  const auto mass = [&](const char* name) { return run.state.gas.masses[thermo.index(name)]; };
  // 0.025 kg of equal moles of 17.03 and 2.016 g/mol, and 0.015 kg.
  const double ammonia = thermo.species(thermo.index("NH3")).molar_mass,
               hydrogen = thermo.species(thermo.index("H2")).molar_mass;
  EXPECT_NEAR(mass("NH3"), 0.025 * ammonia / (ammonia + hydrogen), 1e-14);
  EXPECT_NEAR(mass("H2"), 0.025 * hydrogen / (ammonia + hydrogen), 1e-14);
  EXPECT_NEAR(mass("He"), 0.015, 1e-14);
}

TEST(tank_scene, tank_never_builds_a_mesh) {
  const auto scene = coupled::scene_of("rigid_tank");
  EXPECT_FALSE(scene.bag || scene.pendulum || scene.contact || scene.target);
  EXPECT_TRUE(scene.jets.empty());
}

TEST(tank_scene, blowdown_eq_choked_subsonic_and_rest) {
  const auto run = run_case("tank_blowdown");
  ASSERT_EQ(run.outcome.status, driver::RunStatus::done);
  const closed_form::Blowdown tank{{kGasConstant, kModelGamma}, 0.06, 1e-3, 1.0, 5e5, 600.0, 101325.0};
  constexpr double tolerance = 1e-8;
  const char* why = "350 steps of the stepper's 1e-10, amplified near the square root at p_a";
  for (const auto& row : run.history) {
    const auto exact = closed_form::blowdown(tank, row.at("time_s"));
    claim::expect_relative({"G.6", "case tank_blowdown, every row: pressure [Pa]", why},
                           row.at("pressure_Pa"), exact.pressure, tolerance);
    claim::expect_relative({"G.10", "case tank_blowdown, every row: temperature [K]", why},
                           row.at("temperature_K"), exact.temperature, tolerance);
  }
  EXPECT_NEAR(run.history.back().at("pressure_Pa") / 101325.0, 1.0, 1e-8);  // the laminar range
  EXPECT_LT(run.history.back().at("vent_outflow_kg_s"), 1e-9);
  EXPECT_LT(run.state.peaks.mass_residual, 1e-12);
}

TEST(tank_scene, energy_of_a_tank_balances) {
  for (const char* name : {"rigid_tank", "tank_blowdown"}) {
    const auto run = run_case(name);
    double scale = 0.0;
    for (const auto& row : run.energy) scale = std::max(scale, row.at("gas_internal_J"));
    // The books repeat the additions of the gas: eps x rows.
    for (const auto& row : run.energy)
      EXPECT_LT(std::abs(row.at("residual_J")), 1e-12 * scale) << name << row.at("time_s");
  }
}

// Of cp(T) behind an open vent: 60 bar of 300 K would be at 94 K when they come to ambient pressure, 3 bar at
// 220 K.
TEST(warnings, name_gas_that_expands_out_of_its_range) {
  const auto count = [](const char* pressure, const char* thermodynamics) {
    const auto warnings =
        coupled::scene_of("tank_backflow",
                          {std::string("gas.initial.pressure=") + pressure, "gas.initial.temperature=300.0",
                           std::string("gas.thermodynamics=") + thermodynamics})
            .warnings;
    return std::ranges::count_if(warnings, [](auto& w) { return w.find("falls below 200 K") != w.npos; });
  };
  EXPECT_EQ(count("60e5", "nasa7"), 1);
  EXPECT_EQ(count("3e5", "nasa7"), 0);
  EXPECT_EQ(count("60e5", "constant"), 0);
}

int hot_warnings(const std::vector<std::string>& overrides) {
  int count = 0;
  for (const auto& w : coupled::scene_of("tank_backflow", overrides).warnings)
    count += w.find("rises above 6000 K") != w.npos;
  return count;
}

// N2 of 3000 K has gamma of 1.30 to 1.29 up there: 6000 K are reached between 9- and 12-fold compression.
TEST(warnings, name_gas_that_a_shrinking_tank_heats_out_of_its_range) {
  const auto count = [](const char* smallest, const char* thermodynamics) {
    return hot_warnings({"gas.initial.temperature=3000.0",
                         std::string("gas.thermodynamics=") + thermodynamics,
                         std::string("tank.volume={time=[0.0,0.1,0.2],value=[0.06,") + smallest + ",0.06]}"});
  };
  EXPECT_EQ(count("0.005", "nasa7"), 1);
  EXPECT_EQ(count("0.0067", "nasa7"), 0);
  EXPECT_EQ(count("0.005", "constant"), 0);
}

// Its enthalpy becomes internal energy: 5500 K would be about 7000 K in a tank that was empty, in one that
// was not it mixes.
TEST(warnings, name_gas_that_fills_an_empty_tank_and_leaves_its_range) {
  const auto count = [](const char* temperature, const char* pressure) {
    return hot_warnings(
        {std::string("gas.initial.pressure=") + pressure,
         std::string("inflator=[{composition={N2=1.0},mass_flow=0.1,temperature=") + temperature + "}]"});
  };
  EXPECT_EQ(count("5500.0", "0.0"), 1);
  EXPECT_EQ(count("4000.0", "0.0"), 0);
  EXPECT_EQ(count("5500.0", "2e5"), 0);
}

}  // namespace
