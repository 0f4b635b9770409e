// SPDX-License-Identifier: Apache-2.0
// The runs of a ladder, side by side.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "ensemble/each_run.hpp"
#include "ladder/parts.hpp"

namespace driver {
namespace {

constexpr double short_run = 0.02;  // [s] of a run below it the cost is the least of those that take as long
constexpr int short_repeats = 5;    // at least

std::vector<std::string> all_names(const Scene& scene) {
  std::vector<std::string> names = quantity_names(scene);
  const auto history = history_columns(scene);
  for (std::size_t c = 1; c < history.size(); ++c) names.push_back(history[c].name);
  return names;
}

LadderSample run_job(const std::filesystem::path& file, const LadderJob& job, const std::string& quantity) {
  LadderSample sample;
  try {
    CaseDocument document(file, job.overrides);
    const Scene scene = read_scene(document);
    double total = 0.0;
    for (int i = 0; i < short_repeats || total < short_run; ++i) {
      const Member member = run_member(scene);
      sample.failure = member.outcome.message;
      if (member.outcome.status != RunStatus::done) return {{}, 0.0, 0, sample.failure};
      sample.value = quantity_of(scene, member, quantity);
      sample.steps = member.steps;
      sample.cpu_seconds = i == 0 ? member.cpu_seconds : std::min(sample.cpu_seconds, member.cpu_seconds);
      total += member.cpu_seconds;
      if (job.is_one_of_many || sample.cpu_seconds > short_run) break;
    }
    sample.no_event = !sample.value;
    if (sample.no_event) sample.failure = "the run has no such event";
  } catch (const std::exception& error) {
    sample.failure = error.what();
  }
  return sample;
}

// Of what the sample follows from, besides the case: the journal's key.
std::string key_of(const LadderJob& job) {
  return fmt::format("{}{}", job.is_one_of_many ? "one of many" : "alone", fmt::join(job.overrides, "\n"));
}

// A failure is found again, not kept.
void keep(Journal& journal, const LadderJob& job, const LadderSample& sample) {
  if (sample.value && std::isfinite(*sample.value))
    journal.add(key_of(job),
                {{"value", *sample.value}, {"cpu_s", sample.cpu_seconds}, {"steps", sample.steps}});
}

std::optional<LadderSample> kept(const Journal& journal, const LadderJob& job) {
  const auto* before = journal.find(key_of(job));
  if (!before) return {};
  LadderSample sample;
  sample.value = before->at("value").get<double>();
  sample.cpu_seconds = before->at("cpu_s");
  sample.steps = before->at("steps");
  return sample;
}

}  // namespace

std::string quantity_name(const Scene& scene, const std::string& quantity) {
  const auto names = all_names(scene);
  std::vector<std::string> found;
  for (const auto& name : names) {
    if (name == quantity) return name;
    if (name.starts_with(quantity + '_')) found.push_back(name);
  }
  if (found.size() != 1)
    throw CaseError(fmt::format("--quantity {}: {}, allowed are {}", quantity,
                                found.empty() ? "the scene has none of that name" : "is more than one",
                                fmt::join(found.empty() ? names : found, ", ")));
  return found.front();
}

std::vector<LadderSample> run_jobs(const std::filesystem::path& file, const std::vector<LadderJob>& jobs,
                                   const std::string& quantity, const std::string& title, int threads,
                                   bool quiet, Journal& journal) {
  std::vector<LadderSample> samples(jobs.size());
  each_run(title, static_cast<int>(jobs.size()), threads, quiet, [&](int i) {
    const auto j = static_cast<std::size_t>(i);
    if (const auto before = kept(journal, jobs[j])) {
      samples[j] = *before;
    } else {
      samples[j] = run_job(file, jobs[j], quantity);
      keep(journal, jobs[j], samples[j]);
    }
  });
  return samples;
}

}  // namespace driver
