// SPDX-License-Identifier: Apache-2.0
// Runs are added, twice as many at each look, until a question is decided or there are as many as allowed.
#pragma once

#include <vector>

namespace driver {

/// Looks from `first` runs to `most`. Each has an equal share of the error rate (Bonferroni), so the test is
/// wrong at most at that rate.
int looks(int first, int most);
/// Runs of the look after one of `runs`.
int next_look(int runs, int most);

/// True if the mean of `differences` has a sign of its own: its distance from 0 exceeds the quantile of
/// Student's t at error_rate / looks.
bool sign_is_decided(const std::vector<double>& differences, int looks, double error_rate);

}  // namespace driver
