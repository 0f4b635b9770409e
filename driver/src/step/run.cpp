// SPDX-License-Identifier: Apache-2.0
#include "driver/run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "driver/fields.hpp"
#include "driver/progress.hpp"
#include "step/drift.hpp"
#include "step/stages.hpp"

namespace driver {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Levels to record: the first at or past each multiple of the interval.
class Schedule {
 public:
  explicit Schedule(double interval) : interval_(interval) {}
  bool due(double time) {
    // Multiples meet the step's times to round-off only.
    if (interval_ <= 0.0 || time < next_ * interval_ * (1.0 - 1e-12)) return false;
    next_ = std::floor(time / interval_ * (1.0 + 1e-12)) + 1.0;
    return true;
  }

 private:
  double interval_;
  double next_ = 0.0;  // multiple that is due next
};

void run_steps(const Scene& scene, State& state, const LevelSink& sink,
               const std::function<void(const State&)>& fields, const Executor& executor,
               const std::function<bool()>& stop_wanted, RunOutcome& outcome) {
  Schedule history(scene.output.history_every), pictures(scene.output.fields_every);
  for (;;) {
    StepRequest request;
    const bool stop = stop_wanted ? stop_wanted() : interrupted();
    request.last = stop || state.time >= scene.time.end;
    request.record = history.due(state.time) || request.last;
    if (fields && pictures.due(state.time)) request.before_advance = &fields;
    const double now = state.time;
    step(scene, state, request, executor);
    sink(request.record, state);
    if (stop) outcome.status = RunStatus::interrupted;
    if (request.last) return;
    const double stop_at = next_stop(scene, now);
    state.time = state.step.after >= stop_at - now ? stop_at : now + state.step.after;
    ++state.steps;
  }
}

void judge_drift(const Scene& scene, const State& state, RunOutcome& outcome) {
  const double drift = energy_drift(state);
  if (!(drift > kDriftWarned)) return;
  if (outcome.status != RunStatus::done || drift <= kDriftInaccurate) {
    outcome.warning = drift_text(scene, state);
    return;
  }
  outcome.status = RunStatus::inaccurate;
  outcome.message = drift_text(scene, state);
}

}  // namespace

RunOutcome run_scene(const Scene& scene, State& state, const LevelSink& sink,
                     const std::function<void(const State&)>& fields, const Executor& executor,
                     const std::function<bool()>& stop) {
  RunOutcome outcome;
  const auto start = std::chrono::steady_clock::now();
  const auto fail = [&](const std::exception& error) {
    outcome.status = RunStatus::failed;
    outcome.message = fmt::format("stage {} at {} s, step {}: {}", stage_name(state.stage), state.time,
                                  state.steps, text_of(error));
  };
  try {
    run_steps(scene, state, sink, fields, executor, stop, outcome);
  } catch (const std::exception& error) {
    // A stage refused what an earlier one computed (a coordinate out of range, say), or memory ran out.
    fail(error);
  }
  outcome.wall_seconds = seconds_since(start);
  judge_drift(scene, state, outcome);
  return outcome;
}

RunOutcome run_to_folder(const Scene& scene, const std::filesystem::path& path, const Provenance& lines,
                         const RunOptions& options) {
  State state = make_state(scene);
  const bool with_fields = scene.output.fields_every > 0.0;
  ResultFolder folder(path, "run", [&](const std::string& name) {
    return name == "history.csv" || name == "energy.csv" || name == "summary.json" ||
           (with_fields && FieldWriter::is_own(name));
  });
  folder.begin(lines);
  folder.write("summary.json", summary_of_running(scene, folder.lines()));
  CsvWriter history(folder, "history.csv", history_columns(scene));
  CsvWriter energy(folder, "energy.csv", energy_columns(scene));
  Progress progress(scene.name, scene.time.end, options.quiet);
  std::optional<FieldWriter> pictures;
  if (with_fields) pictures.emplace(folder, scene);
  const auto record = [&](bool recorded, const State& now) {
    progress.update(now.time);
    if (recorded) {
      history.write(scene, now);
      energy.write(scene, now);
    }
    if (options.watch) options.watch(recorded, now);
    history.keep_up();
    energy.keep_up();
  };
  const auto fields = [&](const State& now) {
    if (pictures) pictures->write(now);
  };
  const RunOutcome outcome = run_scene(scene, state, record, fields, Executor(options.threads), options.stop);
  history.flush();
  energy.flush();
  folder.write("summary.json", summary_text(scene, state, outcome, folder.lines()));
  folder.end(status_name(outcome.status));
  return outcome;
}

}  // namespace driver
