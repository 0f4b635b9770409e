// SPDX-License-Identifier: Apache-2.0
// Perturbed runs of one scene: a chaotic scene has a distribution, not a result.
#pragma once

#include <algorithm>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "base/case_reader.hpp"
#include "base/result_folder.hpp"
#include "base/share.hpp"
#include "engine/run.hpp"
#include "many_runs/crew.hpp"

namespace driver {

/// A fifth of the paper's fabric: smaller seeds have not grown to the full scatter by the end of its scene,
/// see docs/ensembles.md.
inline constexpr double default_amplitude = 1e-4;  // [m]

struct EnsembleOptions {
  int runs = 16;
  double amplitude = default_amplitude;  // [m] largest random displacement of the initial nodes
  int first_seed = 1;                    // of the displacements; the runs have this and the following ones
  bool quiet = false;
  Share share = {};  // of the runs
};

/// Mean, its standard error (sample deviation / sqrt(n)) and extremes over the runs.
struct Statistics {
  double mean = 0.0;
  double standard_error = 0.0;
  double minimum = 0.0;
  double maximum = 0.0;
  int count = 0;
};
Statistics statistics(const std::vector<double>& values);

/// One row of the mean history: time, then statistics of each column of the scene's history and of the
/// filtered accelerations of a pendulum.
struct EnsembleRow {
  double time_s = 0.0;
  std::vector<Statistics> values;
};

/// Columns of one run at some of the rows, for pictures.
struct SingleRun {
  int seed = 0;
  std::vector<std::vector<double>> rows;  // of the columns, without time
};

struct EnsembleResult {
  std::vector<std::string> columns;  // of the history, without time
  std::vector<EnsembleRow> rows;     // at multiples of the history interval
  std::vector<SingleRun> singles;    // of the first runs, 16 at most
  std::size_t singles_every = 1;     // their rows are every such row of the means: 201 at most
  std::map<std::string, std::vector<double>>
      quantities;                     // one value a run: first contact, final angle, peaks
  std::vector<std::string> failures;  // of runs that left their domain or were inaccurate: in no mean
  std::vector<std::string> warnings;  // of runs whose energy drifts by more than a thousandth: in the means
  int asked = 0, ended = 0;           // runs; those that an interrupt stopped have not ended
};

/// Throws CaseError for a bad case, a scene that has no membrane to perturb, and overrides of the
/// perturbation.
Scene read_ensemble_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides);

/// The runs of scenes, which must outlive it, as the work of a crew. `amplitude` [m] is that of
/// EnsembleOptions.
CrewWork ensemble_work(const std::deque<Scene>& scenes, double amplitude);
/// A scene with a membrane, and the crew that computes its runs.
struct EnsembleScene {
  const Scene& scene;
  Crew& crew;  // of ensemble_work()
  int number;  // index of the scene in that work
};

/// Runs a scene with `runs` seeds from `first_seed` on; the result does not depend on who computes them. Each
/// run that ends is noted in the folder's journal, and what stands there is not run again.
EnsembleResult run_ensemble(const EnsembleScene& scene, const EnsembleOptions& options, ResultFolder& folder);
/// The same on threads of this process, and without a folder.
EnsembleResult run_ensemble(const Scene& scene, const EnsembleOptions& options, int threads = 1);
/// What a share has come to.
struct ShareOutcome {
  int asked = 0, ended = 0, failed = 0;  // runs; failed: left their domain or inaccurate
};
/// The runs of a share, each noted in the journal of `folder`: shares/NAME in that of the whole ensemble,
/// whose run_ensemble() then has them.
ShareOutcome run_ensemble_share(const EnsembleScene& scene, const EnsembleOptions& options,
                                ResultFolder& folder);

/// ensemble.csv (time, mean and standard error of each column), quantities.csv (one row a quantity) and
/// ensemble.json (the same with the value of each run, and failures), runs.csv (single runs). Each says how
/// many of the runs had ended. Throws WriteError.
void write_ensemble(ResultFolder& folder, const EnsembleResult& result);

/// "done", or "interrupted" before all runs had ended.
const char* status_of(const EnsembleResult& result);

/// Difference of two means in units of its standard error.
struct Effect {
  std::string quantity;
  Statistics with, without;
  double difference = 0.0;
  double standard_errors = 0.0;  // infinite for runs without any scatter
  /// Standard errors that decide: 5, or with few runs as many as chance exceeds as rarely as 5 by 16 runs,
  /// once in 6000 (Welch's test, if the scatter is normal). Infinite for one run.
  double needed = 0.0;
  bool decided() const { return standard_errors > needed; }
};
std::vector<Effect> effects(const EnsembleResult& with, const EnsembleResult& without);

}  // namespace driver
