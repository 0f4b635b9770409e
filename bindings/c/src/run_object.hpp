// SPDX-License-Identifier: Apache-2.0
// Runs as objects of the border, and calls of the driver.
#pragma once
#include <gasjet/run.h>

#include <array>
#include <chrono>
#include <sstream>
#include <string>
#include <vector>

#include "base/case_reader.hpp"
#include "base/result_folder.hpp"
#include "border.hpp"
#include "engine/columns.hpp"

namespace border {

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

using Tables = std::array<Table, 2>;
inline const Table& table_of(const Tables& tables, int number) {
  if (number != GASJET_HISTORY && number != GASJET_ENERGY)
    refuse("table", "is " + std::to_string(number) + ", allowed: GASJET_HISTORY, GASJET_ENERGY");
  return tables[static_cast<std::size_t>(number)];
}
/// Number of a column.
inline std::size_t column_of(const Table& table, const std::string& name) {
  std::string there;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (table.columns[c].name == name) return c;
    there += (c == 0 ? "" : ", ") + table.columns[c].name;
  }
  refuse("name", "'" + name + "' is not a column, allowed: " + there);
}

struct Run : Object {
  static constexpr const char* name = "a run";
  static constexpr bool shared = true;
  explicit Run(const driver::Scene& scene)
      : tables{Table(driver::history_columns(scene)), Table(driver::energy_columns(scene))} {}

  const Table& table(int number) const { return table_of(tables, number); }
  Tables tables;
  std::string summary;
};

/// The non-empty parts of a text, without blanks and carriage returns around them.
inline std::vector<std::string> parts_of(const std::string& text, char separator) {
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

inline Order order_of(const char* case_file, const char* overrides, const char* out, int threads) {
  if (threads < 1 || threads > 1024)
    refuse("threads", "is " + std::to_string(threads) + ", allowed: 1 to 1024");
  return {path(case_file, "case_file"), path_or_none(out, "out"), parts_of(text_or(overrides, ""), '\n'),
          threads};
}

inline driver::CaseDocument document_of(const Order& order, const char* case_text) {
  if (case_text == nullptr) return {order.file, order.overrides};
  return driver::CaseDocument::of_text(case_text, order.file, order.overrides);
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

}  // namespace border
