// SPDX-License-Identifier: Apache-2.0
// The fidelity ladder of a scene: which of its effects and resolutions one quantity needs, and what they
// cost.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/compare.hpp"
#include "many_runs/crew.hpp"
#include "many_runs/ensemble.hpp"
#include "many_runs/statistics.hpp"

namespace driver {

/// One way to treat an effect, or one resolution.
struct LadderChoice {
  std::string name;                    // "occlusion off"
  std::vector<std::string> overrides;  // of the case; empty: as it stands
};

/// What the choices of an axis are: ways to treat an effect, the truest last; resolutions of which those from
/// `first` on halve a length or a step each, so that an order can be seen; any that get finer; or assumptions
/// of the model, the case's first, of which nobody knows which is true. The last are not judged, and no other
/// rung has them: they say what the full case may be off by.
enum class AxisKind { effect, halving, tightening, model };

/// An effect or a resolution that the case names, its choices from coarse to fine.
struct LadderAxis {
  std::string name;
  AxisKind kind = AxisKind::effect;
  std::vector<LadderChoice> choices;
  std::size_t base = 0;   // of the full case: the truest way, or the case's own resolution; finer ones follow
  std::size_t first = 0;  // choice that can be compared with its neighbours
  bool follows_mesh = false;  // a finer mesh halves it too
};

struct LadderPlan {
  std::vector<LadderAxis> axes;
  int finer = 1;  // levels of the mesh beyond the case's own
  std::optional<std::vector<std::string>>
      no_membrane;                    // overrides that leave the bag's gas; no tank.volume yet
  double design_volume = 0.0;         // [m3] of the bag; 0 if it is flat
  std::vector<std::string> left_out;  // "cp: why"
};

/// Whether a finer mesh of this plan refines the axis too.
bool follows_finer_mesh(const LadderPlan& plan, const LadderAxis& axis);

/// Choices of the finest rung: the mesh is as fine as it gets, by that what follows it, and everything else
/// that halves is one level finer.
std::vector<std::size_t> finest_picks(const LadderPlan& plan);

/// The overrides of the choices `picks`, one an axis, after `more`; nothing inside a table that is taken out.
std::vector<std::string> combine(const LadderPlan& plan, const std::vector<std::size_t>& picks,
                                 const std::vector<std::string>& more = {});

/// One run, or the mean of several, of the case with `overrides`.
struct LadderRung {
  std::string name;
  std::vector<std::string> overrides;  // beside the user's own
  bool can_be_perturbed = false;       // has a membrane
  std::optional<std::size_t> axis;     // whose choice alone differs from the full case
  std::size_t choice = 0;              // of that axis
  std::string differs;                 // what is not the full case's, joined; else the name
  Statistics value;             // of a single run of a membrane: with the deviation of seeds as its error
  double cpu_seconds = 0.0;     // of one run
  double steps = 0.0;           // of one run
  std::string failure;          // why it has no value
  double error = 0.0;           // value - the reference's
  double standard_error = 0.0;  // of that
  double doubt = 0.0;  // what the error may be off by: standard errors and the reference's uncertainty
  Verdict verdict = Verdict::not_judged;
  int front = 0;  // place on the front by cost, from 1; 0: another is no dearer and as exact
};

/// What lies beyond one value of an axis.
struct Remainder {
  double correction = 0.0;      // to add to that value
  double uncertainty = 0.0;     // of what was added
  double standard_error = 0.0;  // of what was added, from those of the values
  std::optional<double> order;  // where three levels show one from 0.7 to 4.6
};

/// Of values at levels each twice as fine as the one before (AxisKind::halving), else of any that get finer,
/// beyond that at `at`. With an order p seen in the last three, of which both changes exceed two of their
/// standard errors: Richardson's limit, and its own last step as uncertainty. Otherwise nothing is added, and
/// the uncertainty is what the levels after `at` differ by, with the last difference once more: right for
/// order 1 or more.
Remainder remainder(const std::vector<Statistics>& values, std::size_t at, AxisKind kind);

struct LadderReference {
  double value = 0.0;           // that of the finest rung, and the remainder of each resolution
  double standard_error = 0.0;  // of the finest rung and the remainders, added up: they may share runs
  double uncertainty = 0.0;     // of the remainders, root of the sum of squares
  std::vector<std::pair<std::string, Remainder>> remainders;
};

/// What the model's assumptions do to the full case: the lowest and the highest change, 0 among them.
struct ModelBand {
  double low = 0.0, high = 0.0;
  std::string lowest = "full", highest = "full";  // names of those rungs
  bool cheapest_stands = true;  // the cheapest rung is within the tolerance at both ends too
};

struct LadderOptions {
  std::string quantity;     // column of the history at the end, or of an ensemble's quantities; unit optional
  double tolerance = 0.02;  // share of the reference's magnitude, from LadderResult::zero
  std::vector<std::string> hold;  // axes that stay as the case has them
  int runs = 16;                  // of each rung where the scene is chaotic
  bool quiet = false;
  int most_runs = 0;          // of a rung whose verdict stays open, if above `runs`: see sequential_test.hpp
  double error_rate = 0.025;  // of one verdict being wrong by the scatter of runs
  int finer = 1;              // levels of the mesh beyond the case's own, 1 to 3
};

struct LadderResult {
  std::string quantity;  // full name
  double zero = 0.0;     // value from which the quantity counts: the ambient pressure for pressures
  LadderPlan plan;
  bool chaotic = false;           // rungs are means: seeds scatter, or --most-runs asks for it
  double spread = 0.0;            // of the quantity over seeds of the full case; scenes with a membrane
  std::vector<LadderRung> rungs;  // the full case first
  std::size_t finest = 0;         // of them
  LadderReference reference;
  std::optional<ModelBand> model;         // of a plan with such axes
  std::optional<std::size_t> cheapest;    // rung within the tolerance
  Verdict verdict = Verdict::not_judged;  // inside: `cheapest` is set; else undecided, or not_judged
  std::string reason;  // why there is no share to judge by: no such event, or a value of nothing
};

/// What a rung does to the full case; standard error 0 for that itself.
struct Change {
  double value = 0.0, standard_error = 0.0;
};
Change change_of(const LadderResult& result, const LadderRung& rung);

/// Share of the tolerance below which errors do not tell rungs apart on the front.
inline constexpr double least_share = 1e-3;

/// Share of the tolerance by which the error of a rung on the bound may lie beside it.
inline constexpr double bound_width = 0.2;

/// Reference, errors, front and verdicts of rungs that have run, with the costs that they have. In a chaotic
/// scene fewer than 16 runs, of a rung or of the finest, decide nothing. A verdict is wrong by scatter at
/// most at the rate `error_rate`: it allows for as many standard errors as Student's t has for that,
/// one-sided.
void judge(LadderResult& result, double tolerance, double error_rate = 0.025);

/// Rungs of a judged ladder of a chaotic scene of which more runs may decide an open verdict: that rung, and
/// those that the reference rests on, whichever scatters more. None where the reference's uncertainty keeps
/// the verdict open and is more than scatter.
std::vector<std::size_t> open_rungs(const LadderResult& result, double tolerance);

/// The axes of a case. Throws CaseError for a bad case, a quantity it does not have, a held axis it does not
/// have, and nothing left to vary.
LadderPlan plan_ladder(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                       const std::string& quantity, const std::vector<std::string>& hold, int finer = 1);

/// The runs of a ladder as the work of a crew; `quantity` by its whole name.
CrewWork ladder_work(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                     const std::string& quantity, int workers);

/// Runs the ladder of `plan`; results but the costs do not depend on who computes them. Where the quantity is
/// 0 in the full case or has no event there, only that is run, and `reason` says so. Throws CaseError for a
/// case that cannot be read, and std::runtime_error when the full case, one of its seeds or the finest rung
/// leaves its domain: errors have no reference then. With a folder each run that ends is kept in its
/// journal, and what stands there is not run again.
LadderResult run_ladder(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                        const LadderPlan& plan, const LadderOptions& options, Crew& crew,
                        ResultFolder* folder);
/// The same on threads of this process, and without a folder. Throws CaseError as plan_ladder does.
LadderResult run_ladder(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                        const LadderOptions& options, int threads = 1);

/// ladder.csv, ladder.json, and, if there is a cheapest rung, cheapest.toml, which runs as it is. `partial`,
/// of one that was interrupted: what had run by then. Throws WriteError.
void write_ladder(ResultFolder& folder, const LadderResult& result, const std::filesystem::path& file,
                  const std::vector<std::string>& overrides, const LadderOptions& options, bool partial);

/// The chart of a ladder that has been judged, error against cost of its rungs: ladder.gp, gnuplot's commands
/// with the numbers, and ladder.svg, which gnuplot draws of them. Returns why there is no picture; empty:
/// there is. Throws WriteError.
std::string draw_ladder(ResultFolder& folder, const LadderResult& result, const LadderOptions& options);

}  // namespace driver
