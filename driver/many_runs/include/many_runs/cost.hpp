// SPDX-License-Identifier: Apache-2.0
// What the parts of a scene cost: whole runs of the case as it is and with one part left out or changed, in
// turn, by their CPU time.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/case_reader.hpp"
#include "base/result_folder.hpp"
#include "engine/state.hpp"

namespace driver {

struct CostOptions {
  int runs = 9;     // of each variant; a third of them for those that take more than five times as long
  int threads = 1;  // of each run
  bool quiet = false;
};

/// One way to run the case.
struct CostVariant {
  std::string name = {};
  std::vector<std::string> overrides = {};  // beside those of the case
  bool writes_files = true;
  std::string failure = {};  // why it has no numbers

  long steps = 0;
  /// [s] CPU time of each run, in their order: from the state at the start to the last file.
  std::vector<double> cpu_seconds = {};
  /// [s] CPU time of each stage, and of all else (start, rows, files), in a run of the least CPU time: they
  /// add up to it. Shares of the stages in all runs.
  std::array<double, kStages> stage_seconds{};
  double rest_seconds = 0.0;

  double least() const;    // [s] of cpu_seconds
  double median() const;   // [s]
  double largest() const;  // [s]
  /// [s] CPU time of a step, all else shared out.
  double per_step() const;
};

/// What the case as it is costs more than a variant; negative if less.
struct CostDifference {
  double run_seconds = 0.0;      // [s] of the least CPU times: the sum of the next two
  double by_steps = 0.0;         // [s] of the steps that the case takes more, each at its cost in the case
  double by_cost = 0.0;          // [s] of a step's cost, for the steps of the variant
  double scatter = 0.0;          // [s] half of what the middle half of the runs' differences, in pairs, spans
  double ratio = 1.0;            // of the least CPU times: the case as it is over the variant
  double low = 1.0, high = 1.0;  // middle half of the runs' ratios, in pairs
};

struct CostResult {
  std::string scene;
  std::optional<int> elements;  // of the bag
  int runs = 0, threads = 1;
  std::vector<CostVariant> variants;  // the case as it is first
  std::vector<std::string> left_out;  // name: why

  /// nullptr if there is none of that name, or it has no numbers.
  const CostVariant* find(const std::string& name) const;
};

inline constexpr const char* cost_base = "as it is";
inline constexpr const char* cost_no_jet = "without jet";
inline constexpr const char* cost_no_occlusion = "without hidden-element test";
inline constexpr const char* cost_no_contact = "without pendulum and contact";
inline constexpr const char* cost_no_self_contact = "without self-contact";
inline constexpr const char* cost_no_files = "without files";

/// The paper's two runs of its scene [s], with the jet and without.
inline constexpr double paper_cpu_with_jet = 3803.0, paper_cpu_without = 2072.0;

/// Adds the case as it is, and what it can be run without.
void add_variants(const Scene& scene, const CaseDocument& document, CostResult& result);

/// Names the variants that the case has, and runs each in turn, first all once, to warm up. Stops early after
/// an interrupt, with what was measured. Throws CaseError for a case that is refused, OutputError or
/// WriteError where the folder for temporary files takes none.
CostResult measure_cost(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                        const CostOptions& options);

CostDifference cost_difference(const CostVariant& base, const CostVariant& variant);

/// Tables for people.
std::string cost_text(const CostResult& result);
/// cost.csv: one row a variant.
std::string cost_csv(const CostResult& result);
/// cost.json: all that was measured.
std::string cost_json(const CostResult& result, const Provenance& lines);

}  // namespace driver
