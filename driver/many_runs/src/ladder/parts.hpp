// SPDX-License-Identifier: Apache-2.0
// Parts of a ladder: its plan, its runs, its verdict; and the settings of a case by their path.
#pragma once

#include "base/journal.hpp"
#include "ensemble/member.hpp"
#include "many_runs/ladder.hpp"

namespace driver {

/// Share of a cost from which on another is cheaper: CPU times repeat to some percent.
inline constexpr double worth_it = 0.97;
/// Steps of a coarser choice, as a share of the full case's, up to which it may save something. They are the
/// same in each run, which times are not.
inline constexpr double most_steps = 1.03;

/// Seeds that tell a chaotic scene, and the scatter of one that is not.
inline constexpr int probes = 4;

/// Settings of a case that has been read.
class CaseSettings {
 public:
  explicit CaseSettings(const CaseDocument& document) : settings_(document.settings()) {}
  /// As TOML, given or by default; empty if the case has no use for the key.
  std::string value(const std::string& path) const;
  /// The key, or one inside the table `path`, is given.
  bool has(const std::string& path) const;
  /// Adds what makes `path` be `value`, nothing if it is.
  void set(std::vector<std::string>& overrides, const std::string& path, const std::string& value) const;
  /// Adds what takes `path` out of the case, nothing if it is not given.
  void unset(std::vector<std::string>& overrides, const std::string& path) const;
  /// Path of a key of a jet.
  static std::string jet_key(const JetPart& jet, const char* key);

 private:
  const std::vector<Setting>& settings_;
};

void add_effects(const Scene& scene, const CaseSettings& settings, LadderPlan& plan);
void add_resolutions(const Scene& scene, const CaseSettings& settings, LadderPlan& plan);

/// Adds what takes the membrane out of the bag's case to the plan, or says why that cannot be.
void add_no_membrane(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                     const Scene& scene, const CaseSettings& settings, const std::string& quantity,
                     LadderPlan& plan);

/// The gas of the plan's bag in a rigid tank of its design volume; or nothing, and the plan says why.
std::optional<LadderChoice> rigid_tank(LadderPlan& plan);

/// The same in a volume that follows its pressure as that of the bag of the case with `overrides` does at
/// rest; or nothing, and the plan says why unless it was an interrupt.
std::optional<LadderChoice> bag_by_volume(const std::filesystem::path& file,
                                          const std::vector<std::string>& overrides, bool quiet,
                                          LadderPlan& plan, Journal& journal);

/// The full case less one thing more each time, the least important first: the name of what is left out, and
/// all choices. None of it depends on the clock: the rungs are the same whenever and in how many parts a
/// ladder runs.
std::vector<std::pair<std::string, std::vector<std::size_t>>> combinations(const LadderResult& result);

struct LadderJob {
  std::size_t rung = 0;
  std::vector<std::string> overrides;  // all of them
  bool is_one_of_many = false;         // of an ensemble; else a short run is repeated, for its cost
};

struct LadderSample {
  std::optional<double> value;
  double cpu_seconds = 0.0;
  long steps = 0;
  std::string failure;    // why it has no value
  bool no_event = false;  // that is all: the run is whole
};

/// One sample a job, by a crew of ladder_work(); those that an interrupt forestalled have neither value nor
/// failure. What stands in the journal is not run again.
std::vector<LadderSample> run_jobs(Crew& crew, const std::vector<LadderJob>& jobs, const std::string& title,
                                   bool quiet, Journal& journal);

}  // namespace driver
