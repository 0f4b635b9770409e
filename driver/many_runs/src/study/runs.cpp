// SPDX-License-Identifier: Apache-2.0
// The runs of a study: which, on which threads, into which share.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <any>
#include <iterator>
#include <new>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "base/progress.hpp"
#include "base/text_file.hpp"
#include "engine/scene.hpp"
#include "ensemble/member.hpp"
#include "many_runs/study_analysis.hpp"
#include "results/results.hpp"
#include "study/parts.hpp"

namespace driver {
namespace {

// Runs of a chunk, which one thread computes. Few runs are not shared out unevenly.
constexpr std::size_t longest_chunk = 16, fewest_chunks = 64;

StudyRun run_of(const StudyPlan& plan, long number, const Member& member, const Scene& scene) {
  StudyRun run{number,
               status_name(member.outcome.status),
               member.outcome.message,
               {},
               member.steps,
               member.cpu_seconds};
  for (const auto& name : plan.quantities)
    run.values.push_back(member.rows.empty() ? std::nullopt : quantity_of(scene, member, name));
  return run;
}

// What the case and its models refuse, in contrast to what the machine does.
bool is_of_the_values(const std::exception& error) {
  if (dynamic_cast<const FileError*>(&error) || dynamic_cast<const std::system_error*>(&error)) return false;
  return dynamic_cast<const std::runtime_error*>(&error) || dynamic_cast<const std::domain_error*>(&error) ||
         dynamic_cast<const std::invalid_argument*>(&error);
}

StudyRun refused(const StudyPlan& plan, long number, const std::exception& error) {
  return {number, "refused", text_of(error), std::vector<std::optional<double>>(plan.quantities.size()),
          0,      0.0};
}

// The numbers of a chunk's runs, as a job.
std::vector<std::string> jobs_of(const StudyPlan& plan, const std::vector<long>& runs) {
  std::vector<StudyChunk> chunks;
  const std::size_t longest = std::clamp<std::size_t>(runs.size() / fewest_chunks, 1, longest_chunk);
  for (const long run : runs) {
    const bool joins = !chunks.empty() && chunks.back().size() < longest &&
                       point_of(plan, chunks.back().front()) == point_of(plan, run);
    if (!joins) chunks.emplace_back();
    chunks.back().push_back(run);
  }
  std::vector<std::string> jobs;
  for (const StudyChunk& chunk : chunks) jobs.push_back(fmt::format("{}", fmt::join(chunk, " ")));
  return jobs;
}

StudyChunk chunk_of(const std::string& job) {
  std::istringstream text(job);
  return {std::istream_iterator<long>(text), {}};
}

// A share's own file, in which a run stands as soon as it has ended.
class ShareFile {
 public:
  ShareFile(const StudyPlan& plan, const std::filesystem::path& study, const std::string& share)
      : folder_(study / shares_folder / share, "study", std::vector<std::string>{journal_file}) {
    folder_.begin(provenance(plan.case_file, plan.overrides, plan.id));
    file_.emplace(folder_.add(journal_file), true);
    // On a line of its own, whatever a kill has torn before.
    file_->append('\n' + head_line(plan, study, folder_.lines()));
  }
  void keep(const std::string& line) { file_->append(line + '\n'); }
  // Never "done", which would remove the journal.
  void end(bool whole) { folder_.end(whole ? "whole" : "interrupted"); }

 private:
  ResultFolder folder_;
  std::optional<GrowingFile> file_;
};

// What the progress of a share tells: how many runs all shares have ended, and what its own take.
class ShareProgress {
 public:
  ShareProgress(const StudyPlan& plan, const std::filesystem::path& folder, const Share& share, bool quiet) {
    if (!quiet && !plan.stop) watch_.emplace(plan, folder, share);
  }
  void add(const StudyRun& run) {
    ++runs_;
    seconds_ += run.cpu_seconds;
    if (watch_) watch_->add(run.number);
  }
  std::string note(std::size_t asked, int failed) {
    return fmt::format("{} {} of {}, {:.3g} CPU s a run{}", watch_ ? "all shares" : "run",
                       watch_ ? watch_->ended() : runs_, asked, seconds_ / static_cast<double>(runs_),
                       failed ? fmt::format(", {} not done", failed) : "");
  }

