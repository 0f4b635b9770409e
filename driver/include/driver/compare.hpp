// SPDX-License-Identifier: Apache-2.0
// The difference of two histories, judged by the error band that the reference carries.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace driver {

/// Columns over strictly rising times, in SI units.
struct History {
  std::vector<double> time;                                          // [s]
  std::vector<std::pair<std::string, std::vector<double>>> columns;  // name, values; as many as times

  /// Values of a column, or nullptr.
  const std::vector<double>* find(const std::string& name) const;
};

/// Reads a history: a CSV file with a column `time_s` and every other column a quantity, or, with a map
/// (TOML, docs/case_files.md), a foreign file of which the map names the columns, units and offsets. Throws
/// CaseError at the place of the fault: unreadable, no number, a band below 0, times that do not rise, fewer
/// than 3 rows.
History read_history(const std::filesystem::path& file, const std::filesystem::path& map = {});

/// Ends the name of a column that holds the half width of the error band of the column before it.
inline constexpr const char* band_suffix = "_band";

enum class Verdict { inside, outside, undecided, not_judged };
/// As the results have it: "inside", "not judged".
const char* verdict_name(Verdict verdict);

/// A value and when it was reached.
struct Peak {
  double value = 0.0;
  double time = 0.0;  // [s]
};

/// One quantity over the times of the reference that both histories cover. Units of the quantity.
struct QuantityDifference {
  std::string name;
  Verdict verdict = Verdict::not_judged;
  std::string reason;               // unless inside
  Peak largest;                     // of |mine - reference|
  double l2 = 0.0;                  // sqrt(mean over time of (mine - reference)^2)
  std::optional<double> relative;   // l2 over sqrt(mean of reference^2), none where that is 0
  double share_of_band = 0.0;       // largest |mine - reference| / band over the rows
  std::optional<double> phase_lag;  // [s] by which mine is late; none for a signal that does not change
  Peak mine, reference;             // of largest magnitude
  std::vector<double> values, expected, band;  // [row] of mine, of the reference; band empty when it has none
};

struct Difference {
  Verdict verdict = Verdict::undecided;
  std::string reason;        // unless inside
  std::vector<double> time;  // [s] rows of the reference that mine covers
  std::vector<QuantityDifference> quantities;
};

/// Compares at the reference's own times; mine is interpolated linearly, and what that may be off by (twice
/// its difference to the cubic through the neighbours) never decides: a row is outside only beyond band +
/// that. A quantity with a band is undecided when mine does not have it, does not cover all of the
/// reference's times or is sampled too coarsely, or when the band is as wide as the signal itself.
/// `tolerance`, a share of the reference's largest magnitude that mine may be off by itself, is added to
/// every band. The whole is outside if a quantity is, else undecided if one is or none was judged. `only`:
/// names to compare, all if empty; throws CaseError for one that the reference does not have, or given twice.
Difference compare(const History& mine, const History& reference, const std::vector<std::string>& only = {},
                   double tolerance = 0.0);

}  // namespace driver
