// SPDX-License-Identifier: Apache-2.0
// Judges a history by proved bounds.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/compare.hpp"

namespace driver {

/// Proved bounds of columns over time, as `gasjet enclose` prints them.
struct ProvedBounds {
  std::vector<double> time;                       // [s]
  std::vector<std::string> columns;               // without the suffixes _lower and _upper
  std::vector<std::vector<double>> lower, upper;  // [column][row], rounded outward
};

/// Reads the CSV file. Throws CaseError at the place of a fault: a column of bounds without its other one, a
/// lower bound above the upper one, or what read_csv refuses.
ProvedBounds read_enclosure(const std::filesystem::path& file);

/// Verdict on one quantity.
struct EnclosedQuantity {
  std::string name;
  Verdict verdict = Verdict::undecided;
  std::string reason;     // unless inside
  long rows = 0;          // rows at times of the enclosure
  double distance = 0.0;  // largest distance from the bounds: mine is off by this at least
  double time = 0.0;      // [s] of it
  double share = 0.0;     // [-] distance over the largest magnitude of the bounds
  double width = 0.0;     // [-] largest width of the bounds, likewise
};

/// Verdict on a history.
struct EnclosureVerdict {
  Verdict verdict = Verdict::undecided;
  std::vector<EnclosedQuantity> quantities;
};

/// Judges the rows of mine at the times of the enclosure (to 4 roundings); nothing is interpolated. Without a
/// tolerance a quantity is outside if one of its values is outside its bounds, and inside else. With one, a
/// share of its largest magnitude, it is outside if a value is farther than that from every value within the
/// bounds, inside if each is at most that far from all of them, and undecided between. It is undecided too if
/// mine lacks a time. Throws CaseError for a name that is not in both, and if no
/// column is.
EnclosureVerdict judge(const History& mine, const ProvedBounds& enclosure,
                       const std::vector<std::string>& only = {}, const Tolerance& tolerance = {});

}  // namespace driver
