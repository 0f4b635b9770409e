// SPDX-License-Identifier: Apache-2.0
// Difference of two histories against the reference's error band.
#include <fmt/format.h>

#include <fstream>

#include "argument_list.hpp"
#include "base/case_reader.hpp"
#include "base/number_text.hpp"
#include "base/progress.hpp"
#include "commands/command.hpp"
#include "compare/compare.hpp"
#include "compare_enclosure.hpp"
#include "input_files.hpp"
#include "results/results.hpp"

namespace driver::commands {
namespace {

std::string runs_text(int runs) {
  return runs == 1 ? "one run" : fmt::format("the mean of {} runs", runs);
}

std::string seen_text(const QuantityDifference& q) {
  return fmt::format("{:>9}", q.seen ? fmt::format("{:.3g} %", 100.0 * *q.seen) : "-");
}

void print_text(const CompareArguments& a, const Difference& difference) {
  fmt::print("{} against {}", a.mine.string(), a.reference.string());
  if (!difference.time.empty())
    fmt::print(": {} times from {:.6g} to {:.6g} s", difference.time.size(), difference.time.front(),
               difference.time.back());
  if (difference.reference_runs > 1)
    fmt::print("; {} against the mean of {}", runs_text(difference.runs), difference.reference_runs);
  const bool means = difference.reference_runs > 1;
  fmt::print("\n{:34} {:>10} {:>10} {:>10} {:>9} {:>8} {:>10} {:>12} {:>9} {:>12} {:>9} {} {}\n", "quantity",
             "max error", "at [s]", "L2 error", "relative", "of band", "lag [s]", "peak", "at [s]",
             "reference", "at [s]", means ? "     sees" : "", "verdict");
  for (const auto& q : difference.quantities) {
    if (q.values.empty()) {
      fmt::print("{:34} {}: {}\n", q.name, verdict_name(q.verdict), q.reason);
      continue;
    }
    fmt::print(
        "{:34} {:10.4g} {:10.4g} {:10.4g} {:>9} {:>8} {:>10} {:12.6g} {:9.4g} {:12.6g} {:9.4g} {} {}{}\n",
        q.name, q.largest.value, q.largest.time, q.l2, q.relative ? fmt::format("{:.2e}", *q.relative) : "-",
        q.band.empty() ? "-" : fmt::format("{:.3g}", q.share_of_band),
        q.phase_lag ? fmt::format("{:.3g}", *q.phase_lag) : "-", q.mine.value, q.mine.time, q.reference.value,
        q.reference.time, means ? seen_text(q) : "", verdict_name(q.verdict),
        q.reason.empty() ? "" : ": " + q.reason);
  }
  if (means)
    fmt::print("sees: the change of the reference's peak that would be outside in nine of ten cases\n");
  if (means && difference.verdict == Verdict::outside)
    fmt::print(
        "the reference's runs start with nodes displaced at random (membrane.perturbation) and have rows by "
        "output.history_exact of the case: check that mine do, too\n");
  fmt::print("{}{}\n", verdict_name(difference.verdict),
             difference.reason.empty() ? "" : ": " + difference.reason);
}

double part_of_one(const std::string& option, std::string_view text) {
  const auto share = fraction_of(text);
  if (!share || *share < 0.0 || *share > 1.0)
    throw CaseError(
        fmt::format("--tolerance {}: '{}' is not a share, allowed: a finite number from 0 to 1, such as 0.02 "
                    "or 2%, or COLUMN=SHARE",
                    option, text));
  return *share;
}

Tolerance tolerance_of(const std::vector<std::string>& options) {
  Tolerance tolerance;
  bool given = false;
  for (const auto& text : options) {
    const auto equals = text.find('=');
    const bool of_one = equals != std::string::npos;
    const double share = part_of_one(text, std::string_view(text).substr(of_one ? equals + 1 : 0));
    if (of_one ? !tolerance.of.emplace(text.substr(0, equals), share).second : given)
      throw CaseError(fmt::format("--tolerance {}: is given twice, allowed: once", text));
    if (of_one) continue;
    given = true;
    tolerance.share = share;
  }
  return tolerance;
}

void write_rows(const std::filesystem::path& file, const Difference& difference) {
  std::string rows = "time_s";
  for (const auto& q : difference.quantities) {
    if (q.values.empty()) continue;
    rows += fmt::format(",{0},{0}_reference", q.name);
    if (!q.band.empty()) rows += ',' + q.name + band_suffix;
  }
  for (std::size_t i = 0; i < difference.time.size(); ++i) {
    rows += fmt::format("\n{}", difference.time[i]);
    for (const auto& q : difference.quantities) {
      if (q.values.empty()) continue;
      rows += fmt::format(",{},{}", q.values[i], q.expected[i]);
      if (!q.band.empty()) rows += fmt::format(",{}", q.band[i]);
    }
  }
  replace_file(file, rows + '\n');
}

}  // namespace

int exit_code(Verdict verdict) {
  return verdict == Verdict::inside ? exit_done : verdict == Verdict::outside ? exit_outside : exit_undecided;
}

int compare(const CompareArguments& a) {
  if (a.enclosure) return compare_enclosure(a, tolerance_of(a.tolerance));
  refuse_same_file("--rows", a.rows, {a.mine, a.reference, a.map});
  const History reference = read_history(a.reference);
  const auto names = names_of(a.columns);
  const History mine = read_history(a.mine, a.map, reference, names);
  if (names.empty())
    for (const auto& name : mine.left_out) tell(name + " is ignored: the reference has no such column");
  const Difference difference = driver::compare(mine, reference, names, tolerance_of(a.tolerance));
  if (!a.rows.empty()) write_rows(a.rows, difference);
  if (a.format == "json")
    fmt::print("{}\n", json_of(difference, a.mine.string(), a.reference.string()));
  else
    print_text(a, difference);
  return exit_code(difference.verdict);
}

}  // namespace driver::commands
