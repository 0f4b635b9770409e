// SPDX-License-Identifier: Apache-2.0
#include "ladder_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/progress.hpp"
#include "many_runs/sequential_test.hpp"

namespace driver {
namespace {

constexpr double harmless_share = 0.1;  // of the tolerance that the scatter of single runs may take
constexpr long volume_number = 0;       // of the line in the journal that is none of a run

}  // namespace

struct RungRuns::Sample {
  const RunRecord* run;  // none: an interrupt forestalled it
  bool no_event() const { return run && run->is_done() && !run->values.front(); }
  std::optional<double> value() const { return run && run->is_done() ? run->values.front() : std::nullopt; }
  std::string failure() const { return !run ? "" : no_event() ? "the run has no such event" : run->message; }
};

RungRuns::RungRuns(const Scene& scene, const LadderOptions& options, Crew& crew, LadderResult& result,
                   ResultFolder* folder)
    : scene_(scene),
      options_(options),
      crew_(crew),
      result_(result),
      most_seeds_(std::max({options.runs, options.most_runs, probes})),
      journal_({std::numeric_limits<long>::max(), 1}) {
  if (folder) journal_.open(*folder);
  tell_start(one_line(scene.name), journal_, options.quiet);
}

std::optional<std::string> RungRuns::kept_volume() const {
  const RunRecord* run = journal_.find(volume_number);
  return run ? std::optional(run->message) : std::nullopt;
}

void RungRuns::keep_volume(const std::string& text) {
  const RunRecord line{.number = volume_number, .status = "done", .message = text, .values = {std::nullopt}};
  journal_.keep({line_of(line), line});
}

void RungRuns::probe() {
  if (!scene_.bag) return;
  std::vector<RunJob> jobs;
  for (int seed = 1; seed <= probes; ++seed) jobs.push_back(job(0, seed));
  compute(std::move(jobs), "seeds");
  std::vector<double> values;
  for (int seed = 1; seed <= probes; ++seed) {
    const Sample sample{journal_.find(number(0, seed))};
    need(fmt::format("seed {} of rung \"full\"", seed), sample);
    if (const auto value = sample.value()) values.push_back(*value);
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
}

void RungRuns::run(std::size_t first, const char* what) {
  wanted_.resize(result_.rungs.size(), options_.runs);
  if (result_.chaotic && first > 0) {
    run_missing(first, 1, fmt::format("one run of each of the {}", what));
    tell_cost(first);
  }
  run_missing(first, std::max(options_.runs, options_.most_runs), what);
}

void RungRuns::look_again() {
  const int count = result_.chaotic ? looks(options_.runs, options_.most_runs) : 1;
  for (int look = 2; look <= count && !interrupted() && result_.reason.empty(); ++look) {
    judge(result_, options_.tolerance, options_.error_rate / count);
    const auto open = open_rungs(result_, options_.tolerance);
    if (open.empty()) return;
    for (const std::size_t r : open) wanted_[r] = next_look(wanted_[r], options_.most_runs);
    tell_cost(0);
    run_missing(0, options_.most_runs, fmt::format("look {} of at most {}", look, count));
  }
}

bool RungRuns::is_mean(std::size_t rung) const {
  return result_.chaotic && result_.rungs[rung].can_be_perturbed;
}

int RungRuns::wanted(std::size_t rung) const {
  return is_mean(rung) ? wanted_[rung] : 1;
}

long RungRuns::number(std::size_t rung, int seed) const {
  return volume_number + 1 + static_cast<long>(rung) * (most_seeds_ + 1) + seed;
}

// The first ones of a rung, as far as they have ended.
std::vector<RungRuns::Sample> RungRuns::samples(std::size_t rung, int count) const {
  std::vector<Sample> list;
  for (int i = 0; i < count; ++i)
    if (const RunRecord* run = journal_.find(number(rung, is_mean(rung) ? i + 1 : 0))) list.push_back({run});
  return list;
}

RunJob RungRuns::job(std::size_t rung, int seed) const {
  RunJob job{.name = fmt::format("rung \"{}\"", result_.rungs[rung].name),
             .overrides = result_.rungs[rung].overrides,
             .amplitude = default_amplitude,
             .runs = {{number(rung, seed), seed}},
             .for_cost = seed == 0};
  if (seed > 0) job.overrides.emplace_back("membrane.perturbation=0.0");  // that of the seed takes its place
  return job;
}

void RungRuns::compute(std::vector<RunJob> jobs, const std::string& what) {
  std::erase_if(jobs, [&](const RunJob& job) { return journal_.find(job.runs.front().first) != nullptr; });
  compute_runs(crew_, batch_of(scene_.name + ", " + what, options_.quiet, std::move(jobs)), journal_);
}

void RungRuns::run_missing(std::size_t first, int most, const std::string& what) {
  std::vector<RunJob> jobs;
  for (std::size_t r = first; r < result_.rungs.size(); ++r)
    for (int i = 0; i < std::min(most, wanted(r)); ++i) jobs.push_back(job(r, is_mean(r) ? i + 1 : 0));
  compute(std::move(jobs), what);
  for (std::size_t r = first; r < result_.rungs.size(); ++r) collect(r);
}

// What the runs that are missing of the rungs from `first` on take.
void RungRuns::tell_cost(std::size_t first) const {
  if (options_.quiet || interrupted()) return;
  double seconds = 0.0, most = 0.0;
  const int largest = std::max(options_.runs, options_.most_runs);
  for (std::size_t r = first; r < result_.rungs.size(); ++r) {
    const auto have = static_cast<int>(samples(r, largest).size());
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
  for (const Sample& sample : samples(index, wanted(index))) {
    if (index == 0 || index == result_.finest) need(fmt::format("rung \"{}\"", rung.name), sample);
    if (auto failure = sample.failure(); !failure.empty()) rung.failure = std::move(failure);
    const auto value = sample.value();
    if (!value) continue;
    values.push_back(*value);
    cpu += sample.run->cpu_seconds;
    steps += static_cast<double>(sample.run->steps);
  }
  rung.value = statistics(values);
  if (!result_.chaotic && rung.can_be_perturbed) rung.value.standard_error = deviation_;
  if (values.empty()) return;
  rung.cpu_seconds = cpu / static_cast<double>(values.size());
  rung.steps = steps / static_cast<double>(values.size());
}

// All are compared to this one.
void RungRuns::need(const std::string& name, const Sample& sample) {
  const auto failure = sample.failure();
  if (interrupted() || failure.empty()) return;
  const auto message = fmt::format("{}, the reference of all others: {}", name, failure);
  if (!sample.no_event()) throw std::runtime_error(message);
  if (result_.reason.empty()) result_.reason = message;
}

}  // namespace driver
