// SPDX-License-Identifier: Apache-2.0
// The energy that the drift is compared with (K.43), and sensible energies: neither depends on the zero of
// enthalpy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "claim.hpp"
#include "engine/run.hpp"
#include "results/summary.hpp"
#include "run_case.hpp"

namespace {

using coupled::CaseRun;

// As scene_of, with the enthalpies of all species moved by R a6 of `shift` [K].
CaseRun run_moved(const char* name, std::vector<std::string> overrides, double shift) {
  overrides.emplace_back("gas.thermodynamics=nasa7");
  driver::Scene scene = coupled::scene_of(name, overrides);
  std::vector<gas::Species> species;
  for (std::size_t k = 0; k < scene.gas->model.thermo.size(); ++k) {
    species.push_back(scene.gas->model.thermo.species(k));
    species.back().low[5] += shift;
    species.back().high[5] += shift;
  }
  scene.gas->model.thermo = gas::Thermo(species);
  return coupled::run_of(scene);
}

double energy_rel(const CaseRun& run) {
  return run.state.peaks.energy_residual / run.state.peaks.energy_scale;
}

struct Example {
  const char* name;
  std::vector<std::string> overrides;
};

// Smooth scenes, or short ones: rounding of a large zero grows in a chaotic one.
const Example kScenes[] = {
    {"sphere_inflation", {"scene.end_time=0.01"}},
    {"driver_bag", {"scene.end_time=0.002"}},
    {"tank_triggers", {"scene.end_time=0.03"}},
    {"jet_bag", {"scene.end_time=0.002", "membrane.mesh.levels=2"}},
};

TEST(energy_figure, zero_of_enthalpy_leaves_it_as_it_is) {
  for (const Example& e : kScenes) {
    const CaseRun own = run_moved(e.name, e.overrides, 0.0);
    for (const double shift : {-1e7, 3e6}) {
      const CaseRun moved = run_moved(e.name, e.overrides, shift);
      ASSERT_EQ(moved.outcome.status, driver::RunStatus::done) << e.name << moved.outcome.message;
      // R a6 of 3e9 J/kg is held to 1e-16 of it in each of some 1000 steps; p V is at least 1e3 J.
      EXPECT_NEAR(energy_rel(moved), energy_rel(own), 1e-9) << e.name << shift;
      EXPECT_NEAR(moved.state.peaks.energy_scale, own.state.peaks.energy_scale,
                  1e-9 * own.state.peaks.energy_scale)
          << e.name << shift;
    }
  }
}

TEST(energy_figure, sensible_columns_balance_as_the_absolute_ones) {
  for (const Example& e : kScenes) {
    const CaseRun run = run_moved(e.name, e.overrides, 0.0);
    const auto at = [](const coupled::Row& row, const char* column) {
      const auto found = row.find(column);
      return found == row.end() ? 0.0 : found->second;
    };
    for (const auto& row : run.energy) {
      const double absolute = at(row, "gas_internal_J") + at(row, "outflow_enthalpy_J") -
                              at(row, "inflow_enthalpy_J") - at(row, "backflow_enthalpy_J");
      const double sensible = at(row, "gas_sensible_J") + at(row, "outflow_sensible_J") -
                              at(row, "inflow_sensible_J") - at(row, "backflow_sensible_J");
      const double first = at(run.energy[0], "gas_internal_J") - at(run.energy[0], "gas_sensible_J");
      const double scale = std::abs(at(row, "inflow_enthalpy_J")) + std::abs(at(row, "gas_internal_J"));
      EXPECT_NEAR(absolute - sensible, first, 1e-12 * scale) << e.name;
    }
    double out = 0.0;
    for (std::size_t j = 0; j < run.state.streams.outflows.size(); ++j)
      out += run.state.streams.outflows[j].enthalpy - run.state.streams.outflow_ambient[j];
    EXPECT_NEAR(out, at(run.energy.back(), "outflow_sensible_J"),
                1e-10 * std::abs(run.state.flows.enthalpy_out) + 1e-9)
        << e.name;
  }
}

// Gas of constant heat capacity: cp (T - T_a) + R T_a of the inflow, cv (T - T_a) of what is held.
TEST(energy_figure, sensible_energies_eq_those_of_constant_heat_capacity) {
  const auto run = coupled::run_case("rigid_tank", {"gas.thermodynamics=constant"});
  const driver::Scene scene = coupled::scene_of("rigid_tank", {"gas.thermodynamics=constant"});
  const gas::Thermo& thermo = scene.gas->model.thermo;
  const double ambient = scene.ambient.temperature;
  double held = 0.0, reference = 0.0;
  for (std::size_t k = 0; k < thermo.size(); ++k) {
    const double cv = thermo.cp(k, 300.0) - thermo.gas_constant(k);
    held += run.state.gas.masses[k] * cv * (run.state.gas_point.temperature - ambient);
    reference += run.state.gas.masses[k] * cv * run.state.gas_point.temperature;
  }
  EXPECT_NEAR(run.energy.back().at("gas_sensible_J"), held, 1e-10 * reference);
}

// Without heat, motion and flow there is p V.
TEST(energy_figure, sealed_sphere_of_ambient_temperature_has_p_V) {
  const auto run = coupled::run_case(
      "sphere_inflation", {"inflator.0.mass_flow=0", "scene.end_time=0.002", "gas.thermodynamics=nasa7"});
  EXPECT_EQ(run.outcome.status, driver::RunStatus::done) << run.outcome.message;
  EXPECT_EQ(run.outcome.warning, "");
  const auto& row = run.history.front();
  EXPECT_GE(run.state.peaks.energy_scale, row.at("pressure_Pa") * row.at("volume_m3") * (1.0 - 1e-12));
  EXPECT_LT(run.state.peaks.energy_scale, 1.1 * row.at("pressure_Pa") * row.at("volume_m3"));
}

TEST(energy_figure, summary_and_text_say_the_share_of_the_mechanical_energy) {
  const driver::Scene scene = coupled::scene_of(
      "strapped_sphere", {"membrane.strap.0.stiffness=1e6", "time.step=1e-5", "scene.end_time=0.02"});
  const auto run = coupled::run_of(scene);
  const auto json = nlohmann::json::parse(driver::summary_text(scene, run.state, run.outcome, {}, {}));
  double mechanical = 0.0, drift = 0.0;
  for (const auto& row : run.energy) {
    mechanical = std::max(mechanical, row.at("skin_kinetic_J") + row.at("skin_strain_J") + row.at("strap_J"));
    drift = std::max(drift, std::abs(row.at("residual_J")));
  }
  EXPECT_NEAR(json["residual"]["energy_of_mechanical"].get<double>(), drift / mechanical, 1e-12);
  EXPECT_NE(run.outcome.warning.find("% of the mechanical energy"), std::string::npos) << run.outcome.warning;
}

}  // namespace
