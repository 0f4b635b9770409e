// SPDX-License-Identifier: Apache-2.0
// The runs of a plan as jobs of a crew. All commands of many runs write their jobs here.
#pragma once

#include "engine/scene.hpp"
#include "run_journal.hpp"

namespace driver {

/// What the runs of one case have in common.
struct RunCase {
  /// The scene with these overrides; several threads may call it.
  std::function<Scene(const std::vector<std::string>& overrides)> load;
  std::vector<std::string> quantities;
  bool with_rows = false;
  /// A run that the case or its models refuse is a run, "refused"; else the error ends all.
  bool keeps_refusals = true;
};

/// Runs of one scene, with one seed after the other.
struct RunJob {
  std::size_t place = 0;                   // of its case
  std::string name;                        // for messages
  std::vector<std::string> overrides;      // of the case
  double amplitude = 0.0;                  // [m] of the displacement of the initial nodes
  std::vector<std::pair<long, int>> runs;  // number and seed; seed 0: the nodes stay
  bool for_cost = false;                   // a short run is repeated: the cost is the least of them
};

/// Computes jobs. A run that an interrupt stops has no result, nor has one that the machine stops: FileError
/// and std::runtime_error say so. At most `workers` threads call it at a time.
CrewWork run_work(std::vector<RunCase> cases, int workers);

/// Jobs of one go.
struct RunBatch {
  std::string title;  // of the progress
  bool quiet = false;
  long runs = 0;
  std::size_t jobs = 0;
  std::function<RunJob(std::size_t)> job;  // several threads may call it
  long of_all = 0;  // if above 0, the progress counts the runs of all shares, of which there are so many
};
/// A job of its own for each of `jobs`.
RunBatch batch_of(std::string title, bool quiet, std::vector<RunJob> jobs);

/// Lets a crew of run_work() compute jobs, and keeps each run in the journal as soon as it has ended.
void compute_runs(Crew& crew, const RunBatch& batch, RunJournal& journal);

/// Tells that runs are in the journal already.
void tell_start(const std::string& title, const RunJournal& journal, bool quiet);

}  // namespace driver
