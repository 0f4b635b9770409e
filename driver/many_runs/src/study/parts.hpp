// SPDX-License-Identifier: Apache-2.0
// The parts of a study: from the plan to points, from shares to tables.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>

#include "base/case_reader.hpp"
#include "engine/scene.hpp"
#include "many_runs/ensemble.hpp"
#include "many_runs/study.hpp"
#include "many_runs/study_analysis.hpp"

namespace driver {

inline constexpr const char* plan_copy = "plan.toml";  // in the study's folder
/// Tells the tables and pictures of a plan from other files in the study's folder.
ResultFolder::IsOwn files_of_study(const StudyPlan& plan);

/// A file, and the digits of what it held when it was first read.
struct StudyInput {
  std::filesystem::path file;
  std::string digits;
};

/// All files that a study reads, but its plan. Any thread may call.
class StudyInputs {
 public:
  /// Throws FileError for one that holds something else than when it was first read, or can no longer be
  /// read. To be called after what reads the files: then they have been read as they were at first.
  void check(const std::vector<std::filesystem::path>& files);
  void check_all();
  std::vector<StudyInput> list() const;

 private:
  mutable std::mutex lock_;
  std::vector<StudyInput> list_;
};

/// Names of the levels of a point.
std::vector<std::string> level_names(const StudyPlan& plan, const StudyPoint& point);

/// The scene of a point, or of its first factors. Throws FileError if a file cannot be read or has changed,
/// and CaseError for what the case refuses.
Scene scene_at(const StudyPlan& plan, const StudyPoint& point);

/// Scenes of the points that are being computed: a worker takes one, and gives it back for the next runs of
/// the point. Any thread may call.
class StudyScenes {
 public:
  explicit StudyScenes(std::size_t workers) : workers_(workers) {}
  /// One that is free, or a new one: see scene_at().
  std::unique_ptr<Scene> take(const StudyPlan& plan, std::size_t point);
  void give(std::size_t point, std::unique_ptr<Scene> scene);

 private:
  std::size_t workers_;
  std::mutex lock_;
  std::vector<std::pair<std::size_t, std::unique_ptr<Scene>>> free_;  // at most one for each worker
};

/// Runs of one point, with one seed after the other.
using StudyChunk = std::vector<long>;
/// Calls `keep` for each run of a chunk as soon as it has ended. A run that an interrupt stops is not among
/// them, nor is one that the machine stops: FileError and std::runtime_error say so.
void run_chunk(const StudyPlan& plan, const StudyChunk& chunk, StudyScenes& scenes,
               const std::function<void(const StudyRun&)>& keep);

/// Points of the design; `table` is [study].
std::vector<StudyPoint> points_of(TableReader& table, StudyPlan& plan);
/// Reads [analysis] and [stop]. Throws CaseError for what cannot be made of the plan's points.
void read_analysis(TableReader& root, StudyPlan& plan);

/// Points that differ in the size of the convergence alone, by the names of the other factors' levels.
std::map<std::vector<std::string>, std::vector<std::size_t>> size_groups(const StudyPlan& plan);

/// Seed of a run; 0 without a perturbation.
int seed_of(const StudyPlan& plan, long run);
std::size_t point_of(const StudyPlan& plan, long run);

/// Runs that have ended, by their numbers; of one that two shares have computed the first share's.
using StudyRuns = std::map<long, StudyRun>;
/// What opens a share's file, as its build wrote it.
struct StudyRecords {
  StudyRuns runs;
  Provenance lines;  // of the build that computed them
};
/// Whose shares are read: of this plan, case and build, or of any build.
enum class SharesOf { this_build, any_build };
/// Reads all shares of a folder. A line that a kill tore is not there. Throws CaseError for shares of another
/// plan, case or file than those that `plan` was read from, or of different builds, and for damaged lines.
StudyRecords read_shares(const std::filesystem::path& folder, const StudyPlan& plan, SharesOf build);
/// Without its end, as what a crew emits.
std::string line_of(const StudyRun& run);
/// Nothing if the line is none of a run of the plan.
std::optional<StudyRun> run_of_line(const StudyPlan& plan, const std::string& line);
/// What opens a share's part of its file: its build, and the files that it has read.
std::string head_line(const StudyPlan& plan, const std::filesystem::path& folder, const Provenance& build);

/// Counts the runs that have ended, those too that other shares compute meanwhile. It reads only what has
/// been appended to their files since it looked last.
class StudyWatch {
 public:
  /// To be made before the shares are read. Not for a stop rule, whose runs are of one share.
  StudyWatch(const StudyPlan& plan, const std::filesystem::path& folder, const Share& own);
  void add(long run);
  /// Looks at the other shares if that is due, once a second or less often.
  long ended();

