// SPDX-License-Identifier: Apache-2.0
// Prints a closed form of the verification suite as CSV or JSON.
#include "command_exact.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/case_reader.hpp"
#include "base/json_head.hpp"
#include "commands/command.hpp"
#include "time_list.hpp"

namespace driver::commands {
namespace {

using Json = nlohmann::ordered_json;

void print_list() {
  for (const auto& entry : closed_form::catalogue()) {
    fmt::print("{}: {}\n    {}\n    parameters:", entry.name, entry.title, entry.equation);
    for (const auto& p : entry.parameters)
      fmt::print(" {}{}", p.name,
                 p.default_value ? fmt::format("={}", *p.default_value) : std::string(" (required)"));
    fmt::print("\n");
  }
}

// The output of a closed form. Values that do not depend on the abscissa are outside the table, so that the
// table can be compared with a history.
struct Printed {
  std::vector<std::pair<std::string, double>> constants;
  std::vector<std::vector<double>> rows;

  Printed(const closed_form::Entry& entry, const closed_form::Table& table) : rows(table.rows.size()) {
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      if (entry.is_constant(table.columns[c]))
        constants.emplace_back(table.columns[c], table.rows.front()[c]);
      else
        for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(table.rows[i][c]);
    }
  }
};

// The catalogue page of the documentation.
void print_page() {
  fmt::print(
      "# Closed forms\n\n"
      "Printed by `gasjet exact --list --format markdown`. "
      "`gasjet exact NAME --set parameter=value --times 0:0.3:1e-3` prints one of\n"
      "them as CSV or JSON (`--format`); SI units; the digits are those that are correct. `--times` gives\n"
      "the values of the first column, which is the time or what the form says. "
      "A value beside the table does not\ndepend on it: a `#` line of the CSV. "
      "Parameters outside their validity are refused.\n\n"
      "`--proved` prints lower and upper bounds of the formula, [with "
      "proof](theory/enclosure.md#closed-forms); "
      "`gasjet exact\n--list --proved` prints which forms have them.\n");
  std::string family;
  for (const auto& entry : closed_form::catalogue()) {
    if (entry.family != family) fmt::print("\n## {}\n", family = entry.family);
    fmt::print("\n**`{}`**: {}\n\n    {}\n\n", entry.name, entry.title, entry.equation);
    fmt::print("- columns: `{}`\n", fmt::join(table_columns(entry), "`, `"));
    if (!entry.constants.empty())
      fmt::print("- beside the table: `{}`\n", fmt::join(entry.constants, "`, `"));
    for (const auto& p : entry.parameters)
      fmt::print("- `{}`{} [{}], {}: {}\n", p.name, p.symbol.empty() ? "" : fmt::format(" (`{}`)", p.symbol),
                 p.unit, p.default_value ? fmt::format("{}", *p.default_value) : "required", p.meaning);
    fmt::print("- validity: {}; {} digits; source: {}\n", entry.validity, entry.digits, entry.source);
  }
}

Json to_json(const closed_form::Parameter& p) {
  return {{"name", p.name},
          {"symbol", p.symbol},
          {"unit", p.unit},
          {"default", p.default_value ? Json(*p.default_value) : Json()},
          {"meaning", p.meaning}};
}

Json to_json(const closed_form::Entry& entry) {
  Json parameters = Json::array();
  for (const auto& p : entry.parameters) parameters.push_back(to_json(p));
  return {{"name", entry.name},
          {"family", entry.family},
          {"title", entry.title},
          {"equation", entry.equation},
          {"source", entry.source},
          {"validity", entry.validity},
          {"digits", entry.digits},
          {"parameters", parameters},
          {"columns", table_columns(entry)},
          {"constants", entry.constants},
          {"abscissae", entry.default_abscissae}};
}

// The list for programs: a default is null if the parameter must be given; abscissae are empty if there is
// one row.
void print_list_json() {
  auto object = json_head<Json>();
  for (const auto& entry : closed_form::catalogue()) object["closed_forms"].push_back(to_json(entry));
  fmt::print("{}\n", object.dump(2));
}

void print_csv(const closed_form::Entry& entry, const closed_form::ParameterMap& parameters,
               const closed_form::Table& table) {
  fmt::print("# name: {}\n# equation: {}\n# source: {}\n# validity: {}\n# digits: {}\n", entry.name,
             entry.equation, entry.source, entry.validity, entry.digits);
  for (const auto& [name, value] : parameters) fmt::print("# {}: {}\n", name, value);
  const Printed printed(entry, table);
  for (const auto& [name, value] : printed.constants) fmt::print("# {}: {}\n", name, value);
  fmt::print("{}\n", fmt::join(table_columns(entry), ","));
  for (const auto& row : printed.rows) fmt::print("{}\n", fmt::join(row, ","));
}

void print_json(const closed_form::Entry& entry, const closed_form::ParameterMap& parameters,
                const closed_form::Table& table) {
  const Printed printed(entry, table);
  Json constants = Json::object();
  for (const auto& [name, value] : printed.constants) constants[name] = value;
  auto object = json_head<Json>();
  object.update({{"name", entry.name},
                 {"equation", entry.equation},
                 {"source", entry.source},
                 {"validity", entry.validity},
                 {"digits", entry.digits},
                 {"parameters", parameters},
                 {"constants", constants},
                 {"columns", table_columns(entry)},
                 {"rows", printed.rows}});
  fmt::print("{}\n", object.dump(2));
}

int list(const ExactArguments& a) {
  if (!a.name.empty() || !a.parameters.empty() || !a.times.empty())
    throw CaseError("--list: prints the whole catalogue: leave out NAME, --set and --times");
  if (a.format == "csv") throw CaseError("--format csv: prints one NAME; for --list use markdown or json");
  a.format.empty() ? print_list() : a.format == "json" ? print_list_json() : print_page();
  return exit_done;
}

}  // namespace

closed_form::ParameterMap parse_parameters(const std::vector<std::string>& texts) {
  closed_form::ParameterMap parameters;
  for (const auto& text : texts) {
    const auto equals = text.find('=');
    if (equals == std::string::npos) throw CaseError(fmt::format("--set {}: name=value is expected", text));
    const double value = parse_number(std::string_view(text).substr(equals + 1), "--set " + text);
    if (!parameters.emplace(text.substr(0, equals), value).second)
      throw CaseError(fmt::format("--set {}: {} is given twice", text, text.substr(0, equals)));
  }
  return parameters;
}

std::vector<std::string> table_columns(const closed_form::Entry& entry) {
  auto columns = entry.columns;
  std::erase_if(columns, [&](const std::string& name) { return entry.is_constant(name); });
  return columns;
}

int exact(const ExactArguments& arguments) {
  gsl_set_error_handler_off();  // closed forms check their results; GSL's own handler would end the program
  if (arguments.list) return list(arguments);
  if (arguments.format == "markdown")
    throw CaseError("--format markdown: prints --list only; use csv or json");
  if (arguments.name.empty())
    throw CaseError("exact: NAME is missing; `gasjet exact --list` prints the names");
  try {
    const auto& entry = closed_form::find_entry(arguments.name);
    const auto given = parse_parameters(arguments.parameters);
    const auto times = parse_times(arguments.times);
    const auto table = closed_form::evaluate(entry, given, times);
    const auto parameters = closed_form::complete_parameters(entry, given);
    arguments.format == "json" ? print_json(entry, parameters, table) : print_csv(entry, parameters, table);
  } catch (const std::invalid_argument& error) {
    throw CaseError(fmt::format("exact {}: {}", arguments.name, error.what()));
  }
  return exit_done;
}

}  // namespace driver::commands
