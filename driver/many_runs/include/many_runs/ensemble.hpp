// SPDX-License-Identifier: Apache-2.0
// Perturbed runs of one scene: a chaotic scene has a distribution, not a result.
#pragma once

#include <deque>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/case_reader.hpp"
#include "base/result_folder.hpp"
#include "engine/run.hpp"
#include "many_runs/crew.hpp"
#include "many_runs/share.hpp"
#include "many_runs/statistics.hpp"

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
  int asked = 0, ended = 0;           // runs of the share; those that an interrupt stopped have not ended
};

/// A case whose scene has a membrane.
struct EnsembleCase {
  std::filesystem::path file;
  std::vector<std::string> overrides;
  Scene scene;
};
/// Throws CaseError for a bad case, a scene that has no membrane to perturb, and overrides of the
/// perturbation.
EnsembleCase read_ensemble_case(const std::filesystem::path& file, const std::vector<std::string>& overrides);

/// The runs of cases as the work of a crew.
CrewWork ensemble_work(const std::deque<EnsembleCase>& cases, int workers);

/// Runs cases[place] with `runs` seeds from `first_seed` on, or the share of them; the result does not depend
/// on who computes them. `crew` does ensemble_work(cases). Each run that ends is kept in the journal of
/// `folder`. What stands there or in the shares below `whole`, the folder of all runs, is not run again.
EnsembleResult run_ensemble(const std::deque<EnsembleCase>& cases, std::size_t place,
                            const EnsembleOptions& options, Crew& crew, ResultFolder& folder,
                            const std::filesystem::path& whole);
/// The same of one case, on threads of this process, and without a folder.
EnsembleResult run_ensemble(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                            const EnsembleOptions& options, int threads = 1);

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
