// SPDX-License-Identifier: Apache-2.0
// Difference of two histories, judged by the error band of the reference.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compare/history.hpp"

namespace driver {

/// Verdict on a quantity, a rung or a whole comparison. Only rungs can be on_the_bound.
enum class Verdict { inside, outside, on_the_bound, undecided, not_judged };
/// Text of a verdict in the results: "inside", "not judged".
const char* verdict_name(Verdict verdict);

/// A value and its time.
struct Peak {
  double value = 0.0;
  double time = 0.0;  // [s]
};

/// Difference of one quantity, at the times of the reference that both histories cover. Numbers have the unit
/// of the quantity.
struct QuantityDifference {
  std::string name;
  Verdict verdict = Verdict::not_judged;
  std::string reason;  // reason of the verdict, unless inside
  Peak largest;        // largest |mine - reference|
  double l2 = 0.0;     // sqrt(mean over time of (mine - reference)^2)
  /// [-] l2 / sqrt(mean of reference^2); empty if that is 0.
  std::optional<double> relative;
  double share_of_band = 0.0;  // [-] largest |mine - reference| / band of all rows
  /// [-] share of the reference's peak: a change of this size would be found outside in nine of ten cases;
  /// ensembles only.
  std::optional<double> seen;
  /// [s] delay of mine; empty for a signal that does not change.
  std::optional<double> phase_lag;
  Peak mine, reference;  // largest in magnitude
  /// [row] of mine, of the reference, and of its band (empty if it has none).
  std::vector<double> values, expected, band;
};

/// Difference of two histories.
struct Difference {
  int runs = 1, reference_runs = 1;  // number of runs that they are means of
  Verdict verdict = Verdict::undecided;
  std::string reason;        // reason of the verdict, unless inside
  std::vector<double> time;  // [s] times of the reference that mine covers
  std::vector<QuantityDifference> quantities;
};

/// The allowed error of mine, as shares [-] of the reference's largest magnitude.
struct Tolerance {
  double share = 0.0;                // for each quantity
  std::map<std::string, double> of;  // for named quantities, in place of `share`

  Tolerance(double of_each = 0.0) : share(of_each) {}  // one number for all
};

/// Compares two histories at the reference's times. Mine is interpolated linearly. A row is outside only
/// beyond the band plus the possible error of the interpolation (twice its difference from the cubic through
/// the neighbours).
///
/// A quantity with a band is undecided if mine lacks it, does not cover all of the reference's times or is
/// sampled too coarsely, or if the band is as wide as the signal itself. The comparison is outside if a
/// quantity is; otherwise it is undecided if a quantity is, or if none was judged.
///
/// If the reference is an ensemble, the effect of chance on the difference of both means (Student's test) is
/// added to the band of each quantity with a standard error. A quantity hidden by the scatter is then not
/// judged.
///
/// `tolerance` widens every band, and is the band if the reference has none at all. `only`: names to compare;
/// all if empty. Throws CaseError for a name in `only` or `tolerance` that the reference does not have, and
/// for a name given twice in `only`.
Difference compare(const History& mine, const History& reference, const std::vector<std::string>& only = {},
                   const Tolerance& tolerance = {});

/// The difference as JSON; `mine` and `reference` name the files.
std::string json_of(const Difference& difference, const std::string& mine, const std::string& reference);

}  // namespace driver