 private:
  template <class Action>
  void for_each_file(const Action& action);

  std::filesystem::path folder_;
  std::string own_;
  std::vector<bool> is_ended_;
  long ended_ = 0;
  std::map<std::filesystem::path, std::uintmax_t> read_;  // bytes of each share's file
  std::chrono::steady_clock::time_point next_look_;
};

/// Runs that the plan asks for, given those that have ended: more only after a stop rule's look is whole.
std::vector<long> asked_runs(const StudyPlan& plan, const StudyRuns& ended);

/// What a stop rule has come to at a point: nothing where it claims nothing, as at a base.
enum class StopClaim { none, open, decided, undecided };
/// Of each point; none without a stop rule.
std::vector<StopClaim> stop_claims(const StudyPlan& plan, const StudyRuns& ended);

/// What a study could not say, for its reader.
using StudyNotes = std::vector<std::string>;
/// What runs that are left out could change is the first of the notes.
std::string means_text(const StudyPlan& plan, const StudyRuns& runs, StudyNotes& notes);
/// Indices of each quantity; none if it has none.
using SobolTable = std::vector<std::vector<SobolIndex>>;
SobolTable sobol_table(const StudyPlan& plan, const StudyRuns& runs);
/// Means of a quantity over sizes, at one set of levels of the other factors, and their fit.
struct SizeFit {
  std::size_t quantity = 0;
  std::vector<std::string> others;  // names of the levels; empty for the size
  std::vector<double> sizes, means;
  bool means_differ = false;
  std::optional<Convergence> fit;
};
std::vector<SizeFit> size_fits(const StudyPlan& plan, const StudyRuns& runs);
/// Tables of the analysis; what has no answer is in the notes.
std::string sobol_text(const StudyPlan& plan, const SobolTable& table, StudyNotes& notes);
std::string surface_text(const StudyPlan& plan, const StudyRuns& runs, StudyNotes& notes);
std::string convergence_text(const StudyPlan& plan, const std::vector<SizeFit>& fits, StudyNotes& notes);

/// gnuplot's commands of a picture, or why there is none.
struct StudyPicture {
  std::string commands, why_not;
};
/// Against the first factor that has numbers, else by point.
StudyPicture means_picture(const StudyPlan& plan, const StudyRuns& runs);
StudyPicture sobol_picture(const StudyPlan& plan, const SobolTable& table);
StudyPicture convergence_picture(const StudyPlan& plan, const std::vector<SizeFit>& fits);

/// A cell of a CSV row, and the cells of a point's levels with a comma before each.
std::string csv_cell(const std::string& text);
std::string level_cells(const StudyPlan& plan, std::size_t point);
/// Names of the factors, with a comma before each.
std::string factor_names(const StudyPlan& plan);

/// Values of one quantity at a point by seed; runs that are not done have none.
std::map<int, double> values_at(const StudyPlan& plan, const StudyRuns& runs, std::size_t point,
                                std::size_t quantity);
Statistics statistics_at(const StudyPlan& plan, const StudyRuns& runs, std::size_t point,
                         std::size_t quantity);
/// Differences against the base at common seeds.
std::vector<double> differences(const StudyPlan& plan, const StudyRuns& runs, std::size_t point,
                                std::size_t quantity);

/// [point][factor] in [-1, 1] between the ends of the factor's range, or else its least and greatest number
/// (of their logarithms on a logarithmic scale). None if a level is no number or a factor does not vary.
std::optional<std::vector<std::vector<double>>> scaled_points(const StudyPlan& plan);

}  // namespace driver
