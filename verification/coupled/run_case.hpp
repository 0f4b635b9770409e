// SPDX-License-Identifier: Apache-2.0
// Runs a shipped case in memory.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/columns.hpp"
#include "engine/run.hpp"
#include "results/load_scene.hpp"

namespace coupled {

using Row = std::map<std::string, double>;  // by the column's name

inline Row row_of(const std::vector<driver::Column>& columns, const driver::Scene& scene,
                  const driver::State& state) {
  Row row;
  for (const auto& column : columns) row[column.name] = column.value(scene, state);
  return row;
}

struct CaseRun {
  driver::RunOutcome outcome;
  std::vector<Row> history, energy;
  driver::State state;
};

inline std::string case_file(const std::string& name) {
  return GASJET_SOURCE_DIR "/cases/" + name + ".toml";
}

inline driver::Scene scene_of(const std::string& name, const std::vector<std::string>& overrides = {}) {
  driver::CaseDocument document(case_file(name), overrides);
  return driver::load_scene(document);
}

inline CaseRun run_of(const driver::Scene& scene,
                      const driver::Executor& executor = driver::Executor::serial()) {
  CaseRun run;
  run.state = driver::make_state(scene);
  const auto history = driver::history_columns(scene), energy = driver::energy_columns(scene);
  const auto record = [&](bool recorded, const driver::State& now) {
    if (!recorded) return;
    run.history.push_back(row_of(history, scene, now));
    run.energy.push_back(row_of(energy, scene, now));
  };
  run.outcome = driver::run_scene(scene, run.state, record, {}, executor);
  return run;
}

inline CaseRun run_case(const std::string& name, const std::vector<std::string>& overrides = {},
                        const driver::Executor& executor = driver::Executor::serial()) {
  return run_of(scene_of(name, overrides), executor);
}

}  // namespace coupled