 private:
  long runs_ = 0;
  double seconds_ = 0.0;
  std::optional<StudyWatch> watch_;
};

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
      throw OutputError(fmt::format("{}: is another plan than {}: another folder is allowed", copy.string(),
                                    plan.file.string()));
    return;
  }
  replace_file(copy, text);
}

}  // namespace

int seed_of(const StudyPlan& plan, long run) {
  return plan.seeds == 0 ? 0 : static_cast<int>(run % plan.most_seeds()) + 1;
}

std::size_t point_of(const StudyPlan& plan, long run) {
  return static_cast<std::size_t>(run / plan.most_seeds());
}

void run_chunk(const StudyPlan& plan, const StudyChunk& chunk, StudyScenes& scenes,
               const std::function<void(const StudyRun&)>& keep) {
  const std::size_t point = point_of(plan, chunk.front());
  std::unique_ptr<Scene> scene;
  for (const long number : chunk) {
    if (interrupted()) break;
    StudyRun run;
    try {
      if (!scene) scene = scenes.take(plan, point);
      const Eigen::Matrix3Xd shape = scene->bag ? scene->bag->initial_position : Eigen::Matrix3Xd();
      if (plan.seeds > 0) displace_nodes(*scene, plan.amplitude_at(point), seed_of(plan, number));
      const Member member = run_member(*scene);
      if (member.outcome.out_of_memory) throw std::bad_alloc();
      if (scene->bag) scene->bag->initial_position = shape;
      if (member.outcome.status == RunStatus::interrupted) break;
      run = run_of(plan, number, member, *scene);
    } catch (const std::bad_alloc& error) {
      throw std::runtime_error(fmt::format("point {}, seed {}: {}: with more of it the same command goes on",
                                           point, seed_of(plan, number), text_of(error)));
    } catch (const std::exception& error) {
      if (!is_of_the_values(error)) throw;
      run = refused(plan, number, error);
      scene.reset();
    }
    keep(run);
  }
  if (scene) scenes.give(point, std::move(scene));
}

CrewWork study_work(const StudyPlan& plan, int workers) {
  const auto scenes = std::make_shared<StudyScenes>(static_cast<std::size_t>(workers));
  return [&plan, scenes](const std::string& job, const std::function<void(CrewResult)>& emit) {
    run_chunk(plan, chunk_of(job), *scenes, [&](const StudyRun& run) { emit({line_of(run), run}); });
  };
}

bool run_study(const StudyPlan& plan, const std::filesystem::path& folder, const Share& share, Crew& crew,
               bool quiet) {
  ResultFolder::require_free(folder, "study", files_of_study(plan));
  keep_plan(plan, folder);
  ShareProgress all(plan, folder, share, quiet);
  StudyRuns ended = read_shares(folder, plan, SharesOf::this_build).runs;
  for (const auto& [number, run] : ended) all.add(run);
  ShareFile file(plan, folder, share.name());
  if (!quiet && !ended.empty())
    tell(fmt::format("{}: goes on after {} runs that are done", plan.name, ended.size()));
  while (!interrupted()) {
    const auto asked = asked_runs(plan, ended);
    std::vector<long> mine;
    for (const long run : asked)
      if (share.has(run) && !ended.contains(run)) mine.push_back(run);
    if (mine.empty()) break;
    Progress progress(plan.name, static_cast<double>(mine.size()), quiet);
    long done = 0;
    int failed = 0;
    crew.compute(jobs_of(plan, mine), [&](std::size_t, const CrewResult& result) {
      file.keep(result.line);
      const auto* known = std::any_cast<StudyRun>(&result.object);
      const StudyRun run = known ? *known : run_of_line(plan, result.line).value();
      ended.emplace(run.number, run);
      all.add(run);
      failed += run.status != "done";
      progress.update(static_cast<double>(++done), [&] { return all.note(asked.size(), failed); });
    });
  }
  file.end(!interrupted());
  return !interrupted();
}

}  // namespace driver
