// SPDX-License-Identifier: Apache-2.0
#include "mean_test.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include "compare/students_t.hpp"

namespace driver {
namespace {

constexpr double false_alarms = 0.01;  // rate for all comparisons together
constexpr double missed = 0.1;         // share of missed changes of the size `seen`
constexpr double window = 1.0 / 50.0;  // share of the times, on each side

// The largest value within `reach` of each time; a queue of falling values makes it linear in the rows.
std::vector<double> largest_within(std::span<const double> time, const std::vector<double>& values,
                                   double reach) {
  std::vector<double> largest;
  std::deque<std::size_t> candidates;
  std::size_t next = 0;
  for (const double t : time) {
    for (; next < time.size() && time[next] <= t + reach; ++next) {
      while (!candidates.empty() && values[candidates.back()] <= values[next]) candidates.pop_back();
      candidates.push_back(next);
    }
    while (time[candidates.front()] < t - reach) candidates.pop_front();
    largest.push_back(values[candidates.front()]);
  }
  return largest;
}

}  // namespace

MeanTest::MeanTest(int runs, int reference_runs, std::size_t comparisons)
    : runs_(runs), reference_runs_(reference_runs) {
  const double freedom = static_cast<double>(runs) + reference_runs - 2.0;
  const double tests = static_cast<double>(std::max<std::size_t>(comparisons, 1));
  const StudentsT student(freedom);
  chance_ = quantile(complement(student, false_alarms / (2.0 * tests)));
  seen_ = chance_ + quantile(complement(student, missed));
}

std::vector<double> MeanTest::standard_errors(std::span<const double> time, std::span<const double> mine,
                                              std::span<const double> reference) const {
  const double m = runs_, n = reference_runs_;
  std::vector<double> scatter;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const double own =
        mine.empty() ? 0.0 : m * (m - 1.0) * mine[i] * mine[i];  // (m - 1) s^2 = (m - 1) m se^2
    scatter.push_back(std::sqrt((own + n * (n - 1.0) * reference[i] * reference[i]) / (m + n - 2.0)));
  }
  if (time.empty()) return scatter;
  auto errors = largest_within(time, scatter, window * (time.back() - time.front()));
  for (double& error : errors) error *= std::sqrt(1.0 / m + 1.0 / n);
  return errors;
}

}  // namespace driver
