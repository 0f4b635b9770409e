// SPDX-License-Identifier: Apache-2.0
#include "sim_object.hpp"

namespace border {

void Sim::watch() {
  driver::LevelSink files = folder ? folder->sink() : driver::LevelSink{};
  simulation.watch(
      [this, files](bool recorded, const driver::State& now) {
        if (recorded)
          for (Table& table : tables) table.record(simulation.scene(), now);
        if (!files) return;
        folder->follow(simulation.scene());
        files(recorded, now);
      },
      folder ? folder->views() : std::vector<driver::LevelView>{checks.view()});
}

void Sim::open(const std::string& path, const driver::RunOptions& options) {
  folder.emplace(*simulation.now().given, path, lines, options);
  watch();
}

void Sim::finish() {
  if (simulation.ended() && simulation.now().failure.empty()) simulation.evaluate();
  if (!folder) return;
  driver::RunOutcome outcome = simulation.outcome();
  folder->follow(simulation.scene());
  folder->end(state(), outcome);
  checks.go_on_as(folder->checks());
  folder.reset();
  watch();
}

Sim::~Sim() {
  try {
    finish();
  } catch (const std::exception&) {  // a full disk, say: no caller is left to report to
  }
}

}  // namespace border
