// SPDX-License-Identifier: Apache-2.0
// Student's test of two means, row by row.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace driver {

/// Tests whether the runs behind mine (a mean, or one run) and behind the reference are runs of one scene.
class MeanTest {
 public:
  /// `comparisons`: number of all comparisons. If the scatter is normal, at most one of a hundred tests of
  /// equal scenes finds a difference (Bonferroni). Precondition: the reference has 2 runs or more.
  MeanTest(int runs, int reference_runs, std::size_t comparisons);

  /// Standard error of the difference of means at each time, from the standard errors of both; `mine` is
  /// empty for one run. The scatter is pooled over all runs. At each time it is the largest within a fiftieth
  /// of the times on each side, because events come earlier in one run than in another.
  std::vector<double> standard_errors(std::span<const double> time, std::span<const double> mine,
                                      std::span<const double> reference) const;

  /// Largest difference that chance explains, in standard errors.
  double chance() const { return chance_; }
  /// The change that is found in nine of ten cases, in standard errors.
  double seen() const { return seen_; }

 private:
  int runs_, reference_runs_;
  double chance_, seen_;
};

}  // namespace driver
