// SPDX-License-Identifier: Apache-2.0
// Prints proved bounds of a closed form as CSV or JSON.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gsl/gsl_errno.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/case_reader.hpp"
#include "base/json_head.hpp"
#include "command_exact.hpp"
#include "commands/command.hpp"
#include "enclosure_module.hpp"
#include "time_list.hpp"

namespace driver::commands {
namespace {

using Json = nlohmann::ordered_json;

/// A closed form at some parameters and abscissae, and its bounds there.
struct Proof {
  const closed_form::Entry& entry;
  closed_form::ParameterMap parameters;
  std::vector<double> abscissae;
  enclosure::ProvedForm form;
};

Proof proof_of(const ExactArguments& arguments) {
  const auto& entry = closed_form::find_entry(arguments.name);
  const auto given = parse_parameters(arguments.parameters);
  Proof proof{entry, closed_form::complete_parameters(entry, given), {}, {}};
  // The form itself refuses what is outside its validity.
  for (const auto& row : closed_form::evaluate(entry, given, parse_times(arguments.times)).rows)
    proof.abscissae.push_back(row.front());
  enclosure::Question question{entry.name, {}, entry.columns, proof.abscissae};
  if (entry.has_abscissa()) question.columns.erase(question.columns.begin());
  for (const auto& p : entry.parameters)
    question.values[p.symbol.empty() ? p.name : p.symbol] = proof.parameters.at(p.name);
  proof.form = prove_by_module(question);
  return proof;
}

/// Where bounds are wide: "depth_m where force_N is 1e-09".
std::vector<std::string> wide_places(const Proof& proof) {
  std::vector<std::string> places;
  for (const auto& [row, column] : proof.form.wide) {
    places.push_back(proof.form.columns[column]);
    if (proof.entry.has_abscissa())
      places.back() += fmt::format(" where {} is {}", proof.entry.columns.front(), proof.abscissae[row]);
  }
  return places;
}

void print_csv(const Proof& proof) {
  const auto& [entry, parameters, abscissae, form] = proof;
  fmt::print("# name: {}\n# equation: {}\n# source: {}\n# validity: {}\n# proved: lower and upper bounds\n",
             entry.name, entry.equation, entry.source, entry.validity);
  for (const auto& [column, reason] : form.refused) fmt::print("# not proved: {}: {}\n", column, reason);
  for (const auto& place : wide_places(proof)) fmt::print("# wider than 1e-20 of the value: {}\n", place);
  for (const auto& [name, value] : parameters) fmt::print("# {}: {}\n", name, value);
  std::vector<std::string> heads;
  if (entry.has_abscissa()) heads.push_back(entry.columns.front());
  for (std::size_t c = 0; c < form.columns.size(); ++c) {
    const auto& b = form.rows.front()[c];
    if (entry.is_constant(form.columns[c]))
      fmt::print("# {0}_lower: {1}\n# {0}_upper: {2}\n", form.columns[c], b.lower_text, b.upper_text);
    else
      heads.push_back(fmt::format("{0}_lower,{0}_upper", form.columns[c]));
  }
  fmt::print("{}\n", fmt::join(heads, ","));
  for (std::size_t i = 0; i < form.rows.size(); ++i) {
    std::vector<std::string> cells;
    if (entry.has_abscissa()) cells.push_back(fmt::format("{}", abscissae[i]));
    for (std::size_t c = 0; c < form.columns.size(); ++c)
      if (!entry.is_constant(form.columns[c]))
        cells.push_back(form.rows[i][c].lower_text + "," + form.rows[i][c].upper_text);
    fmt::print("{}\n", fmt::join(cells, ","));
  }
}

/// Bounds are texts: a double has too few digits.
void print_json(const Proof& proof) {
  const auto& [entry, parameters, abscissae, form] = proof;
  Json columns = Json::array(), constants = Json::object(), rows = Json::array();
  if (entry.has_abscissa()) columns.push_back(entry.columns.front());
  for (std::size_t c = 0; c < form.columns.size(); ++c) {
    const auto& b = form.rows.front()[c];
    if (entry.is_constant(form.columns[c]))
      constants[form.columns[c]] = {b.lower_text, b.upper_text};
    else
      columns.push_back(form.columns[c]);
  }
  for (std::size_t i = 0; i < form.rows.size(); ++i) {
    Json row = Json::array();
    if (entry.has_abscissa()) row.push_back(abscissae[i]);
    for (std::size_t c = 0; c < form.columns.size(); ++c)
      if (!entry.is_constant(form.columns[c]))
        row.push_back({form.rows[i][c].lower_text, form.rows[i][c].upper_text});
    rows.push_back(row);
  }
  auto object = json_head<Json>();
  object.update({{"name", entry.name},
                 {"equation", entry.equation},
                 {"source", entry.source},
                 {"validity", entry.validity},
                 {"parameters", parameters},
                 {"not_proved", form.refused},
                 {"wide", wide_places(proof)},
                 {"constants", constants},
                 {"columns", columns},
                 {"rows", rows}});
  fmt::print("{}\n", object.dump(2));
}

int print_names(const ExactArguments& a) {
  if (!a.name.empty() || !a.parameters.empty() || !a.times.empty())
    throw CaseError("--list: prints the whole catalogue: leave out NAME, --set and --times");
  if (!a.format.empty() && a.format != "json")
    throw CaseError(fmt::format("--format {}: --list --proved prints text or json", a.format));
  const auto names = formula_names_by_module();
  if (a.format == "json") {
    auto object = json_head<Json>();
    for (const auto& [name, reason] : names)
      object["closed_forms"].push_back({{"name", name}, {"proved", reason.empty()}, {"reason", reason}});
    fmt::print("{}\n", object.dump(2));
    return exit_done;
  }
  for (const auto& [name, reason] : names)
    fmt::print("{}: {}\n", name, reason.empty() ? "proved" : "not proved: " + reason);
  return exit_done;
}

}  // namespace

int prove(const ExactArguments& arguments) {
  gsl_set_error_handler_off();
  if (arguments.list) return print_names(arguments);
  if (arguments.format == "markdown")
    throw CaseError("--format markdown: prints --list only; use csv or json");
  if (arguments.name.empty())
    throw CaseError("exact: NAME is missing; `gasjet exact --list --proved` prints the names");
  try {
    const Proof proof = proof_of(arguments);
    arguments.format == "json" ? print_json(proof) : print_csv(proof);
    if (proof.form.wide.empty()) return exit_done;
    fmt::print(
        stderr,
        "gasjet: exact {}: --proved: {} of {} bounds are wider than 1e-20 of the value; the table names "
        "them\n",
        arguments.name, proof.form.wide.size(), proof.form.rows.size() * proof.form.columns.size());
    return exit_domain;
  } catch (const std::invalid_argument& error) {
    throw CaseError(fmt::format("exact {}: {}", arguments.name, error.what()));
  } catch (const enclosure::Refusal& refusal) {
    throw CaseError(fmt::format(
        "exact {}: --proved: {}; `gasjet exact --list --proved` prints the forms that have bounds",
        arguments.name, refusal.what()));
  }
  return exit_done;
}

}  // namespace driver::commands
