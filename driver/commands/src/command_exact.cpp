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
template <class Value>
struct Printed {
  std::vector<std::pair<std::string, Value>> constants;
  std::vector<std::vector<Value>> rows;

  Printed(const closed_form::Entry& entry, const std::vector<std::vector<Value>>& all) : rows(all.size()) {
    for (std::size_t c = 0; c < entry.columns.size(); ++c) {
      if (entry.is_constant(entry.columns[c]))
        constants.emplace_back(entry.columns[c], all.front()[c]);
      else
        for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(all[i][c]);
    }
  }
};

// The digits that are left; 0e-16 if none is.
std::vector<std::vector<std::string>> texts_of(const closed_form::RoundedTable& table) {
  std::vector<std::vector<std::string>> texts(table.rows.size());
  for (std::size_t i = 0; i < texts.size(); ++i)
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      const double value = table.rows[i][c], unit = table.within[i][c];
      texts[i].push_back(value == 0.0 && unit > 0.0 ? fmt::format("0e{:.0f}", std::log10(unit))
                                                    : fmt::format("{}", value));
    }
  return texts;
}

// The catalogue page of the documentation.
void print_page() {
  fmt::print(
      "# Closed forms\n\n"
      "Printed by `gasjet exact --list --format markdown`. "
      "`gasjet exact NAME --set parameter=value --times 0:0.3:1e-3` prints one of\n"
      "them as CSV or JSON (`--format`); SI units. `--times` gives the values of the first column, which is\n"
      "the time or what the form says. A value beside the table does not depend on it: a `#` line of the\n"
      "CSV. Parameters outside their validity are refused.\n\n"
      "A printed number is within one unit of its last digit of the exact value. It has at most the digits\n"
      "that the form states, and fewer where terms cancel. Each row is computed four times, with every\n"
      "operation rounded to nearest, up, down and toward zero; digits that differ are left out. (A browser\n"
      "rounds to nearest only: there all stated digits are printed.) `0e-16` says that the value is within\n"
      "1e-16 of 0 and that no digit of it is known. `within` in JSON is the unit of each number, or 0 if no\n"
      "rounding took part.\n\n"
      "`--proved` prints lower and upper bounds of the formula, "
      "[with proof](theory/enclosure.md#closed-forms).\n"
      "`gasjet exact --list --proved` prints which forms have them; `--format json` is for programs. Bounds\n"
      "wider than 1e-20 of the value are named, in `#` lines of the CSV and in `wide` of the JSON; then the\n"
      "exit code is 3.\n");
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
               const closed_form::RoundedTable& table) {
  fmt::print("# name: {}\n# equation: {}\n# source: {}\n# validity: {}\n# digits: {}\n", entry.name,
             entry.equation, entry.source, entry.validity, entry.digits);
  for (const auto& [name, value] : parameters) fmt::print("# {}: {}\n", name, value);
  const Printed printed(entry, texts_of(table));
  for (const auto& [name, value] : printed.constants) fmt::print("# {}: {}\n", name, value);
  fmt::print("{}\n", fmt::join(table_columns(entry), ","));
  for (const auto& row : printed.rows) fmt::print("{}\n", fmt::join(row, ","));
}

void print_json(const closed_form::Entry& entry, const closed_form::ParameterMap& parameters,
                const closed_form::RoundedTable& table) {
  const Printed printed(entry, table.rows), within(entry, table.within);
  const auto object_of = [](const auto& pairs) {
    Json constants = Json::object();
    for (const auto& [name, value] : pairs) constants[name] = value;
    return constants;
  };
  auto object = json_head<Json>();
  object.update({{"name", entry.name},
                 {"equation", entry.equation},
                 {"source", entry.source},
                 {"validity", entry.validity},
                 {"digits", entry.digits},
                 {"parameters", parameters},
                 {"constants", object_of(printed.constants)},
                 {"constants_within", object_of(within.constants)},
                 {"columns", table_columns(entry)},
                 {"rows", printed.rows},
                 {"within", within.rows}});
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
    const auto table = closed_form::evaluate_rounded(entry, given, times);
    const auto parameters = closed_form::complete_parameters(entry, given);
    arguments.format == "json" ? print_json(entry, parameters, table) : print_csv(entry, parameters, table);
  } catch (const std::invalid_argument& error) {
    throw CaseError(fmt::format("exact {}: {}", arguments.name, error.what()));
  }
  return exit_done;
}

}  // namespace driver::commands
