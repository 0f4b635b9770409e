// SPDX-License-Identifier: Apache-2.0
// A run with its result files.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "base/run_id.hpp"
#include "engine/run.hpp"
#include "results/skin_checks.hpp"

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

/// Result files of one run, from its start to its end: history.csv, energy.csv, summary.json, check.json,
/// frames and fields.
class RunFolder {
 public:
  /// Begins the files. Throws OutputError before it touches an earlier run, and as ResultFolder does. `scene`
  /// must outlive the object; the other arguments as in run_to_folder().
  RunFolder(const Scene& scene, const std::filesystem::path& folder, const Provenance& provenance,
            const RunOptions& options);
  ~RunFolder();

  /// To be called for each level. It and the views refer to this object.
  LevelSink sink();
  std::vector<LevelView> views();
  /// Looks at the skin so far.
  const SkinChecks& checks() const;
  /// The scene of the levels that follow, if its caller has changed it; it must outlive their calls.
  void follow(const Scene& scene);
  /// Completes the files of a run with that outcome, and adds its notes.
  void end(const State& state, RunOutcome& outcome);

 private:
  struct Files;
  std::unique_ptr<Files> files_;
};

/// Runs and writes history.csv, energy.csv, summary.json, check.json (and frames and fields) to `folder`.
/// `provenance` has the first lines of the files; its "run" is the id, by default made of the other lines
/// except the date. Throws OutputError before it touches an earlier run, and as ResultFolder does.
RunOutcome run_to_folder(const Scene& scene, const std::filesystem::path& folder,
                         const Provenance& provenance, const RunOptions& options);

}  // namespace driver
