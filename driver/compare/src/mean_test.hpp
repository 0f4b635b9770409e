// SPDX-License-Identifier: Apache-2.0
// Student's test of two means, row by row.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace driver {

/// Whether runs of which mine is the mean (one run: itself) and those of the reference are runs of one scene.
class MeanTest {
 public:
  /// `comparisons` are made in all: at most one of a hundred such tests of one scene finds a difference
  /// (Bonferroni), if the scatter is normal. The reference has 2 runs or more.
  MeanTest(int runs, int reference_runs, std::size_t comparisons);

  /// Standard error of the difference of means at each time, from the standard errors of both; `mine` is
  /// empty for one run. The scatter is that of all runs together, the largest within a fiftieth of the times
  /// on each side: events come earlier in one run than in another.
  std::vector<double> standard_errors(std::span<const double> time, std::span<const double> mine,
                                      std::span<const double> reference) const;

  /// What chance does to a difference, in its standard errors.
  double chance() const { return chance_; }
  /// The change that is beyond chance in nine of ten cases, in standard errors.
  double seen() const { return seen_; }

 private:
  int runs_, reference_runs_;
  double chance_, seen_;
};

}  // namespace driver
