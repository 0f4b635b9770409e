// SPDX-License-Identifier: Apache-2.0
#include "ladder/rung_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/progress.hpp"

namespace driver {
namespace {

constexpr double harmless_share = 0.1;  // of the tolerance that the scatter of single runs may take

}  // namespace

void RungRuns::probe() {
  if (!scene_.bag) return;
  std::vector<LadderJob> jobs;
  for (int seed = 1; seed <= probes; ++seed) jobs.push_back(job(0, seed));
  auto samples = samples_of(jobs, "seeds");
  std::vector<double> values;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    need(fmt::format("seed {} of rung \"full\"", i + 1), samples[i]);
    if (samples[i].value) values.push_back(*samples[i].value);
  }
  if (interrupted() || values.empty()) return;
  const Statistics seeds = statistics(values);
  result_.spread = seeds.maximum - seeds.minimum;
  deviation_ = seeds.standard_error * std::sqrt(seeds.count);
  const double size =
      std::max(std::abs(seeds.minimum - result_.zero), std::abs(seeds.maximum - result_.zero));
  // Who allows for more runs wants them where a verdict is open, however little they scatter.
  result_.chaotic =
      result_.spread > harmless_share * options_.tolerance * size || options_.most_runs > options_.runs;
  if (result_.chaotic && options_.runs >= probes) samples_.assign(1, std::move(samples));
}

void RungRuns::run(std::size_t first, const char* what) {
  wanted_.resize(result_.rungs.size(), options_.runs);
  samples_.resize(result_.rungs.size());
  if (result_.chaotic && first > 0) {
    run_missing(first, 1, fmt::format("one run of each of the {}", what));
    tell_cost(first);
  }
  run_missing(first, std::max(options_.runs, options_.most_runs), what);
}

void RungRuns::look_again() {
  const int looks = result_.chaotic ? ladder_looks(options_) : 1;
  for (int look = 2; look <= looks && !interrupted() && result_.reason.empty(); ++look) {
    judge(result_, options_.tolerance, options_.error_rate / looks);
    const auto open = open_rungs(result_, options_.tolerance);
    if (open.empty()) return;
    for (const std::size_t r : open) wanted_[r] = std::min(2 * wanted_[r], options_.most_runs);
    tell_cost(0);
    run_missing(0, options_.most_runs, fmt::format("look {} of at most {}", look, looks));
  }
}

std::vector<std::string> RungRuns::overrides(std::size_t rung) const {
  auto all = user_;
  const auto& own = result_.rungs[rung].overrides;
  all.insert(all.end(), own.begin(), own.end());
  return all;
}

int RungRuns::wanted(std::size_t rung) const {
  return result_.chaotic && result_.rungs[rung].can_be_perturbed ? wanted_[rung] : 1;
}

LadderJob RungRuns::job(std::size_t rung, int seed) const {
  auto all = overrides(rung);
  if (seed > 0) all = perturbed(std::move(all), default_amplitude, seed);
  return {rung, std::move(all), seed > 0};
}

std::vector<LadderSample> RungRuns::samples_of(const std::vector<LadderJob>& jobs,
                                               const std::string& what) const {
  return run_jobs(crew_, jobs, scene_.name + ", " + what, options_.quiet, journal_);
}

void RungRuns::run_missing(std::size_t first, int most, const std::string& what) {
  std::vector<LadderJob> jobs;
  for (std::size_t r = first; r < result_.rungs.size(); ++r)
    for (int i = static_cast<int>(samples_[r].size()); i < std::min(most, wanted(r)); ++i)
      jobs.push_back(job(r, result_.chaotic && result_.rungs[r].can_be_perturbed ? i + 1 : 0));
  const auto samples = samples_of(jobs, what);
  for (std::size_t j = 0; j < jobs.size(); ++j) samples_[jobs[j].rung].push_back(samples[j]);
  for (std::size_t r = first; r < result_.rungs.size(); ++r) collect(r);
}

// What the runs that are missing of the rungs from `first` on take.
void RungRuns::tell_cost(std::size_t first) const {
  if (options_.quiet || interrupted()) return;
  double seconds = 0.0, most = 0.0;
  const int largest = std::max(options_.runs, options_.most_runs);
  for (std::size_t r = first; r < result_.rungs.size(); ++r) {
    const auto have = static_cast<int>(samples_[r].size());
    seconds += result_.rungs[r].cpu_seconds * (wanted(r) - have);
    if (wanted(r) > 1) most += result_.rungs[r].cpu_seconds * (largest - have);
  }
  auto text = fmt::format("{}: {:.3g} CPU s to go, {:.2g} min with {} at a time", one_line(scene_.name),
                          seconds, seconds / (60.0 * crew_.workers()), crew_.workers());
  if (largest > options_.runs)
    text += fmt::format("; at most {:.3g} CPU s, if all of these verdicts stay open", most);
  tell(text);
}

void RungRuns::collect(std::size_t index) {
  std::vector<double> values;
  LadderRung& rung = result_.rungs[index];
  double cpu = 0.0, steps = 0.0;
  for (const LadderSample& sample : samples_[index]) {
    if (index == 0 || index == result_.finest) need(fmt::format("rung \"{}\"", rung.name), sample);
    if (!sample.failure.empty()) rung.failure = sample.failure;
    if (!sample.value) continue;
    values.push_back(*sample.value);
    cpu += sample.cpu_seconds;
    steps += static_cast<double>(sample.steps);
  }
  rung.value = statistics(values);
  if (!result_.chaotic && rung.can_be_perturbed) rung.value.standard_error = deviation_;
  if (values.empty()) return;
  rung.cpu_seconds = cpu / static_cast<double>(values.size());
  rung.steps = steps / static_cast<double>(values.size());
}

// All are compared to this one.
void RungRuns::need(const std::string& name, const LadderSample& sample) {
  if (interrupted() || sample.failure.empty()) return;
  const auto message = fmt::format("{}, to which all are compared: {}", name, sample.failure);
  if (!sample.no_event) throw std::runtime_error(message);
  if (result_.reason.empty()) result_.reason = message;
}

}  // namespace driver
