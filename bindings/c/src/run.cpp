// SPDX-License-Identifier: Apache-2.0
#include "engine/run.hpp"

#include <gasjet/run.h>

#include <array>
#include <chrono>
#include <fstream>
#include <sstream>

#include "arrays.hpp"
#include "base/case_reader.hpp"
#include "compare/compare.hpp"
#include "engine/columns.hpp"
#include "forecast/jet_peak.hpp"
#include "results/load_scene.hpp"
#include "results/results.hpp"
#include "results/run_to_folder.hpp"
#include "results/skin_checks.hpp"
#include "results/summary.hpp"

using namespace border;

namespace {

/// Columns of a table, by name and values.
struct Table {
  std::vector<driver::Column> columns;
  std::vector<std::vector<double>> values;  // values of each column

  explicit Table(std::vector<driver::Column> given) : columns(std::move(given)), values(columns.size()) {}
  void record(const driver::Scene& scene, const driver::State& state) {
    const auto row = driver::row(columns, scene, state);
    for (std::size_t c = 0; c < row.size(); ++c) values[c].push_back(row[c]);
  }
};

struct Run : Object {
  static constexpr const char* name = "a run";
  static constexpr bool shared = true;
  explicit Run(const driver::Scene& scene)
      : tables{Table(driver::history_columns(scene)), Table(driver::energy_columns(scene))} {}

  const Table& table(int number) const {
    if (number != GASJET_HISTORY && number != GASJET_ENERGY)
      refuse("table", "is " + std::to_string(number) + ", allowed: GASJET_HISTORY, GASJET_ENERGY");
    return tables[static_cast<std::size_t>(number)];
  }
  std::array<Table, 2> tables;
  std::string summary;
};

/// The non-empty parts of a text, without blanks and carriage returns around them.
std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
    if (const auto trimmed = trim(part); !trimmed.empty()) parts.emplace_back(trimmed);
  return parts;
}

/// Calls the callback now and then. An exception in it stops the run.
class Callback {
 public:
  Callback(gasjet_progress function, void* user, double end, Environment& environment)
      : function_(function), user_(user), end_(end), environment_(environment) {}
  void level(double time) {
    if (function_ == nullptr || stopped_) return;
    const auto now = std::chrono::steady_clock::now();
    if (called_ && time < end_ && now - last_ < std::chrono::milliseconds(100)) return;
    called_ = true;
    last_ = now;
    stopped_ = environment_.callers([&] { return asks_to_stop(time); });
  }
  bool stopped() const { return stopped_; }
  bool thrown() const { return thrown_; }

 private:
  bool asks_to_stop(double time) {
    try {
      return function_(time, end_, user_) != 0;
    } catch (...) {
      return thrown_ = true;
    }
  }

  gasjet_progress function_;
  void* user_;
  double end_;
  Environment& environment_;
  bool called_ = false, stopped_ = false, thrown_ = false;
  std::chrono::steady_clock::time_point last_;
};

struct Order {
  std::string file, out;
  std::vector<std::string> overrides;
  int threads;
};

driver::CaseDocument document_of(const Order& order, const char* case_text) {
  if (case_text == nullptr) return {order.file, order.overrides};
  return driver::CaseDocument::of_text(case_text, order.file, order.overrides);
}

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

/// Calls f; turns the driver's errors into errors of the border.
template <class F>
int call_driver(F&& f) {
  return call([&](Environment& environment) {
    try {
      f(environment);
    } catch (const driver::CaseError& error) {
      throw Refusal(error.what());
    } catch (const driver::OutputError& error) {
      throw Refusal(error.what());
    }
  });
}

}  // namespace

int gasjet_run(const char* case_file, const char* case_text, const char* overrides, const char* out,
               int threads, gasjet_progress progress, void* user, gasjet_handle* run) {
  return call_driver([&](Environment& environment) {
    needed(run, "run");
    if (threads < 1 || threads > 1024)
      refuse("threads", "is " + std::to_string(threads) + ", allowed: 1 to 1024");
    const Order order{path(case_file, "case_file"), path_or_none(out, "out"),
                      parts_of(text_or(overrides, ""), '\n'), threads};
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
    const std::string wanted = text(name, "name");
    needed(values, "values");
    std::string there;
    for (std::size_t c = 0; c < asked.columns.size(); ++c) {
      if (asked.columns[c].name == wanted) {
        *values = asked.values[c].data();
        return;
      }
      there += (c == 0 ? "" : ", ") + asked.columns[c].name;
    }
    refuse("name", "'" + wanted + "' is not a column, allowed: " + there);
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
