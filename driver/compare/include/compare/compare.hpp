// SPDX-License-Identifier: Apache-2.0
// Difference of two histories, judged by the error band of the reference.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compare/history.hpp"

namespace driver {

/// Verdict on a quantity, a rung or a whole comparison; on_the_bound of rungs alone.
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
  std::string reason;  // why, unless inside
  Peak largest;        // of |mine - reference|
  double l2 = 0.0;     // sqrt(mean over time of (mine - reference)^2)
  /// [-] l2 over sqrt(mean of reference^2); none if that is 0.
  std::optional<double> relative;
  double share_of_band = 0.0;  // [-] largest |mine - reference| / band over the rows
  /// [-] of the reference's peak: the change there that would be outside in nine of ten cases; ensembles
  /// only.
  std::optional<double> seen;
  /// [s] by which mine is late; none for a signal that does not change.
  std::optional<double> phase_lag;
  Peak mine, reference;  // largest in magnitude
  /// [row] of mine, of the reference, and of its band (empty if it has none).
  std::vector<double> values, expected, band;
};

/// Difference of two histories.
struct Difference {
  int runs = 1, reference_runs = 1;  // that they are means of
  Verdict verdict = Verdict::undecided;
  std::string reason;        // why, unless inside
  std::vector<double> time;  // [s] times of the reference that mine covers
  std::vector<QuantityDifference> quantities;
};

/// The error that mine may have by itself, as shares [-] of the reference's largest magnitude.
struct Tolerance {
  double share = 0.0;                // of each quantity
  std::map<std::string, double> of;  // of the quantities that it names, in place of `share`

  Tolerance(double of_each = 0.0) : share(of_each) {}  // a number is one for all
};

/// Compares two histories at the reference's times. Mine is interpolated linearly. The possible error of the
/// interpolation (twice its difference from the cubic through the neighbours) never decides: a row is outside
/// only beyond band plus this error.
///
/// A quantity with a band is undecided if mine lacks it, does not cover all of the reference's times or is
/// sampled too coarsely. It is also undecided if the band is as wide as the signal itself. The whole is
/// outside if a quantity is; else undecided if a quantity is, or if none was judged.
///
/// If the reference is an ensemble, what chance does to the difference of both means (Student's test) is
/// added to the band of each quantity that has a standard error. One that the scatter hides is not judged
/// then.
///
/// `tolerance` widens every band; it is the band if the reference states none at all. `only`: names to
/// compare, all if empty. Throws CaseError for a name of `only` or `tolerance` that the reference does not
/// have, and for one of `only` that is given twice.
Difference compare(const History& mine, const History& reference, const std::vector<std::string>& only = {},
                   const Tolerance& tolerance = {});

/// The difference as JSON; `mine` and `reference` name the files.
std::string json_of(const Difference& difference, const std::string& mine, const std::string& reference);

}  // namespace driver
