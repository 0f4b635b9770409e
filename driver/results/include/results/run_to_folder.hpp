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
  LevelSink watch = {};              // after the files have got the level; may be empty
  std::function<bool()> stop = {};   // asked before every step, instead of Ctrl-C
  std::function<void()> ready = {};  // called once all is set up, before anything is written
  /// Of the scene; with it check.json tells the case with its defaults, and what follows from them.
  const CaseDocument* document = nullptr;
};

/// Runs and writes history.csv, energy.csv, summary.json, check.json (and frames and fields) to `folder`.
/// `provenance` opens the files; its "run" is the id, by default that of the other lines but the date. Throws
/// OutputError before anything of an earlier run is touched, and as ResultFolder does.
RunOutcome run_to_folder(const Scene& scene, const std::filesystem::path& folder,
                         const Provenance& provenance, const RunOptions& options);

}  // namespace driver
