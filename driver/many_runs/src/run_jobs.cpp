// SPDX-License-Identifier: Apache-2.0
#include "run_jobs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <any>
#include <mutex>
#include <new>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

#include "base/case_reader.hpp"
#include "base/progress.hpp"
#include "base/text_file.hpp"
#include "many_runs/quantities.hpp"
#include "results/skin_checks.hpp"

namespace driver {
namespace {

using RunJson = nlohmann::json;

// [s] of a run below it the cost is the least of those that take as long, of which there are
constexpr double short_run = 0.02;
constexpr int short_repeats = 5;  // at least

// An override may hold any byte, which JSON's own text does not.
std::string job_text(const RunJob& job) {
  std::string text;
  RunJson::to_cbor({job.place, job.name, job.overrides, job.amplitude, job.runs, job.for_cost}, text);
  return text;
}

RunJob job_of(const std::string& text) {
  const RunJson json = RunJson::from_cbor(text);
  return {json[0], json[1], json[2], json[3], json[4], json[5]};
}

// Scenes that are being computed: a worker takes one, and gives it back for the next runs of the same job or
// of another with its overrides.
class ScenePool {
 public:
  explicit ScenePool(std::size_t most) : most_(most) {}

  std::unique_ptr<Scene> take(const RunCase& of, const RunJob& job) {
    {
      const std::lock_guard<std::mutex> guard(lock_);
      const auto found = std::ranges::find_if(
          free_, [&](const Free& one) { return one.place == job.place && one.overrides == job.overrides; });
      if (found != free_.end()) {
        auto scene = std::move(found->scene);
        free_.erase(found);
        return scene;
      }
    }
    return std::make_unique<Scene>(of.load(job.overrides));
  }

  void give(const RunJob& job, std::unique_ptr<Scene> scene) {
    const std::lock_guard<std::mutex> guard(lock_);
    if (free_.size() == most_) free_.erase(free_.begin());
    free_.push_back({job.place, job.overrides, std::move(scene)});
  }

