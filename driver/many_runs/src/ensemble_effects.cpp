// SPDX-License-Identifier: Apache-2.0
// Whether two ensembles differ.
#include <cmath>
#include <elementary/hypot.hpp>

#include "compare/students_t.hpp"
#include "many_runs/ensemble.hpp"

namespace driver {
namespace {

// Of each case's runs, squared: with no scatter at all on one side the other's freedom counts.
double welch_freedom(const Statistics& a, const Statistics& b) {
  const double va = a.standard_error * a.standard_error, vb = b.standard_error * b.standard_error;
  return (va + vb) * (va + vb) / (va * va / (a.count - 1) + vb * vb / (b.count - 1));
}

double needed_standard_errors(const Statistics& a, const Statistics& b) {
  constexpr double many_runs = 5.0, freedom_of_16_runs = 15.0;
  if (std::min(a.count, b.count) < 2) return HUGE_VAL;
  if (a.standard_error == 0.0 && b.standard_error == 0.0) return many_runs;
  const double chance = cdf(complement(StudentsT(freedom_of_16_runs), many_runs));
  return std::max(many_runs, quantile(complement(StudentsT(welch_freedom(a, b)), chance)));
}

}  // namespace

std::vector<Effect> effects(const EnsembleResult& with, const EnsembleResult& without) {
  std::vector<Effect> list;
  for (const auto& [name, values] : with.quantities) {
    const auto other = without.quantities.find(name);
    if (other == without.quantities.end()) continue;
    Effect effect{name, statistics(values), statistics(other->second)};
    effect.difference = effect.with.mean - effect.without.mean;
    const double error = elementary::hypot(effect.with.standard_error, effect.without.standard_error);
    if (effect.difference != 0.0) effect.standard_errors = std::abs(effect.difference) / error;
    effect.needed = needed_standard_errors(effect.with, effect.without);
    list.push_back(effect);
  }
  return list;
}

}  // namespace driver
