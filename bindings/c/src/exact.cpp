// SPDX-License-Identifier: Apache-2.0
// The library gasjet_exact.
#include <gasjet_exact.h>
#include <gsl/gsl_errno.h>

#include <cmath>
#include <mutex>
#include <nlohmann/json.hpp>
#include <sstream>

#include "border.hpp"
#include "closed_form/catalogue.hpp"

using namespace border;

const gasjet_handle border::kHandlesBegin = gasjet_handle{1} << 62;

namespace {

struct Table : Object {
  static constexpr const char* name = "a table";
  static constexpr bool shared = true;
  explicit Table(const closed_form::Table& table) : columns(table.columns), values(columns.size()) {
    for (const auto& row : table.rows)
      for (std::size_t c = 0; c < row.size(); ++c) values[c].push_back(row[c]);
  }
  std::size_t column(int64_t number) const {
    if (number < 0 || number >= static_cast<int64_t>(columns.size()))
      refuse("column",
             "is " + std::to_string(number) + ", allowed: 0 to " + std::to_string(columns.size() - 1));
    return static_cast<std::size_t>(number);
  }
  std::vector<std::string> columns;
  std::vector<std::vector<double>> values;  // values of each column
};

/// GSL's own handler would end the program; closed forms check their results.
void quiet_gsl() {
  static std::once_flag once;
  std::call_once(once, [] { gsl_set_error_handler_off(); });
}

closed_form::ParameterMap parameters_of(const std::string& text) {
  closed_form::ParameterMap parameters;
  std::istringstream stream(text);
  for (std::string given; std::getline(stream, given);) {
    const std::string line(trim(given));
    if (line.empty()) continue;
    const auto equals = line.find('=');
    if (equals == std::string::npos) refuse("parameters", "'" + line + "', allowed: lines name=value");
    const std::string name(trim(std::string_view(line).substr(0, equals)));
    const double value = number_in(trim(std::string_view(line).substr(equals + 1)));
    if (!std::isfinite(value)) refuse("parameters", "'" + line + "', allowed: name=finite number");
    if (!parameters.emplace(name, value).second)
      refuse("parameters", name + " is given twice, allowed: once");
  }
  return parameters;
}

const closed_form::Entry& entry_of(const std::string& name) {
  try {
    return closed_form::find_entry(name);
  } catch (const std::invalid_argument& error) {
    refuse("name", error.what());
  }
}

nlohmann::ordered_json json_of(const closed_form::Entry& entry) {
  nlohmann::ordered_json json{{"name", entry.name},         {"title", entry.title},
                              {"equation", entry.equation}, {"source", entry.source},
                              {"validity", entry.validity}, {"digits", entry.digits},
                              {"family", entry.family},     {"columns", entry.columns}};
  for (const auto& p : entry.parameters) {
    nlohmann::ordered_json one{
        {"name", p.name}, {"symbol", p.symbol}, {"unit", p.unit}, {"meaning", p.meaning}};
    one["default"] = p.default_value ? nlohmann::ordered_json(*p.default_value) : nlohmann::ordered_json();
    json["parameters"].push_back(one);
  }
  return json;
}

}  // namespace

const char* gasjet_exact_last_error() {
  return last_error();
}

int gasjet_exact_catalogue(char text[], int64_t size, int64_t* needed) {
  return call([&] {
    auto all = nlohmann::ordered_json::array();
    for (const auto& entry : closed_form::catalogue()) all.push_back(json_of(entry));
    write_sized(all.dump(), text, size, needed);
  });
}

int gasjet_exact_create(const char* name, const char* parameters, const double times[], int64_t count,
                        gasjet_handle* table) {
  return call([&] {
    needed(table, "table");
    quiet_gsl();
    if (count < 0 || count > 10000000)
      refuse("count", "is " + std::to_string(count) + ", allowed: 0 to 10000000");
    if (count > 0) needed(times, "times");
    for (int64_t i = 0; i < count; ++i) number(times[i], "times");
    const auto& entry = entry_of(text(name, "name"));
    const std::span abscissae(times, static_cast<std::size_t>(count));
    *table = keep(std::make_shared<Table>(
        closed_form::evaluate(entry, parameters_of(text_or(parameters, "")), abscissae)));
  });
}

int gasjet_exact_size(gasjet_handle table, int64_t* columns, int64_t* rows) {
  return call([&] {
    const Use<Table> use(table, "table");
    needed(columns, "columns");
    needed(rows, "rows") = static_cast<int64_t>(use->values.front().size());
    *columns = static_cast<int64_t>(use->columns.size());
  });
}

int gasjet_exact_name(gasjet_handle table, int64_t column, char text[], int64_t size) {
  return call([&] {
    const Use<Table> use(table, "table");
    write_text(use->columns[use->column(column)], text, size, "text");
  });
}

int gasjet_exact_column(gasjet_handle table, int64_t column, const double** values) {
  return call([&] {
    const Use<Table> use(table, "table");
    needed(values, "values") = use->values[use->column(column)].data();
  });
}

int gasjet_exact_free(gasjet_handle table) {
  return call([&] { release(table); });
}
