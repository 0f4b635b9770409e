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

RunOutcome run_to_folder(const Scene& scene, const std::filesystem::path& path, const Provenance& lines,
                         const RunOptions& options) {
  State state = make_state(scene);
  const bool with_fields = scene.output.fields_every > 0.0,
             with_frames = (scene.bag || scene.target) && scene.output.frames > 0;
  ResultFolder folder(path, "run");
  if (options.ready) options.ready();
  folder.begin(lines);
  folder.write("summary.json", summary_of_running(scene, folder.lines()));
  const std::string check = options.document ? check_file(*options.document, scene, folder.run()) : "";
  if (!check.empty()) folder.write("check.json", check);
  CsvWriter history(folder, "history.csv", history_columns(scene));
  CsvWriter energy(folder, "energy.csv", energy_columns(scene));
  Progress progress(scene.name, scene.time.end, options.quiet);
  std::optional<FieldWriter> fields;
  if (with_fields) fields.emplace(folder, scene);
  std::optional<FrameWriter> frames;
  if (with_frames) frames.emplace(folder, scene);
  AccelerationRecord accelerations;
  const auto& classes = scene.output.channel_classes;
  const auto record = [&](bool recorded, const State& now) {
    progress.update(now.time, [&] { return reached(now); });
    if (recorded) {
      history.write(scene, now);
      energy.write(scene, now);
    }
    if (!classes.empty()) accelerations.add(recorded, now);
    if (options.watch) options.watch(recorded, now);
    history.keep_up();
    energy.keep_up();
  };
  SkinChecks checks(scene);
  std::vector<LevelView> views;
  if (fields)
    views.push_back(at_multiples(scene.output.fields_every, [&](const State& now) { fields->write(now); }));
  if (frames)
    views.push_back(
        at_multiples(scene.time.end / scene.output.frames, [&](const State& now) { frames->write(now); }));
  views.push_back(checks.view());
  RunOutcome outcome = run_scene(scene, state, record, views, Executor(options.threads), options.stop);
  checks.note(outcome);
  for (CsvWriter* table : {&history, &energy}) flush(*table, outcome);
  if (!classes.empty())
    folder.write("accelerations.csv", comment_lines(folder.lines()) + accelerations.table(classes));
  write_summary(folder, summary_text(scene, state, outcome, checks.found(), folder.lines()));
  folder.end(status_name(outcome.status));
  return outcome;
}

}  // namespace driver
