// SPDX-License-Identifier: Apache-2.0
// Simulations as objects of the border.
#pragma once
#include <gasjet/simulation.h>

#include <array>
#include <memory>
#include <optional>
#include <utility>

#include "engine/simulation.hpp"
#include "results/run_to_folder.hpp"
#include "results/skin_checks.hpp"
#include "run_object.hpp"

namespace border {

/// A simulation, its rows, and its folder if it has one.
struct Sim : Object {
  static constexpr const char* name = "a simulation";
  static constexpr bool shared = false;

  Sim(driver::Simulation start, driver::Provenance the_lines)
      : lines(std::move(the_lines)),
        tables{Table(driver::history_columns(start.scene())), Table(driver::energy_columns(start.scene()))},
        simulation(std::move(start)),
        checks(*simulation.now().given) {
    watch();
  }
  Sim(const Sim& other)
      : lines(other.lines), tables(other.tables), simulation(other.simulation), checks(other.seen()) {
    watch();
  }
  ~Sim() override;

  const driver::Scene& scene() const { return simulation.scene(); }
  const driver::State& state() const { return simulation.state(); }

  /// Looks at the skin: those of the folder if there is one.
  const driver::SkinChecks& seen() const { return folder ? folder->checks() : checks; }

  /// Rows into the tables, files into the folder if there is one.
  void watch();
  void open(const std::string& path, const driver::RunOptions& options);
  void finish();

  driver::Provenance lines;
  Tables tables;
  driver::Simulation simulation;
  driver::SkinChecks checks;  // of the scene as it was given
  std::optional<driver::RunFolder> folder;
};

}  // namespace border
