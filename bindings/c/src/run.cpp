// SPDX-License-Identifier: Apache-2.0
#include "engine/run.hpp"

#include <gasjet/run.h>

#include <fstream>

#include "arrays.hpp"
#include "compare/compare.hpp"
#include "forecast/jet_peak.hpp"
#include "results/load_scene.hpp"
#include "results/results.hpp"
#include "results/run_to_folder.hpp"
#include "results/skin_checks.hpp"
#include "results/summary.hpp"
#include "run_object.hpp"

using namespace border;

namespace {

/// Runs a scene. If a folder is given, writes the command's files. `run` gets tables and summary in any case.
driver::RunOutcome run_scene(const driver::Scene& scene, const driver::CaseDocument& document,
                             const Order& order, Callback& callback, Run& run) {
  const auto lines = driver::provenance(order.file, order.overrides);
  driver::RunOptions options{.quiet = true, .threads = order.threads, .document = &document};
  options.watch = [&](bool recorded, const driver::State& now) {
    callback.level(now.time);
    if (!recorded) return;
    for (Table& table : run.tables) table.record(scene, now);
  };
  options.stop = [&] { return callback.stopped(); };
  if (!order.out.empty()) {
    const auto outcome = driver::run_to_folder(scene, order.out, lines, options);
    std::ifstream file(std::filesystem::path(order.out) / "summary.json");
    run.summary.assign(std::istreambuf_iterator<char>(file), {});
    return outcome;
  }
  driver::State state = driver::make_state(scene);
  driver::SkinChecks checks(scene);
  auto outcome = driver::run_scene(scene, state, options.watch, {checks.view()},
                                   driver::Executor(order.threads), options.stop);
  checks.note(outcome);
  run.summary = driver::summary_text(scene, state, outcome, checks.found(), lines);
  return outcome;
}

/// Turns the outcome into a status; the run is kept in any case.
void judge(const driver::RunOutcome& outcome, const Callback& callback) {
  if (callback.thrown())
    throw Failure(GASJET_STOPPED, "progress: threw an exception, allowed: to return a number");
  if (outcome.status == driver::RunStatus::interrupted)
    throw Failure(GASJET_STOPPED, "progress: stopped the run");
  if (outcome.status == driver::RunStatus::inaccurate)
    throw Failure(GASJET_DOMAIN, "inaccurate: " + outcome.message);
  if (outcome.status == driver::RunStatus::failed) throw Failure(GASJET_DOMAIN, outcome.message);
}

std::size_t column_of(const Table& table, int64_t column) {
  if (column < 0 || column >= static_cast<int64_t>(table.columns.size()))
    refuse("column",
           "is " + std::to_string(column) + ", allowed: 0 to " + std::to_string(table.columns.size() - 1));
  return static_cast<std::size_t>(column);
}

}  // namespace

int gasjet_run(const char* case_file, const char* case_text, const char* overrides, const char* out,
               int threads, gasjet_progress progress, void* user, gasjet_handle* run) {
  return call_driver([&](Environment& environment) {
    needed(run, "run");
    const Order order = order_of(case_file, overrides, out, threads);
    driver::CaseDocument document = document_of(order, case_text);
    driver::Scene scene = driver::load_scene(document);
    driver::add_jet_warnings(scene);
    driver::add_skin_warning(scene);
    const auto made = std::make_shared<Run>(scene);
    Callback callback(progress, user, scene.time.end, environment);
    const auto outcome = run_scene(scene, document, order, callback, *made);
    *run = keep(made);
    judge(outcome, callback);
  });
}

int gasjet_run_size(gasjet_handle run, int table, int64_t* columns, int64_t* rows) {
  return call([&] {
    const Use<Run> use(run, "run");
    const Table& asked = use->table(table);
    needed(columns, "columns");
    needed(rows, "rows") = static_cast<int64_t>(asked.values.front().size());
    *columns = static_cast<int64_t>(asked.columns.size());
  });
}

int gasjet_run_name(gasjet_handle run, int table, int64_t column, char text[], int64_t size) {
  return call([&] {
    const Use<Run> use(run, "run");
    const Table& asked = use->table(table);
    write_text(asked.columns[column_of(asked, column)].name, text, size, "text");
  });
}

int gasjet_run_column(gasjet_handle run, int table, int64_t column, const double** values) {
  return call([&] {
    const Use<Run> use(run, "run");
    const Table& asked = use->table(table);
    needed(values, "values") = asked.values[column_of(asked, column)].data();
  });
}

int gasjet_run_find(gasjet_handle run, int table, const char* name, const double** values) {
  return call([&] {
    const Use<Run> use(run, "run");
    const Table& asked = use->table(table);
    needed(values, "values") = asked.values[column_of(asked, text(name, "name"))].data();
  });
}

int gasjet_run_summary(gasjet_handle run, char text[], int64_t size, int64_t* needed) {
  return call([&] { write_sized(Use<Run>(run, "run")->summary, text, size, needed); });
}

int gasjet_compare(const char* mine, const char* reference, const char* map, const char* columns,
                   double tolerance, int* verdict, char text[], int64_t size, int64_t* needed_size) {
  return call_driver([&](Environment&) {
    const std::string my_file = path(mine, "mine"), reference_file = path(reference, "reference");
    number(tolerance, "tolerance", 0.0);
    const auto map_file = path_or_none(map, "map");
    const auto names = parts_of(text_or(columns, ""), ',');
    const auto reference_history = driver::read_history(reference_file);
    const auto my_history = driver::read_history(my_file, map_file, reference_history, names);
    const auto difference = driver::compare(my_history, reference_history, names, tolerance);
    const bool inside = difference.verdict == driver::Verdict::inside;
    const bool outside = difference.verdict == driver::Verdict::outside;
    needed(verdict, "verdict") = inside ? GASJET_INSIDE : outside ? GASJET_OUTSIDE : GASJET_UNDECIDED;
    write_sized(driver::json_of(difference, my_file, reference_file), text, size, needed_size);
  });
}
