// SPDX-License-Identifier: Apache-2.0
// A run with its result files.
#pragma once

#include <filesystem>
#include <functional>

#include "base/run_id.hpp"
#include "engine/run.hpp"

namespace driver {

class CaseDocument;

struct RunOptions {
  bool quiet = false;
  int threads = 1;
  LevelSink watch = {};              // called for each level, after the files; may be empty
  std::function<bool()> stop = {};   // called before every step, instead of the test for Ctrl-C
  std::function<void()> ready = {};  // called once after all is set up, before anything is written
  /// The case of the scene. With it the run writes check.json: settings, defaults, and derived values.
  const CaseDocument* document = nullptr;
};

/// Runs and writes history.csv, energy.csv, summary.json, check.json (and frames and fields) to `folder`.
/// `provenance` has the first lines of the files; its "run" is the id, by default made of the other lines
/// except the date. Throws OutputError before it touches an earlier run, and as ResultFolder does.
RunOutcome run_to_folder(const Scene& scene, const std::filesystem::path& folder,
                         const Provenance& provenance, const RunOptions& options);

}  // namespace driver
