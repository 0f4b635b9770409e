// SPDX-License-Identifier: Apache-2.0
// The runs of a ladder, side by side.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

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
    const Scene scene = load_scene(document);
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

constexpr std::string_view one_of_many = "one of many", alone = "alone";

// What the sample follows from, besides the case: the crew's job and the journal's key. An override may hold
// any byte but 0.
std::string text_of(const LadderJob& job) {
  std::string text(job.is_one_of_many ? one_of_many : alone);
  for (const auto& one : job.overrides) (text += '\0') += one;
  return text;
}

LadderJob job_of(const std::string& text) {
  LadderJob job;
  job.is_one_of_many = text.starts_with(one_of_many);
  for (std::size_t at = text.find('\0'); at != std::string::npos;) {
    const std::size_t end = text.find('\0', at + 1);
    job.overrides.push_back(text.substr(at + 1, end == std::string::npos ? end : end - at - 1));
    at = end;
  }
  return job;
}

std::string line_of(const LadderSample& sample) {
  nlohmann::json json{{"cpu_s", sample.cpu_seconds}, {"steps", sample.steps}};
  if (sample.value) json["value"] = *sample.value;
  if (sample.no_event) json["no_event"] = true;
  if (!sample.failure.empty()) json["failure"] = sample.failure;
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

LadderSample sample_of(const nlohmann::json& json) {
  LadderSample sample;
  if (json.contains("value")) sample.value = json["value"].get<double>();
  sample.cpu_seconds = json.at("cpu_s");
  sample.steps = json.at("steps");
  sample.failure = json.value("failure", "");
  sample.no_event = json.value("no_event", false);
  return sample;
}

// Nothing if there is no entry, or a damaged one.
std::optional<LadderSample> sample_of_entry(const nlohmann::json* entry) {
  if (!entry) return std::nullopt;
  try {
    LadderSample sample = sample_of(*entry);
    return sample.value ? std::optional(std::move(sample)) : std::nullopt;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
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

bool has_quantity(const Scene& scene, const std::string& name) {
  return std::ranges::count(all_names(scene), name) > 0;
}

CrewWork ladder_work(const std::filesystem::path& file, const std::string& quantity) {
  return [file, quantity](const std::string& job, const std::function<void(CrewResult)>& emit) {
    emit({line_of(run_job(file, job_of(job), quantity))});
  };
}

// A failure is found again, not kept.
std::vector<LadderSample> run_jobs(Crew& crew, const std::vector<LadderJob>& jobs, const std::string& title,
                                   bool quiet, Journal& journal) {
  std::vector<LadderSample> samples(jobs.size());
  std::vector<std::size_t> missing;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    std::string text = text_of(jobs[i]);
    if (auto before = sample_of_entry(journal.find(text))) {
      samples[i] = std::move(*before);
    } else {
      missing.push_back(i);
      texts.push_back(std::move(text));
    }
  }
  compute_jobs(title, crew, texts, quiet, [&](std::size_t job, const CrewResult& result) {
    LadderSample& sample = samples[missing[job]];
    sample = sample_of(nlohmann::json::parse(result.line));
    if (sample.value) journal.add(texts[job], result.line);
  });
  return samples;
}

}  // namespace driver