 private:
  struct Free {
    std::size_t place;
    std::vector<std::string> overrides;
    std::unique_ptr<Scene> scene;
  };
  std::size_t most_;
  std::mutex lock_;
  std::vector<Free> free_;
};

// The displacement may push layers through each other, which contact could not undo.
RecordedRun first_run(const Scene& scene, const RunJob& job, int seed) {
  if (seed == 0 || !scene.skin_contact) return record_run(scene);
  const std::string crossed = crossed_layers(scene);
  if (crossed.empty()) return record_run(scene);
  RecordedRun run;
  run.outcome.status = RunStatus::failed;
  run.outcome.message = fmt::format(
      "membrane.self_contact: {}: displaced by up to {:.3g} m; lower the amplitude", crossed, job.amplitude);
  return run;
}

RecordedRun recorded(Scene& scene, const RunJob& job, int seed) {
  const Eigen::Matrix3Xd shape = scene.bag ? scene.bag->initial_position : Eigen::Matrix3Xd();
  if (seed > 0) displace_nodes(scene, job.amplitude, seed);
  RecordedRun run = first_run(scene, job, seed);
  double total = run.cpu_seconds, least = total;
  for (int i = 1; job.for_cost && run.outcome.status == RunStatus::done && least <= short_run &&
                  (i < short_repeats || total < short_run);
       ++i) {
    run = record_run(scene);
    total += run.cpu_seconds;
    least = std::min(least, run.cpu_seconds);
  }
  run.cpu_seconds = least;
  if (scene.bag) scene.bag->initial_position = shape;
  if (run.outcome.out_of_memory) throw std::bad_alloc();
  return run;
}

RunRecord record_of(const RunCase& of, const Scene& scene, RecordedRun run, long number) {
  RunRecord record{.number = number,
                   .status = status_name(run.outcome.status),
                   .message = run.outcome.message,
                   .warning = run.outcome.warning,
                   .values = {},
                   .rows = {},
                   .steps = run.steps,
                   .cpu_seconds = run.cpu_seconds};
  for (const auto& name : of.quantities)
    record.values.push_back(run.rows.empty() ? std::nullopt : quantity_of(scene, run, name));
  if (of.with_rows && record.is_done()) record.rows = std::move(run.rows);
  return record;
}

// What the case and its models refuse, in contrast to what the machine does.
bool is_of_the_values(const std::exception& error) {
  if (dynamic_cast<const FileError*>(&error) || dynamic_cast<const std::system_error*>(&error)) return false;
  return dynamic_cast<const std::runtime_error*>(&error) || dynamic_cast<const std::domain_error*>(&error) ||
         dynamic_cast<const std::invalid_argument*>(&error);
}

void do_job(const RunCase& of, const RunJob& job, ScenePool& scenes,
            const std::function<void(CrewResult)>& emit) {
  std::unique_ptr<Scene> scene;
  for (const auto& [number, seed] : job.runs) {
    if (interrupted()) break;
    RunRecord record;
    try {
      if (!scene) scene = scenes.take(of, job);
      RecordedRun run = recorded(*scene, job, seed);
      if (run.outcome.status == RunStatus::interrupted) break;
      record = record_of(of, *scene, std::move(run), number);
    } catch (const std::bad_alloc& error) {
      throw std::runtime_error(
          fmt::format("{}, seed {}: {}. Run the same command with more memory to continue", job.name, seed,
                      text_of(error)));
    } catch (const std::exception& error) {
      if (!of.keeps_refusals || !is_of_the_values(error)) throw;
      record = {.number = number, .status = "refused", .message = text_of(error), .values = {}};
      record.values.resize(of.quantities.size());
      scene.reset();
    }
    std::string line = line_of(record);
    emit({std::move(line), std::move(record)});
  }
  if (scene) scenes.give(job, std::move(scene));
}

}  // namespace

CrewWork run_work(std::vector<RunCase> cases, int workers) {
  const auto scenes = std::make_shared<ScenePool>(static_cast<std::size_t>(workers));
  return [cases = std::move(cases), scenes](const std::string& text,
                                            const std::function<void(CrewResult)>& emit) {
    const RunJob job = job_of(text);
    do_job(cases.at(job.place), job, *scenes, emit);
  };
}

RunBatch batch_of(std::string title, bool quiet, std::vector<RunJob> jobs) {
  RunBatch batch{std::move(title), quiet, 0, jobs.size(), {}};
  for (const RunJob& job : jobs) batch.runs += static_cast<long>(job.runs.size());
  batch.job = [jobs = std::move(jobs)](std::size_t i) { return jobs[i]; };
  return batch;
}

void compute_runs(Crew& crew, const RunBatch& batch, RunJournal& journal) {
  Progress progress(batch.title, static_cast<double>(batch.runs), batch.quiet);
  long ended = 0, not_done = 0;
  double seconds = 0.0;
  const auto note = [&] {
    if (batch.of_all > 0) journal.look_at_shares();
    return fmt::format("{} {} of {}, {:.3g} CPU s a run{}", batch.of_all > 0 ? "all shares" : "run",
                       batch.of_all > 0 ? static_cast<long>(journal.runs().size()) : ended,
                       batch.of_all > 0 ? batch.of_all : batch.runs, seconds / static_cast<double>(ended),
                       not_done > 0 ? fmt::format(", {} not done", not_done) : "");
  };
  const auto text = [&](std::size_t i) { return job_text(batch.job(i)); };
  crew.compute(batch.jobs, text, [&](CrewResult result) {
    const RunRecord& run = journal.keep(std::move(result));
    seconds += run.cpu_seconds;
    not_done += !run.is_done();
    progress.update(static_cast<double>(++ended), note);
  });
}

void tell_start(const std::string& title, const RunJournal& journal, bool quiet) {
  if (!quiet && !journal.runs().empty())
    tell(fmt::format("{}: continues after {} finished runs", title, journal.runs().size()));
}

}  // namespace driver
