// SPDX-License-Identifier: Apache-2.0
// Simulations of shipped cases.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/drift.hpp"
#include "engine/simulation.hpp"
#include "run_case.hpp"

namespace coupled {

using Overrides = std::vector<std::string>;

inline std::shared_ptr<const driver::Scene> shared_scene_of(const std::string& name,
                                                            const Overrides& overrides = {}) {
  driver::Scene scene = scene_of(name, overrides);
  scene.driven = true;
  return std::make_shared<const driver::Scene>(std::move(scene));
}

inline driver::Simulation simulation_of(const std::string& name, const Overrides& overrides = {}) {
  return driver::Simulation(shared_scene_of(name, overrides));
}

inline double drift(const driver::Simulation& simulation) {
  return driver::energy_drift(simulation.state());
}

}  // namespace coupled
