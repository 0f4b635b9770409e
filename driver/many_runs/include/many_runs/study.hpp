// SPDX-License-Identifier: Apache-2.0
// Many independent runs of one case: factors, points, seeds; in shares, on as many machines as there are.
#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "many_runs/crew.hpp"
#include "many_runs/distribution.hpp"
#include "many_runs/run_record.hpp"
#include "many_runs/share.hpp"

namespace driver {

/// One value of a factor: its name in the tables, and what it changes in the case.
struct StudyLevel {
  std::string name;
  std::vector<std::string> overrides;
  std::optional<double> number;                    // of a level that is a number
  std::optional<int> seeds = std::nullopt;         // at most those of the study
  std::optional<double> amplitude = std::nullopt;  // instead of the study's
};

/// What a study varies: listed levels, or a range or a distribution that a sampled design takes values from.
struct StudyFactor {
  std::string name;                // column of the tables
  std::string key;                 // path in the case; empty if the levels say what they change
  std::vector<StudyLevel> levels;  // none: a range, a distribution, or the columns of a file
  double low = 0.0, high = 0.0;    // of a range
  bool logarithmic = false;
  std::optional<Distribution> distribution;
  std::string path;  // of its table in the plan

  bool has_range() const { return high > low; }
  /// Whether a sampled design can take values from it.
  bool is_sampled() const { return has_range() || distribution; }
  /// The value below which a share in (0, 1) of the range, or of the distribution, lies.
  double sampled_value(double unit) const;

  // Of a point's value of this factor, see StudyPoint; the first is nothing for a number that has no level.
  const StudyLevel* level_of(double value) const;
  std::string name_of(double value) const;
  std::vector<std::string> overrides_of(double value) const;
  std::optional<double> number_of(double value) const;
};

/// How the points follow from the factors.
enum class StudyDesign { grid, list, latin_hypercube, sobol, sobol_indices, file };
/// True for those whose points are samples of the factors.
bool is_sampled(StudyDesign design);

/// One point: a value of each factor. It is the place of a level in the factor's list, or a number if the
/// factor has no list. There may be millions.
using StudyPoint = std::vector<double>;

/// Differences are taken against the point where `factor` has its level `level` and all others are the same.
struct StudyBase {
  std::size_t factor = 0;
  std::string level;
};

/// Seeds are added, twice as many at each look, until each point has what is asked for.
struct StudyStop {
  std::string quantity;
  std::optional<double> standard_error;  // wanted, of the mean
  std::optional<double> error_rate;      // of the sign of the difference against the base
  int most_seeds = 0;
};

/// A value that a quantity should not pass.
struct StudyLimit {
  std::size_t quantity = 0;
  double value = 0.0;
  bool above = true;  // what counts: runs above it, or runs below it
};

/// What is computed of the means and values of all points.
struct StudyAnalysis {
  bool response_surface = false;
  bool pictures = false;                   // of the tables
  std::optional<std::size_t> convergence;  // factor whose numbers are sizes
  std::vector<StudyLimit> limits;
};

class StudyInputs;

/// A plan that has been read.
struct StudyPlan {
  std::filesystem::path file, case_file;
  std::string name;
  std::vector<std::string> overrides;  // of every run
  std::vector<StudyFactor> factors;
  StudyDesign design = StudyDesign::grid;
  std::optional<Correlation> correlation;  // of the factors
  std::filesystem::path points_file;       // CSV of the points; empty if they are of no file
  std::vector<StudyPoint> points;
  int seeds = 0;  // for each point, at first; 0: one run without a perturbation
  double amplitude = 0.0;
  std::vector<std::string> quantities;
  std::optional<StudyBase> base;
  std::vector<std::optional<std::size_t>> bases;  // of each point: the point that it is compared with
  std::optional<StudyStop> stop;
  StudyAnalysis analysis;
  std::string text;                     // of its file
  std::string id;                       // of the plan, the case, their files and this build
  std::shared_ptr<StudyInputs> inputs;  // the case, and the files that the plan and the case name

  int most_seeds() const { return stop ? stop->most_seeds : std::max(seeds, 1); }
  /// Of a point: the fewest that it or one of its levels asks for.
  int seeds_at(std::size_t point) const;
  /// Of a point: that of its last level that has one.
  double amplitude_at(std::size_t point) const;
  /// Runs that it can ask for.
  long most_runs() const;
  /// Numbers of runs lie below it: that of a run is point * most_seeds() + seed - 1 (seed 0 and 1 alike).
  long end_of_numbers() const { return static_cast<long>(points.size()) * most_seeds(); }
};

/// Reads a plan and builds the scenes at the ends of each factor's range. Throws CaseError
/// `file:line:column: key: message` for a plan, a factor, a range or a quantity that the case does not have.
StudyPlan read_study(const std::filesystem::path& file);

/// Computes one run at the first point and one at the last, those of the first seed: a sample of what runs
/// cost. Fewer after an interrupt.
std::vector<RunRecord> sample_runs(const StudyPlan& plan);

/// The runs of a plan, which must outlive it, as the work of a crew; at most `workers` call it at a time.
CrewWork study_work(const StudyPlan& plan, int workers);

/// Lets a crew of study_work() compute what no share in `folder` has computed yet of `share`. Each run that
/// ends is kept at once, in folder/shares/NAME. False if an interrupt stopped it. Throws OutputError and
/// WriteError.
bool run_study(const StudyPlan& plan, const std::filesystem::path& folder, const Share& share, Crew& crew,
               bool quiet);

/// What a merge found.
struct StudySummary {
  long runs = 0, asked = 0;                                // ended; asked for by the plan so far
  long done = 0, inaccurate = 0, failed = 0, refused = 0;  // of the ended
  double cpu_seconds = 0.0;
  long decided = 0, undecided = 0;    // points of a stop rule; the latter after all seeds that it allows
  std::vector<std::string> findings;  // percentiles and chances, of a sampled design
  std::vector<std::string> notes;     // what has no answer, and why
  bool complete() const { return runs == asked; }
};

/// Lines for the reader of a summary: what a stop rule has decided, the findings, and the first of the notes.
std::vector<std::string> note_lines(const StudySummary& summary);

/// Writes results.csv, timing.csv, means.csv, study.json and what the plan's analysis asks for from all
/// shares of a folder. The bytes of all but timing.csv do not depend on how the runs were shared out. Throws
/// CaseError for a folder without a plan or with shares of different plans or builds.
StudySummary merge_study(const std::filesystem::path& folder);

}  // namespace driver
