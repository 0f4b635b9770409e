// SPDX-License-Identifier: Apache-2.0
#include "many_runs/sequential_test.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>

#include "many_runs/statistics.hpp"

namespace driver {

int looks(int first, int most) {
  int count = 1;
  for (int runs = first; runs < most; runs = next_look(runs, most)) ++count;
  return count;
}

int next_look(int runs, int most) {
  return static_cast<int>(std::min(2L * runs, static_cast<long>(most)));
}

bool sign_is_decided(const std::vector<double>& differences, int looks, double error_rate) {
  const Statistics s = statistics(differences);
  if (s.count < 3) return false;
  if (s.standard_error == 0.0) return s.mean != 0.0;
  const double quantile = gsl_cdf_tdist_Qinv(0.5 * error_rate / looks, s.count - 1.0);
  return std::abs(s.mean) > quantile * s.standard_error;
}

}  // namespace driver
