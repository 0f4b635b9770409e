// SPDX-License-Identifier: Apache-2.0
#include "results/run_to_folder.hpp"

#include <fmt/format.h>

#include <numbers>
#include <optional>

#include "base/progress.hpp"
#include "base/result_folder.hpp"
#include "forecast/check_json.hpp"
#include "results/acceleration_record.hpp"
#include "results/fields.hpp"
#include "results/frames.hpp"
#include "results/results.hpp"
#include "results/skin_checks.hpp"
#include "results/summary.hpp"

namespace driver {
namespace {

// Text of a run in the line of progress.
std::string reached(const State& now) {
  const double pressure = now.bag && !now.gas_integrator ? now.bag->gauge_pressure : now.gas_point.pressure;
  std::string text = fmt::format("{:.4g} ms", 1e3 * now.time);
  if (now.bag || now.gas_integrator) text += fmt::format(", {:.4g} kPa", 1e-3 * pressure);
  if (now.pendulum) text += fmt::format(", {:.3g} deg", now.level.pendulum_angle * 180.0 / std::numbers::pi);
  return text;
}

// If rows do not fit on the disk, the run counts as failed, and the other files are still written.
void flush(CsvWriter& table, RunOutcome& outcome) {
  try {
    table.flush();
  } catch (const WriteError& error) {
    outcome.status = RunStatus::failed;
    outcome.message = error.what();
  }
}

// On a full disk the old summary is removed, because it would say "running" for ever.
void write_summary(ResultFolder& folder, const std::string& text) {
  try {
    folder.write("summary.json", text);
  } catch (const WriteError&) {
    folder.remove("summary.json");
    folder.write("summary.json", text);
  }
}

}  // namespace

struct RunFolder::Files {
  Files(const Scene& scene, const std::filesystem::path& path, const Provenance& lines,
        const RunOptions& the_options)
      : now(&scene), watch(the_options.watch), folder(path, "run") {
    if (the_options.ready) the_options.ready();
    folder.begin(lines);
    folder.write("summary.json", summary_of_running(scene, folder.lines()));
    const std::string check =
        the_options.document ? check_file(*the_options.document, scene, folder.run()) : "";
    if (!check.empty()) folder.write("check.json", check);
    history.emplace(folder, "history.csv", history_columns(scene));
    energy.emplace(folder, "energy.csv", energy_columns(scene));
    progress.emplace(scene.name, scene.time.end, the_options.quiet);
    if (scene.output.fields_every > 0.0) fields.emplace(folder, scene);
    if ((scene.bag || scene.target) && scene.output.frames > 0) frames.emplace(folder, scene);
    checks.emplace(scene);
  }

  void record(bool recorded, const State& state) {
    progress->update(state.time, [&] { return reached(state); });
    if (recorded) {
      history->write(*now, state);
      energy->write(*now, state);
    }
    if (!now->output.channel_classes.empty()) accelerations.add(recorded, state);
    if (watch) watch(recorded, state);
    history->keep_up();
    energy->keep_up();
  }

  const Scene* now;  // of the level
  LevelSink watch;
  ResultFolder folder;
  std::optional<CsvWriter> history, energy;
  std::optional<Progress> progress;
  std::optional<FieldWriter> fields;
  std::optional<FrameWriter> frames;
  AccelerationRecord accelerations;
  std::optional<SkinChecks> checks;
};

RunFolder::RunFolder(const Scene& scene, const std::filesystem::path& path, const Provenance& lines,
                     const RunOptions& options)
    : files_(std::make_unique<Files>(scene, path, lines, options)) {}
RunFolder::~RunFolder() = default;

LevelSink RunFolder::sink() {
  return [&files = *files_](bool recorded, const State& now) { files.record(recorded, now); };
}

std::vector<LevelView> RunFolder::views() {
  Files& files = *files_;
  const OutputPart& output = files.now->output;
  std::vector<LevelView> views;
  if (files.fields)
    views.push_back(at_multiples(output.fields_every, [&](const State& now) { files.fields->write(now); }));
  if (files.frames)
    views.push_back(at_multiples(files.now->time.end / output.frames,
                                 [&](const State& now) { files.frames->write(now); }));
  views.push_back(files.checks->view());
  return views;
}

const SkinChecks& RunFolder::checks() const {
  return *files_->checks;
}

void RunFolder::follow(const Scene& scene) {
  files_->now = &scene;
}

void RunFolder::end(const State& state, RunOutcome& outcome) {
  Files& files = *files_;
  ResultFolder& folder = files.folder;
  files.checks->note(outcome);
  for (auto* table : {&files.history, &files.energy}) flush(**table, outcome);
  if (const auto& classes = files.now->output.channel_classes; !classes.empty())
    folder.write("accelerations.csv", comment_lines(folder.lines()) + files.accelerations.table(classes));
  write_summary(folder, summary_text(*files.now, state, outcome, files.checks->found(), folder.lines()));
  folder.end(status_name(outcome.status));
}

RunOutcome run_to_folder(const Scene& scene, const std::filesystem::path& path, const Provenance& lines,
                         const RunOptions& options) {
  State state = make_state(scene);
  RunFolder folder(scene, path, lines, options);
  RunOutcome outcome =
      run_scene(scene, state, folder.sink(), folder.views(), Executor(options.threads), options.stop);
  folder.end(state, outcome);
  return outcome;
}

}  // namespace driver
