// SPDX-License-Identifier: Apache-2.0
// Runs a shipped case in memory.
#pragma once

#include <string>
#include <vector>

#include "driver/run.hpp"

namespace coupled {

struct CaseRun {
  driver::RunOutcome outcome;
  std::vector<driver::Record> history;
  std::vector<driver::EnergyRecord> energy;
  driver::State state;
};

inline std::string case_file(const std::string& name) {
  return GASJET_SOURCE_DIR "/cases/" + name + ".toml";
}

inline driver::Scene scene_of(const std::string& name, const std::vector<std::string>& overrides = {}) {
  driver::CaseDocument document(case_file(name), overrides);
  return driver::read_scene(document);
}

inline CaseRun run_case(const std::string& name, const std::vector<std::string>& overrides = {}) {
  const driver::Scene scene = scene_of(name, overrides);
  CaseRun run;
  run.state = driver::make_state(scene);
  run.outcome =
      driver::run_scene(scene, run.state, [&](const driver::StepRecords* records, const driver::State&) {
        if (!records) return;
        run.history.push_back(records->history);
        run.energy.push_back(records->energy);
      });
  return run;
}

}  // namespace coupled
