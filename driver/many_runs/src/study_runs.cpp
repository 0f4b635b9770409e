// SPDX-License-Identifier: Apache-2.0
#include "study_runs.hpp"

#include <algorithm>

#include "many_runs/sequential_test.hpp"

namespace driver {
namespace {

bool has_enough(const StudyPlan& plan, const RunJournal::Runs& ended, std::size_t point) {
  const auto at = std::ranges::find(plan.quantities, plan.stop->quantity) - plan.quantities.begin();
  const auto quantity = static_cast<std::size_t>(at);
  if (plan.stop->error_rate) {
    return sign_is_decided(differences(plan, ended, point, quantity),
                           looks(plan.seeds, plan.stop->most_seeds), *plan.stop->error_rate);
  }
  const Statistics s = statistics_at(plan, ended, point, quantity);
  return s.count > 2 && s.standard_error <= *plan.stop->standard_error;
}

struct Look {
  int seeds;  // that the point needs
  StopClaim claim;
};

std::vector<Look> looks_at(const StudyPlan& plan, const RunJournal::Runs& ended) {
  const auto is_whole = [&](std::size_t point, int seeds) {
    for (int seed = 0; seed < seeds; ++seed)
      if (!ended.contains(static_cast<long>(point) * plan.most_seeds() + seed)) return false;
    return true;
  };
  // As of the runs of the look: what a run of another point has computed beyond does not count.
  const auto of_look = [&](std::size_t point, int seeds) {
    RunJournal::Runs part;
    const auto add = [&](std::size_t p) {
      for (const auto& run : runs_at(plan, ended, p, seeds)) part.insert(run);
    };
    add(point);
    if (const auto base = plan.bases[point]) add(*base);
    return part;
  };
  const auto look_at = [&](std::size_t point) {
    const auto base = plan.bases[point];
    if (plan.stop->error_rate && !base) return Look{plan.seeds, StopClaim::none};
    for (int seeds = plan.seeds;; seeds = next_look(seeds, plan.most_seeds())) {
      if (!is_whole(point, seeds) || (base && !is_whole(*base, seeds))) return Look{seeds, StopClaim::open};
      if (has_enough(plan, of_look(point, seeds), point)) return Look{seeds, StopClaim::decided};
      if (seeds == plan.most_seeds()) return Look{seeds, StopClaim::undecided};
    }
  };
  std::vector<Look> looks;
  for (std::size_t p = 0; p < plan.points.size(); ++p) looks.push_back(look_at(p));
  for (std::size_t p = 0; p < plan.points.size(); ++p)
    if (const auto base = plan.bases[p]) looks[*base].seeds = std::max(looks[*base].seeds, looks[p].seeds);
  return looks;
}

}  // namespace

RunShape shape_of(const StudyPlan& plan) {
  return {plan.end_of_numbers(), plan.quantities.size(), 0,
          [&plan](long run) { return run % plan.most_seeds() < plan.seeds_at(point_of(plan, run)); }};
}

int seed_of(const StudyPlan& plan, long run) {
  return plan.seeds == 0 ? 0 : static_cast<int>(run % plan.most_seeds()) + 1;
}

std::size_t point_of(const StudyPlan& plan, long run) {
  return static_cast<std::size_t>(run / plan.most_seeds());
}

RunRange runs_at(const StudyPlan& plan, const RunJournal::Runs& runs, std::size_t point, int most) {
  const long first = static_cast<long>(point) * plan.most_seeds();
  return {runs.lower_bound(first), runs.lower_bound(first + std::min(most, plan.most_seeds()))};
}

long StudyPlan::most_runs() const {
  long runs = 0;
  for (std::size_t p = 0; p < points.size(); ++p) runs += seeds_at(p);
  return runs;
}

std::vector<long> asked_runs(const StudyPlan& plan, const RunJournal::Runs& ended) {
  std::vector<int> seeds;
  if (plan.stop)
    for (const Look& look : looks_at(plan, ended)) seeds.push_back(look.seeds);
  else
    for (std::size_t p = 0; p < plan.points.size(); ++p) seeds.push_back(plan.seeds_at(p));
  std::vector<long> runs;
  for (std::size_t p = 0; p < plan.points.size(); ++p)
    for (int seed = 0; seed < seeds[p]; ++seed)
      runs.push_back(static_cast<long>(p) * plan.most_seeds() + seed);
  return runs;
}

std::vector<StopClaim> stop_claims(const StudyPlan& plan, const RunJournal::Runs& ended) {
  std::vector<StopClaim> claims;
  if (plan.stop)
    for (const Look& look : looks_at(plan, ended)) claims.push_back(look.claim);
  return claims;
}

std::map<int, double> values_at(const StudyPlan& plan, const RunJournal::Runs& runs, std::size_t point,
                                std::size_t quantity) {
  std::map<int, double> values;
  for (const auto& [number, run] : runs_at(plan, runs, point))
    if (run.is_done() && run.values[quantity]) values.emplace(seed_of(plan, number), *run.values[quantity]);
  return values;
}

Statistics statistics_at(const StudyPlan& plan, const RunJournal::Runs& runs, std::size_t point,
                         std::size_t quantity) {
  std::vector<double> values;
  for (const auto& [seed, value] : values_at(plan, runs, point, quantity)) values.push_back(value);
  return statistics(values);
}

std::vector<double> differences(const StudyPlan& plan, const RunJournal::Runs& runs, std::size_t point,
                                std::size_t quantity) {
  std::vector<double> list;
  const auto base = plan.bases[point];
  if (!base) return list;
  const auto without = values_at(plan, runs, *base, quantity);
  for (const auto& [seed, value] : values_at(plan, runs, point, quantity))
    if (const auto other = without.find(seed); other != without.end()) list.push_back(value - other->second);
  return list;
}

}  // namespace driver
