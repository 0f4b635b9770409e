// SPDX-License-Identifier: Apache-2.0
#include "many_runs/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <system_error>

#include "base/case_reader.hpp"
#include "base/progress.hpp"
#include "results/results.hpp"
#include "run_jobs.hpp"
#include "study_inputs.hpp"
#include "study_runs.hpp"
#include "study_tables.hpp"

namespace driver {
namespace {

// Runs of one point, with one seed after the other.
RunJob study_job(const StudyPlan& plan, std::span<const long> runs) {
  const std::size_t point = point_of(plan, runs.front());
  RunJob job{.name = fmt::format("point {}", point),
             .overrides = study_overrides(plan, plan.points[point]),
             .amplitude = plan.amplitude_at(point),
             .runs = {}};
  for (const long run : runs) job.runs.emplace_back(run, seed_of(plan, run));
  return job;
}

// Few runs are not shared out unevenly.
RunBatch study_batch(const StudyPlan& plan, const std::vector<long>& runs, bool quiet) {
  constexpr std::size_t longest_job = 16, fewest_jobs = 64;
  const std::size_t longest = std::clamp<std::size_t>(runs.size() / fewest_jobs, 1, longest_job);
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (begins.empty() || i - begins.back() == longest ||
        point_of(plan, runs[begins.back()]) != point_of(plan, runs[i]))
      begins.push_back(i);
  const std::size_t count = begins.size();
  begins.push_back(runs.size());
  const auto job = [&plan, &runs, begins = std::move(begins)](std::size_t i) {
    return study_job(plan, std::span(runs).subspan(begins[i], begins[i + 1] - begins[i]));
  };
  return {plan.name, quiet, static_cast<long>(runs.size()), count, job};
}

// The plan stands in the folder, so that a merge needs the folder alone.
void keep_plan(const StudyPlan& plan, const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw OutputError(fmt::format("--out {}: {}", folder.string(), error.message()));
  const auto copy = folder / plan_copy;
  // With its name, which may be that of the file.
  const CaseDocument document =
      CaseDocument::of_text(plan.text, plan.file, {fmt::format("study.name={}", quoted(plan.name))});
  const std::string text = document.text(folder);
  if (std::filesystem::exists(copy, error)) {
    CaseDocument other(copy, {});
    if (other.text(folder) != text)
      throw OutputError(
          fmt::format("{}: is another plan than {}: name another folder", copy.string(), plan.file.string()));
    return;
  }
  replace_file(copy, text);
}

}  // namespace

CrewWork study_work(const StudyPlan& plan, int workers) {
  const auto load = [&plan](const std::vector<std::string>& overrides) {
    return study_scene(plan, overrides);
  };
  return run_work({{load, plan.quantities}}, workers);
}

std::vector<RunRecord> sample_runs(const StudyPlan& plan) {
  std::vector<long> numbers{0};
  if (plan.points.size() > 1) numbers.push_back(plan.end_of_numbers() - plan.most_seeds());
  RunJournal journal(shape_of(plan));
  compute_runs(*thread_crew(study_work(plan, 1), 1), study_batch(plan, numbers, true), journal);
  std::vector<RunRecord> runs;
  for (const auto& [number, run] : journal.runs()) runs.push_back(run);
  return runs;
}

bool run_study(const StudyPlan& plan, const std::filesystem::path& folder, const Share& share, Crew& crew,
               bool quiet) {
  std::error_code ignored;
  ResultFolder::require_free(folder, "study", std::filesystem::exists(folder / plan_copy, ignored));
  keep_plan(plan, folder);
  RunJournal journal(shape_of(plan), study_inputs(plan, folder));
  journal.read_shares(folder, plan.id);
  ResultFolder own(folder / shares_folder / share.name(), "study");
  own.begin(provenance(plan.case_file, plan.overrides, plan.id));
  tell_start(plan.name, journal, quiet);
  journal.open(own);
  while (!interrupted()) {
    const auto asked = asked_runs(plan, journal.runs());
    std::vector<long> mine;
    for (const long run : asked)
      if (share.has(run) && !journal.find(run)) mine.push_back(run);
    if (mine.empty()) break;
    RunBatch batch = study_batch(plan, mine, quiet);
    if (!plan.stop) batch.of_all = static_cast<long>(asked.size());  // a stop rule's runs are of one share
    compute_runs(crew, batch, journal);
  }
  // Never "done", which would remove the journal.
  own.end(interrupted() ? "interrupted" : "whole");
  return !interrupted();
}

}  // namespace driver
